// Distances from the circle in the middle of a torus; see the header.
#include <initializer_list>
#include <tuple>

#include "csg/certify/contact.h"
#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Kind = Contact::Kind;

/// The sign of x - sqrt(square), square >= 0.
int less_root(const Rational& x, const Rational& square) { return x < 0 ? -1 : sgn(x * x - square); }

RationalPoint part_along(const RationalPoint& v, const RationalPoint& axis) {
  return Rational(dot(v, axis) / dot(axis, axis)) * axis;
}
Contact at(const RationalPoint& p) { return {Kind::point, {0, 0, 0}, p, 0}; }
Contact circle_about(const RationalPoint& center, const RationalPoint& axis, const Rational& radius) {
  return {Kind::circle, axis, center, radius};
}

enum class Place : std::uint8_t { clear, touch, neither };
/// Whether sqrt(square + sign 2 sqrt(root2)) is more than `reach` >= 0 (with `within`: less).
Place place(const Rational& square, int sign, const Rational& root2, const Rational& reach, bool within) {
  // square - reach^2 + sign 2 root2^(1/2)
  const Rational rest = square - reach * reach;
  const int order = sign < 0 ? less_root(rest, 4 * root2) : -less_root(-rest, 4 * root2);
  return order == 0 ? Place::touch : (order > 0) != within ? Place::clear : Place::neither;
}

/// A distance of which less (with `within`) or more is clear, and where the contact is then.
struct Limit {
  Rational distance;
  bool within;
  Rational to;
};
/// Nothing, or what `meet` tells of the limit that sqrt(square) is; none where it is between them.
template <class Meet>
std::optional<Contact> by_limits(const Rational& square, std::initializer_list<Limit> limits, const Meet& meet) {
  for (const Limit& limit : limits) {
    if (limit.distance < 0) continue;
    const int order = sgn(square - limit.distance * limit.distance);
    if (order == 0) return meet(limit);
    if ((order > 0) != limit.within) return Contact{};
  }
  return std::nullopt;
}

struct Tube {  // all points at a distance from a point, or with a direction from a line
  RationalPoint point, direction{0, 0, 0};
  Rational radius;
};
/// Nothing for other quadrics and irrational radii.
std::optional<Tube> tube_of(const Quadric& q) {
  const Rational trace = q[0][0] + q[1][1] + q[2][2];
  const RationalPoint linear{q[0][3], q[1][3], q[2][3]};
  Tube tube;
  Rational scale = trace / 3;
  const auto is_form = [&] {  // scale (1 - d d' / d.d)
    const Rational square = dot(tube.direction, tube.direction);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Rational share =
            square == 0 ? Rational(0) : Rational(tube.direction[i] * tube.direction[j] / square);
        if (q[i][j] != scale * ((i == j ? 1 : 0) - share)) return false;
      }
    }
    return true;
  };
  if (trace == 0) return std::nullopt;
  if (!is_form()) {
    scale = trace / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      if (q[i][i] == scale) continue;
      for (std::size_t j = 0; j < 3; ++j) tube.direction[j] = (i == j ? scale : Rational(0)) - q[i][j];
    }
    if (!is_form() || dot(linear, tube.direction) != 0) return std::nullopt;
  }
  tube.point = Rational(-1 / scale) * linear;
  const auto radius = rational_root(dot(tube.point, tube.point) - q[3][3] / scale);
  if (!radius) return std::nullopt;
  tube.radius = *radius;
  return tube;
}

std::optional<Contact> with_ball(const Torus& torus, const RationalPoint& middle, const Rational& around_it) {
  const RationalPoint &center = torus.center, &axis = torus.axis;  // clang 14 captures no bindings
  const Rational &radius = torus.radius, &tube = torus.tube;
  const RationalPoint way = middle - center, flat = way - part_along(way, axis);
  const Rational off = dot(flat, flat), square = dot(way, way) + radius * radius, root2 = radius * radius * off;
  // The nearest or farthest point of the circle, where the distance is known, and from there to the surface.
  const auto meet = [&](int sign, const Rational& distance, const Rational& to_middle) -> std::optional<Contact> {
    const Rational share = distance == 0 ? Rational(0) : Rational(to_middle / distance);
    if (off == 0) return circle_about(center + share * way, axis, radius * (1 - share));
    const Rational root = abs(square - distance * distance) / (2 * radius);
    const RationalPoint foot = center + Rational(-sign * radius / root) * flat;
    if (distance == 0) return circle_about(middle, cross(axis, flat), tube);  // the ball fills the tube
    return at(foot + share * (middle - foot));
  };
  for (const auto& [sign, reach, within] :
       {std::tuple(-1, Rational(tube + around_it), false), std::tuple(-1, Rational(tube - around_it), true),
        std::tuple(1, Rational(around_it - tube), true)}) {
    if (reach < 0) continue;
    const Place found = place(square, sign, root2, reach, within);
    if (found == Place::clear) return Contact{};
    if (found == Place::touch) return meet(sign, reach, sign > 0 ? Rational(-tube) : tube);
  }
  return std::nullopt;
}

