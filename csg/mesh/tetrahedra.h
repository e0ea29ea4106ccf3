// A result as tetrahedra: conforming to every region, wall, dangling face, wire and point of it.
#pragma once

#include <optional>
#include <string>

#include "csg/mesh/deadline.h"
#include "csg/mesh/mesh.h"
#include "csg/mesh/quality.h"
#include "csg/mesh/split.h"
#include "kernel/base/error.h"

namespace cnrg {

/// What became of a mesh that was brought to the true surfaces (curved_mesh.h).
struct CurvedReport {
  /// Of each region, parallel to TetrahedralMesh::regions: tetrahedra with an edge on a curved face that bend, and
  /// such that stay straight, wholly or in part, since they or a neighbour would fold.
  std::vector<std::size_t> curved, straight;
  std::size_t moved = 0;    ///< points of the straight mesh that were moved
  double farthest = 0;      ///< the longest of these moves
  std::size_t middles = 0;  ///< middles of edges that were moved
  std::size_t left = 0;     ///< points and middles on curved faces for which no place on the surfaces was found
};

struct TetrahedralMesh {
  Mesh mesh;
  RoundingReport rounding;
  std::vector<RegionTetrahedra> regions;  ///< in the order of the mesh's entities of dimension 3
  MeshQuality quality;
  double expected = 0;                  ///< tetrahedra, as foretold; 0: nothing was
  std::string notice;                   ///< what the user should know of how it was made; else empty
  std::vector<std::string> warnings{};  ///< what nobody may miss: regions that had to go, so that there is a mesh
  std::optional<CurvedReport> bent{};   ///< of a curved one
  std::optional<SplitReport> parted{};  ///< of a split one
};

/// Its regions as people list them: their places in `regions`, by their names.
std::vector<std::size_t> listed_regions(const TetrahedralMesh& made);

/// The tetrahedra of the active regions of a closed and bounded result, by TetGen (si2015), or, where it makes
/// none that are proven or with `constrained`, constrained ones (constrained_run.h). Faces, wires and
/// points outside of them are in the mesh as triangles, segments and points that conform, too. The boundary of a
/// region is that of the result rounded to doubles, which must be embedded. A facet is given to TetGen as a whole,
/// and where it cannot mesh that, or with `keep_boundary`, as triangles unless it is planar in doubles.
///
/// With `surface_first` its faces and edges are meshed as surfaces before (surface_triangles.h); TetGen gets these
/// triangles and keeps them. Then there is no other way to tetrahedra.
///
/// They are improved (improved.h), with points that are added, until shapes are above 0.1 where that can be.
///
/// What is returned is proven: every tetrahedron is turned right; those of a region
/// have together the volume that its rounded boundary encloses, to the last bit with `keep_boundary` (with
/// `surface_first` that of the triangles, which are exactly the boundary), else but for
/// area * 1e-8 * size (TetGen's own tolerance for what lies in a plane, times the longest side of the model's
/// box); every face and edge is there, bounded as it should be; on both sides of each triangle are the regions of
/// its face, and between regions are such triangles only.
///
/// Throws InputError for a result without regions, open or unbounded, and where neither makes a mesh that is
/// proven; RoundingFault for one that rounding breaks; NearFault (kernel/tetrahedra/constrained.h) for one with
/// features so near to each other that there is none in doubles; TimeOver where `seconds` were over before there
/// was any mesh; Stopped. What time has kept from being improved `notice` says.
TetrahedralMesh tetrahedra(const ResultView& view, const TetrahedraOptions& options = {});

/// What TetGen says, or does, instead of a mesh.
class TetgenFault : public InputError {
 public:
  using InputError::InputError;
};
/// The words of an error without what helps, which follows a `;`.
inline std::string without_remedy(const std::string& words) { return words.substr(0, words.find(';')); }

/// What is known of TetGen and this result.
struct TetgenTrial {
  bool only = false;    ///< nobody else is asked: throws TetgenFault where it makes no mesh
  std::string fault{};  ///< if not empty it is not asked: it has failed so before
};
/// The same as a part of work with a deadline, which counts instead of the time and the watch of the options:
/// throws Stopped when that is over.
TetrahedralMesh tetrahedra(const ResultView& view, const TetrahedraOptions& options, const Deadline& deadline,
                           const TetgenTrial& trial = {});

}  // namespace cnrg
