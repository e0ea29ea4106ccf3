// A flattened result as a drawing whose points can be moved.
#pragma once

#include "csg/result/flat.h"
#include "csg/result/moved_drawing.h"

namespace cnrg {

/// True if a face or line reaches the frame of unbounded leaves.
bool reaches_frame(const FlatComplex& flat);

/// Throws InputError if a face or line reaches the frame of unbounded leaves: `why` it must not, as the beginning
/// of the message.
void require_bounds(const FlatComplex& flat, const char* why, const char* otherwise);

/// All cells of a flattened result, by their numbers there.
NumberedDrawing drawing_of_cells(const FlatComplex& flat);

}  // namespace cnrg
