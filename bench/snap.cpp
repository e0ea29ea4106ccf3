// Results of mesh files on doubles: evaluates each file, snaps the result, writes it and reads it back; in a
// process of its own with limits.
//
//   bench_snap [--seconds N] [--gigabytes N] [--copy none|turned|close] PATH...
//
// PATH is a mesh file or a folder (searched through). The result is the file with all of its self-intersections;
// or its union with a copy of itself, turned by 30 degrees, or by 7e-16 so that nearly everything of the two
// almost coincides. A line per case: `ok` and what was snapped, `plain` where rounding alone is right, `error`
// with the message of a file that cannot be read or of a result that cannot be snapped, or CRASH, TIMEOUT, OOM,
// BUG (a broken invariant), WRONG (what was written is not what it should be). Exit status 1 if any of those.
#include "csg/result/snap.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "bench/cases/mesh_cases.h"
#include "bench/peers/program.h"
#include "csg/formats/writer.h"
#include "csg/leaves/leaf.h"
#include "csg/mesh/mesh.h"
#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "csg/result/flat.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

enum class Copy { none, turned, close };

/// Turned about (1, 2, 3) by 7e-16: the quaternion 1 + 1e-16 (i + 2 j + 3 k), exactly.
Transform turned_a_little(const RationalPoint& center) {
  const Rational x(1, Integer("10000000000000000")), y = 2 * x, z = 3 * x, square = 1 + x * x + y * y + z * z;
  Transform t;
  t.linear = {{{1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)},
               {2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)},
               {2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z}}};
  for (std::size_t i = 0; i < 3; ++i) {
    t.offset[i] = center[i];
    for (std::size_t j = 0; j < 3; ++j) {
      t.linear[i][j] /= square;
      t.offset[i] -= t.linear[i][j] * center[j];
    }
  }
  return t;
}

std::optional<Rational> volume_of(const Complex& complex, const Selection& selection) {
  std::vector<RegionId> cells;
  for (const auto& [cell, component] : selection.regions) cells.push_back(cell);
  return volume(complex, cells);
}

/// The double area of all faces of regions.
double area_of(const Complex& complex, const Selection& selection) {
  double area = 0;
  for (const auto& [cell, component] : selection.regions) {
    for (const HalfFace h : complex.region_faces[cell])
      area += std::sqrt(to_double(squared_area(complex, h.face())));
  }
  return area;
}

/// What is wrong with a written result, read back; empty if nothing is.
std::string check_file(const std::string& path, const Drawing& drawing) {
  const auto leaf = prepare(MeshShape{path, Fill::none, false});
  const auto built_complex = build_complex(make_soup({{leaf}}));
  const Complex& complex = *built_complex;
  if (const std::string invalid = validate(complex); !invalid.empty()) return path + " read back: " + invalid;
  if (complex.face_count() != drawing.triangles.size()) {
    return path + " has " + std::to_string(drawing.triangles.size()) + " triangles, which are refined to " +
           std::to_string(complex.face_count());
  }
  for (const VertexId v : complex.vertices) {
    if (!complex.points.is_double(v)) return path + " has triangles that cross";
  }
  return "";
}

std::string check(const ResultView& exact, const SnappedResult& snapped, const std::string& folder) {
  const ResultView view = snapped.shown(exact);
  if (view.complex != exact.complex) {
    if (const std::string invalid = validate(*view.complex); !invalid.empty())
      return "snapped complex: " + invalid;
    const FlatComplex flat = flatten(view);
    const RoundedPoints points = round_points(view, flat);
    if (points.moved != 0) return std::to_string(points.moved) + " vertices are no doubles";
    const auto before = volume_of(*exact.complex, selection_of(*exact.complex, *exact.value));
    const Selection selection = view.value->components().selection;
    const auto after = volume_of(*view.complex, selection);
    const double area =
        area_of(*exact.complex, selection_of(*exact.complex, *exact.value)) + area_of(*view.complex, selection);
    const double change = to_double(abs(*after - *before)), bound = area * snapped.report().displacement;
    if (change > bound) {
      return "volume changed by " + std::to_string(change) +
             ", more than area * displacement = " + std::to_string(bound);
    }
  }
  for (const char* name : {"out.vtu", "out.msh", "out.obj"}) {
    const RoundingReport report = write(folder + "/" + name, view);
    if (!report.embedded) return std::string(name) + ": facets cross";
  }
  return check_file(folder + "/out.obj", drawing_of(flatten(view)));
}

std::string evaluate(const std::string& file, Copy copy, const std::string& folder) {
  const auto leaf = prepare(MeshShape{file, {}, false});
  std::vector<LeafInstance> instances{{leaf}};
  if (copy != Copy::none) {
    Soup soup;
    leaf->add_to(soup, {});
    RationalPoint middle{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (std::size_t p = 0; p < soup.point_count(); ++p) {
        low = std::min(low, soup.xyz(PointId(p))[k]);
        high = std::max(high, soup.xyz(PointId(p))[k]);
      }
      middle[k] = (from_double(low) + from_double(high)) / 2;
    }
    instances.push_back(
        {leaf, copy == Copy::turned ? Transform::rotation({1, 2, 3}, 30, middle) : turned_a_little(middle)});
  }
  const auto built_complex = build_complex(make_soup(instances));
  const Complex& complex = *built_complex;
  const std::vector<Group> groups = leaf_groups(complex);
  Group group = groups[0];
  if (copy != Copy::none)
    group = boolean_operation(complex, BooleanOp::unite, Dominance::equal, group, groups[1]).group;
  const NodeValue value(complex, std::move(group));
  const SimplifiedComplex simplified = simplify(complex, selection_of(complex, value), value.features());
  ResultView view;
  view.complex = &complex;
  view.value = &value;
  view.simplified = &simplified;
  const FlatComplex flat = flatten(view);
  const RoundedPoints rounded = round_points(view, flat);
  const SnappedResult snapped(view, false);
  if (const std::string wrong = check(view, snapped, folder); !wrong.empty()) return "WRONG " + wrong;
  if (snapped.report().rounds == 0) return "plain: " + std::to_string(rounded.moved) + " vertices rounded";
  return "ok " + snapped.report().text();
}

int run(int argc, char** argv) {
  Limits limits{120, std::size_t{4} << 30};
  Copy copy = Copy::none;
  std::vector<std::string> paths;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto value = [&] {
      if (++i >= argc) throw std::runtime_error(arg + " needs a value");
      return std::string(argv[i]);
    };
    if (arg == "--seconds") {
      limits.seconds = std::stod(value());
    } else if (arg == "--gigabytes") {
      limits.bytes = static_cast<std::size_t>(std::stod(value()) * (1 << 30));
    } else if (arg == "--copy") {
      const std::map<std::string, Copy> copies{
          {"none", Copy::none}, {"turned", Copy::turned}, {"close", Copy::close}};
      copy = copies.at(value());
    } else {
      paths.push_back(arg);
    }
  }
  const TemporaryFolder folder;
  std::vector<MeshCase> cases;
  for (const std::string& file : mesh_files(paths)) {
    cases.push_back({file, [&, file] { return evaluate(file, copy, folder.path()); }});
  }
  return run_cases(cases, limits, {"ok", "plain"});
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  try {
    return cnrg::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_snap: %s\n", error.what());
    return 2;
  }
}
