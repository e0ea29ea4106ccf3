// Which side of a surface a component is on: it tells pieces of one region apart that a fault has cut
// (csg/SEMANTICS.md#sides-of-surfaces).
//
// A surface is a leaf without regions: a polygon, a height field, a mesh that bounds nothing. The front of its
// faces is the one that the leaf gave them, and moves with the leaf. Walls of solids part what is inside from what
// is outside, which `inside` tells, and two regions of one solid by a wall whose front means nothing.
//
// A component touches a side where a face of the value, which came from the surface, is next to its 3-cells. It is
// in front of a surface if it touches its front and nowhere its back: around the end of a fault it is neither.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "csg/operators/node_value.h"

namespace cnrg {

struct SurfaceSide {
  LeafId surface;
  bool front = true;
  friend auto operator<=>(const SurfaceSide&, const SurfaceSide&) = default;
};

/// By component, of component i at i - 1: the sides that it touches, ascending and unique.
using TouchedSides = std::vector<std::vector<SurfaceSide>>;
TouchedSides touched_sides(const Complex& complex, const Group& group);
TouchedSides touched_sides(const Complex& complex, const Components& components);

/// True if sides of these surfaces (ascending) are touched, and all are fronts, or all are backs.
bool lies_on(const std::vector<SurfaceSide>& touched, std::span<const LeafId> surfaces, bool front);

/// A component is in front of the surfaces of one name, or behind them.
struct NamedSide {
  std::string surface;
  bool front = true;
  bool tells = false;  ///< another component with the name of this one is not there
  /// As `select` has it: `front of`.
  const char* key() const { return front ? "front of" : "behind"; }
};

/// By component, of component i at i - 1: where it is, by the names of surfaces. Those without a name are left
/// out.
std::vector<std::vector<NamedSide>> named_sides(const Complex& complex, const NodeValue& value,
                                                const std::function<std::string(LeafId)>& name_of);

}  // namespace cnrg
