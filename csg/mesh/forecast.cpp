#include "csg/mesh/forecast.h"

#include <cmath>
#include <queue>

#include "csg/mesh/improved.h"
#include "csg/mesh/near_sizes.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = SizeField::Vector;

// Calibrated on meshes that TetGen makes where a tetrahedron is split while its longest edge is above kLongestEdge
// (kernel/tetrahedra/bounds.h) times the size; tests/mesh/forecast_test.cpp has the models. Edges are 0.98 h long
// in the mean then.

/// Tetrahedra per h^3: 12 in cubes, 14 to 15 where many facets of curved faces are about as wide as h. Regular
/// ones would be 6 * sqrt(2) = 8.49.
constexpr double kPerCube = 13;
/// Where sizes grow, an edge that is as long as they are in its middle is too long at its shorter end: 1.05, 1.18
/// and 1.8 times as many were made with a growth of 0.1, 0.3 and 1, and no more with 2.
double for_growth_of_tetgen(double growth) { return std::min(1 + 0.55 * growth + 0.35 * growth * growth, 1.8); }
/// The improver looks at both ends of an edge instead, and pulls short edges together.
constexpr double kPerCubeOfOurs = 12.5;
double for_growth_of_ours(double growth) { return 1 + 0.1 * growth; }
/// In a volume of as many bounds of volumes, where these are small beside features.
constexpr double kPerVolume = 2.05, kPerVolumeOfOurs = 2.45;
/// A tetrahedron is no thicker than its region; and no edge is longer than so many times that thickness, if its
/// quality is bounded: plates of 8 x 8 x 0.1 and 8 x 8 x 0.5 with h = 0.5 and 0.4.
constexpr double kPerThickness = 2;
/// Ours is bounded by shape alone, which flat ones of sixteen times that thickness have: three in a prism on each
/// triangle, so seven on each h^2, where a cube of h has twelve.
/// Where sides are so narrow that they ask for nothing, thirty times: slabs of 2.5 x 2, 0.0015 and 0.001 thick.
constexpr double kPerThicknessOfOurs = 16, kPerThicknessOfNarrow = 30, kFlatPart = 7.0 / 12;
/// By TetGen in wedges, whose faces have points at their thin ends in common.
constexpr double kFlatPartOfWedges = 0.65;
double for_flatness(double ratio, double part) {
  return part + (1 - part) * std::clamp((ratio - 0.25) / 0.75, 0.0, 1.0);
}

class Forecast {
 public:
  Forecast(const FlatComplex& flat, const MeshSizes& sizes, const SizeField& near, const RegionLocator& regions,
           Maker maker, double max_volume, const Watch& watch, bool rough)
      : watch_(watch),
        most_(rough ? kMost / 8 : kMost),
        of_narrow_(rough ? kOfNarrow / 8 : kOfNarrow),
        flat_(flat),
        sizes_(sizes),
        near_(near),
        regions_(regions),
        maker_(maker),
        density_(max_volume > 0 ? (maker == Maker::tetgen ? kPerVolume : kPerVolumeOfOurs) / max_volume : 0),
        per_cube_(maker == Maker::tetgen ? kPerCube : kPerCubeOfOurs),
        per_thickness_(maker == Maker::tetgen ? kPerThickness
                       : maker == Maker::own  ? kPerThicknessOfOurs
                                              : HUGE_VAL),
        for_growth_(maker == Maker::tetgen ? for_growth_of_tetgen(sizes.field.growth())
                                           : for_growth_of_ours(sizes.field.growth())) {}

  ExpectedTetrahedra run(const RoundedPoints& points) {
    if (points.xyz.empty()) return {};
    narrow_ = least_asked(points) / 2;
    cover(points.xyz);
    in_thin_parts(points.xyz);
    while (!queue_.empty() && cells_.size() < most_cells()) {
      watch_.check();
      split();
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      watch_.check();
      add_share_of(cells_[i], double(i));
    }
    return sum_;
  }

