// Height fields: a surface over a grid or over scattered points, or the solid from it down to a level.
//
// Cell (i, j) is cut by the diagonal from (i, j) to (i + 1, j + 1). The surface is one patch, number 0, its front
// is up; a solid has its bottom as number 1 and its four walls as 2 to 5, each one polygon.
// Heights in the tree are exact. In a file they are the doubles that the text rounds to, and the coordinates of
// its points are the doubles nearest to origin + i * spacing, taken exactly from the decimals of the header.
// Scattered points (.xyz) are joined by the Delaunay triangulation of their plan, which covers its convex hull; a
// solid has a wall for each side of the hull, counter-clockwise as the four are.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "csg/imports/heights.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/exact/delaunay.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/rational.h"

namespace cnrg {
namespace {

// A height field on fewer points: a surface that nowhere leaves the bound around the one over all points.
//
// Points are added until no deviation is too large, first the four corners: of each triangle the point that is
// farthest off, and of each edge an end of the grid's edge that it crosses too far off.
//
// Both surfaces are linear between the points of the table, the edges of the grid and those of the triangles. So
// is their difference, which therefore is largest at a point of the table or where an edge of a triangle crosses
// one of the grid. To look at points alone proves nothing: an edge may cut through a ridge between them.
//
// Triangles are Delaunay in a plan in which the cells of the grid are sheared to rhombi of two acute triangles.
// There the circle on an edge of the grid as diameter holds no other point of the table, so this edge is among the
// triangles as soon as both of its ends are: an edge that crosses it has an end of it to add, and adding comes to
// an end, with all points at the latest. Doubles choose; where they are too near to the bound, and only there,
// fractions decide.

/// Heights by rows along y, entries along x; at least 2 by 2. Cells are cut by the diagonal from the first corner
/// to the opposite one.
struct HeightTable {
  std::size_t columns = 0, rows = 0;
  std::vector<Rational> heights;  ///< of point (i, j) at j * columns + i
};

/// Triangles between points of the table, counter-clockwise, by places in it, and the largest deviation: how far
/// the surface is above or below that of the table at most, rounded up.
struct CoarseSurface {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double deviation = 0;
};

using Index = std::uint32_t;
using Whole = std::int64_t;

/// A point between two neighbours of the grid: `part` of `parts` of the way from one to the other.
struct Between {
  Index from = 0, to = 0;
  Whole part = 0, parts = 1;
};

Whole floor_of(Whole a, Whole b) { return a / b - (a % b < 0 ? 1 : 0); }

class Coarsening {
 public:
  Coarsening(const HeightTable& table, const Rational& within)
      : table_(table), within_(within), bound_(to_double(within)), chosen_(table.heights.size(), kNot) {
    for (const Rational& z : table.heights) {
      rounded_.push_back(to_double(z));
      highest_ = std::max(highest_, std::abs(rounded_.back()));
    }
    // Heights are off by 2^-53 of themselves, weights are whole numbers below 2^53, sums have three terms.
    error_ = 0x1p-49 * highest_;
    for (const Whole i : {Whole(0), columns() - 1})
      for (const Whole j : {Whole(0), rows() - 1}) choose(at(i, j));
  }

  CoarseSurface run() {
    for (;;) {
      triangulate();
      farthest_ = 0;
      const std::size_t before = points_.size();
      std::set<std::array<Index, 2>> bad;  // sides of triangles that will not stay
      for (const auto& triangle : surface_.triangles) {
        if (!check_points(triangle)) continue;
        for (std::size_t k = 0; k < 3; ++k) bad.insert(side(triangle, k));
      }
      for (const auto& triangle : surface_.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [p, q] = side(triangle, k);
          const bool first = triangle[k] == p || is_border(p, q);  // an inner edge is there twice
          if (first && !bad.contains({p, q})) check_edge(p, q);
        }
      }
      if (points_.size() == before) break;
    }
    return {std::move(surface_.triangles), std::min(farthest_ + error_, bound_)};
  }

 private:
  const HeightTable& table_;
  const Rational& within_;
  const double bound_;
  std::vector<double> rounded_;
  double highest_ = 0, error_ = 0, farthest_ = 0;
  enum Choice : char { kNot, kNext, kThere };  ///< not, for the next round, among the corners of triangles
  std::vector<Choice> chosen_;
  std::vector<Index> points_;
  Delaunay surface_;  // by places in the table
  double worst_ = 0;  // of the crossings of an edge, and where
  Between worst_place_;

