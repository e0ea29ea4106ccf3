// One function per kind of leaf; `prepare` (leaf.h) dispatches to them. All throw InputError for what is wrong
// in the shape alone; the message names the parameter and the remedy.
//
// Leaves with curved patches are made with a record of their parameters or (null, as `prepare` does) without.
#pragma once

#include "csg/leaves/leaf.h"

namespace cnrg {

// shapes/solids.cpp: closed, outward oriented, Fill::winding.
std::unique_ptr<PreparedLeaf> prepare_leaf(const BoxShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const PrismShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const PyramidShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const TetrahedronShape& shape);

// shapes/hull.cpp: likewise.
std::unique_ptr<PreparedLeaf> prepare_leaf(const HullShape& shape);

// shapes/open_shapes.cpp: no regions.
std::unique_ptr<PreparedLeaf> prepare_leaf(const PolygonShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const DiskShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const PolylineShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const PointsShape& shape);

// curves/curved.cpp: tessellated solids, Fill::winding.
std::unique_ptr<PreparedLeaf> prepare_leaf(const SphereShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_leaf(const CylinderShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_leaf(const ConeShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_leaf(const TorusShape& shape, LeafParameters* record);

// curves/parametric.cpp: Bézier and B-spline patches and curves, Coons patches; fill as the shape says.
std::unique_ptr<PreparedLeaf> prepare_leaf(const BezierShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_leaf(const CoonsShape& shape, LeafParameters* record);

// curves/extrude.cpp, curves/revolve.cpp: Fill::winding, or none for a curve.
std::unique_ptr<PreparedLeaf> prepare_leaf(const ExtrudeShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_leaf(const RevolveShape& shape, LeafParameters* record);

// curves/sweep.cpp, curves/skin.cpp: Fill::winding.
std::unique_ptr<PreparedLeaf> prepare_leaf(const SweepShape& shape, LeafParameters* record);
std::unique_ptr<PreparedLeaf> prepare_leaf(const LoftShape& shape, LeafParameters* record);

/// Where the axis of an extrusion meets the plane of its profile.
RationalPoint axis_point(const ExtrudeShape& shape);

// curves/surface_round.cpp, curves/surface_swept.cpp: the true surfaces of shapes that were prepared.
std::shared_ptr<const LeafSurfaces> true_surfaces(const SphereShape& shape);
/// With parameters about another axis than z, v growing along it.
std::shared_ptr<const LeafSurfaces> sphere_surfaces(const RationalPoint& center, const Rational& radius,
                                                    const RationalPoint& axis);
std::shared_ptr<const LeafSurfaces> true_surfaces(const CylinderShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const ConeShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const TorusShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const BezierShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const CoonsShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const ExtrudeShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const RevolveShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const SweepShape& shape);
std::shared_ptr<const LeafSurfaces> true_surfaces(const LoftShape& shape);

// leaves/unbounded.cpp.
std::unique_ptr<PreparedLeaf> prepare_leaf(const PlaneShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const HalfspaceShape& shape);

// imports/mesh.cpp, imports/cad.cpp, shapes/heightfield.cpp, shapes/group.cpp.
std::unique_ptr<PreparedLeaf> prepare_leaf(const HeightfieldShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const MeshShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const CadShape& shape);
std::unique_ptr<PreparedLeaf> prepare_leaf(const GroupShape& shape);

// transfer/result_check.cpp
/// Reads a result that `cnrg eval -o file.json` wrote, of a group or of components: open, closed or neither, of
/// any dimension. The leaf has the same complex and (PreparedLeaf::stored) the same value: components with their
/// names, materials and dominance, and features. Its soup has the faces by their loops (by their facets where they
/// are not flat) with the regions on both sides (Fill::sides), the edges that bound no face as wires, and isolated
/// points, active or not. Faces, edges and regions are numbered as in the file (regions from 1); patches are kept.
///
/// A region may be unbounded; a face or line without bounds is refused: read the operands back and apply the
/// operator in the tree, or cut the node with a box before it is written.
///
/// Throws LeafFileError `file:line:column: error: ...` where the file is no JSON and `file: error: /faces/3/loops:
/// ...` with the JSON path of any other fault, each with what to do; InputError if there is no such file,
/// FileError if it cannot be read.
std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape);
/// The same of a text that is in no file; `name` stands for the file in messages.
std::unique_ptr<PreparedLeaf> prepare_result(const std::string& text, const std::string& name);

}  // namespace cnrg
