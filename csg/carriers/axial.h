// Leaves of revolution that their transform stretches along their own axis, or across it alike on all sides: they
// are leaves of revolution still, about the image of the axis.
//
// A cylinder of length 1 that is stretched to 3 is the cylinder of length 3, and meets others about its axis as
// that one does. As it stands it would be taken for something that is round in a stretched space of its own.
#pragma once

#include <map>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Puts leaves that are what the stretched ones become in their places, with the identity as transform; returns
/// what was there, by instance. Meridians with arcs become others, and stay; so do leaves whose turn would begin
/// elsewhere, and all that are stretched as one of these is, for with that they may share something.
std::map<std::uint32_t, LeafInstance> replace_axial(std::vector<LeafInstance>& instances);

/// Puts those back that nothing else has replaced.
void restore_axial(const std::map<std::uint32_t, LeafInstance>& before, std::vector<LeafInstance>& instances);

}  // namespace cnrg
