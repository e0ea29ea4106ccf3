// Leaves of Bézier, B-spline and Coons patches, of curves and of extrusions, tessellated alike where they overlap.
//
// Each leaf alone has facets that depend on its own net, place and fineness. So two leaves with one curved wall in
// common, of which one has more segments or reaches farther, would overlap a little and leave slivers between
// them. Here those that share a carrier (net_carriers.h) or a curve are cut along the same lines, into sub-patches
// that are the same patch in both (cuts.h), with steps that all of them agree on. `mesh_patch`
// makes of equal patches equal facets, so the overlap is one set of facets, and its border the same edges.
//
// Walls of extrusions are compared by their segments, projected along the vector: they need the same rulings.
// Their rims are curves in space like the sides of patches.
#pragma once

#include <set>
#include <vector>

#include "csg/carriers/extra_lines.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

/// The same instances. Those that share a surface or a curve with another one, by more than points, are replaced
/// by leaves in the place of the given ones, with the identity as transform; all others stay as they are. Nothing
/// depends on their order. `extra`: further lines, and `drawn`, if given, gets who has them. Throws InputError,
/// the message names the instance as `leaf N`.
std::vector<LeafInstance> with_common_nets(const std::vector<LeafInstance>& instances,
                                           const ExtraOfInstances& extra = {},
                                           std::set<std::uint32_t>* drawn = nullptr);

}  // namespace cnrg
