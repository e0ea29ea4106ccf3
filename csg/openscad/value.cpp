// What a Boolean takes; hulls and Minkowski sums of values.
#include "csg/openscad/value.h"

#include <set>
#include <utility>

namespace cnrg::openscad {
namespace {

bool is_flat(const std::vector<Point3>& points) { return hull(points).faces.empty(); }

std::vector<Point3> joined(const Parts& parts) {
  std::vector<Point3> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}
/// The nearest doubles.
std::vector<Point3> corners(const std::vector<ExactTriangle>& triangles) {
  std::vector<Point3> out;
  for (const ExactTriangle& t : triangles) {
    for (const RationalPoint& p : t) out.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
  }
  return out;
}

/// The convex solids that a solid is the union of; nothing if nobody knows any.
std::optional<Parts> parts_of(const Value& value) {
  if (const Exact* known = std::get_if<Exact>(&value)) return known->parts;
  const Polyset& polyset = std::get<Solid>(value).polyset;
  return is_convex(polyset) ? std::optional(Parts{polyset.points}) : std::nullopt;
}

/// Of a hull; all points, if it is flat.
std::vector<Point3> corners(const Polyset& hull, const std::vector<Point3>& all) {
  std::set<Point3> used;
  for (const Face& face : hull.faces) {
    for (const std::uint32_t i : face) used.insert(hull.points[i]);
  }
  return used.empty() ? all : std::vector<Point3>(used.begin(), used.end());
}

Parts summed(const Parts& a, const Parts& b) {
  Parts out;
  for (const auto& p : a) {
    for (const auto& q : b) out.push_back(corners(hull(sums(p, q)), sums(p, q)));
  }
  return out;
}
Point3 middle(const std::vector<Point3>& points) {
  Point3 sum{};
  for (const Point3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k] / double(points.size());
  }
  return sum;
}

/// What is not convex, moved to a point inside of each convex part, and the sums of the triangles of its boundary.
std::vector<Value> around(const Value& solid, const Parts& parts, const Statement& at) {
  const std::optional<Exact> placed = exact_of(solid);
  if (!placed) return {};
  const std::vector<ExactTriangle> skin = boundary(*placed->solid);
  std::vector<Value> out;
  for (const auto& part : parts) {
    const Point3 by = middle(part);
    out.push_back(moved(*placed, {{{1, 0, 0, by[0]}, {0, 1, 0, by[1]}, {0, 0, 1, by[2]}}}, at));
    const std::vector<RationalPoint> around = exact_points(part);
    for (const ExactTriangle& t : skin) {
      ExactSolid sum{ExactSolid::Kind::sum, &at};
      sum.sum.summands = {{t[0], t[1], t[2]}, around};
      out.push_back(Exact{std::make_shared<const ExactSolid>(std::move(sum)), {}});
    }
  }
  return out;
}

}  // namespace

bool is_empty(const Value& value) {
  const Area* area = std::get_if<Area>(&value);
  const Solid* solid = std::get_if<Solid>(&value);
  return value.index() == 0 || (area && area->loops.empty()) || (solid && solid->polyset.faces.empty());
}

std::optional<Exact> exact_of(const Value& value) {
  if (is_empty(value)) return {};
  if (const Exact* known = std::get_if<Exact>(&value)) return *known;
  const Solid& solid = std::get<Solid>(value);
  ExactSolid made{ExactSolid::Kind::polyset, solid.from, on_grid(solid.polyset)};
  made.polyset.convex = is_convex(made.polyset);
  const bool convex = *made.polyset.convex;
  if (made.polyset.faces.empty() || (convex && is_flat(made.polyset.points))) return {};
  Exact out;
  if (convex) out.parts = Parts{made.polyset.points};
  out.solid = std::make_shared<const ExactSolid>(std::move(made));
  return out;
}

Exact moved(const Exact& solid, const Matrix& m, const Statement& at) {
  ExactSolid made{ExactSolid::Kind::moved, &at};
  made.matrix = m;
  made.operands = {solid.solid};
  Exact out{std::make_shared<const ExactSolid>(std::move(made)), solid.parts};
  if (out.parts) {
    for (auto& part : *out.parts) part = transformed(Polyset{part, {}, true}, m).points;
  }
  return out;
}

Value boolean(const Statement& at, ExactSolid::Kind kind, const std::vector<Exact>& operands) {
  if (operands.empty()) return {};
  if (operands.size() == 1) return operands.front();
  ExactSolid solid{kind, &at};
  for (const Exact& operand : operands) solid.operands.push_back(operand.solid);
  return Exact{std::make_shared<const ExactSolid>(std::move(solid)), {}};
}

std::vector<Point3> corners_of(const std::vector<Value>& solids) {
  std::vector<Point3> out;
  for (const Value& value : solids) {
    const Exact* known = std::get_if<Exact>(&value);
    const std::vector<Point3> more = !known         ? std::get<Solid>(value).polyset.points
                                     : known->parts ? joined(*known->parts)
                                                    : corners(boundary(*known->solid));
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

std::optional<std::vector<Value>> minkowski_sum(const std::vector<Value>& solids, const Statement& at) {
  Parts sum{{{0, 0, 0}}};
  std::optional<Value> concave;
  for (const Value& value : solids) {
    const std::optional<Parts> parts = parts_of(value);
    if (!parts && concave) return {};
    if (parts) sum = summed(sum, *parts);
    else concave = value;
  }
  if (concave) return around(*concave, sum, at);
  std::vector<Value> out;
  for (const auto& part : sum) out.push_back(Solid{hull(part), &at});
  return out;
}

}  // namespace cnrg::openscad
