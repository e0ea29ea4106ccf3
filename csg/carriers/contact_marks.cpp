// Each mark is added once, and only if the leaf does not have it already.
#include "csg/carriers/contact_marks.h"

#include <algorithm>
#include <cmath>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

AboutAxis about_axis(const AxisLine& axis, const RationalPoint& p) {
  const Rational t = axis.place_of(p);
  const RationalPoint out = p - (axis.foot + t * axis.direction);
  const std::optional<Rational> r = rational_root(dot(out, out));
  if (!r || *r == 0) return {{0, t}, std::nullopt};
  return {{*r, t}, Rational(1 / *r) * out};
}

bool ContactMarks::has_vertex(const RoundLeaf& round, const RationalPoint& p) const {
  const auto* leaf = dynamic_cast<const GeometryLeaf*>(instances_[round.instance()].leaf.get());
  if (leaf == nullptr) return false;
  const RationalPoint own = round.transform().inverse().apply(p);
  const std::array<double, 3> rough = to_doubles(own);
  const Soup& soup = leaf->geometry();
  for (const PointId v : IdRange<PointId>(soup.point_count())) {
    const double* x = soup.xyz(v);
    if (std::abs(x[0] - rough[0]) + std::abs(x[1] - rough[1]) + std::abs(x[2] - rough[2]) >
        1e-9 * (std::abs(rough[0]) + std::abs(rough[1]) + std::abs(rough[2])))
      continue;
    if (exact_value(soup, v) == own) return true;
  }
  return false;
}

void ContactMarks::mark_point(const RoundLeaf& round, const RationalPoint& at) {
  TangencyMarks& marks = marks_[round.instance()];
  if (std::find(marks.points.begin(), marks.points.end(), at) != marks.points.end()) return;
  marks.points.push_back(at);
  marks.needed = marks.needed || !has_vertex(round, at);
}

bool ContactMarks::mark_ring(const RoundLeaf& round, const RationalPoint& at) {
  const auto [place, direction] = about_axis(round.exact().placed.axis, at);
  if (!direction || !round.holds(place, *direction)) return false;
  mark_point(round, at);
  return true;
}

void ContactMarks::mark_direction(const RoundLeaf& round, const RationalPoint& direction, const Tube& tube) {
  const auto end = [&](const Rational& t) { return tube.foot + t * tube.axis + tube.radius * direction; };
  if (tube.low == tube.high) mark_point(round, end(tube.low));
  else mark_line(round, direction, end(tube.low), end(tube.high));
}

void ContactMarks::mark_line(const RoundLeaf& round, const RationalPoint& direction, const RationalPoint& p,
                             const RationalPoint& q) {
  TangencyMarks& marks = marks_[round.instance()];
  if (std::find(marks.directions.begin(), marks.directions.end(), direction) != marks.directions.end()) return;
  marks.directions.push_back(direction);
  marks.needed = marks.needed || !has_vertex(round, p) || !has_vertex(round, q);
}

void ContactMarks::mark_rim(const RoundLeaf& round, const RationalPoint& at) {
  for (const Tube& tube : round.exact().tubes) {
    const Rational t = dot(at - tube.foot, tube.axis) / dot(tube.axis, tube.axis);
    const RationalPoint off = at - (tube.foot + t * tube.axis);
    if (t < tube.low || t > tube.high || dot(off, off) != tube.radius * tube.radius) continue;
    mark_direction(round, Rational(1 / tube.radius) * off, tube);
  }
}

void ContactMarks::mark_circle(const RoundLeaf& round, const MeridianPoint& at) {
  const PlacedForm& placed = round.exact().placed;
  TangencyMarks& marks = marks_[round.instance()];
  marks.circles.push_back(at);
  marks.needed =
      marks.needed || !has_vertex(round, placed.axis.foot + at.t * placed.axis.direction + at.r * placed.start);
}

}  // namespace cnrg
