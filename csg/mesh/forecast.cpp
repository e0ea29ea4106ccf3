#include "csg/mesh/forecast.h"

#include <cmath>
#include <queue>

#include "csg/mesh/improved.h"
#include "csg/mesh/reach.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = SizeField::Vector;

/// Tetrahedra per h^3: 12 in cubes, 14 to 15 where facets of curved faces are about as wide as h. Regular ones
/// would be 6 * sqrt(2) = 8.49.
constexpr double kPerCube = 13;
/// TetGen splits an edge that is too long at its shorter end: 1.05, 1.18 and 1.8 times as many were made with a
/// growth of 0.1, 0.3 and 1, and no more with 2. Our own mesher looks at both ends.
double for_growth(Mesher mesher, double growth) {
  return mesher == Mesher::own ? 1 : std::min(1 + 0.55 * growth + 0.35 * growth * growth, 1.8);
}
/// In a volume of as many bounds of volumes.
constexpr double kPerVolume = 2.2;
/// As flat as they have to be there are three in a prism on each triangle, so seven on each h^2.
constexpr double kPerSquare = 7;
/// No edge is longer than so many times the thickness of its region, if shapes are good, and there are so many
/// tetrahedra on its square: TetGen's are bounded by their quality, ours by shapes above 0.1.
struct ThinShapes {
  double length_per_thickness, per_square;
};
constexpr ThinShapes kThinShapes[] = {{2, kPerCube}, {24, kPerSquare}};
/// Edges grow from those of a thin region into what lies beside it.
constexpr double kBesideThin = 1.8;

double box_volume(const Vector& half) { return 8 * half[0] * half[1] * half[2]; }

class Estimate {
 public:
  Estimate(const FlatComplex& flat, const std::vector<Vector>& points, const MeshSizes& sizes,
           const RegionLocator& regions, Mesher mesher, double max_volume, const Watch& watch)
      : flat_(flat),
        points_(points),
        sizes_(sizes),
        regions_(regions),
        shapes_(kThinShapes[mesher == Mesher::tetgen ? 0 : 1]),
        per_cube_(kPerCube * for_growth(mesher, sizes.field.growth())),
        density_(max_volume > 0 ? kPerVolume / max_volume : 0),
        watch_(watch) {}

  ExpectedTetrahedra run() {
    if (points_.empty()) return {};
    add_box();
    while (!queue_.empty() && cells_.size() < kMostCells) {
      watch_.check();
      split();
    }
    for (const Cell& cell : cells_) sum_.wide += cell.share;
    add_thin_regions();
    return sum_;
  }

 private:
  struct Cell {
    Vector middle, half;
    double share;  // tetrahedra
  };
  static constexpr std::size_t kMostCells = 20'000;
  static constexpr double kLeastShare = 1e-7;  // of the model; absurd, and numbers stay numbers
  static constexpr double kThin = 0.25;        // of lengths that are wanted
  static constexpr int kPointsOfTriangle = 8;

  const FlatComplex& flat_;
  const std::vector<Vector>& points_;
  const MeshSizes& sizes_;
  const RegionLocator& regions_;
  const ThinShapes shapes_;
  const double per_cube_, density_;
  const Watch& watch_;
  std::vector<Cell> cells_;
  std::priority_queue<std::pair<double, std::size_t>> queue_;  // by what the share may be wrong
  double least_ = 0;                                           // shorter edges are counted as if they were as long
  ExpectedTetrahedra sum_;

  double size_at(const Vector& p, Index region) const { return std::max(sizes_.at(p, region), least_); }
  double count(const Vector& half, double size) const {
    return box_volume(half) * std::max(per_cube_ / size / size / size, density_);
  }