 private:
  enum class Kind : std::uint8_t { inside, outside, mixed };
  struct Cell {
    Vector middle, half;
    Index region;  // of the middle
    Kind kind;
    bool narrow;          // there may be a face so near that the region is thinner than edges are long
    double share, doubt;  // as the middle tells, in tetrahedra
  };
  struct Doubt {
    double doubt;
    std::size_t cell;
    bool operator<(const Doubt& other) const {
      return doubt != other.doubt ? doubt < other.doubt : cell > other.cell;
    }
  };
  static constexpr std::size_t kFewest = 600, kMost = 40'000;  // cells
  static constexpr double kLeastShare = 1e-7;                  // of the model; absurd, and numbers stay numbers
  static constexpr double kOfNarrow = 16'000;                  // points in all narrow cells together
  static constexpr double kPerCell = 60;                       // tetrahedra, between these bounds
  static constexpr double kThin = 0.125;                       // of lengths that are wanted

  const Watch& watch_;
  const std::size_t most_;  // cells
  const double of_narrow_;  // points
  const FlatComplex& flat_;
  const MeshSizes& sizes_;
  const SizeField& near_;  // between features that nearly touch
  const RegionLocator& regions_;
  const Maker maker_;
  const double density_;  // at least
  const double per_cube_, per_thickness_, for_growth_;
  std::vector<Cell> cells_;
  std::priority_queue<Doubt> queue_;
  double shares_ = 0;
  double least_ = 0;   // shorter edges are counted as if they were as long
  double narrow_ = 0;  // the sides of a part that is thinner ask for nothing
  ExpectedTetrahedra sum_;

  double per_thickness(double thick) const {
    return maker_ == Maker::own && thick < narrow_ ? kPerThicknessOfNarrow : per_thickness_;
  }

  std::size_t most_cells() const {
    return std::size_t(std::clamp(shares_ / kPerCell, double(kFewest), double(most_)));
  }

  static double volume_of(const Vector& half) { return 8 * half[0] * half[1] * half[2]; }
  /// Of the tetrahedra that a point of a cell tells of, in all of it.
  double count(const Vector& half, double a, double b, double c) const {
    return volume_of(half) * std::max(per_cube_ / a / b / c, density_);
  }
  double size_at(const Vector& p, Index region) const {
    return std::max(std::min(sizes_.at(p, region), near_.at(p)), least_);
  }

  void add_at(const Vector& p, Index region, const Cell& cell, double volume) {
    const double size = size_at(p, region);
    const double grown = near_.at(p) > size ? for_growth_ : 1;
    if (!cell.narrow) return add_density(size, size, region, volume, grown);
    const RegionLocator::Plate plate = regions_.plate(p, size);
    if (plate.even() && !plate.meet && plate.thickness < kThin * size) return;  // `in_thin_parts` has it
    // Where the faces of a wedge meet it has no thickness, and tetrahedra that have an edge there have.
    const bool even = plate.even() && !plate.meet;
    const double thick = even ? plate.thickness : std::max(plate.thickness, plate.sine * size);
    add_density(size, thick, region, volume, grown, plate.meet);
  }
  /// In a volume where edges are to be so long and the region is so thick; `grown`: so many times as many where
  /// they grow. `wedge`: its faces meet, and edges there are as long as elsewhere.
  void add_density(double size, double thick, Index region, double volume, double grown, bool wedge = false) {
    const bool bounded =
        size == sizes_.field.overall() || (region < sizes_.regions.size() && size == sizes_.regions[region]);
    thick = std::max(thick, least_);
    const double most = per_thickness(thick) * thick;
    const bool thin = !wedge && size > most;  // then edges do not grow
    if (thin) size = most;
    const double part = maker_ != Maker::tetgen ? kFlatPart : wedge ? kFlatPartOfWedges : 1;
    const double flat = for_flatness(thick / size, part);
    const double by_sizes = per_cube_ / size / size / std::min(size, thick);
    // In thin parts shapes and volumes want other points: slabs get as many as both.
    if (thin) sum_.by_thickness += volume * by_sizes * flat;
    if (by_sizes <= density_ || thin) sum_.by_volume += volume * density_;
    else if (bounded) sum_.even += volume * by_sizes * flat;
    else sum_.growing += volume * by_sizes * flat * grown;
  }

