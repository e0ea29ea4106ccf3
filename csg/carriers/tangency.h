// Where round leaves touch planes and each other at a point or along a line, about no common axis.
//
// A ball on a table touches it in one point, and only if this point is one of its corners do its facets touch the
// table at all. Whether two surfaces touch is decided exactly: a distance of rational square equals a sum of radii
// or it does not. Where they do, the point of contact is rational, and becomes a vertex of both.
#pragma once

#include <map>

#include "csg/carriers/revolved_families.h"
#include "kernel/refine/box.h"

namespace cnrg {

/// A revolved instance with a box around it.
struct RevolvedInstance {
  std::uint32_t instance = 0;
  Box box;
};

/// The contacts of balls, cylinders and planes of all instances. `pairs`: instances whose boxes meet, each once.
Contacts contacts(const std::vector<LeafInstance>& instances, const std::vector<RevolvedInstance>& revolved,
                  const std::vector<std::array<std::uint32_t, 2>>& pairs);

}  // namespace cnrg