  void add_box() {
    const Reach reach(points_);
    least_ = kLeastShare * reach.longest_side();
    Vector middle, half;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = reach.box.lo[k], high = reach.box.hi[k];
      middle[k] = low / 2 + high / 2, half[k] = high / 2 - low / 2;
    }
    add(middle, half);
  }

  /// Where faces pass through a cell, its middle speaks for all of it.
  void add(const Vector& middle, const Vector& half) {
    const Index region = regions_.at(middle);
    const bool mixed =
        regions_.meets_faces(minus(middle, half), {middle[0] + half[0], middle[1] + half[1], middle[2] + half[2]});
    if (!mixed && !flat_.active(region)) return;
    const double size = size_at(middle, region);
    const double slope = sizes_.field.growth() * hypotenuse(half[0], half[1], half[2]);
    const double all = count(half, size), doubt = count(half, std::max(size - slope, size / 8)) - all;
    queue_.emplace(doubt + (mixed ? all : 0), cells_.size());
    cells_.push_back({middle, half, flat_.active(region) ? all : 0});
  }

  /// The cell in most doubt becomes its eight parts.
  void split() {
    Cell& whole = cells_[queue_.top().second];
    queue_.pop();
    whole.share = 0;
    const Vector of = whole.middle, half{whole.half[0] / 2, whole.half[1] / 2, whole.half[2] / 2};
    for (unsigned part = 0; part < 8; ++part) {
      Vector middle = of;
      for (std::size_t k = 0; k < 3; ++k) middle[k] += part >> k & 1 ? half[k] : -half[k];
      add(middle, half);
    }
  }

  void add_thin_regions() {
    std::size_t place = 0;
    for (const FlatComplex::Face& face : flat_.faces) {
      for (const auto& t : face.triangles) {
        watch_.check();
        for (const std::size_t side : {0u, 1u}) add_thin_side(t, place, face.regions, side);
        ++place;
      }
    }
  }

  /// Half of what lies between a triangle and the face opposite, if that is near. `place`: the triangle's among
  /// all.
  void add_thin_side(const std::array<Index, 3>& triangle, std::size_t place, const std::array<Index, 2>& regions,
                     std::size_t side) {
    const Index region = regions[side];
    const Vector &a = points_[triangle[0]], ab = minus(points_[triangle[1]], a),
                 ac = minus(points_[triangle[2]], a), n = cross(ab, ac);
    const double twice = std::sqrt(dot(n, n));
    if (!flat_.active(region) || !(twice > 0)) return;
    const double turn = (side == 0 ? 1 : -1) / twice;
    const double beside = flat_.active(regions[1 - side]) ? kBesideThin : 1;
    for (int i = 0; i < kPointsOfTriangle; ++i) {  // a lattice of rank one, folded into the triangle
      double u = (i + 0.5) * 0.7548776662466927, v = (i + 0.5) * 0.5698402909980532;
      u -= std::floor(u), v -= std::floor(v);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      Vector p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + u * ab[k] + v * ac[k];
      const double size = size_at(p, region), thin = std::max(kThin, 1 / shapes_.length_per_thickness) * size;
      const double thick =
          std::max(regions_.gap(p, {turn * n[0], turn * n[1], turn * n[2]}, region, place, thin), least_);
      if (!(thick < thin)) continue;
      const double area = twice / 2 / kPointsOfTriangle,
                   longest = std::min(size, shapes_.length_per_thickness * thick);
      sum_.thin += area / 2 * shapes_.per_square / longest / longest * (longest < size ? beside : 1);
      sum_.flat += area / 2 * kPerSquare / size / size;
    }
  }
};

/// Estimates are good within this factor.
constexpr double kFactor = 2;
/// A bound of the ratio of circumradius to shortest edge makes as many more as 2 does: 1.6 to 1.9 times at 1.4,
/// and 2.8 to 6.3 at 1.2.
double for_quality(double radius_edge) {
  if (radius_edge == 0 || radius_edge >= 2) return 1;
  const double stricter = 2 - radius_edge;
  return radius_edge >= 1.4 ? 1 + 1.5 * stricter : 1.9 + 11.5 * (stricter - 0.6);
}
// Where nothing is bounded shapes alone ask for points, and flat ones take no more than some for each point.
constexpr double kGrowthOfNothing = 2, kMostOfNothing = 3, kAddedForShapes = 10'000, kMostOfFewest = 20,
                 kPerPoint = 7;
// Meshes of 10,000 to 2 million tetrahedra on one core: memory at its peak, and time of all of the meshing, the
// proof and the writing of a .vtu.
constexpr double kBytes = 40e6, kBytesEach = 450, kSecondsEach = 15e-6;

MeshForecast with_costs(double tetrahedra, double least, double most, double seconds_each) {
  return {tetrahedra, least, most, kBytes + kBytesEach * most, seconds_each * most};
}

/// With two digits that count.
std::string two_digits(double x) {
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(x, 1.0))) - 1));
  return grouped(std::size_t(std::round(x / step) * step));
}
std::string memory_text(double bytes) {
  return bytes < 1e9 ? two_digits(bytes / 1e6) + " MB" : two_digits(bytes / 1e9) + " GB";
}

/// Faces that tetrahedra have on both sides of triangles: each has four at most.
double fewest_of(const FlatComplex& flat) {
  double sides = 0;
  for (const FlatComplex::Face& face : flat.faces) {
    for (const Index r : face.regions) sides += flat.active(r) ? double(face.triangles.size()) : 0;
  }
  return sides / 4;
}

