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
#include "csg/shapes/coarse_grid.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/exact/delaunay.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

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

}  // namespace

CoarseSurface coarse_surface(const HeightTable& table, const Rational& within) {
  return Coarsening(table, within).run();
}

}  // namespace cnrg