  /// The integral over faces: each has half of what lies between it and the one opposite.
  void in_thin_parts(const std::vector<Vector>& points) {
    std::size_t all = 0, at = 0;
    for (const FlatComplex::Face& face : flat_.faces) all += face.triangles.size();
    const std::size_t step = 1 + all / most_;  // where there are many, some speak for all
    for (const FlatComplex::Face& face : flat_.faces) {
      for (const auto& t : face.triangles) {
        const std::size_t place = at++;
        if (place % step != 0) continue;
        watch_.check();
        add_beside(points[t[0]], points[t[1]], points[t[2]], face.regions, place, double(step));
      }
    }
  }
  /// Of a triangle, which stands for so many: by few points, and by more where it is one of a thin part.
  void add_beside(const Vector& a, const Vector& b, const Vector& c, const std::array<Index, 2>& regions,
                  std::size_t place, double many) {
    const Vector ab = minus(b, a), ac = minus(c, a), n = cross(ab, ac);
    const double length = std::sqrt(dot(n, n));
    if (!(length > 0)) return;
    for (const int side : {0, 1}) {
      const Index region = regions[std::size_t(side)];
      if (!flat_.active(region)) continue;
      const double turn = (side == 0 ? 1 : -1) / length;
      const Vector to{turn * n[0], turn * n[1], turn * n[2]};
      constexpr int kFew = 3, kMany = 32;
      struct Thin {
        double size, thick, beyond;
      };
      std::array<Thin, kMany> found;
      std::size_t count = 0;
      int taken = 0;
      for (int most = kFew; taken < most; ++taken) {
        // Points of a lattice of rank one, folded into the triangle.
        double u = (taken + 0.5) * 0.7548776662466927, v = (taken + 0.5) * 0.5698402909980532;
        u -= std::floor(u), v -= std::floor(v);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        Vector p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + u * ab[k] + v * ac[k];
        const double size = size_at(p, region), most_thick = std::max(kThin, 1 / per_thickness_) * size;
        const double thick = regions_.gap(p, to, region, place, most_thick);
        if (!(thick < most_thick)) continue;
        most = kMany;
        const Index other = regions[std::size_t(1 - side)];
        found[count++] = {size, thick, maker_ == Maker::tetgen ? beyond(p, to, other, place, thick) : 0};
      }
      const double each = many * length / 2 / taken;
      for (std::size_t i = 0; i < count; ++i) {
        const auto [size, thick, beyond] = found[i];
        sum_.by_thickness += each * beyond;
        if (thick < kThin * size) add_density(size, thick, region, each * thick / 2, for_growth_);
      }
    }
  }

  /// Per unit of area: edges on the face of a thin part are short, and on its other side they grow from there.
  /// What is counted there anyway is left out.
  double beyond(const Vector& p, const Vector& to, Index region, std::size_t triangle, double thick) const {
    if (!flat_.active(region) || thick < least_) return 0;  // nobody refines for what is as near as that
    const double begin = per_thickness_ * thick, size = size_at(p, region);
    if (begin >= size) return 0;
    const double most = size / per_thickness_;
    const double other = regions_.gap(p, {-to[0], -to[1], -to[2]}, region, triangle, most);
    const double way = std::min((size - begin) / kGrowthOfShapes, other < most ? other / 2 : HUGE_VAL);
    const double end = begin + kGrowthOfShapes * way;
    const double there = other < most ? per_thickness_ * std::max(other, least_) : size;
    const double anyway = std::max(per_cube_ / there / there / std::min(there, other), density_);
    return std::max(0.0, per_cube_ / (2 * kGrowthOfShapes) * (1 / begin / begin - 1 / end / end) - anyway * way);
  }

