#include "csg/result/slight_moves.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

// Vectors of other sizes are not looked at; between these, what products lose below the least double is less than
// kUnderflow.
constexpr double kSmallest = 1e-60, kLargest = 1e60, kUnderflow = 1e-250;

/// A triangle, a segment or a point; numbers of points.
struct Cell {
  std::array<std::uint32_t, 3> points{};
  std::size_t size = 0;
  std::span<const std::uint32_t> corners() const { return {points.data(), size}; }
};

/// From a to b in each coordinate, and how far it may be from that, whatever way the points go.
///
/// Its ends may be `reach` off: |b' - a' - (b - a)| <= reach(a) + reach(b); one subtraction and the sums here err
/// by less than 3 units in the last place, which 4 of them cover.
struct Vector {
  std::array<double, 3> v{};
  double size = 0, off = 0;  // largest coordinate; bound of the error of each
};

class Movement {
 public:
  Movement(const RoundedPoints& points, const Drawing& drawing) : points_(points) {
    for (const auto& t : drawing.triangles) cells_.push_back({t, 3});
    for (const auto& [a, b] : drawing.segments) cells_.push_back({{a, b, 0}, 2});
    for (const std::uint32_t p : drawing.points) cells_.push_back({{p, 0, 0}, 1});
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      if (moves(cells_[c])) moving_.push_back(c);
    }
  }

  bool is_harmless() const {
    std::vector<Box> boxes;
    for (const std::uint32_t c : moving_) boxes.push_back(box(cells_[c]));
    const BoxTree tree(std::move(boxes));
    std::atomic<bool> certain = true;
    for_each_index(cells_.size(), [&](std::size_t i) {
      if (!certain.load(std::memory_order_relaxed)) return;
      const Cell& cell = cells_[i];
      const bool moving = moves(cell);
      if (moving && !stays(cell)) certain = false;
      const Box own = box(cell);
      tree.query([&](const Box& other) { return other.meets(own); },
                 [&](std::uint32_t m) {
                   const std::uint32_t other = moving_[m];
                   if (other == i || (moving && other < i)) return;
                   if (!apart(cell, cells_[other])) certain = false;
                 });
    });
    return certain;
  }

 private:
  const RoundedPoints& points_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> moving_;

  double reach(std::uint32_t p) const { return points_.reach[p]; }

  bool moves(const Cell& cell) const {
    return std::ranges::any_of(cell.corners(), [&](std::uint32_t p) { return reach(p) > 0; });
  }

  Box box(const Cell& cell) const {
    Box out;
    for (const std::uint32_t p : cell.corners()) {
      const auto& x = points_.xyz[p];
      std::array<double, 3> low = x, high = x;
      if (const double r = reach(p); r > 0) {
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::nextafter(x[k] - r, -kInfinity);
          high[k] = std::nextafter(x[k] + r, kInfinity);
        }
      }
      out.extend(low, high);
    }
    return out;
  }

  Vector vector(std::uint32_t a, std::uint32_t b) const {
    Vector out;
    for (std::size_t k = 0; k < 3; ++k) {
      out.v[k] = points_.xyz[b][k] - points_.xyz[a][k];
      out.size = std::max(out.size, std::abs(out.v[k]));
    }
    out.off = out.size < kSmallest || out.size > kLargest
                  ? kInfinity
                  : (reach(a) + reach(b)) * (1 + 4 * kUlp) + 4 * kUlp * out.size;
    return out;
  }

  /// The sign if it is certain, else 0. `terms` products of `product` at most in size, of vectors that may be off.
  static int certain_sign(double value, double product, double product_off, double terms) {
    const double bound = terms * ((product_off - product) + 16 * kUlp * product_off) + kUnderflow;
    return !(std::abs(value) > bound) || !std::isfinite(value) ? 0 : value > 0 ? 1 : -1;
  }

  /// The side of the plane through a, b, c on which d is.
  int side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const Vector u = vector(a, b), v = vector(a, c), w = vector(a, d);
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      value += w.v[k] * (u.v[i] * v.v[j] - u.v[j] * v.v[i]);
    }
    return certain_sign(value, u.size * v.size * w.size, (u.size + u.off) * (v.size + v.off) * (w.size + w.off),
                        6);
  }

  /// The side of the plane through a and b along an axis on which c is.
  int side_along(std::size_t axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vector u = vector(a, b), v = vector(a, c);
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    return certain_sign(u.v[i] * v.v[j] - u.v[j] * v.v[i], u.size * v.size, (u.size + u.off) * (v.size + v.off),
                        2);
  }

  /// A triangle stays a triangle, a segment a segment.
  bool stays(const Cell& cell) const {
    const auto& [a, b, c] = cell.points;
    if (cell.size == 1) return true;
    if (cell.size == 2) {
      const Vector v = vector(a, b);
      return v.size > v.off;
    }
    return is_triangle(a, b, c);
  }

  bool is_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (side_along(axis, a, b, c) != 0) return true;
    }
    return false;
  }

  static bool has(const Cell& cell, std::uint32_t p) {
    return std::ranges::find(cell.corners(), p) != cell.corners().end();
  }

  /// A plane through points of `on` parts the cells: `on` is on one side of it, `other` on the other side but for
  /// shared points. `side_of` gives the side of a point that is not one of `through`.
  template <class Side>
  static bool parts(std::span<const std::uint32_t> through, const Cell& on, const Cell& other,
                    const Side& side_of) {
    const auto is_through = [&](std::uint32_t p) { return std::ranges::find(through, p) != through.end(); };
    int of_on = 0;
    for (const std::uint32_t p : on.corners()) {
      if (is_through(p)) continue;
      of_on = side_of(p);
      if (of_on == 0) return false;
    }
    for (const std::uint32_t p : other.corners()) {
      if (is_through(p)) continue;
      const int s = side_of(p);
      if (s == 0 || s == of_on) return false;
      of_on = -s;
    }
    return true;
  }

  bool parted_by(const Cell& on, const Cell& other) const {
    if (on.size == 3) {
      const auto& t = on.points;
      if (parts(on.corners(), on, other, [&](std::uint32_t p) { return side(t[0], t[1], t[2], p); })) return true;
    }
    if (on.size == 1) return false;
    for (std::size_t s = 0; s < (on.size == 3 ? 3u : 1u); ++s) {
      const std::array<std::uint32_t, 2> through{on.points[s], on.points[(s + 1) % on.size]};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (parts(through, on, other,
                  [&](std::uint32_t p) { return side_along(axis, through[0], through[1], p); }))
          return true;
      }
      // Through a corner of the other, too, which is not on the line of the side: `other` has it in the plane,
      // `on` has the side there, and these meet in nothing but an end of the side that is shared.
      for (const std::uint32_t corner : other.corners()) {
        if (has(on, corner) || !is_triangle(through[0], through[1], corner)) continue;
        const std::array<std::uint32_t, 3> plane{through[0], through[1], corner};
        if (parts(plane, on, other, [&](std::uint32_t p) { return side(plane[0], plane[1], plane[2], p); }))
          return true;
      }
    }
    return false;
  }

  /// Whether the two meet all the time in nothing but the points that they share and what these span.
  bool apart(const Cell& a, const Cell& b) const {
    const auto inside = [](const Cell& x, const Cell& y) {
      return std::ranges::all_of(x.corners(), [&](std::uint32_t p) { return has(y, p); });
    };
    if (inside(a, b) || inside(b, a)) return a.size != b.size;
    return parted_by(a, b) || parted_by(b, a);
  }
};

}  // namespace

bool is_surely_faithful(const RoundedPoints& points, const Drawing& drawing) {
  require(points.reach.size() == points.xyz.size(), "slight moves: nobody knows how far the points have moved");
  return Movement(points, drawing).is_harmless();
}

}  // namespace cnrg