  Whole columns() const { return static_cast<Whole>(table_.columns); }
  Whole rows() const { return static_cast<Whole>(table_.rows); }
  static std::array<Index, 2> side(const std::array<Index, 3>& triangle, std::size_t k) {
    const auto [p, q] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
    return {p, q};
  }
  Index at(Whole i, Whole j) const { return static_cast<Index>(j * columns() + i); }
  Whole i_of(Index p) const { return static_cast<Whole>(p) % columns(); }
  Whole j_of(Index p) const { return static_cast<Whole>(p) / columns(); }

  void choose(Index p) {
    if (chosen_[p] != kNot) return;
    chosen_[p] = kNext;
    points_.push_back(p);
  }

  void triangulate() {
    std::vector<std::array<double, 2>> plan;
    for (const Index p : points_) {
      chosen_[p] = kThere;
      const auto i = static_cast<double>(i_of(p)), j = static_cast<double>(j_of(p));
      plan.push_back({i - j / 2, 0.875 * j});
    }
    surface_ = delaunay(plan);
    for (auto& triangle : surface_.triangles)
      for (Index& p : triangle) p = points_[p];
  }

  /// Is a deviation too large? `rounded` is what doubles make of it, off by `error_` at most.
  template <class Exact>
  bool too_far(double rounded, Exact exact) {
    const double size = std::abs(rounded);
    if (size <= bound_ + error_) farthest_ = std::max(farthest_, size);
    if (size < bound_ * (1 - 0x1p-50) - error_) return false;
    if (size > bound_ * (1 + 0x1p-50) + error_) return true;
    return abs(exact()) > within_;
  }

  // --- points of the table in a triangle

  /// False if none is too far off; else the farthest is chosen.
  bool check_points(const std::array<Index, 3>& corners) {
    const auto [first, last] = std::minmax({j_of(corners[0]), j_of(corners[1]), j_of(corners[2])});
    double worst = 0;
    Index farthest = 0;
    for (Whole j = first; j <= last; ++j) {
      const auto [begin, end] = row_of(corners, j);
      for (Whole i = begin; i <= end; ++i) {
        const Index p = at(i, j);
        if (chosen_[p] != kNot) continue;
        const std::array<Whole, 3> w = weights(corners, i, j);
        const double off = deviation<double>(rounded_, corners, w, p);
        if (std::abs(off) < worst ||
            !too_far(off, [&] { return deviation<Rational>(table_.heights, corners, w, p); }))
          continue;
        worst = std::abs(off);
        farthest = p;
      }
    }
    if (worst > 0) choose(farthest);
    return worst > 0;
  }

  /// The first and last entry of row j in a triangle.
  std::pair<Whole, Whole> row_of(const std::array<Index, 3>& corners, Whole j) const {
    Whole begin = 0, end = columns() - 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index p = corners[k], q = corners[(k + 1) % 3];
      const Whole dj = j_of(q) - j_of(p), di = i_of(q) - i_of(p), up = (j - j_of(p)) * di;
      if (dj > 0) end = std::min(end, i_of(p) + floor_of(up, dj));
      if (dj < 0) begin = std::max(begin, i_of(p) - floor_of(up, -dj));
    }
    return {begin, end};
  }

  /// How much of each corner's height the triangle has at a point, in parts of their sum.
  std::array<Whole, 3> weights(const std::array<Index, 3>& corners, Whole i, Whole j) const {
    std::array<Whole, 3> w{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index p = corners[(k + 1) % 3], q = corners[(k + 2) % 3];
      w[k] = (i_of(q) - i_of(p)) * (j - j_of(p)) - (j_of(q) - j_of(p)) * (i - i_of(p));
    }
    return w;
  }

  template <class Number>
  static Number number(Whole n) {
    if constexpr (std::is_same_v<Number, double>) return static_cast<double>(n);
    else return Rational(to_integer(n));
  }

  template <class Number>
  static Number deviation(const std::vector<Number>& z, const std::array<Index, 3>& corners,
                          const std::array<Whole, 3>& w, Index p) {
    const Number sum = number<Number>(w[0]) * z[corners[0]] + number<Number>(w[1]) * z[corners[1]] +
                       number<Number>(w[2]) * z[corners[2]];
    return Number(z[p] - sum / number<Number>(w[0] + w[1] + w[2]));
  }

  // --- crossings of an edge with those of the grid

