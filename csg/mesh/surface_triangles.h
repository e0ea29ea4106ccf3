// The faces of a result as triangles, its edges and wires as segments, without volumes: what shells, boundary
// elements and networks of fractures are computed on, and what tetrahedra may begin with.
#pragma once

#include "csg/mesh/mesh.h"
#include "csg/mesh/plc.h"
#include "csg/mesh/refine_surface.h"

namespace cnrg {

struct SurfaceTriangles {
  Mesh mesh;  ///< without tetrahedra and regions; entities are cells of the result
  RoundingReport rounding;
  std::vector<FaceTriangles> groups;
  std::size_t kept = 0;  ///< facets that keep their triangles since others of doubles would cross what is near
  std::string notice{};  ///< what the user should know of how it was made; else empty
  std::vector<std::string> warnings{};  ///< regions that had to go
};

/// All groups as one.
FaceTriangles all_groups(const SurfaceTriangles& made);

/// Meshes all faces, edges, wires and points of a closed result, with regions or without: conforming, since what
/// meets shares points; no angle below 25 degrees but where the result has small angles itself; no side longer
/// than `options.size` says (refine_surface.h). With `options.quads` what has been proven is merged into
/// quadrilaterals where two triangles make a good one (quads.h); points and all other sides stay.
///
/// Proven before it is returned: the pieces of each edge are its way, the triangles of each face have its
/// boundary, turn as it does, and together its area but for rounding; and all of it, refined exactly as it is
/// written, meets nowhere but in what it shares, with the regions, wires and points where they are
/// (csg/result/rounding.h). Facets near which that fails keep the triangles that they have.
///
/// Throws InputError for a result with neither faces nor wires, for one that is not closed or reaches the frame,
/// and as `refine` does; RoundingFault; NearFault (kernel/tetrahedra/constrained.h) where sizes that are asked for
/// have no room between doubles; Stopped.
SurfaceTriangles surface_triangles(const ResultView& view, const SurfaceOptions& options = {});

/// The same triangles and segments as the facets and segments of a complex to fill, without seeds. The points of
/// the result keep their numbers. `points`: of a rounding that is faithful. `said`: as of `refine`; `options.size`
/// where it is empty.
Plc refined_plc(const FlatComplex& flat, const RoundedPoints& points, const SurfaceOptions& options = {},
                const SizeAt& said = {}, SurfaceNarrow narrow = SurfaceNarrow::rationed);

}  // namespace cnrg
