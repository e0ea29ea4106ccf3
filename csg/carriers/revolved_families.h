// Leaves of revolution that touch one another about one axis, tessellated together.
#pragma once

#include <map>

#include "csg/carriers/axes.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

/// What an instance must have in its tessellation beside what it shares with others about its axis.
struct Marks {
  std::vector<RationalPoint> directions;  ///< at right angles to the axis: unit vectors, exactly
  std::vector<RationalPoint> points;      ///< on balls, whole ones or parts
  std::vector<MeridianPoint> circles;     ///< on arcs, as `place` (axes.h) has them
  bool needed = false;                    ///< some are no vertices of the leaf as it is
};

/// A ball or tube that touches a tube from inside, about another axis that is parallel: see nested_turns.h. The
/// unit vector `direction` points from both axes to the contact.
struct Inside {
  std::uint32_t inner = 0, outer = 0;
  RationalPoint direction;
};

struct Contacts {
  std::map<std::uint32_t, Marks> marks;  ///< by instance, in the space of the tree
  /// Whole spheres of which one touches the other from inside: a point alone would not keep facets apart around
  /// it, so these two share the axis through their centres.
  std::vector<std::array<std::uint32_t, 2>> nested;
  std::vector<Inside> inside;
};

/// Of pairs of instances those that may have an axis in common, by doubles.
std::vector<std::array<std::uint32_t, 2>> near_axes(const std::vector<LeafInstance>& instances,
                                                    const std::vector<std::array<std::uint32_t, 2>>& pairs);

/// Replaces the instances concerned. `near`: pairs of `near_axes`, each once. `notices`: of banded leaves that
/// stay as they are, `leaf 2, face 3 ...`.
void share_axes(std::vector<LeafInstance>& instances, const std::vector<std::array<std::uint32_t, 2>>& near,
                const Contacts& contacts, std::vector<std::string>& notices);

}  // namespace cnrg