  void check_edge(Index p, Index q) {
    worst_ = 0;
    const Whole i = i_of(p), j = j_of(p), di = i_of(q) - i, dj = j_of(q) - j;
    cross_lines(p, q, i, di, [&](Whole line, Whole n, Whole d) {
      const Whole y = j * d + n * dj, row = floor_of(y, d);
      return Between{at(line, row), at(line, std::min(row + 1, rows() - 1)), y - row * d, d};
    });
    cross_lines(p, q, j, dj, [&](Whole line, Whole n, Whole d) {
      const Whole x = i * d + n * di, column = floor_of(x, d);
      return Between{at(column, line), at(std::min(column + 1, columns() - 1), line), x - column * d, d};
    });
    cross_lines(p, q, i - j, di - dj, [&](Whole line, Whole n, Whole d) {
      const Whole x = i * d + n * di, column = floor_of(x, d);
      const Whole next = x == column * d ? column : column + 1;
      return Between{at(column, column - line), at(next, next - line), x - column * d, d};
    });
    if (worst_ > 0) choose_end();
  }
  bool is_border(Index p, Index q) const {
    return (i_of(p) == i_of(q) && (i_of(p) == 0 || i_of(p) == columns() - 1)) ||
           (j_of(p) == j_of(q) && (j_of(p) == 0 || j_of(p) == rows() - 1));
  }

  /// Looks where the edge crosses the lines number `first` + 1, ... of one direction; `step` is how many there
  /// are, and `place(line, n, d)` the point at n / d of the edge.
  template <class Place>
  void cross_lines(Index p, Index q, Whole first, Whole step, const Place& place) {
    const Whole d = std::abs(step), way = step < 0 ? -1 : 1;
    for (Whole n = 1; n < d; ++n) check_crossing(p, q, n, d, place(first + way * n, n, d));
  }

  void check_crossing(Index p, Index q, Whole n, Whole d, const Between& place) {
    if (place.part == 0) return;  // a point of the table
    const auto off = [&]<class Number>(const std::vector<Number>& z) {
      const Number edge = z[p] + number<Number>(n) * (z[q] - z[p]) / number<Number>(d);
      const Number grid =
          z[place.from] + number<Number>(place.part) * (z[place.to] - z[place.from]) / number<Number>(place.parts);
      return Number(grid - edge);
    };
    const double size = std::abs(off(rounded_));
    if (!too_far(size, [&] { return off(table_.heights); }) || size <= worst_) return;
    worst_ = size;
    worst_place_ = place;
  }

  void choose_end() {
    const bool nearer = 2 * worst_place_.part > worst_place_.parts;
    const Index one = nearer ? worst_place_.to : worst_place_.from,
                other = nearer ? worst_place_.from : worst_place_.to;
    require(chosen_[one] != kThere || chosen_[other] != kThere, "coarse_surface: an edge crosses one of the grid");
    if (chosen_[one] == kNext || chosen_[other] == kNext) return;
    choose(chosen_[one] == kNot ? one : other);
  }
};

/// A surface with no deviation above `within` (units, above 0), exactly.
CoarseSurface coarse_surface(const HeightTable& table, const Rational& within) {
  return Coarsening(table, within).run();
}

/// Points of the grid, rows along y upwards; `none` where data is missing.
struct GridPoints {
  std::size_t columns, rows;
  std::vector<PointId> ids;
  PointId at(std::size_t i, std::size_t j) const { return ids[j * columns + i]; }
};

void check_base(const Rational& lowest, const Rational& base) {
  if (lowest > base) return;
  throw LeafKeyError("base", "heightfield: base is " + to_decimal(base) + ", but the lowest height is " +
                                 to_decimal(lowest) + ": give a base below all heights");
}

GridPoints points_of_tree(LeafBuilder& builder, const HeightfieldShape& shape) {
  const auto& rows = shape.heights;
  if (rows.size() < 2 || rows[0].size() < 2) {
    throw LeafKeyError("heights", "heightfield: heights has " + std::to_string(rows.size()) + " rows of " +
                                      std::to_string(rows.empty() ? 0 : rows[0].size()) +
                                      " entries: give at least 2 rows of 2");
  }
  if (shape.spacing_x <= 0 || shape.spacing_y <= 0) {
    throw LeafKeyError("spacing", "heightfield: spacing is [" + to_decimal(shape.spacing_x) + ", " +
                                      to_decimal(shape.spacing_y) + "]: give positive lengths");
  }
  GridPoints grid{rows[0].size(), rows.size(), {}};
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (rows[j].size() != grid.columns) {
      throw LeafKeyError("heights", "heightfield: row " + std::to_string(j + 1) + " has " +
                                        std::to_string(rows[j].size()) + " heights, row 1 has " +
                                        std::to_string(grid.columns) + ": give rows of equal length");
    }
    const Rational y = shape.origin_y + to_integer(j) * shape.spacing_y;
    for (std::size_t i = 0; i < grid.columns; ++i) {
      if (shape.base) check_base(rows[j][i], *shape.base);
      const Rational x = shape.origin_x + to_integer(i) * shape.spacing_x;
      grid.ids.push_back(builder.point({x, y, rows[j][i]}));
    }
  }
  return grid;
}

