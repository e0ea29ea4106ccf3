#include "bench/witness/integral.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cnrg::bench::witness {
namespace {

using Place = std::array<Number, 2>;
using Polygon = std::vector<Place>;  // convex, counter-clockwise

struct Box {
  std::array<double, 2> low, high;
  bool meets(const Box& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1];
  }
};

/// Rounded outwards.
Box box_of(const Polygon& polygon) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box box{{kFar, kFar}, {-kFar, -kFar}};
  for (const Place& p : polygon)
    for (int k = 0; k < 2; ++k) {
      const double x = p[k].get_d();
      box.low[k] = std::min(box.low[k], std::nextafter(x, -kFar));
      box.high[k] = std::max(box.high[k], std::nextafter(x, kFar));
    }
  return box;
}

/// A triangle that is not vertical, as seen from above.
struct Roof {
  Polygon polygon;
  Box box;
  Number dx, dy, height;  ///< z = dx x + dy y + height
  int sign = 0;           ///< 1: its outer side is above
  std::size_t words = 0;  ///< of its numbers
  Number at(const Place& p) const { return dx * p[0] + dy * p[1] + height; }
};

std::size_t words_of(const Number& x) { return mpz_size(x.get_num_mpz_t()) + mpz_size(x.get_den_mpz_t()); }

Number turn(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

std::vector<Roof> roofs_of(const Cycle& cycle) {
  std::vector<Roof> roofs;
  for (const auto& t : cycle.triangles) {
    const Point &a = cycle.points[t[0]], &b = cycle.points[t[1]], &c = cycle.points[t[2]];
    Roof roof;
    roof.polygon = {{a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]}};
    const Number twice = turn(roof.polygon[0], roof.polygon[1], roof.polygon[2]);
    roof.sign = sgn(twice);
    if (roof.sign == 0) continue;
    const Number ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
    const Number vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
    roof.dx = (uz * vy - uy * vz) / twice;
    roof.dy = (ux * vz - uz * vx) / twice;
    roof.height = a[2] - roof.dx * a[0] - roof.dy * a[1];
    if (roof.sign < 0) std::swap(roof.polygon[1], roof.polygon[2]);
    roof.box = box_of(roof.polygon);
    roof.words = words_of(roof.dx) + words_of(roof.dy) + words_of(roof.height);
    roofs.push_back(std::move(roof));
  }
  return roofs;
}

/// What of a convex polygon is where `value`, linear, is not negative.
template <class Value>
Polygon clipped(const Polygon& polygon, Value value) {
  std::vector<Number> values;
  for (const Place& p : polygon) values.push_back(value(p));
  if (std::none_of(values.begin(), values.end(), [](const Number& v) { return sgn(v) < 0; })) return polygon;
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t k = (i + 1) % polygon.size();
    if (sgn(values[i]) >= 0) part.push_back(polygon[i]);
    if (sgn(values[i]) * sgn(values[k]) >= 0) continue;
    const Number along = values[i] / (values[i] - values[k]);
    part.push_back({polygon[i][0] + along * (polygon[k][0] - polygon[i][0]),
                    polygon[i][1] + along * (polygon[k][1] - polygon[i][1])});
  }
  if (part.size() < 3) part.clear();
  return part;
}

Polygon common(Polygon polygon, const Polygon& other) {
  for (std::size_t i = 0; i < other.size() && !polygon.empty(); ++i) {
    const Place &a = other[i], &b = other[(i + 1) % other.size()];
    polygon = clipped(polygon, [&](const Place& p) { return turn(a, b, p); });
  }
  return polygon;
}

/// Adds in pairs of equal size.
class Sum {
 public:
  void add(const Number& value, int factor) {
    Fraction carry{value.get_num() * factor, value.get_den()};
    for (std::size_t level = 0;; ++level) {
      if (level == levels_.size()) levels_.emplace_back();
      std::optional<Fraction>& here = levels_[level];
      if (!here) {
        here = std::move(carry);
        return;
      }
      carry = plus(*here, carry);
      here.reset();
    }
  }
  Fraction total() const {
    Fraction all;
    for (const std::optional<Fraction>& part : levels_)
      if (part) all = plus(all, *part);
    return all;
  }

 private:
  static Fraction plus(const Fraction& a, const Fraction& b) {
    if (a.q == b.q) return {a.p + b.p, a.q};
    return {a.p * b.q + b.p * a.q, a.q * b.q};
  }
  std::vector<std::optional<Fraction>> levels_;
};

/// Sums over the roofs of several cycles, taken together; the last level of each chain is counted.
class Integrator {
 public:
  explicit Integrator(std::size_t most) : left_(most) {}

