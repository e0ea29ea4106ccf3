#include "bench/witness/points.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace cnrg::bench::witness {
namespace {

class Asker {
 public:
  explicit Asker(const Question& question) : q_(question), random_(question.seed), answer_(question.answer) {
    for (const Cycle& operand : q_.operands) operands_.emplace_back(operand);
    for (const Cycle& operand : q_.operands) take(operand);
    take(q_.answer);
  }

  Points run(std::size_t count) {
    for (std::size_t i = 0; i < count && !corners_.empty() && !result_.differs; ++i) {
      constexpr int kTries = 4;
      for (int tries = 0; tries < kTries; ++tries)
        if (ask(i % 2 == 0 ? anywhere() : at_a_face())) break;
    }
    return result_;
  }

 private:
  void take(const Cycle& cycle) {
    if (!cycle.triangles.empty()) cycles_.push_back(&cycle);
    for (const Point& p : cycle.points) {
      corners_.push_back(&p);
      extent_ = std::max({extent_, std::fabs(p[0].get_d()), std::fabs(p[1].get_d()), std::fabs(p[2].get_d())});
    }
  }

  /// From 0 to 1, of 32 bits.
  Number part() { return Number(std::ldexp(static_cast<double>(random_() >> 32), -32)); }
  std::size_t below(std::size_t count) { return random_() % count; }

  /// Of the box of two corners, one of them often far away: boxes of all would miss small parts.
  Point anywhere() {
    const Point &a = *corners_[below(corners_.size())], &b = *corners_[below(corners_.size())];
    Point p;
    for (int k = 0; k < 3; ++k) p[k] = a[k] + (b[k] - a[k]) * part() + Number(extent_ / 64) * (part() - part());
    return p;
  }

  /// Off a random place of a random triangle, by a length from beyond the rounding on.
  Point at_a_face() {
    const Cycle& cycle = *cycles_[below(cycles_.size())];
    const auto& t = cycle.triangles[below(cycle.triangles.size())];
    const Point &a = cycle.points[t[0]], &b = cycle.points[t[1]], &c = cycle.points[t[2]];
    Number u = part(), v = part();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    std::array<double, 3> d, e;
    Point p;
    for (int k = 0; k < 3; ++k) {
      p[k] = a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]);
      d[k] = Number(b[k] - a[k]).get_d();
      e[k] = Number(c[k] - a[k]).get_d();
    }
    const std::array n{d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0 && std::isfinite(length))) return p;
    const double near = std::max(2 * q_.rounding.get_d(), extent_ * 0x1p-60);
    const int steps = std::max(1, std::ilogb(extent_ / near) - 2);
    const double offset =
        std::ldexp(near, static_cast<int>(below(static_cast<std::size_t>(steps)))) * (random_() % 2 == 0 ? 1 : -1);
    for (int k = 0; k < 3; ++k) p[k] += Number(n[k] / length * offset);
    return p;
  }

  /// False: no answer here.
  bool ask(const Point& p) {
    std::vector<bool> in;
    for (const Locator& operand : operands_) {
      if (operand.may_be_near(p, q_.rounding)) return false;
      const std::optional<int> winding = operand.winding(p);
      if (!winding) return false;
      in.push_back(*winding != 0);
    }
    const std::optional<int> found = answer_.winding(p);
    if (!found) return false;
    bool expected = in[0];
    for (std::size_t i = 0; i < q_.steps.size(); ++i) {
      const bool right = in[i + 1];
      switch (q_.steps[i]) {
        case Operation::unite: expected = expected || right; break;
        case Operation::subtract: expected = expected && !right; break;
        case Operation::intersect: expected = expected && right; break;
      }
    }
    ++result_.asked;
    if (*found != (expected ? 1 : 0)) {
      result_.differs = p;
      result_.winding = *found;
      result_.expected = expected;
    }
    return true;
  }

  const Question& q_;
  std::mt19937_64 random_;
  std::vector<Locator> operands_;
  Locator answer_;
  std::vector<const Cycle*> cycles_;
  std::vector<const Point*> corners_;
  double extent_ = 0;
  Points result_;
};

}  // namespace

Points ask(const Question& question, std::size_t count) { return Asker(question).run(count); }

}  // namespace cnrg::bench::witness
