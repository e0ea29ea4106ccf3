// TetGen (si2015) in a process of its own (csg/text/child.h): its library throws numbers, prints, and ends the
// process where an assertion of its own fails; none of that reaches the caller.
#pragma once

#include <stop_token>
#include <string>

#include "csg/mesh/plc.h"

namespace cnrg {

/// What TetGen returns, of a box around the complex. The points of the complex keep their numbers; the corners of
/// the box and Steiner points follow.
struct TetgenResult {
  using Index = std::uint32_t;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<Index, 4>> tetrahedra;
  std::vector<std::int32_t> attribute;  ///< of each tetrahedron: place in `Plc::regions` + 1; more: none
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::int32_t> facet;  ///< of each triangle: place in `Plc::facets`; more: on the box
  std::vector<std::array<Index, 2>> segments;
  std::vector<std::int32_t> edge;  ///< of each segment: the edge, or -1 where there is none
};

/// The box around the complex: equally far away on all sides, or a little further on each than on the one before.
/// A model and its even box may be so regular together (their corners on one sphere) that TetGen stops at an
/// assertion of its own.
enum class TetgenFrame { even, uneven };

/// Runs TetGen's library with these switches besides `pAQMJ`, for so many seconds of processor time at most (0: no
/// bound; there are models on which it never ends).
/// Throws InputError with what TetGen said and what helps, std::bad_alloc when it runs out of memory, Stopped.
TetgenResult run_tetgen(const Plc& plc, const std::string& switches, TetgenFrame frame, int seconds,
                        const std::stop_token& stop = {});

}  // namespace cnrg