/// Where nothing is bounded, or faces leave no room for bounds. The improver adds no more than some points for
/// each point: thin regions stay flat.
MeshForecast unbounded(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                       std::size_t complex_points, const Watch& watch) {
  const MeshSizes features = mesh_sizes(view, flat, points, {0, kGrowthOfNothing, true});
  const double shapes =
      expected_tetrahedra(flat, points, features, RegionLocator(flat, points), Mesher::own, 0, watch)
          .good_shapes();
  const std::size_t begun = std::max(points.xyz.size(), complex_points);
  const double all = kPerPoint * double(begun + points_for_shapes(begun)), n = std::min(shapes, all);
  const double fewest = fewest_of(flat);
  MeshForecast mesh =
      with_costs(n, std::min(fewest, n),
                 std::max(std::min(kMostOfNothing * shapes + kAddedForShapes, all), kMostOfFewest * fewest),
                 kSecondsOfShapes);
  if (n < shapes) mesh.for_shapes = shapes;
  return mesh;
}

}  // namespace

ExpectedTetrahedra expected_tetrahedra(const FlatComplex& flat, const RoundedPoints& points,
                                       const MeshSizes& sizes, const RegionLocator& regions, Mesher mesher,
                                       double max_volume, const Watch& watch) {
  return Estimate(flat, points.xyz, sizes, regions, mesher, max_volume, watch).run();
}

std::string time_text(double seconds) {
  if (seconds < 1) return "less than a second";
  return seconds < 100    ? two_digits(seconds) + (seconds < 1.5 ? " second" : " seconds")
         : seconds < 6000 ? two_digits(seconds / 60) + " minutes"
                          : two_digits(seconds / 3600) + " hours";
}

std::string forecast_text(const MeshForecast& mesh) {
  return "from " + two_digits(mesh.least) + " to " + two_digits(mesh.most) + " tetrahedra are expected, up to " +
         memory_text(mesh.bytes) + " of memory, " + time_text(mesh.seconds);
}

std::string count_text(double count) {
  constexpr double kMostShown = 1e15;
  if (!(count < kMostShown)) return "more than " + grouped(std::size_t(kMostShown));
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 2));
  return "about " + grouped(std::size_t(std::round(count / step) * step));
}

ThinForecast forecast(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                      const MeshSizes& sizes, const std::optional<RegionLocator>& regions, Mesher mesher,
                      const TetrahedraOptions& options, const Watch& watch, std::size_t complex_points) {
  const bool bounded = !sizes.empty() || options.max_volume > 0 || options.quality > 0;
  if (!bounded) {
    const MeshForecast mesh = unbounded(view, flat, points, complex_points, watch);
    return {mesh, mesh};
  }
  const auto expected = [&](bool wide) {  // narrow features ask for nothing where shapes may be flat
    if (!sizes.empty())
      return expected_tetrahedra(flat, points, sizes, *regions, mesher, options.max_volume, watch);
    const MeshSizes features = mesh_sizes(view, flat, points, {0, kGrowthOfShapes, true, false, wide});
    return expected_tetrahedra(flat, points, features, RegionLocator(flat, points), mesher, options.max_volume,
                               watch);
  };
  const auto range = [&](double n) {
    return with_costs(n, n / kFactor, kFactor * for_quality(options.quality) * n, kSecondsEach);
  };
  const ExpectedTetrahedra good = expected(false), flat_ones = sizes.empty() ? expected(true) : good;
  ThinForecast mesh{range(good.good_shapes()), range(flat_ones.flat_shapes())};
  if (options.keep_boundary) {  // bounds hold where faces leave room for them
    const MeshForecast kept = unbounded(view, flat, points, complex_points, watch);
    for (MeshForecast* one : {&mesh.good, &mesh.flat}) {
      const double most = one->most > kMostTetrahedra ? HUGE_VAL : std::max(one->most, kept.most);
      *one = with_costs(one->tetrahedra, kept.least, most, kSecondsOfShapes);
    }
  }
  return mesh;
}

std::string impossible_text(const MeshForecast& mesh, double memory) {
  if (mesh.tetrahedra > kMostTetrahedra) {
    return count_text(mesh.tetrahedra) + " tetrahedra, and at most " + grouped(std::size_t(kMostTetrahedra)) +
           " are made";
  }
  const double least = kBytes + kBytesEach * mesh.least;
  if (memory > 0 && least > memory) {
    return count_text(mesh.tetrahedra) + " tetrahedra and with them " + memory_text(least) +
           " of memory at least, and the machine has " + memory_text(memory);
  }
  return {};
}

void require_possible(const MeshForecast& mesh, double memory) {
  const std::string text = impossible_text(mesh, memory);
  if (text.empty()) return;
  throw InputError(
      "what is asked for takes " + text +
      "; ask for a larger --size, a larger `size` of the smallest nodes, a larger --growth or "
      "--max-volume, or leave out --quality and --constrained: then thin regions are filled as flat as they are");
}

}  // namespace cnrg