  Cell cell_at(const Vector& middle, const Vector& half) const {
    Cell cell{middle, half, regions_.at(middle), Kind::mixed, true, 0, 0};
    const Vector low = minus(middle, half), high{middle[0] + half[0], middle[1] + half[1], middle[2] + half[2]};
    if (!regions_.meets_faces(low, high)) cell.kind = flat_.active(cell.region) ? Kind::inside : Kind::outside;
    if (cell.kind == Kind::outside) return cell;
    const double here = size_at(middle, cell.region);
    const double growth = near_.empty() ? sizes_.field.growth() : std::max(sizes_.field.growth(), near_.growth());
    const double slope = growth * std::hypot(half[0], half[1], half[2]);
    // The field may fall to a source within the cell, and there is one at most as far away as it could have risen.
    const double least = std::max(here - slope, here / (near_.empty() ? 8 : 32)), most = here + slope;
    const auto around = [&](double room) {
      return std::pair<Vector, Vector>{{low[0] - room, low[1] - room, low[2] - room},
                                       {high[0] + room, high[1] + room, high[2] + room}};
    };
    const auto [near_low, near_high] = around(most / 2);
    const auto [far_low, far_high] = around(most);
    cell.narrow = (cell.kind == Kind::mixed || regions_.meets_faces(near_low, near_high)) &&
                  regions_.may_have_plates(far_low, far_high);
    cell.share = count(half, here, here, here);
    cell.doubt = count(half, least, least, least) - count(half, most, most, most);
    if (cell.kind == Kind::mixed) cell.doubt += cell.share;
    return cell;
  }

  void add(const Cell& cell) {
    if (cell.kind == Kind::outside) return;
    shares_ += cell.share;
    queue_.push({cell.doubt, cells_.size()});
    cells_.push_back(cell);
  }

