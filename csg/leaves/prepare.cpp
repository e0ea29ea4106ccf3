// From a shape to its preparation.
#include "csg/leaves/prepare_shapes.h"
#include "csg/leaves/result_leaf.h"

namespace cnrg {
namespace {

struct Dispatch {
  using Leaf = std::unique_ptr<PreparedLeaf>;
  Leaf operator()(const BoxShape& shape) const { return prepare_box(shape); }
  Leaf operator()(const PrismShape& shape) const { return prepare_prism(shape); }
  Leaf operator()(const PyramidShape& shape) const { return prepare_pyramid(shape); }
  Leaf operator()(const TetrahedronShape& shape) const { return prepare_tetrahedron(shape); }
  Leaf operator()(const PolygonShape& shape) const { return prepare_polygon(shape); }
  Leaf operator()(const PolylineShape& shape) const { return prepare_polyline(shape); }
  Leaf operator()(const PointsShape& shape) const { return prepare_points(shape); }
  Leaf operator()(const PlaneShape& shape) const { return prepare_plane(shape); }
  Leaf operator()(const HalfspaceShape& shape) const { return prepare_halfspace(shape); }
  Leaf operator()(const SphereShape& shape) const { return prepare_sphere(shape); }
  Leaf operator()(const CylinderShape& shape) const { return prepare_cylinder(shape); }
  Leaf operator()(const ConeShape& shape) const { return prepare_cone(shape); }
  Leaf operator()(const TorusShape& shape) const { return prepare_torus(shape); }
  Leaf operator()(const BezierShape& shape) const { return prepare_bezier(shape); }
  Leaf operator()(const CoonsShape& shape) const { return prepare_coons(shape); }
  Leaf operator()(const ExtrudeShape& shape) const { return prepare_extrude(shape); }
  Leaf operator()(const RevolveShape& shape) const { return prepare_revolve(shape); }
  Leaf operator()(const HeightfieldShape& shape) const { return prepare_heightfield(shape); }
  Leaf operator()(const MeshShape& shape) const { return prepare_mesh(shape); }
  Leaf operator()(const CadShape& shape) const { return prepare_cad(shape); }
  Leaf operator()(const GroupShape& shape) const { return prepare_group(shape); }
  Leaf operator()(const ResultShape& shape) const { return prepare_result(shape); }
};

}  // namespace

std::unique_ptr<PreparedLeaf> prepare(const Shape& shape) { return std::visit(Dispatch{}, shape); }

}  // namespace cnrg
