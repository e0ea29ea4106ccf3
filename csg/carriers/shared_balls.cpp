// Which balls are hulls, and of what.
#include "csg/carriers/shared_balls.h"

#include <cmath>
#include <cstdint>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

void cross_two(const Ball& ball, Family& a, const MeridianPoint& p, Family& b, const MeridianPoint& q) {
  const RationalPoint &n = a.axis().direction, &m = b.axis().direction, line = cross(n, m);
  const RationalPoint on_a = a.axis().foot + p.t * n, on_b = b.axis().foot + q.t * m;
  // c + x n + y m lies in both planes; from there the circles cross along the line.
  const Rational nn = dot(n, n), mm = dot(m, m), nm = dot(n, m), whole = nn * mm - nm * nm;
  const Rational ga = dot(on_a - ball.center, n), gb = dot(on_b - ball.center, m);
  const RationalPoint foot = Rational((ga * mm - gb * nm) / whole) * n + Rational((gb * nn - ga * nm) / whole) * m;
  const Rational square = (ball.radius * ball.radius - dot(foot, foot)) / dot(line, line);
  if (square < 0) return;
  const std::optional<Rational> reach = rational_root(square);
  if (!reach || p.r * p.r * nn == 0 || q.r == 0) return;
  for (const int sign : {1, -1}) {
    const RationalPoint at = ball.center + foot + Rational(sign * *reach) * line;
    a.add_direction((1 / p.r) * (at - on_a));
    b.add_direction((1 / q.r) * (at - on_b));
    if (*reach == 0) return;
  }
}

RationalPoint contact_of(const Ball& inner, const Ball& outer) {
  return inner.center + Rational(inner.radius / (outer.radius - inner.radius)) * (inner.center - outer.center);
}

/// The corners of the inner ball as they are on the outer one, and the ring around the contact.
void add_images(const Ball& inner, const std::vector<RationalPoint>& corners, const Ball& outer,
                std::vector<RationalPoint>& points) {
  const RationalPoint at = contact_of(inner, outer);
  const Rational scale = outer.radius / inner.radius;
  double nearest = HUGE_VAL;
  for (const RationalPoint& p : corners) {
    const RationalPoint off = scale * (p - at);
    if (is_zero(off)) continue;
    points.push_back(at + off);
    nearest = std::min(nearest, to_double(dot(off, off)));
  }
  // At a quarter of the way the pyramid over a ring of eight is flatter than any edge from the contact.
  constexpr int kRing = 8;
  const RationalPoint up = Rational(1 / outer.radius) * (at - outer.center);
  const CircleFrame frame(up);
  const Rational tangent = from_double(std::sqrt(nearest) / (8 * to_double(outer.radius))),
                 whole = 1 + tangent * tangent;
  for (int k = 0; k < kRing; ++k) {
    points.push_back(outer.center + outer.radius * (Rational((1 - tangent * tangent) / whole) * up +
                                                    Rational(2 * tangent / whole) *
                                                        frame.offset(1, fraction(std::int64_t{360} * k, kRing))));
  }
}

}  // namespace

void SharedBalls::add(const Ball& ball, Family& family, std::size_t member,
                      const std::vector<RationalPoint>& points) {
  Shared& shared = balls_[ball];
  shared.places.push_back({&family, member});
  shared.points.insert(shared.points.end(), points.begin(), points.end());
}

std::shared_ptr<const BallHull> SharedBalls::hull(const Ball& ball) const {
  const auto found = hulls_.find(ball);
  return found == hulls_.end() ? nullptr : found->second;
}

void SharedBalls::add_lines(const Ball& ball, const ExtraLines& lines) {
  const auto of = lines.of.find(0);
  if (of == lines.of.end()) return;
  Shared& shared = balls_.at(ball);
  for (const Rational& u : of->second[0]) shared.lines[0].insert(within_one(u));
  each_between(of->second[1], {0, 1}, [&](const Rational& v) { shared.lines[1].insert(v); });
  shared.lines[0].erase(0);
}

void SharedBalls::choose() {
  std::sort(nested_.begin(), nested_.end(), [](const Nested& a, const Nested& b) {
    return a.inner.radius != b.inner.radius ? a.inner.radius < b.inner.radius : a.inner < b.inner;
  });
  std::set<Ball> hulls;
  for (const auto& [ball, shared] : balls_) {
    if (shared.places.size() > 1) hulls.insert(ball);
  }
  for (const Nested& pair : nested_) {
    if (hulls.contains(pair.inner)) hulls.insert(pair.outer);
  }
  by_size_.assign(hulls.begin(), hulls.end());
  std::stable_sort(by_size_.begin(), by_size_.end(),
                   [](const Ball& a, const Ball& b) { return a.radius < b.radius; });
}

void SharedBalls::solve(const std::function<void()>& solve_turns) {
  for (const Ball& ball : by_size_) cross_circles(balls_.at(ball).places, ball);
  constexpr int kMostRounds = 8;
  for (int round = 0;; ++round) {
    solve_turns();
    bool missed = false;
    for (const Ball& ball : by_size_) {
      const Parts parts = parts_of(ball);
      auto hull = std::make_shared<const BallHull>(
          hull_of(ball, parts.circles, parts.points, parts.others, parts.around, parts.up));
      hulls_[ball] = hull;
      if (round == kMostRounds) continue;
      // A chord of a circle that is no edge of the hull is halved, for all leaves about this axis.
      for (const auto& [c, i] : hull->missed) {
        const SphereCircle& circle = parts.circles[c];
        Family& family = *parts.family[c];
        const RationalPoint middle = Rational(1, 2) * (circle[i] + circle[(i + 1) % circle.size()]);
        const RationalPoint out =
            middle - (family.axis().foot + family.axis().place_of(middle) * family.axis().direction);
        family.add_direction((1 / root(dot(out, out))) * out);
        missed = true;
      }
    }
    if (!missed) return;
  }
}

/// The points where shared circles of one ball cross become corners of both, where they are rational.
void SharedBalls::cross_circles(const std::vector<Place>& places, const Ball& ball) const {
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Family &a = *places[i].family, &b = *places[j].family;
      for (const MeridianPoint& p : a.shared_circles(places[i].member)) {
        for (const MeridianPoint& q : b.shared_circles(places[j].member)) cross_two(ball, a, p, b, q);
      }
    }
  }
}

std::vector<RationalPoint> SharedBalls::corners(const Ball& ball) const {
  if (const auto of = hull(ball)) return of->points;
  const Place& place = balls_.at(ball).places.front();
  return place.family->corners(place.member);
}

SharedBalls::Parts SharedBalls::parts_of(const Ball& ball) const {
  const Shared& shared = balls_.at(ball);
  Parts parts;
  parts.points = shared.points;
  parts.around.lines = shared.lines[0];
  parts.up.lines = shared.lines[1];
  for (const auto& [family, member] : shared.places) {
    for (const MeridianPoint& p : family->shared_circles(member)) {
      parts.circles.push_back(family->circle(p));
      parts.family.push_back(family);
    }
    const Member& of = family->members()[member];
    parts.around.even = std::max(parts.around.even, of.segments);
    parts.up.even = std::max(parts.up.even, of.placed.lines[0][0].steps);
  }
  for (const Nested& pair : nested_) {
    if (pair.inner != ball && pair.outer != ball) continue;
    parts.points.push_back(contact_of(pair.inner, pair.outer));
    if (pair.outer == ball) add_images(pair.inner, corners(pair.inner), ball, parts.others);
  }
  return parts;
}

}  // namespace cnrg