  /// Near cubes, so that halves of cells stay as compact.
  void cover(const std::vector<Vector>& points) {
    Vector low = points[0], high = points[0];
    for (const Vector& p : points) {
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    const Vector size = minus(high, low);
    const double longest = std::max({size[0], size[1], size[2]});
    least_ = kLeastShare * longest;
    std::array<std::size_t, 3> count{};
    Vector half{};
    for (std::size_t k = 0; k < 3; ++k) {
      count[k] = std::max<std::size_t>(1, std::size_t(std::llround(8 * size[k] / longest)));
      half[k] = size[k] / double(count[k]) / 2;
    }
    for (std::size_t x = 0; x < count[0]; ++x) {
      for (std::size_t y = 0; y < count[1]; ++y) {
        for (std::size_t z = 0; z < count[2]; ++z) {
          const std::array<double, 3> step{double(2 * x + 1), double(2 * y + 1), double(2 * z + 1)};
          Vector middle;
          for (std::size_t k = 0; k < 3; ++k) middle[k] = low[k] + step[k] * half[k];
          add(cell_at(middle, half));
        }
      }
    }
  }

  /// The cell in most doubt becomes its eight parts; the first takes its place.
  void split() {
    const std::size_t place = queue_.top().cell;
    queue_.pop();
    const Cell whole = cells_[place];
    shares_ -= whole.share;
    const Vector half{whole.half[0] / 2, whole.half[1] / 2, whole.half[2] / 2};
    cells_[place].share = 0;
    cells_[place].kind = Kind::outside;  // it stands for nothing now
    for (unsigned part = 0; part < 8; ++part) {
      Vector middle = whole.middle;
      for (std::size_t k = 0; k < 3; ++k) middle[k] += part >> k & 1 ? half[k] : -half[k];
      add(cell_at(middle, half));
    }
  }

  /// The mean of some points of a cell: a lattice of rank one, whose points lie evenly however many there are,
  /// moved for each cell (cranley1976): a wall beside a face is in the same part of all cells along it, and points
  /// in the same places of all would miss what lies between. There may be more of that than of all else.
  void add_share_of(const Cell& cell, double number) {
    if (cell.kind == Kind::outside) return;
    constexpr Vector kStep{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    constexpr Vector kMove{0.6180339887498949, 0.4142135623730951, 0.7320508075688772};
    constexpr double kLeastPoints = 4, kMostPoints = 64;
    const double cells = double(cells_.size()), share = shares_ > 0 ? cell.share / shares_ : 0;
    const double least =
        cell.narrow ? std::clamp(of_narrow_ / cells, kLeastPoints, kMostPoints / 2) : kLeastPoints;
    const auto n = std::size_t(std::clamp(4 * share * cells, least, kMostPoints));
    for (std::size_t i = 0; i < n; ++i) {
      Vector p = cell.middle;
      for (std::size_t k = 0; k < 3; ++k) {
        const double place = (double(i) + 0.5) * kStep[k] + number * kMove[k];
        p[k] += cell.half[k] * (2 * (place - std::floor(place)) - 1);
      }
      const Index region = cell.kind == Kind::inside ? cell.region : regions_.at(p);
      if (flat_.active(region)) add_at(p, region, cell, volume_of(cell.half) / double(n));
    }
  }
};

}  // namespace

ExpectedTetrahedra expected_tetrahedra(const FlatComplex& flat, const RoundedPoints& points,
                                       const MeshSizes& sizes, const RegionLocator& regions, Maker maker,
                                       double max_volume, const Watch& watch, bool rough) {
  const bool nears = maker == Maker::tetgen && !rough;
  const SizeField near = nears ? sizes_of_near(flat, points, sizes, watch) : SizeField();
  return Forecast(flat, sizes, near, regions, maker, max_volume, watch, rough).run(points);
}

double expected_of_volume(double volume, double max_volume) { return kPerVolumeOfOurs * volume / max_volume; }

// Measured on parts with 136 to 1,920 triangles: 1.6 to 1.9 times as many at 1.4, and 2.8 to 6.3 at 1.2.
double for_quality(double radius_edge) {
  if (radius_edge == 0 || radius_edge >= 2) return 1;
  const double stricter = 2 - radius_edge;
  return radius_edge >= 1.4 ? 1 + 1.5 * stricter : 1.9 + 11.5 * (stricter - 0.6);
}

namespace {

// 259 meshes of 136 models of geology, fractures and parts, with and without points on their faces: 247 lie in the
// range, and of the 30 with an integral of 10,000 and more 29, but for a thin shell that has fewer.
constexpr double kGrowthOfNothing = 2, kLeastOfNothing = 0.3, kMostOfNothing = 3, kAddedForShapes = 10'000;
// Facets that nearly touch everywhere, those of 442 faults, have 16 times as many as they touch at least.
constexpr double kMostOfFewest = 20;
// The least and the most of what edges that grow from features make, where shapes or volumes are bounded; of ours
// with sizes and a quality, whose halves come on top, both. Where shapes alone are bounded TetGen adds some
// hundreds where facets meet sharply, and needs as many less elsewhere.
constexpr double kLeastOfShapes = 0.45, kMostOfShapes = 1.8, kLeastOfHalves = 0.6, kMostOfHalves = 2.2,
                 kFewForShapes = 800;
// Of each point of a mesh, those on faces and of flat tetrahedra included.
constexpr double kPerPoint = 7;

// Meshes of 10,000 to 2 million tetrahedra on one core: memory at its peak, with that of TetGen.
constexpr double kBytes = 40e6, kBytesEach = 450;

/// On one core, all of the meshing, the proof and the writing of a .vtu, for each tetrahedron: of a block (7 to 9,
/// and 4 where ours are halved) and of a slope with faults and bolts (16, and 10); more where lengths come from
/// many sources, for each time that these are doubled from kFewSources on (a tunnel: 26 and 21 us
/// each); of slabs an eightieth to a four-hundredth as thick as they are wide (16 to 33, and 80 to 120 where ours
/// are improved); with faces first (42 to 58).
constexpr double kSecondsOfTetgen = 12e-6, kSecondsOfOurs = 8e-6, kSecondsOfDoubling = 3.5e-6, kFewSources = 32,
                 kSecondsOfThin = 25e-6, kSecondsOfFacesFirst = 40e-6;
double seconds_of_each(const ExpectedTetrahedra& parts, Maker maker, const SizeField& field, bool surface_first) {
  const double each = (maker == Maker::tetgen ? kSecondsOfTetgen : kSecondsOfOurs) +
                      kSecondsOfDoubling * std::log2(1 + double(field.sources()) / kFewSources);
  const double wide = each + (surface_first ? kSecondsOfFacesFirst : 0);
  const double thin = std::max(each, maker == Maker::tetgen ? kSecondsOfThin : kSecondsOfShapes);
  const double part = parts.all() > 0 ? parts.by_thickness / parts.all() : 0;
  return (1 - part) * wide + part * thin;
}

}  // namespace

bool is_close(const MeshForecast& mesh) {
  return mesh.least >= 0.65 * mesh.tetrahedra && mesh.most <= 1.35 * mesh.tetrahedra;
}

MeshForecast with_costs(double tetrahedra, double least, double most, double seconds) {
  MeshForecast mesh{tetrahedra, least, most};
  const double counted = is_close(mesh) ? tetrahedra : most;
  mesh.bytes = kBytes + kBytesEach * counted;
  mesh.seconds = seconds * counted;
  return mesh;
}

namespace {

/// With two digits that count.
std::string two_digits(double x) {
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(x, 1.0))) - 1));
  return grouped(std::size_t(std::round(x / step) * step));
}
std::string memory_text(double bytes) {
  return bytes < 1e9 ? two_digits(bytes / 1e6) + " MB" : two_digits(bytes / 1e9) + " GB";
}

}  // namespace

