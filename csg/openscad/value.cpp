// What a Boolean takes; hulls and Minkowski sums of values.
#include "csg/openscad/value.h"

#include <charconv>
#include <set>
#include <utility>

#include "csg/geometry/transform.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/mesh_data.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/triangulate.h"

namespace cnrg::openscad {
namespace {

// One complex of all leaves; its labels tell which leaves hold a 3-cell.

Transform transform_of(const Matrix& m) {
  Transform out;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) out.linear[i][k] = *parse_rational(decimal(m[i][k]));
    out.offset[i] = *parse_rational(decimal(m[i][3]));
  }
  return out;
}

Shape shape_of(const Polyset& solid) {
  if (solid.convex == true) return HullShape{{exact_points(solid.points)}};
  auto data = std::make_shared<MeshData>();
  for (const Point3& p : solid.points) data->xyz.insert(data->xyz.end(), p.begin(), p.end());
  for (const Face& face : solid.faces) {
    data->corners.insert(data->corners.end(), face.begin(), face.end());
    data->end_face();
  }
  MeshShape mesh;
  mesh.data = std::move(data);
  mesh.fill = Fill::winding;
  return mesh;
}

/// Leaves in the order in which `holds` comes to them.
void collect(const ExactSolid& solid, const Transform& outer, std::vector<LeafInstance>& out) {
  const bool moves = solid.kind == ExactSolid::Kind::moved;
  const Transform transform = moves ? outer * transform_of(solid.matrix) : outer;
  if (solid.kind == ExactSolid::Kind::polyset) out.push_back({prepare(shape_of(solid.polyset)), transform});
  if (solid.kind == ExactSolid::Kind::sum) out.push_back({prepare(solid.sum), transform});
  for (const ExactSolidRef& operand : solid.operands) collect(*operand, transform, out);
}

/// Whether a place is in the solid; `in`: whether it is in each leaf. `next` is the number of the solid's first
/// leaf and becomes that of the first one behind it.
bool holds(const ExactSolid& solid, const std::vector<bool>& in, std::size_t& next) {
  if (solid.operands.empty()) return in[next++];
  std::size_t count = 0;
  bool first = false;
  for (const ExactSolidRef& operand : solid.operands) {
    const bool inside = holds(*operand, in, next);
    if (&operand == &solid.operands.front()) first = inside;
    count += inside;
  }
  switch (solid.kind) {
    case ExactSolid::Kind::unite: return count > 0;
    case ExactSolid::Kind::subtract: return first && count == 1;
    default: return count == solid.operands.size();
  }
}

IdVector<RegionId, char> inside(const Complex& complex, const ExactSolid& solid) {
  IdVector<RegionId, char> out;
  for (const RegionId region : IdRange<RegionId>(complex.region_count)) {
    std::vector<bool> in(complex.leaf_count);
    for (const Label& label : complex.labels(region)) in[label.leaf.index()] = true;
    std::size_t next = 0;
    out.push_back(holds(solid, in, next));
  }
  return out;
}

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

std::string decimal(double x) {
  std::array<char, 32> text{};
  return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), x + 0.0).ptr);
}

std::vector<ExactTriangle> boundary(const ExactSolid& solid) {
  std::vector<LeafInstance> leaves;
  collect(solid, {}, leaves);
  const std::shared_ptr<const Complex> complex = build_complex(make_soup(leaves));
  const IdVector<RegionId, char> in = inside(*complex, solid);
  const auto point = [&](VertexId v) { return complex->points.rational(v); };
  std::vector<ExactTriangle> out;
  for (const FaceId face : IdRange<FaceId>(complex->face_count())) {
    const auto [front, back] = complex->face_regions[face];
    if (in[front] == in[back]) continue;
    std::vector<std::vector<VertexId>> loops;
    for (const LoopId loop : complex->face_loops[face]) {
      auto& corners = loops.emplace_back();
      for (const HalfEdge h : complex->loop[loop]) corners.push_back(complex->origin(h));
    }
    for (const auto& t : triangulate(complex->points, complex->sheet_projection[complex->face_sheet[face]], loops))
      out.push_back({point(t[0]), point(t[1]), point(t[2])});
  }
  return out;
}

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