GridPoints points_of_file(LeafBuilder& builder, const HeightfieldShape& shape, std::vector<std::string>& notices) {
  const HeightGrid file = read_height_grid(shape.file, shape.inside);
  GridPoints grid{file.columns, file.rows, {}};
  if (!file.missing.empty()) {
    const auto missing = std::count(file.missing.begin(), file.missing.end(), true);
    if (shape.base) {
      throw InputError("heightfield: '" + shape.file + "' has no data at " + std::to_string(missing) +
                       " points, so it has no solid: fill the gaps, or leave out `base`");
    }
    notices.push_back("heightfield '" + shape.file + "' has no data at " + std::to_string(missing) +
                      " points: the cells around them are left out");
  }
  if (shape.base)
    check_base(from_double(*std::min_element(file.heights.begin(), file.heights.end())), *shape.base);
  const auto coordinates = [](const Rational& origin, const Rational& spacing, std::size_t n) {
    std::vector<double> result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(to_double(origin + to_integer(i) * spacing));
    for (std::size_t i = 1; i < n; ++i) {
      if (result[i - 1] < result[i]) continue;
      throw InputError(
          "heightfield: the cellsize is too small against the coordinates, neighbours round to one point");
    }
    return result;
  };
  const std::vector<double> x = coordinates(file.origin_x, file.spacing_x, file.columns);
  const std::vector<double> y = coordinates(file.origin_y, file.spacing_y, file.rows);
  for (std::size_t j = 0; j < file.rows; ++j) {
    for (std::size_t i = 0; i < file.columns; ++i) {
      const std::size_t k = j * file.columns + i;
      const bool gap = !file.missing.empty() && file.missing[k];
      grid.ids.push_back(gap ? PointId::none() : builder.soup().add_point(x[i], y[j], file.heights[k]));
    }
  }
  return grid;
}

void add_surface(LeafBuilder& builder, const GridPoints& grid) {
  const auto triangle = [&](PointId a, PointId b, PointId c) {
    if (a.valid() && b.valid() && c.valid()) builder.triangle(a, b, c, 0);
  };
  std::size_t cells = 0;
  for (std::size_t j = 0; j + 1 < grid.rows; ++j) {
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
      const PointId a = grid.at(i, j), b = grid.at(i + 1, j), c = grid.at(i + 1, j + 1), d = grid.at(i, j + 1);
      if (!a.valid() || !b.valid() || !c.valid() || !d.valid()) continue;
      ++cells;
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }
  if (cells == 0) throw InputError("heightfield: no cell has data at all of its corners: there is no surface");
}

/// Keeps of a grid the points of a surface with fewer triangles, which it adds.
GridPoints add_coarse(LeafBuilder& builder, const LeafBuilder& all, const GridPoints& grid, const Rational& within,
                      std::vector<std::string>& notices) {
  HeightTable table{grid.columns, grid.rows, {}};
  for (const PointId p : grid.ids) {
    if (!p.valid())
      throw LeafKeyError("within", "heightfield: `within` is for grids without gaps: fill these, or leave it out");
    table.heights.push_back(all.value(p)[2]);
  }
  const CoarseSurface surface = coarse_surface(table, within);
  GridPoints kept{grid.columns, grid.rows, std::vector<PointId>(grid.ids.size())};
  std::size_t count = 0;
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t p : triangle) {
      if (kept.ids[p].valid()) continue;
      kept.ids[p] = builder.point(all.value(grid.ids[p]));
      ++count;
    }
    builder.triangle(kept.ids[triangle[0]], kept.ids[triangle[1]], kept.ids[triangle[2]], 0);
  }
  notices.push_back("heightfield: " + grouped(count) + " of " + grouped(grid.ids.size()) +
                    " points make a surface within " + decimal(surface.deviation, "%.6g") + " of all");
  return kept;
}

/// The sides of the border, each with its two ends, counter-clockwise as seen from above.
using Sides = std::vector<std::vector<PointId>>;

/// South, east, north, west.
Sides sides_of(const GridPoints& grid) {
  const std::size_t last_i = grid.columns - 1, last_j = grid.rows - 1;
  Sides sides(4);
  for (std::size_t i = 0; i <= last_i; ++i) {
    sides[0].push_back(grid.at(i, 0));
    sides[2].push_back(grid.at(last_i - i, last_j));
  }
  for (std::size_t j = 0; j <= last_j; ++j) {
    sides[1].push_back(grid.at(last_i, j));
    sides[3].push_back(grid.at(0, last_j - j));
  }
  return sides;
}