std::string time_text(double seconds) {
  if (seconds < 1) return "less than a second";
  return seconds < 100    ? two_digits(seconds) + (seconds < 1.5 ? " second" : " seconds")
         : seconds < 6000 ? two_digits(seconds / 60) + " minutes"
                          : two_digits(seconds / 3600) + " hours";
}

std::string forecast_text(const MeshForecast& mesh) {
  const bool close = is_close(mesh);
  return (close ? count_text(mesh.tetrahedra)
                : "from " + two_digits(mesh.least) + " to " + two_digits(mesh.most)) +
         " tetrahedra are expected, " + (close ? "" : "up to ") + memory_text(mesh.bytes) + " of memory, " +
         time_text(mesh.seconds);
}

std::string count_text(double count) {
  constexpr double kMostShown = 1e15;
  if (!(count < kMostShown)) return "more than " + grouped(std::size_t(kMostShown));
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 2));
  return "about " + grouped(std::size_t(std::round(count / step) * step));
}

namespace {

/// Of all active regions.
double volume_of_model(const FlatComplex& flat, const RoundedPoints& points) {
  double sum = 0;
  for (Index i = 0; i < flat.regions.size(); ++i) {
    if (!flat.active(i)) continue;
    for (const auto& shell : flat.regions[i].shells) {
      for (const Index side : shell) {
        for (const auto& t : flat.faces[side >> 1].triangles) {
          const Vector &o = points.xyz[0], a = minus(points.xyz[t[0]], o), b = minus(points.xyz[t[1]], o),
                       c = minus(points.xyz[t[2]], o);
          sum += (side & 1) == 0 ? -dot(a, cross(b, c)) : dot(a, cross(b, c));
        }
      }
    }
  }
  return sum / 6;
}

/// Faces that tetrahedra have on both sides of triangles: each has four at most.
double fewest_of(const FlatComplex& flat) {
  double sides = 0;
  for (const FlatComplex::Face& face : flat.faces) {
    for (const Index r : face.regions) sides += flat.active(r) ? double(face.triangles.size()) : 0;
  }
  return sides / 4;
}

MeshForecast of_unbounded(double tetrahedra, double least, double most) {
  MeshForecast mesh{tetrahedra, least, most};
  mesh.bytes = kBytes + kBytesEach * most;
  mesh.seconds = kSecondsOfShapes * most;
  return mesh;
}

/// Where nothing is bounded there are as many as facets and pieces need that are met by good shapes, and edges
/// grow fast from there. The improver adds some thousand points for shapes however few there are, and no more than
/// some for each point: thin regions stay flat.
MeshForecast unbounded(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points, bool kept,
                       std::size_t complex_points, const Watch& watch) {
  const MeshSizes features = mesh_sizes(view, flat, points, {0, kGrowthOfNothing, true});
  const double for_shapes =
      expected_tetrahedra(flat, points, features, RegionLocator(flat, points), Maker::own, 0, watch, true).all();
  const std::size_t begun = std::max(points.xyz.size(), complex_points);
  const double all = kPerPoint * double(begun + points_for_shapes(begun)), n = std::min(for_shapes, all);
  const double fewest = fewest_of(flat);
  const bool scarce = n < for_shapes;  // points may run out, or do no good
  const double least = kept || scarce ? fewest : std::max(fewest, kLeastOfNothing * n);
  const double most =
      std::max(std::min(kMostOfNothing * for_shapes + kAddedForShapes, all), kMostOfFewest * fewest);
  MeshForecast mesh = of_unbounded(n, least, most);
  if (scarce) mesh.for_shapes = for_shapes;
  return mesh;
}

}  // namespace

