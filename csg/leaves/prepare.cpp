// Which function prepares which shape.
#include "csg/leaves/parameters.h"
#include "csg/leaves/prepare_shapes.h"

namespace cnrg {
namespace {

using Leaf = std::unique_ptr<PreparedLeaf>;

/// Keeps the shape: when someone asks for parameters, the leaf is made once more, with a record of them.
template <class Shape>
Leaf curved(const Shape& shape, Leaf (*make)(const Shape&, LeafParameters*)) {
  Leaf leaf = make(shape, nullptr);
  leaf->set_parameters([make, kept = std::make_shared<const Shape>(shape)] {
    auto parameters = std::make_shared<LeafParameters>();
    make(*kept, parameters.get());
    return parameters;
  });
  return leaf;
}

struct Dispatch {
  Leaf operator()(const BoxShape& shape) const { return prepare_box(shape); }
  Leaf operator()(const PrismShape& shape) const { return prepare_prism(shape); }
  Leaf operator()(const PyramidShape& shape) const { return prepare_pyramid(shape); }
  Leaf operator()(const TetrahedronShape& shape) const { return prepare_tetrahedron(shape); }
  Leaf operator()(const PolygonShape& shape) const { return prepare_polygon(shape); }
  Leaf operator()(const PolylineShape& shape) const { return prepare_polyline(shape); }
  Leaf operator()(const PointsShape& shape) const { return prepare_points(shape); }
  Leaf operator()(const PlaneShape& shape) const { return prepare_plane(shape); }
  Leaf operator()(const HalfspaceShape& shape) const { return prepare_halfspace(shape); }
  Leaf operator()(const SphereShape& shape) const { return curved(shape, prepare_sphere); }
  Leaf operator()(const CylinderShape& shape) const { return curved(shape, prepare_cylinder); }
  Leaf operator()(const ConeShape& shape) const { return curved(shape, prepare_cone); }
  Leaf operator()(const TorusShape& shape) const { return curved(shape, prepare_torus); }
  Leaf operator()(const BezierShape& shape) const { return curved(shape, prepare_bezier); }
  Leaf operator()(const CoonsShape& shape) const { return curved(shape, prepare_coons); }
  Leaf operator()(const ExtrudeShape& shape) const { return curved(shape, prepare_extrude); }
  Leaf operator()(const RevolveShape& shape) const { return curved(shape, prepare_revolve); }
  Leaf operator()(const HeightfieldShape& shape) const { return prepare_heightfield(shape); }
  Leaf operator()(const MeshShape& shape) const { return prepare_mesh(shape); }
  Leaf operator()(const CadShape& shape) const { return prepare_cad(shape); }
  Leaf operator()(const GroupShape& shape) const { return prepare_group(shape); }
  Leaf operator()(const ResultShape& shape) const { return prepare_result(shape); }
};

}  // namespace

std::shared_ptr<const PreparedLeaf> prepare(const Shape& shape) { return std::visit(Dispatch{}, shape); }

}  // namespace cnrg
