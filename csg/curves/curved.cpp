// Tessellated solids: cylinder, cone, sphere, torus (extrude.cpp, revolve.cpp, parametric.cpp have the others).
//
// All facets of a curved side have one number, caps have their own. Corners are doubles where the shape allows
// it (circle.h); caps and cylinder sides are planar by construction: a cap's points are rounded within its
// plane only, and the upper ring of a cylinder is the lower one plus the exact vector from -> to. Facets of other
// sides are quadrilaterals where their four rounded corners happen to be coplanar, else two triangles.
//
// Parameters (parameters.h): u is the fraction of the turn about the axis, from 0 to 1; v the fraction of the way
// from `from` to `to`, of the meridian from the south pole to the north pole, or of the turn about the tube, from
// its outermost circle up. Caps are planes and have none.
#include <algorithm>
#include <cstdint>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/revolved.h"
#include "csg/geometry/circle.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

using Ring = std::vector<PointId>;

void check_fineness(const char* shape, const char* what, int count, int least) {
  if (count >= least && count <= Fineness::kMostSegments) return;
  throw LeafKeyError(what, std::string(shape) + ": " + what + " is " + std::to_string(count) + ": give " +
                               (count < least ? "at least " + std::to_string(least)
                                              : "at most " + std::to_string(Fineness::kMostSegments)));
}

/// A grid of facets that no machine of today holds is refused before it is begun.
void check_facets(const char* shape, int segments, int rings) {
  constexpr std::int64_t kMost = 10'000'000;
  const std::int64_t facets = static_cast<std::int64_t>(segments) * rings;
  if (facets <= kMost) return;
  throw InputError(std::string(shape) + ": " + std::to_string(segments) + " segments by " + std::to_string(rings) +
                   " rings are " + std::to_string(facets) + " facets: give at most " + std::to_string(kMost));
}

void check_positive(const char* shape, const char* what, const Rational& value) {
  if (value > 0) return;
  throw LeafKeyError(what,
                     std::string(shape) + ": " + what + " is " + to_decimal(value) + ": give a positive length");
}

/// Points of a circle about `center`, rounded where that keeps them in the circle's plane.
std::vector<RationalPoint> circle(const CircleFrame& frame, const RationalPoint& center, const Rational& radius,
                                  int segments) {
  std::vector<RationalPoint> points = frame.offsets(radius, segments);
  for (RationalPoint& p : points) {
    p = center + p;
    if (frame.parallel_to() == 3) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != frame.parallel_to()) p[k] = rounded_for(p[k], radius);
    }
  }
  return points;
}

/// 0, 1 / n, ... 1.
std::vector<Rational> fractions(int n) {
  std::vector<Rational> result;
  for (int i = 0; i <= n; ++i) result.push_back(fraction(i, n));
  return result;
}

/// A band between two rings of n points, `upper` lying to the left of the direction of `lower` as seen from
/// outside; u has n + 1 entries, v is from v0 to v1.
void add_band(LeafBuilder& builder, const Ring& lower, const Ring& upper, std::uint32_t number,
              const std::vector<Rational>& u, const Rational& v0, const Rational& v1) {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t j = (i + 1) % lower.size();
    builder.facet(lower[i], lower[j], upper[j], upper[i], number,
                  {{{&u[i], &v0}, {&u[i + 1], &v0}, {&u[i + 1], &v1}, {&u[i], &v1}}});
  }
}

MeridianPiece arc(std::uint32_t patch, const Rational& out, const Rational& radius, const Rational& start,
                  const Rational& sweep, int steps) {
  MeridianPiece piece{.kind = MeridianPiece::Kind::arc, .patch = patch, .steps = steps};
  piece.middle = {out, 0};
  piece.radius = radius;
  piece.start = start;
  piece.sweep = sweep;
  return piece;
}

/// What carries the side of a cylinder or cone.
std::shared_ptr<const CurvedForm> capped_form(const RationalPoint& from, const RationalPoint& along,
                                              const Rational& radius, const Rational& top, int segments,
                                              const std::array<const char*, 3>& names) {
  auto form = std::make_shared<RevolvedForm>();
  form->center = from;
  form->axis = along;
  MeridianPiece side{.patch = 2};
  side.from = {radius, 0};
  side.to = {top, 1};
  form->lines = {{side}};
  form->discs = form->turn_is_u = true;
  form->segments = segments;
  for (std::uint32_t i = 0; i < 3; ++i) form->names.emplace_back(i, names[i]);
  return form;
}

