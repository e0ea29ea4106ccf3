// Which function prepares which shape.
#include "csg/leaves/parameters.h"
#include "csg/leaves/prepare_shapes.h"

namespace cnrg {
namespace {

using Leaf = std::unique_ptr<PreparedLeaf>;

/// Keeps the shape: when someone asks for parameters, the leaf is made once more, with a record of them.
template <class Shape>
Leaf curved(const Shape& shape, Leaf (*make)(const Shape&, LeafParameters*),
            std::shared_ptr<const LeafSurfaces> (*surfaces)(const Shape&)) {
  Leaf leaf = make(shape, nullptr);
  const auto kept = std::make_shared<const Shape>(shape);
  leaf->set_parameters([make, kept] {
    auto parameters = std::make_shared<LeafParameters>();
    make(*kept, parameters.get());
    return parameters;
  });
  leaf->set_surfaces([surfaces, kept] { return surfaces(*kept); });
  return leaf;
}

struct Dispatch {
  Leaf operator()(const BoxShape& shape) const { return prepare_box(shape); }
  Leaf operator()(const PrismShape& shape) const { return prepare_prism(shape); }
  Leaf operator()(const PyramidShape& shape) const { return prepare_pyramid(shape); }
  Leaf operator()(const TetrahedronShape& shape) const { return prepare_tetrahedron(shape); }
  Leaf operator()(const HullShape& shape) const { return prepare_hull(shape); }
  Leaf operator()(const PolygonShape& shape) const { return prepare_polygon(shape); }
  Leaf operator()(const DiskShape& shape) const { return prepare_disk(shape); }
  Leaf operator()(const PolylineShape& shape) const { return prepare_polyline(shape); }
  Leaf operator()(const PointsShape& shape) const { return prepare_points(shape); }
  Leaf operator()(const PlaneShape& shape) const { return prepare_plane(shape); }
  Leaf operator()(const HalfspaceShape& shape) const { return prepare_halfspace(shape); }
  Leaf operator()(const SphereShape& shape) const { return curved(shape, prepare_sphere, sphere_surfaces); }
  Leaf operator()(const CylinderShape& shape) const { return curved(shape, prepare_cylinder, cylinder_surfaces); }
  Leaf operator()(const ConeShape& shape) const { return curved(shape, prepare_cone, cone_surfaces); }
  Leaf operator()(const TorusShape& shape) const { return curved(shape, prepare_torus, torus_surfaces); }
  Leaf operator()(const BezierShape& shape) const { return curved(shape, prepare_bezier, bezier_surfaces); }
  Leaf operator()(const CoonsShape& shape) const { return curved(shape, prepare_coons, coons_surfaces); }
  Leaf operator()(const ExtrudeShape& shape) const { return curved(shape, prepare_extrude, extrude_surfaces); }
  Leaf operator()(const RevolveShape& shape) const { return curved(shape, prepare_revolve, revolve_surfaces); }
  Leaf operator()(const SweepShape& shape) const { return curved(shape, prepare_sweep, sweep_surfaces); }
  Leaf operator()(const LoftShape& shape) const { return curved(shape, prepare_loft, loft_surfaces); }
  Leaf operator()(const HeightfieldShape& shape) const { return prepare_heightfield(shape); }
  Leaf operator()(const MeshShape& shape) const { return prepare_mesh(shape); }
  Leaf operator()(const CadShape& shape) const { return prepare_cad(shape); }
  Leaf operator()(const GroupShape& shape) const { return prepare_group(shape); }
  Leaf operator()(const ResultShape& shape) const { return prepare_result(shape); }
};

}  // namespace

std::shared_ptr<const PreparedLeaf> prepare(const Shape& shape) {
  const auto* const result = std::get_if<ResultShape>(&shape);
  if (result != nullptr && result->in_memory != nullptr) return result->in_memory;
  return std::visit(Dispatch{}, shape);
}

}  // namespace cnrg
