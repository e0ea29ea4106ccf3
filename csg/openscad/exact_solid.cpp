// One complex of all leaves; its labels tell which leaves hold a 3-cell.
#include "csg/openscad/exact_solid.h"

#include <charconv>

#include "csg/geometry/transform.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/mesh_data.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/triangulate.h"

namespace cnrg::openscad {
namespace {

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

}  // namespace cnrg::openscad
