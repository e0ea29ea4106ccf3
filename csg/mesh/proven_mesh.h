// What a mesher returns, as the mesh of a result, and the proof that it is one.
//
// Meshers compute in doubles with tolerances and may fail, or return a mesh in which a face is missing or a region
// leaks, without a word. So their answer is not believed: simplices are taken from it by their markers, and then
// each statement of tetrahedra.h is checked.
#pragma once

#include <vector>

#include "csg/mesh/mesh.h"
#include "csg/mesh/plc.h"
#include "csg/mesh/quality.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// What on faces and edges has to be as in the complex: nothing; points: there are no new ones; facets: they are
/// triangles, and so are their segments.
enum class KeptBoundary : std::uint8_t { no, points, facets };

struct ProvenMesh {
  Mesh mesh;
  std::vector<RegionTetrahedra> regions;  ///< in the order of the mesh's entities of dimension 3
};

/// Tetrahedra of active regions, turned so that their determinant is positive, and triangles turned as their faces
/// are, by entity. Points are numbered as `made` has them. Throws InvariantError where it is no mesh of the
/// result, InputError where it has points that `kept` does not allow; Stopped.
ProvenMesh proven_mesh(const ResultView& view, const FlatComplex& flat, const Plc& plc, const PlcMesh& made,
                       KeptBoundary kept, const Watch& watch);

/// Leaves points in use, in their order: those of the result, then those that a mesher added. Throws
/// InvariantError where a point of the result inside of a region is lost.
void number_points(Mesh& mesh, const FlatComplex& flat, const std::vector<std::array<double, 3>>& points);

}  // namespace cnrg
