// Better tetrahedra out of valid ones: of the length that is wanted, and of good shape.
//
// Delaunay tetrahedra are the best that given points allow by one measure, and may be bad by all others: slivers,
// and long ones that lead from small features to large ones. To refine them by their circumcenters is proven to
// end with bounded shapes only where the input has no small angles, and stumbles over these. Here local moves
// (moves.h) make what is bad better one by one, and where none does the longest edge is halved. Each step leaves a
// valid mesh, so the work may end after any of them: a count of steps is the same on every machine, a clock only
// for who asks for it.
//
// Is it worth its lines? TetGen's own optimization of 82 models (fracture networks, geology, triangle meshes) left
// 18,420 of 43,729 tetrahedra with a shape below 0.1; these moves leave 510 of 102,784. New vertices in the middle
// of spheres (klingner2007), besides halves of edges, left 506; of constrained tetrahedra of 65 models, 1.9 % in
// place of 2.1 %, in 1.4 of the time: these were not. CGAL's isotropic remeshing (5.5.1, five rounds, with the
// lengths of TetGen's mesh) leaves 15 % of the tetrahedra of 94 models below 0.1, or 14 % where it may change the
// boundary, whose volume is another one then in 74 of them; of the same models these moves leave 0.8 %.
#pragma once

#include <cstdint>
#include <functional>

#include "kernel/base/progress.h"
#include "kernel/tetrahedra/bounds.h"
#include "kernel/tetrahedra/conforming.h"

namespace cnrg {

struct ImproveOptions {
  ConformingTetrahedra::Index fixed = 0;  ///< the points below it are those of the input, and stay
  bool keep_boundary = false;             ///< nor change faces of facets, nor segments
  /// The length of edges that is wanted at a place; empty: what the shapes need.
  std::function<double(const ConformingTetrahedra::Point&)> size{};
  std::vector<double> region_size{};  ///< the same inside of regions, by number; empty, or infinite: no bound
  /// What somebody wants of that; what is longer in the end is halved (`kLongestEdge`), whatever becomes of its
  /// shape; with `keep_boundary` it might not end. Empty: nothing.
  WantedLength longest{};
  double good = 0.4;  ///< local moves are tried on all of a worse shape
  /// What a tetrahedron has to be; points are added until all are, where that can be.
  double shape = 0.1;      ///< at least
  double radius_edge = 0;  ///< ratio of circumradius to shortest edge at most; 0: no bound
  double volume = 0;       ///< at most; 0: no bound
  std::size_t points = 0;  ///< that are added for these at most
  /// Of these in what is narrow: in flat tetrahedra (`is_flat`) with all corners on facets and lines, which takes
  /// as many as it is longer than thick, squared. Then all else comes first. 0: no ration.
  std::size_t narrow_points = 0;
  /// Where there are more tetrahedra than these, refinement ends: flat parts, in which the lengths that are wanted
  /// are far longer than they are thick, need no more tetrahedra for these, and halves make ever more. 0: no
  /// bound.
  std::size_t most = 0;
  /// After so many nothing is begun: tetrahedra that are looked at, and kStepsOfMove for each that moves are tried
  /// on; 0: no bound.
  std::size_t steps = 0;
  static constexpr std::size_t kStepsOfMove = 20;
  double seconds = 0;     ///< by the clock, the same; 0: no bound
  double afterwards = 0;  ///< so many of these seconds are left for each tetrahedron
};

/// How it ended: whatever comes first leaves the rest undone.
enum class Improved : std::uint8_t { done, time_over, steps_over, too_many };

/// Improves a mesh. Points that are no more used are left out behind the fixed ones. Throws Stopped.
Improved improve(ConformingTetrahedra& mesh, const ImproveOptions& options, const Watch& watch);

}  // namespace cnrg
