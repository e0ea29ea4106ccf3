// Leaves as they are refined, by LeafId: on common lines, and welded where the tree asks for that.
#pragma once

#include <vector>

#include "csg/carriers/surface_numbers.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

struct PlacedLeaves {
  std::vector<LeafInstance> instances;
  std::vector<std::vector<std::uint32_t>> surfaces;  ///< as `make_soup` has it
  SurfaceEquations equations;                        ///< of `surfaces`, before the motion of ProvenLines
};

}  // namespace cnrg
