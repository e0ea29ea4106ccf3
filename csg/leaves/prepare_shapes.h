// One function per kind of leaf; `prepare` (leaf.h) dispatches to them. All throw InputError for what is wrong
// in the shape alone; the message names the parameter and the remedy.
//
// Leaves with curved patches are made with a record of their parameters or (null, as `prepare` does) without.
#pragma once

#include "csg/leaves/leaf.h"

namespace cnrg {

// solids.cpp: closed, outward oriented, Fill::winding.
std::unique_ptr<PreparedLeaf> prepare_box(const BoxShape& shape);
std::unique_ptr<PreparedLeaf> prepare_prism(const PrismShape& shape);
std::unique_ptr<PreparedLeaf> prepare_pyramid(const PyramidShape& shape);
std::unique_ptr<PreparedLeaf> prepare_tetrahedron(const TetrahedronShape& shape);

// flat.cpp: no regions.
std::unique_ptr<PreparedLeaf> prepare_polygon(const PolygonShape& shape);
std::unique_ptr<PreparedLeaf> prepare_polyline(const PolylineShape& shape);
std::unique_ptr<PreparedLeaf> prepare_points(const PointsShape& shape);

// curved.cpp: tessellated solids, Fill::winding.
std::unique_ptr<PreparedLeaf> prepare_sphere(const SphereShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_cylinder(const CylinderShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_cone(const ConeShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_torus(const TorusShape& shape, LeafParameters* record);

// parametric.cpp: Bézier and B-spline patches and curves, Coons patches; fill as the shape says.
std::unique_ptr<PreparedLeaf> prepare_bezier(const BezierShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_coons(const CoonsShape& shape, LeafParameters* record);

// extrude.cpp, revolve.cpp: Fill::winding, or none for a curve.
std::unique_ptr<PreparedLeaf> prepare_extrude(const ExtrudeShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_revolve(const RevolveShape& shape, LeafParameters* record);

// unbounded.cpp
std::unique_ptr<PreparedLeaf> prepare_plane(const PlaneShape& shape);
std::unique_ptr<PreparedLeaf> prepare_halfspace(const HalfspaceShape& shape);

// One file each.
std::unique_ptr<PreparedLeaf> prepare_heightfield(const HeightfieldShape& shape);
std::unique_ptr<PreparedLeaf> prepare_mesh(const MeshShape& shape);
std::unique_ptr<PreparedLeaf> prepare_cad(const CadShape& shape);
std::unique_ptr<PreparedLeaf> prepare_group(const GroupShape& shape);

}  // namespace cnrg
