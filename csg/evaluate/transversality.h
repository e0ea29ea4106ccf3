// Whether curved patches of different leaves cross as their facets do.
//
// What is computed is exact for facets. Where two facets cross, the true surfaces over their cells cross in the
// same way if their normals are nowhere parallel there: then each pair of pieces of them meets in one curve that
// no small change makes or takes away. This is decided by intervals, so "transversal" is proven and the rest is
// uncertain: the surfaces touch, cross at a very small angle, or the facets are too coarse to tell.
//
// A contact that both tessellations contain is what it is meant to be and is not asked about: an edge that both
// have, facets that two patches of one surface share, an edge of one along which it touches the other without
// crossing it. Facets of two surfaces that overlap in a part of each are uncertain: between the surfaces there is
// something, or one is not inside of the other. What is flat contains all its lines. A leaf without true surfaces
// (a mesh, a grid) is its facets.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "csg/leaves/surface_parameters.h"

namespace cnrg {

/// A connected set of edges along which two patches cross, none of them proven to be transversal.
struct UncertainPlace {
  std::array<LeafId, 2> leaves;
  std::array<std::uint32_t, 2> patches{};
  std::vector<EdgeId> edges;  ///< ascending
  std::array<double, 3> at{};
  /// How many times finer facets would prove it, as far as can be told: a power of two; 0 if 1024 times would not.
  int finer = 0;
};

struct Transversality {
  std::size_t edges = 0;               ///< those where a curved patch crosses one of another leaf
  std::vector<UncertainPlace> places;  ///< by leaves, patches and edges
};

/// `at` and `finer` are filled in for the first `described` places. `asked`: whether an edge matters; it is asked
/// of edges between leaves with a curved one among them. Without `at_vertices` a contact is left out that is
/// uncertain only next to a vertex that both tessellations have, as where two equal pipes cross: how surfaces
/// touch in such a point is decided when they are drawn, though it is not proven here.
Transversality transversality(
    const Complex& complex, const SurfaceParameters& parameters, std::size_t described,
    const std::function<bool(EdgeId)>& asked = [](EdgeId) { return true; }, bool at_vertices = true);

}  // namespace cnrg