constexpr std::array<const char*, 3> kCylinderNames{"cylinder bottom", "cylinder top", "cylinder side"};
constexpr std::array<const char*, 3> kConeNames{"cone bottom", "cone top", "cone side"};

/// A cylinder or cone between two rings: the cap at `from` is face 0, the cap at `to` 1 (no cap where the
/// ring is one point), the side 2.
void add_capped(LeafBuilder& builder, const Ring& bottom, const Ring& top,
                const std::array<const char*, 3>& names) {
  for (std::uint32_t number = 0; number < 3; ++number) builder.name_patch(number, names[number]);
  add_band(builder, bottom, top, 2, fractions(static_cast<int>(bottom.size())), 0, 1);
  if (bottom[0] != bottom[1]) builder.face(Ring(bottom.rbegin(), bottom.rend()), 0);
  if (top[0] != top[1]) builder.face(top, 1);
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const CylinderShape& shape, LeafParameters* record) {
  check_positive("cylinder", "radius", shape.radius);
  check_fineness("cylinder", "segments", shape.segments, 3);
  const RationalPoint along = shape.to - shape.from;
  if (is_zero(along))
    throw LeafKeyError("to", "cylinder: from and to are both " + describe(shape.from) + ": move one");
  std::vector<RationalPoint> points = circle(CircleFrame(along), shape.from, shape.radius, shape.segments);
  LeafBuilder builder(Fill::winding, record);
  const Ring bottom = builder.points(points);
  for (RationalPoint& p : points) p = p + along;
  add_capped(builder, bottom, builder.points(points), kCylinderNames);
  auto leaf = builder.finish();
  leaf->set_form(capped_form(shape.from, along, shape.radius, shape.radius, shape.segments, kCylinderNames));
  return leaf;
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const ConeShape& shape, LeafParameters* record) {
  if (shape.radius < 0 || shape.top < 0 || (shape.radius == 0 && shape.top == 0)) {
    throw InputError("cone: radius is " + to_decimal(shape.radius) + " and top is " + to_decimal(shape.top) +
                     ": neither may be negative, and one must be positive");
  }
  if (shape.radius == shape.top) {
    return prepare_leaf(CylinderShape{shape.from, shape.to, shape.radius, shape.segments}, record);
  }
  check_fineness("cone", "segments", shape.segments, 3);
  const RationalPoint along = shape.to - shape.from;
  if (is_zero(along))
    throw LeafKeyError("to", "cone: from and to are both " + describe(shape.from) + ": move one");
  const CircleFrame frame(along);
  LeafBuilder builder(Fill::winding, record);
  const auto ring = [&](const RationalPoint& center, const Rational& radius) {
    if (radius == 0) return Ring(static_cast<std::size_t>(shape.segments), builder.point(center));
    return builder.points(circle(frame, center, radius, shape.segments));
  };
  const Ring bottom = ring(shape.from, shape.radius);
  const Ring top = ring(shape.to, shape.top);
  add_capped(builder, bottom, top, kConeNames);
  for (const Ring& one : {bottom, top}) {  // lines end in an apex
    if (one[0] == one[1]) builder.soup().add_curve_end(builder.leaf(), one[0]);
  }
  auto leaf = builder.finish();
  leaf->set_form(capped_form(shape.from, along, shape.radius, shape.top, shape.segments, kConeNames));
  return leaf;
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const SphereShape& shape, LeafParameters* record) {
  check_positive("sphere", "radius", shape.radius);
  check_fineness("sphere", "segments", shape.segments, 3);
  const int rings = shape.rings == 0 ? std::max(2, shape.segments / 2) : shape.rings;
  check_fineness("sphere", "rings", rings, 2);
  check_facets("sphere", shape.segments, rings);
  LeafBuilder builder(Fill::winding, record);
  const std::size_t n = static_cast<std::size_t>(shape.segments);
  const RationalPoint& c = shape.center;
  builder.name_patch(0, "sphere");
  const std::vector<Rational> u = fractions(shape.segments), v = fractions(rings);
  std::vector<std::array<Rational, 2>> around;
  for (int i = 0; i < shape.segments; ++i) {
    const Rational longitude = fraction(std::int64_t{360} * i, shape.segments);
    around.push_back({from_double(cosine_degrees(longitude)), from_double(sine_degrees(longitude))});
  }
  Ring lower(n, builder.point({c[0], c[1], c[2] - shape.radius}));
  for (int j = 1; j <= rings; ++j) {
    Ring upper;
    if (j == rings) {
      upper.assign(n, builder.point({c[0], c[1], c[2] + shape.radius}));
    } else {
      const Rational latitude = fraction(std::int64_t{180} * j, rings) - 90;
      const Rational out = shape.radius * from_double(cosine_degrees(latitude));
      const Rational z = rounded_for(c[2] + shape.radius * from_double(sine_degrees(latitude)), shape.radius);
      for (const auto& [x, y] : around) {
        upper.push_back(builder.point(
            {rounded_for(c[0] + out * x, shape.radius), rounded_for(c[1] + out * y, shape.radius), z}));
      }
    }
    add_band(builder, lower, upper, 0, u, v[static_cast<std::size_t>(j) - 1], v[static_cast<std::size_t>(j)]);
    lower = std::move(upper);
  }
  auto form = std::make_shared<RevolvedForm>();
  form->center = c;
  form->axis = {0, 0, 1};
  MeridianPiece meridian = arc(0, 0, shape.radius, -90, 180, rings);
  meridian.from = {0, -shape.radius};
  meridian.to = {0, shape.radius};
  form->lines = {{meridian}};
  form->turn_is_u = true;
  form->segments = shape.segments;
  form->names = {{0, "sphere"}};
  auto leaf = builder.finish();
  leaf->set_form(std::move(form));
  return leaf;
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const TorusShape& shape, LeafParameters* record) {
  check_positive("torus", "radius", shape.radius);
  check_positive("torus", "tube", shape.tube);
  if (shape.tube >= shape.radius) {
    throw LeafKeyError("tube", "torus: the tube's radius " + to_decimal(shape.tube) +
                                   " is not less than the radius " + to_decimal(shape.radius) +
                                   ", it would meet itself: give a smaller tube");
  }
  check_fineness("torus", "segments", shape.segments, 3);
  check_fineness("torus", "rings", shape.rings, 3);
  check_facets("torus", shape.segments, shape.rings);
  if (is_zero(shape.axis)) throw LeafKeyError("axis", "torus: the axis is [0, 0, 0]: give a direction");
  const CircleFrame frame(shape.axis);
  // Unit vectors to 52 bits, scaled exactly and rounded once more at the end.
  const std::vector<RationalPoint> around = frame.offsets(1, shape.segments);
  const Rational square = 1 / dot(frame.axis(), frame.axis());
  const RationalPoint up = round_cosine(0, square, exponent_of_root(square) - 51) * frame.axis();
  LeafBuilder builder(Fill::winding, record);
  std::vector<Ring> rows;
  for (int j = 0; j < shape.rings; ++j) {
    const Rational degrees = fraction(std::int64_t{360} * j, shape.rings);
    const Rational out = shape.radius + shape.tube * from_double(cosine_degrees(degrees));
    const RationalPoint center = shape.center + Rational(shape.tube * from_double(sine_degrees(degrees))) * up;
    Ring row;
    for (const RationalPoint& direction : around) {
      RationalPoint p = center + out * direction;
      for (Rational& x : p) x = rounded_for(x, shape.tube);
      row.push_back(builder.point(p));
    }
    rows.push_back(std::move(row));
  }
  builder.name_patch(0, "torus");
  const std::vector<Rational> u = fractions(shape.segments), v = fractions(shape.rings);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    add_band(builder, rows[j], rows[(j + 1) % rows.size()], 0, u, v[j], v[j + 1]);
  }
  auto form = std::make_shared<RevolvedForm>();
  form->center = shape.center;
  form->axis = shape.axis;
  MeridianPiece circle = arc(0, shape.radius, shape.tube, 0, 360, shape.rings);
  circle.from = circle.to = {shape.radius + shape.tube, 0};
  form->lines = {{circle}};
  form->closed_lines = form->turn_is_u = true;
  form->segments = shape.segments;
  form->names = {{0, "torus"}};
  auto leaf = builder.finish();
  leaf->set_form(std::move(form));
  return leaf;
}

}  // namespace cnrg
