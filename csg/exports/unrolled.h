// A face laid out in the parameters of its surface.
//
// CAD programs bound a face by loops of curves in the plane of the surface's parameters. Where the surface closes
// on itself (a cylinder after a turn, a sphere, a torus) a face may go round, and a ring is no loop there: the
// face is cut open along a seam, an edge that its boundary runs through twice. To find seams by following boundary
// curves, as repair programs do, goes wrong where loops are many, or none as on a whole sphere. But we have
// facets: they are laid out one beside the other, each where its neighbour says. If that goes without
// contradiction there is no seam, whatever the line is at which parameters begin anew. Else the facets are cut
// along a line of one parameter, of which there is one between facets, and laid out again; pieces are put together
// again where that goes without contradiction, and what is left of the cut is the seam.
//
// A point at which one parameter may be anything (a pole, the apex of a cone) contradicts nothing; the walk along
// the boundary passes it with a jump.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cnrg {

struct UnrollCorner {
  std::uint32_t point = 0;
  std::array<double, 2> at{0, 0};
  std::array<bool, 2> free{false, false};  ///< may be anything
};
/// Loops with the facet to the left, holes too.
using UnrollFacet = std::vector<std::vector<UnrollCorner>>;

struct Unrolled {
  struct Step {
    UnrollCorner from, to;
    bool seam = false;
  };
  std::vector<std::vector<Step>> loops;             ///< closed, no loop passes a place twice
  std::vector<std::array<std::uint32_t, 2>> seams;  ///< pairs of points, the smaller one first
  std::vector<Step> inner;                          ///< sides between facets that are no seams, each once
  double area = 0;                                  ///< of all facets in the parameters, with its sign
};

/// `period`: of each parameter, 0 for one that has none; `slack`: what two places of one point may differ by.
/// Nothing if facets contradict each other, however they are cut.
std::optional<Unrolled> unroll(const std::vector<UnrollFacet>& facets, const std::array<double, 2>& period,
                               const std::array<double, 2>& slack);

}  // namespace cnrg
