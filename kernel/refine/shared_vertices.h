// Vertices of two leaves in one place, the kind of contact that no pair of elements is tested for.
#pragma once

#include "kernel/refine/input.h"

namespace cnrg {

/// How often a vertex of one leaf is a vertex of another (vertex-vertex in Gursoz et al. 1991): each place counts
/// once for every pair of leaves that have a corner, an end or a point there. Within a leaf equal points are one.
std::uint64_t shared_vertices(const Soup& soup, const RefineInput& input);

}  // namespace cnrg
