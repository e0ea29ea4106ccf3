// Lines, similarities, and meridians under them.
#include "csg/carriers/axes.h"

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

/// 0 for directions in [0, 180) degrees from `first`, 1 for the others.
int half_from(const RationalPoint& first, const RationalPoint& d, const RationalPoint& axis) {
  const int side = sgn(dot(cross(first, d), axis));
  return side > 0 || (side == 0 && dot(first, d) > 0) ? 0 : 1;
}

/// Negative if a comes before b, counter-clockwise from `first`.
int compare_from(const RationalPoint& first, const RationalPoint& a, const RationalPoint& b,
                 const RationalPoint& axis) {
  const int half_a = half_from(first, a, axis), half_b = half_from(first, b, axis);
  return half_a != half_b ? half_a - half_b : -sgn(dot(cross(a, b), axis));
}

bool inside(const Sector& sector, const RationalPoint& d, const RationalPoint& axis) {
  return !same_ray(d, sector.from) && compare_from(sector.from, d, sector.to, axis) < 0;
}

}  // namespace

bool same_ray(const RationalPoint& a, const RationalPoint& b) { return is_zero(cross(a, b)) && dot(a, b) > 0; }

bool overlap(const Sector& a, const Sector& b, const RationalPoint& axis) {
  if (a.whole || b.whole || same_ray(a.from, b.from) || same_ray(a.to, b.to)) return true;
  return inside(a, b.from, axis) || inside(a, b.to, axis) || inside(b, a.from, axis) || inside(b, a.to, axis);
}

bool meet(const Sector& a, const Sector& b, const RationalPoint& axis) {
  return overlap(a, b, axis) || same_ray(a.from, b.to) || same_ray(a.to, b.from);
}

Rational AxisLine::place_of(const RationalPoint& p) const {
  return dot(p - foot, direction) / dot(direction, direction);
}

bool AxisLine::holds(const RationalPoint& p) const { return is_zero(cross(p - foot, direction)); }

AxisLine axis_line(const RationalPoint& point, const RationalPoint& direction) {
  const std::array<Integer, 3> p = primitive_direction(direction);
  AxisLine line;
  line.direction = {p[0], p[1], p[2]};
  if (line.direction < RationalPoint{0, 0, 0}) line.direction = Rational(-1) * line.direction;
  const Rational part = dot(point, line.direction) / dot(line.direction, line.direction);
  line.foot = point - part * line.direction;
  return line;
}

std::optional<Rational> squared_stretch(const Transform& transform) {
  const auto& rows = transform.linear;
  const Rational square = dot(rows[0], rows[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(rows[i], rows[i]) != square || dot(rows[i], rows[(i + 1) % 3]) != 0) return std::nullopt;
  }
  return square;
}

std::optional<Rational> stretch(const Transform& transform) {
  const std::optional<Rational> square = squared_stretch(transform);
  return square ? rational_root(*square) : std::nullopt;
}

Rational PlacedForm::square() const { return dot(axis.direction, axis.direction); }

PlacedForm place(const RevolvedForm& form, const Transform& transform, const Rational& scale) {
  PlacedForm placed;
  const RationalPoint center = transform.apply(form.center), along = transform.apply_to_vector(form.axis);
  placed.axis = axis_line(center, along);
  const RationalPoint& direction = placed.axis.direction;
  const Rational first = placed.axis.place_of(center), step = dot(along, direction) / dot(direction, direction);
  placed.along = step > 0;
  placed.mirrored = transform.determinant() < 0;
  const auto image = [&](const MeridianPoint& p) { return MeridianPoint{scale * p.r, first + step * p.t}; };
  for (const auto& line : form.lines) {
    placed.lines.emplace_back();
    for (MeridianPiece piece : line) {
      piece.from = image(piece.from);
      piece.to = image(piece.to);
      piece.middle = image(piece.middle);
      piece.radius *= scale;
      if (!placed.along) {
        piece.start = -piece.start;
        piece.sweep = -piece.sweep;
      }
      for (Homogeneous& h : piece.net.net) {
        h[0] *= scale;
        h[2] = first * h[3] + step * h[2];
      }
      placed.lines.back().push_back(std::move(piece));
    }
  }
  const CircleFrame frame(form.axis);
  placed.start = (1 / scale) * transform.apply_to_vector(frame.offset(1, 0));
  placed.end = form.around() ? placed.start : (1 / scale) * transform.apply_to_vector(frame.turned(form.degrees));
  return placed;
}

RevolvedForm sphere_about(const Ball& ball, const RationalPoint& axis, const RevolvedForm& like) {
  RevolvedForm form = like;
  form.center = ball.center;
  form.axis = axis;
  MeridianPiece& meridian = form.lines[0][0];
  const Rational reach = scaled_cosine(0, ball.radius * ball.radius / dot(axis, axis));
  meridian.from = {0, -reach};
  meridian.to = {0, reach};
  meridian.middle = {0, 0};
  meridian.radius = ball.radius;
  return form;
}

}  // namespace cnrg
