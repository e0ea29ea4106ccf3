// Curved leaves that have a surface in common are drawn on common lines of it.
//
// Every curved leaf is drawn with facets, exactly, but two that are drawn apart do not agree: a shaft of 24
// segments in a bore of 32 leaves slivers of void, a ball minus the same ball turned round leaves splinters. A
// tolerance would hide that and break what is exact. Instead the surfaces themselves are compared, exactly, before
// any facet is refined: leaves that lie on one carrier, or touch along one, are tessellated once more, all on the
// same lines. Those that share nothing stay as they are. Which lines these are depends on the set of leaves, not
// on their order. Leaves that were moved together are drawn where they stood, and moved then.
#pragma once

#include <set>
#include <vector>

#include "csg/carriers/drawn_leaves.h"
#include "csg/carriers/extra_lines.h"
#include "csg/carriers/near_surfaces.h"
#include "csg/leaves/leaf.h"
#include "kernel/base/leaf_words.h"

namespace cnrg {

/// The same instances in the same order, those that share something with others tessellated anew (their
/// parameters, too). What they are not is said by `LeafInstance`: the transform of one may have changed.
/// `near`, if given, gets the surfaces that are nearly one; `apart` the leaves that share something and yet stay
/// as they are, and why. `anew`: leaves of revolution that are to be drawn in any case, for
/// they are not drawn on the surfaces that they say they have. `extra`: instances with further lines, which all
/// leaves that share the surface have, too; `drawn`, if given, gets those that have them. The others cannot:
/// meshes, extrusions with `twist` or `scale`, faces of CAD models, leaves of revolution that are stretched by a
/// number that is not rational. `known`, if given, keeps leaves from one drawing to the next.
std::vector<LeafInstance> with_common_lines(
    std::vector<LeafInstance> instances, std::vector<NearSurfaces>* near = nullptr,
    std::vector<LeafWords>* apart = nullptr, const std::vector<std::uint32_t>& anew = {},
    const ExtraOfInstances& extra = {}, std::set<std::uint32_t>* drawn = nullptr, DrawnLeaves* known = nullptr);

/// To the space of the tree from that where some leaves stood before they were moved together: what moves most of
/// them. If that is not one transform, it is the one from which the others are seen as the least ones, so that a
/// move of all changes nothing.
Transform space_of(const std::vector<std::uint32_t>& members, const std::vector<LeafInstance>& instances);

/// The leaves where they were before they were moved.
std::vector<LeafInstance> before(const Transform& motion, const std::vector<LeafInstance>& instances);

}  // namespace cnrg