/// From corner to corner of the hull; other points of its border lie on a side, exactly.
Sides sides_of(const std::vector<std::array<double, 3>>& points, const std::vector<std::uint32_t>& border,
               const std::vector<PointId>& ids) {
  const auto exact = [&](std::size_t i, std::size_t axis) { return from_double(points[border[i]][axis]); };
  const std::size_t n = border.size();
  const auto is_corner = [&](std::size_t i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    return (exact(i, 0) - exact(before, 0)) * (exact(after, 1) - exact(i, 1)) !=
           (exact(i, 1) - exact(before, 1)) * (exact(after, 0) - exact(i, 0));
  };
  Sides sides;  // the border begins with the smallest x, and of these y: a corner
  for (std::size_t i = 0; i < n; ++i) {
    if (is_corner(i)) sides.emplace_back(1, ids[border[i]]);
    sides.back().push_back(ids[border[(i + 1) % n]]);
  }
  return sides;
}

void add_walls(LeafBuilder& builder, const Sides& sides, const Rational& base) {
  std::vector<PointId> bottom;
  for (const std::vector<PointId>& side : sides) {
    RationalPoint p = builder.value(side.front());
    p[2] = base;
    bottom.push_back(builder.point(p));
  }
  builder.face(std::vector<PointId>(bottom.rbegin(), bottom.rend()), 1);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    std::vector<PointId> loop{bottom[s], bottom[(s + 1) % sides.size()]};
    loop.insert(loop.end(), sides[s].rbegin(), sides[s].rend());
    builder.face(loop, static_cast<std::uint32_t>(2 + s));
  }
}

/// The surface over scattered points.
Sides add_scattered(LeafBuilder& builder, const HeightfieldShape& shape, std::vector<std::string>& notices) {
  const HeightPoints file = read_height_points(shape.file, shape.inside);
  if (file.repeated > 0) {
    notices.push_back("heightfield '" + shape.file + "': " + std::to_string(file.repeated) +
                      (file.repeated == 1 ? " line repeats a point" : " lines repeat points") + ": left out");
  }
  std::vector<std::array<double, 2>> plan;
  for (const auto& p : file.points) plan.push_back({p[0], p[1]});
  const Delaunay surface = delaunay(plan);
  if (surface.triangles.empty()) {
    throw InputError("heightfield: '" + shape.file + "' has " + std::to_string(plan.size()) +
                     (plan.size() == 1 ? " point" : " points, all on one line as seen from above") +
                     ": give three or more that are not");
  }
  std::vector<PointId> ids;
  for (const auto& p : file.points) {
    if (shape.base) check_base(from_double(p[2]), *shape.base);
    ids.push_back(builder.soup().add_point(p[0], p[1], p[2]));
  }
  for (const auto& [a, b, c] : surface.triangles) builder.triangle(ids[a], ids[b], ids[c], 0);
  return sides_of(file.points, surface.border, ids);
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const HeightfieldShape& shape) {
  if (!shape.file.empty() && !shape.heights.empty()) {
    throw InputError("heightfield: both heights and a file are given: leave one out");
  }
  LeafBuilder builder(shape.base ? Fill::winding : Fill::none);
  std::vector<std::string> notices;
  Sides sides;
  if (holds_height_points(shape.file)) {
    if (shape.within)
      throw LeafKeyError("within", "heightfield: `within` is for grids, and .xyz are points: leave it out");
    sides = add_scattered(builder, shape, notices);
  } else {
    LeafBuilder all(Fill::none);
    LeafBuilder& of_grid = shape.within ? all : builder;
    const GridPoints grid =
        shape.file.empty() ? points_of_tree(of_grid, shape) : points_of_file(of_grid, shape, notices);
    if (!shape.within) add_surface(builder, grid);
    sides = sides_of(shape.within ? add_coarse(builder, all, grid, *shape.within, notices) : grid);
    if (shape.within) {
      for (std::vector<PointId>& side : sides) std::erase_if(side, [](PointId p) { return !p.valid(); });
    }
  }
  for (const std::vector<PointId>& side : sides) {
    if (side.front().valid()) builder.soup().add_curve_end(builder.leaf(), side.front());
  }
  if (shape.base) add_walls(builder, sides, *shape.base);
  return builder.finish(std::move(notices));
}

}  // namespace cnrg
