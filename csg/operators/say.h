// Attributes of a leaf or a node, put on all that has attributes in its value: on its regions or components, and
// on what stands for itself in lower dimensions (origins.h).
#pragma once

#include "csg/operators/components.h"

namespace cnrg {

/// Does what is said give way to what was said before, or replace it? `replaces_standing`: the same, but of what
/// stands for itself in the value alone; a wall of it keeps what was said.
enum class Saying : std::uint8_t { fills_in, replaces, replaces_standing };

/// Says `what` of all sheets, wires and isolated vertices of the group, and of the cells of which something is
/// said already (origins.h); its regions stay as they are.
void say(const Complex& complex, const Attributes& what, Saying saying, Group& group);

/// The same for components. A face stands for itself if it has the same component, or none, on both sides, and is
/// no cell of that component; likewise edges and vertices that bound nothing.
void say(const Complex& complex, const Attributes& what, Saying saying, Components& components);

}  // namespace cnrg
