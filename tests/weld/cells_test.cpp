// A cube is cut into convex cells by planes, cell by cell, so that neighbours meet in parts of faces and edges.
// The cells are written as a mesh with errors in every coordinate: a soup of polygons that are neither planar nor
// closed. Welded, it has the regions that were cut.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Polygon = std::vector<RationalPoint>;
using Cell = std::vector<Polygon>;  // seen counter-clockwise from outside

Cell cube() {
  Cell cell;
  const auto corner = [](int i) { return RationalPoint{i & 1, i >> 1 & 1, i >> 2 & 1}; };
  for (const auto& f : {std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}, std::array{0, 1, 5, 4},
                        std::array{2, 6, 7, 3}, std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}}) {
    cell.push_back({corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])});
  }
  return cell;
}

/// The part of a cell where normal . p <= offset.
Cell half_of(const Cell& cell, const RationalPoint& normal, const Rational& offset) {
  Cell result;
  Polygon lid;
  for (const Polygon& polygon : cell) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Rational a = dot(normal, p) - offset, b = dot(normal, q) - offset;
      if (a <= 0) kept.push_back(p);
      if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(p + Rational(a / (a - b)) * (q - p));
    }
    for (const RationalPoint& p : kept) {
      if (dot(normal, p) == offset && std::find(lid.begin(), lid.end(), p) == lid.end()) lid.push_back(p);
    }
    if (kept.size() > 2) result.push_back(kept);
  }
  if (lid.size() < 3 || result.empty()) return result;
  // The lid in order: by angle about its middle.
  RationalPoint middle{0, 0, 0};
  for (const RationalPoint& p : lid) middle = middle + p;
  middle = Rational(1, lid.size()) * middle;
  const RationalPoint x = lid[0] - middle, y = cross(normal, x);
  std::sort(lid.begin(), lid.end(), [&](const RationalPoint& p, const RationalPoint& q) {
    const auto angle = [&](const RationalPoint& r) {
      return std::atan2(to_double(dot(y, r - middle)) / std::sqrt(to_double(dot(normal, normal))),
                        to_double(dot(x, r - middle)));
    };
    return angle(p) < angle(q);
  });
  result.push_back(lid);
  return result;
}

std::vector<Cell> cut_cube(std::mt19937_64& random, std::size_t count) {
  const auto number = [&](int low, int high) { return low + static_cast<int>(random() % (high - low + 1)); };
  std::vector<Cell> cells{cube()};
  while (cells.size() < count) {
    const std::size_t i = random() % cells.size();
    const RationalPoint normal{number(-3, 3), number(-3, 3), number(-3, 3)};
    if (is_zero(normal)) continue;
    RationalPoint at{0, 0, 0};
    int corners = 0;
    for (const Polygon& polygon : cells[i]) {
      for (const RationalPoint& p : polygon) at = at + p, ++corners;
    }
    const Rational offset = dot(normal, at) / corners;
    const Cell below = half_of(cells[i], normal, offset);
    const Cell above = half_of(cells[i], Rational(-1) * normal, -offset);
    cells[i] = below;
    cells.push_back(above);
  }
  return cells;
}

TEST_CASE("cells of a cube that are written with errors are its cells", "[weld][random]") {
  const char* const seeds = std::getenv("CNRG_SEEDS");
  const std::uint64_t count = seeds != nullptr ? std::strtoull(seeds, nullptr, 10) : 20;
  const char* const from = std::getenv("CNRG_FIRST_SEED");
  const std::uint64_t first = from != nullptr ? std::strtoull(from, nullptr, 10) : 1;
  const std::string file =
      (std::filesystem::temp_directory_path() / ("cnrg_cells_" + std::to_string(getpid()))).string() + ".off";
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    for (const double noise : {1e-15, 2e-10}) {
      CAPTURE(seed, noise);
      std::mt19937_64 random(seed);
      const std::vector<Cell> cells = cut_cube(random, 2 + seed % 30);
      std::uniform_real_distribution<double> error(-noise, noise);
      std::vector<Polygon> polygons;
      for (const Cell& cell : cells) polygons.insert(polygons.end(), cell.begin(), cell.end());
      std::shuffle(polygons.begin(), polygons.end(), random);
      std::string points, faces, exact_points, exact_faces;
      std::size_t number = 0;
      for (const Polygon& polygon : polygons) {
        faces += std::to_string(polygon.size());
        exact_faces += "{loops: [[";
        for (const RationalPoint& p : polygon) {
          exact_points +=
              "[\"" + to_string(p[0]) + "\", \"" + to_string(p[1]) + "\", \"" + to_string(p[2]) + "\"], ";
          exact_faces += std::to_string(number) + ", ";
          faces += " " + std::to_string(number++);
          char text[100];
          std::snprintf(text, sizeof text, "%.17g %.17g %.17g\n", to_double(p[0]) + error(random),
                        to_double(p[1]) + error(random), to_double(p[2]) + error(random));
          points += text;
        }
        faces += "\n";
        exact_faces += "]]}, ";
      }
      std::ofstream(file) << "OFF\n" << number << " " << polygons.size() << " 0\n" << points << faces;
      const auto row_of = [](const std::string& leaf) {
        EvaluateOptions options;
        options.validate = true;
        return evaluate(parse_tree("cnrg: 1\nnodes: {a: {" + leaf + "}}\nresult: a\n", "t.yaml"), options).rows[0];
      };
      const NodeRow row = row_of("mesh: {file: " + file + ", fill: cells, weld: 1e-8}");
      const NodeRow exact =
          row_of("group: {vertices: [" + exact_points + "], faces: [" + exact_faces + "], fill: cells}");
      CHECK(row.raw_cells == exact.raw_cells);
      CHECK(row.regions == cells.size());
      CHECK(to_double(*row.volume()) == Approx(1).epsilon(1e-7));
      std::filesystem::remove(file);
    }
  }
}

}  // namespace
}  // namespace cnrg