  /// The integral over the polygon of the lowest of the roofs, times the factor.
  void add(const Polygon& polygon, const std::vector<const Roof*>& roofs, int factor) {
    for (std::size_t i = 0; i < roofs.size(); ++i) {
      Polygon part = polygon;
      for (std::size_t k = 0; k < roofs.size() && !part.empty(); ++k) {
        if (k == i) continue;
        const Number dx = roofs[k]->dx - roofs[i]->dx, dy = roofs[k]->dy - roofs[i]->dy,
                     height = roofs[k]->height - roofs[i]->height;
        if (sgn(dx) == 0 && sgn(dy) == 0) {  // one is lower everywhere; of equal ones the first
          if (sgn(height) < 0 || (sgn(height) == 0 && k < i)) part.clear();
          continue;
        }
        part = clipped(part, [&](const Place& p) { return Number(dx * p[0] + dy * p[1] + height); });
      }
      for (std::size_t v = 2; v < part.size(); ++v)
        sum_.add(turn(part[0], part[v - 1], part[v]) *
                     (roofs[i]->at(part[0]) + roofs[i]->at(part[v - 1]) + roofs[i]->at(part[v])) / 6,
                 factor);
    }
  }

  /// What a polygon has in common with each roof of a list; false: too much work.
  template <class Work>
  bool each(const Polygon& polygon, const std::vector<Roof>& roofs, Work work) {
    const Box box = box_of(polygon);
    const std::size_t words = words_of(polygon[0][0]) + words_of(polygon[0][1]);
    for (const Roof& roof : roofs) {
      if (!roof.box.meets(box)) continue;
      const std::size_t steps = 1 + words * roof.words / 16;
      if (steps > left_) return false;
      left_ -= steps;
      const Polygon part = common(polygon, roof.polygon);
      if (!part.empty() && !work(roof, part)) return false;
    }
    return true;
  }

  bool add_products(const std::vector<const std::vector<Roof>*>& cycles, const Polygon& polygon,
                    std::vector<const Roof*>& chosen, int factor) {
    if (chosen.size() == cycles.size()) {
      add(polygon, chosen, factor);
      return true;
    }
    return each(polygon, *cycles[chosen.size()], [&](const Roof& roof, const Polygon& part) {
      chosen.push_back(&roof);
      const bool done = add_products(cycles, part, chosen, factor * roof.sign);
      chosen.pop_back();
      return done;
    });
  }

  /// Adds the integral of the product of their winding numbers, times the factor.
  bool add(const std::vector<const std::vector<Roof>*>& cycles, int factor) {
    for (const Roof& roof : *cycles[0]) {
      std::vector<const Roof*> chosen{&roof};
      if (!add_products(cycles, roof.polygon, chosen, factor * roof.sign)) return false;
    }
    return true;
  }

  Fraction total() const { return sum_.total(); }
  void restart() { sum_ = {}; }

 private:
  std::size_t left_;
  Sum sum_;
};

double rounded(const Fraction& f) {
  mpf_class p(f.p, 64), q(f.q, 64);
  return mpf_class(p / q).get_d();
}

}  // namespace

std::optional<Fraction> integral(const std::vector<const Cycle*>& cycles, std::size_t most) {
  std::vector<std::vector<Roof>> roofs;
  for (const Cycle* cycle : cycles) roofs.push_back(roofs_of(*cycle));
  std::vector<const std::vector<Roof>*> lists;
  for (const auto& list : roofs) lists.push_back(&list);
  Integrator sums(most);
  if (!sums.add(lists, 1)) return {};
  return sums.total();
}

std::optional<Distance> distance(const Cycle& a, Operation operation, const Cycle& b, const Cycle& answer,
                                 std::size_t most) {
  const std::vector<Roof> of_a = roofs_of(a), of_b = roofs_of(b), of_answer = roofs_of(answer);
  Integrator sums(most);
  Distance result;
  result.operands_once = true;
  for (const auto* operand : {&of_a, &of_b}) {  // w^2 - w is zero for 0 and 1, and positive for all other windings
    sums.restart();
    if (!sums.add({operand, operand}, 1) || !sums.add({operand}, -1)) return {};
    result.operands_once = result.operands_once && sums.total().p == 0;
  }
  // f = a x + b y + ab z
  const int x = operation == Operation::intersect ? 0 : 1, y = operation == Operation::unite ? 1 : 0,
            z = operation == Operation::intersect ? 1 : -1;
  sums.restart();
  bool done = sums.add({&of_answer, &of_answer}, 1) && sums.add({&of_a, &of_b, &of_answer}, -2 * z) &&
              sums.add({&of_a, &of_b}, z);
  if (x != 0) done = done && sums.add({&of_a, &of_answer}, -2) && sums.add({&of_a}, 1);
  if (y != 0) done = done && sums.add({&of_b, &of_answer}, -2) && sums.add({&of_b}, 1);
  if (!done) return {};
  const Fraction total = sums.total();
  result.zero = total.p == 0;
  result.value = rounded(total);
  return result;
}

}  // namespace cnrg::bench::witness
