// Marks first, since even steps give way to them.
#include "csg/carriers/common_circles.h"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {

namespace {

/// From the centre, by a factor.
RationalPoint scaled_point(const CircleInSpace& circle, const RationalPoint& p, const Rational& by) {
  return circle.center + by * (p - circle.center);
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

}  // namespace cnrg
