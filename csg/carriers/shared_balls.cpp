// Which balls are hulls, and of what.
#include "csg/carriers/shared_balls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

// Marks first, since even steps give way to them.

/// From the centre, by a factor.
RationalPoint scaled_point(const CircleInSpace& circle, const RationalPoint& p, const Rational& by) {
  return circle.center + by * (p - circle.center);
}

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

void CommonCircles::add(const CircleInSpace& circle, Part part) {
  Circle& of =
      circles_.try_emplace(circle, Circle{circle, {}, PointLattice(circle.center, circle.radius)}).first->second;
  Family& family = *part.family;
  if (part.direction) family.add_direction(*part.direction);
  else family.add_circle(part.member, {part.radius, family.axis().place_of(circle.center)});
  of.parts.push_back(std::move(part));
}

bool CommonCircles::exchange() {
  for (auto& [place, circle] : circles_) {
    // The order of the leaves is none; that of their axes is.
    std::stable_sort(circle.parts.begin(), circle.parts.end(), [](const Part& a, const Part& b) {
      return std::tie(a.family->axis(), a.direction) < std::tie(b.family->axis(), b.direction);
    });
  }
  for (const bool marks : {true, false}) {
    bool changed = false;
    for (auto& [place, circle] : circles_) changed = exchange(circle, marks) || changed;
    if (changed) return true;
  }
  bool changed = false;
  for (auto& [place, circle] : circles_) changed = grade(circle) || changed;
  return changed;
}

std::vector<RationalPoint> CommonCircles::points(const Circle& circle, const Part& part, bool marks) const {
  const Family& family = *part.family;
  std::vector<RationalPoint> result;
  if (part.direction) {
    const AxisLine& axis = family.axis();
    const MeridianPoint middle{dot(circle.place.center - axis.foot, *part.direction),
                               axis.place_of(circle.place.center)};
    for (const MeridianPoint& p : family.vertices(middle, part.radius, marks)) {
      const RationalPoint at = axis.foot + p.t * axis.direction + p.r * *part.direction;
      result.push_back(scaled_point(circle.place, at, circle.place.radius / part.radius));
    }
  } else {
    for (const RationalPoint& d : family.turns().directions(marks))
      result.push_back(circle.place.center + circle.place.radius * d);
  }
  return result;
}

bool CommonCircles::exchange(Circle& circle, bool marks) const {
  bool changed = false;
  for (std::size_t from = 0; from < circle.parts.size(); ++from) {
    for (const RationalPoint& p : points(circle, circle.parts[from], marks)) {
      if (!circle.known.add(p)) continue;
      for (std::size_t to = 0; to < circle.parts.size(); ++to) {
        if (to == from) continue;
        changed = true;
        const auto& [family, member, radius, direction] = circle.parts[to];
        if (!direction) {
          family->add_other_direction((1 / circle.place.radius) * (p - circle.place.center));
          continue;
        }
        const RationalPoint own = scaled_point(circle.place, p, radius / circle.place.radius);
        family->add_circle(member, {dot(own - family->axis().foot, *direction), family->axis().place_of(own)});
      }
    }
  }
  if (!changed) return false;
  for (const Part& part : circle.parts) part.family->solve_meridians();
  return true;
}

bool CommonCircles::grade(Circle& circle) const {
  const double tube = to_double(circle.place.radius);
  double row = HUGE_VAL;
  for (const Part& part : circle.parts) {
    if (part.direction) continue;
    const MeridianPoint middle{0, part.family->axis().place_of(circle.place.center)};
    for (const MeridianPoint& p : part.family->vertices(middle, circle.place.radius, false)) {
      if (p.t != middle.t) row = std::min(row, rounded::arc_cosine(std::min(1.0, to_double(p.r) / tube)));
    }
  }
  if (row == HUGE_VAL) return false;
  // Directions around the axis of the circle, in their order.
  std::vector<double> turns;
  std::vector<RationalPoint> corners;
  for (const Part& part : circle.parts) {
    if (corners.empty()) corners = points(circle, part, false);
  }
  const CircleFrame frame(circle.place.axis);
  for (const RationalPoint& p : corners) {
    const RationalPoint off = p - circle.place.center;
    const auto along = [&](const RationalPoint& e) {
      return to_double(dot(off, e)) / std::sqrt(to_double(dot(e, e)));
    };
    turns.push_back(rounded::arc_tangent(along(frame.second()), along(frame.first())));
  }
  std::sort(turns.begin(), turns.end());
  double narrow = 2 * std::numbers::pi, wide = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double gap = i > 0 ? turns[i] - turns[i - 1] : turns[0] + 2 * std::numbers::pi - turns.back();
    narrow = std::min(narrow, gap);
    wide = std::max(wide, gap);
  }
  row = std::min(row, narrow / 2);  // of a hull, which has no rows
  if (row > 0.99 * circle.first_row) return false;
  circle.first_row = row;
  bool changed = false;
  for (const Part& part : circle.parts) {
    if (!part.direction || part.radius != circle.place.radius) continue;
    const AxisLine& axis = part.family->axis();
    const double out = to_double(dot(circle.place.center - axis.foot, *part.direction));
    const double margin = tube * ((out + tube) * rounded::cosine(wide / 2) - tube);
    if (margin <= 0) continue;
    const double most = 2 * std::sqrt(margin) / (out + tube), reach = rounded::arc_sine(tube / out);
    const RationalPoint across = cross(axis.direction, *part.direction);
    const Rational unit = root(1 / dot(across, across));
    for (double angle = 0; angle < reach;) {
      const double latitude =
          std::max(row, rounded::arc_sine(std::min(1.0, out * rounded::tangent(angle) / tube)));
      angle += most * latitude / 2;
      const Rational half = from_double(rounded::tangent(angle / 2)), whole = 1 + half * half;
      for (const int sign : {1, -1}) {
        part.family->add_other_direction(Rational((1 - half * half) / whole) * *part.direction +
                                         Rational(sign * 2 * half * unit / whole) * across);
      }
      changed = true;
    }
  }
  return changed;
}

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