MeshForecast forecast(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                      const MeshSizes& sizes, const std::optional<RegionLocator>& regions, Maker maker,
                      const TetrahedraOptions& options, const Watch& watch, std::size_t complex_points) {
  constexpr double kLeast = 0.7, kMost = 1.3;
  const double volume = options.max_volume, strict = for_quality(options.quality);
  const bool by_shapes = sizes.empty() && volume == 0;
  if (by_shapes && options.quality == 0)
    return unbounded(view, flat, points, options.keep_boundary, complex_points, watch);
  if (options.keep_boundary) {  // what is asked for holds where faces leave room for it
    TetrahedraOptions free = options;
    free.keep_boundary = false;
    MeshForecast mesh = forecast(view, flat, points, sizes, regions, maker, free, watch);
    const MeshForecast kept = unbounded(view, flat, points, true, complex_points, watch);
    const double most = mesh.most > kMostTetrahedra ? HUGE_VAL : std::max(mesh.most, kept.most);
    return of_unbounded(mesh.tetrahedra, kept.least, most);
  }
  ExpectedTetrahedra parts;
  if (sizes.empty()) {  // shapes need as many as features make of them
    const double growth = by_shapes                ? kGrowthOfShapes
                          : maker == Maker::tetgen ? kGrowthOfFeatures
                                                   : kGrowthOfNothing;
    const bool wide = maker == Maker::flat;
    const MeshSizes features = mesh_sizes(view, flat, points, {0, growth, true, false, wide});
    const bool quick = by_shapes || maker != Maker::tetgen;  // a range
    parts = expected_tetrahedra(flat, points, features, RegionLocator(flat, points), maker, volume, watch, quick);
  } else {
    parts = expected_tetrahedra(flat, points, sizes, *regions, maker, volume, watch);
  }
  const double each = seconds_of_each(parts, maker, sizes.field, options.surface_first);
  const double n = parts.all(), strict_n = n + (strict - 1) * parts.growing;
  // What is thin gets points for shapes, too, if these are of use there.
  const double rationed = maker == Maker::flat
                              ? kPerPoint * double(points_for_shapes(std::max(points.xyz.size(), complex_points)))
                              : 0;
  if (!sizes.empty()) {  // ours halve what is still bad
    const bool halves = maker == Maker::own && options.quality > 0;
    return with_costs(n, (halves ? kLeastOfHalves : kLeast) * n, (halves ? kMostOfHalves : kMost) * strict_n,
                      each);
  }
  if (maker == Maker::tetgen) {
    const double rest = n - parts.growing, shapes = strict * parts.growing;
    const double few = by_shapes ? kFewForShapes : 0;
    const double least = std::max(kLeastOfShapes * shapes - few, std::min(shapes, fewest_of(flat)));
    return with_costs(shapes + rest, least + kLeast * rest, kMostOfShapes * shapes + few + kMost * rest, each);
  }
  if (by_shapes) {
    return with_costs(strict_n, std::min(fewest_of(flat), kLeastOfShapes * strict_n),
                      kMostOfShapes * strict_n + rationed, each);
  }
  // Features need less where flat tetrahedra are good enough, and more where facets are long and many.
  const double by_volume = std::min(n, expected_of_volume(volume_of_model(flat, points), volume));
  return with_costs(n, kLeast * by_volume, kMostOfShapes * strict_n + rationed, each);
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
