// The round surfaces of a tree's leaves that are meant to be one are made one, before they are drawn.
//
// A shaft of radius 1 and a bore of 1.000000000001 are two surfaces, and no weld of facets makes them one: of 24
// and 32 sides, they have few corners near each other. Here leaves of revolution get the axes, centres and radii
// that they agree on (round_carriers.h). What they then have in common is drawn on common lines, exactly as if the
// numbers had been equal in the tree (csg/carriers), and all that is flat is welded after that.
#pragma once

#include <vector>

#include "csg/leaves/leaf.h"
#include "kernel/base/leaf_words.h"

namespace cnrg {

struct WeldedSurfaces {
  std::vector<LeafInstance> instances;  ///< with other forms, still drawn as they were
  std::vector<std::uint32_t> anew;      ///< of these: they are to be drawn on their forms
  Rational farthest = 0;                ///< no point of a surface was moved farther
  LeafWords notice;                     ///< empty: nothing is near
};

/// Cylinders, cones, spheres, tori, `revolve` of straight lines, and bands of CAD models, where their transforms
/// keep angles; of other leaves of revolution the axis alone. Throws InputError that names a leaf or face if it
/// would vanish. d > 0.
WeldedSurfaces weld_surfaces(const std::vector<LeafInstance>& instances, const Rational& d);

}  // namespace cnrg
