// Boxes around curved leaves, as their surfaces are and not as they are drawn.
#pragma once

#include "csg/curves/extrude.h"
#include "csg/curves/revolved.h"
#include "kernel/refine/box.h"

namespace cnrg {

/// Wide enough for what doubles round.
Box box_of(const RevolvedForm& form, const Transform& transform);
/// By control points.
Box box_of(const ExtrudeForm& form, const Transform& transform);

}  // namespace cnrg