std::optional<Contact> with_cylinder(const Torus& torus, const Tube& cylinder) {
  const RationalPoint &center = torus.center, &axis = torus.axis;  // clang 14 captures no bindings
  const Rational &radius = torus.radius, &tube = torus.tube;
  const Rational &thick = cylinder.radius, inner = radius - tube, outer = radius + tube;
  const RationalPoint way = cylinder.point - center;
  if (is_zero(cross(cylinder.direction, axis))) {
    const RationalPoint flat = way - part_along(way, axis);
    const Rational off = dot(flat, flat);
    return by_limits(off,
                     {{outer + thick, false, outer}, {inner - thick, true, inner}, {thick - outer, true, -outer}},
                     [&](const Limit& limit) {
                       return off == 0 ? circle_about(center, axis, abs(limit.to))
                                       : at(center + Rational(limit.to / limit.distance) * flat);
                     });
  }
  if (dot(cylinder.direction, axis) != 0) return std::nullopt;
  // Along the cylinder the circle is seen as a segment.
  const RationalPoint across = cross(axis, cylinder.direction), seen = part_along(way, across);
  const Rational off = dot(seen, seen), height = dot(part_along(way, axis), part_along(way, axis));
  const Rational reach = tube + thick;
  if (off < radius * radius && height > reach * reach) return Contact{};
  const Rational square = off + height + radius * radius, root2 = radius * radius * off;
  const auto meet = [&](int sign, const Rational& distance, const Rational& to_axis) -> std::optional<Contact> {
    if (off == 0 || distance == 0) return std::nullopt;
    const Rational root = abs(square - distance * distance) / (2 * radius);
    const RationalPoint foot = center + Rational(-sign * radius / root) * seen;
    const RationalPoint ahead = cylinder.point + part_along(foot - cylinder.point, cylinder.direction);
    return at(foot + Rational(to_axis / distance) * (ahead - foot));
  };
  if (off >= radius * radius) {
    const Place found = place(square, -1, root2, reach, false);
    if (found == Place::clear) return Contact{};
    if (found == Place::touch) return meet(-1, reach, tube);
  }
  if (thick < tube) return std::nullopt;
  const Place found = place(square, 1, root2, thick - tube, true);
  if (found == Place::clear) return Contact{};
  return found == Place::touch ? meet(1, thick - tube, -tube) : std::nullopt;
}

}  // namespace

std::optional<Contact> contact(const PlaneEquation& plane, const Torus& torus) {
  const auto& [center, axis, radius, tube] = torus;
  const RationalPoint normal{plane[0], plane[1], plane[2]};
  const Rational square = dot(normal, normal), level = dot(normal, center) + plane[3];
  const RationalPoint flat = normal - part_along(normal, axis);
  // |level| against the support radius sqrt(flat.flat) + tube sqrt(square), squared twice.
  const Rational a = radius * radius * dot(flat, flat), b = tube * tube * square;
  const int order = less_root(level * level - a - b, 4 * a * b);
  if (order < 0) return std::nullopt;
  if (order > 0) return Contact{};
  if (a == 0) return circle_about(center - Rational(level / square) * normal, axis, radius);
  // Roots of a and b, with the sign of the level: their sum is the level.
  const Rational root = (level * level + a - b) / (2 * level);
  return at(center - Rational(radius * radius / root) * flat - Rational((level - root) / square) * normal);
}

std::optional<Contact> contact(const Quadric& quadric, const Torus& torus) {
  const auto tube = tube_of(quadric);
  if (!tube) return std::nullopt;
  return is_zero(tube->direction) ? with_ball(torus, tube->point, tube->radius) : with_cylinder(torus, *tube);
}

std::optional<Contact> contact(const Torus& a, const Torus& b) {
  if (!is_zero(cross(a.axis, b.axis))) return std::nullopt;
  const RationalPoint way = b.center - a.center;
  const Rational off = dot(way, way);
  if (is_zero(cross(way, a.axis))) {  // circles in a half-plane of the axis
    const Rational apart = b.radius - a.radius;
    return by_limits(
        off + apart * apart,
        {{a.tube + b.tube, false, a.tube}, {a.tube - b.tube, true, a.tube}, {b.tube - a.tube, true, -a.tube}},
        [&](const Limit& limit) -> std::optional<Contact> {
          if (limit.distance == 0) return std::nullopt;  // one surface
          const Rational share = limit.to / limit.distance;
          return circle_about(a.center + share * way, a.axis, a.radius + share * apart);
        });
  }
  if (dot(way, a.axis) != 0) return std::nullopt;
  // Rings seen along the axes, side by side or one in the hole of the other.
  const Rational outer_a = a.radius + a.tube, outer_b = b.radius + b.tube, inner_a = a.radius - a.tube,
                 inner_b = b.radius - b.tube;
  return by_limits(off,
                   {{outer_a + outer_b, false, outer_a},
                    {inner_a - outer_b, true, inner_a},
                    {inner_b - outer_a, true, -outer_a}},
                   [&](const Limit& limit) { return at(a.center + Rational(limit.to / limit.distance) * way); });
}

}  // namespace cnrg
