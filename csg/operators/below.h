// What of a solid lies below a surface, and what above it (csg/SEMANTICS.md#below-and-above).
//
// The obvious way, a half-space bent to the surface, needs a lid: somebody has to make walls from the rim of the
// surface down to the bottom of the solid, and these have to miss or meet everything exactly. Here nothing is
// made. The surface cuts the solid into pieces, and which of them lie below is a matter of how many times one
// crosses the surface on the way: pieces on the two sides of a face of the surface are of different colors. If
// that is contradictory, the surface ends inside of the solid, or branches there, and the place is told.
#pragma once

#include <string>

#include "csg/geometry/transform.h"
#include "csg/operators/group.h"

namespace cnrg {

enum class Side : std::uint8_t { below, above };

/// The part of `block` on one side of `surface` as a solid of its own: its regions are the pieces of the block
/// there, and it has walls where they end, those on the surface with the origins of the surface. So
/// `block` intersected with it, the block dominating, is that part with all that is inside of it.
/// Throws InputError, which names both operands by `surface_name` and `block_name`, for a surface with regions, a
/// block without, and for a surface that does not part the block; with `proven` also for a curved one that does
/// not enter a part of it. Upwards is the z-axis that `transform` moves.
Group part_of(const Complex& complex, Side side, const Group& surface, const std::string& surface_name,
              const Group& block, const std::string& block_name, const Transform& transform, bool proven);

/// A source of the face is a facet of a curved surface.
bool is_curved(const Complex& complex, FaceId f);

}  // namespace cnrg
