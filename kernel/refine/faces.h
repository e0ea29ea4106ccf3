// The faces of all sheets in one numbering.
#pragma once

#include <vector>

#include "kernel/refine/refine.h"

namespace cnrg {

/// Sets the arrays of faces and loops, in the order of sheets. `work`, ascending, are the sheets that were
/// subdivided, with their faces in `results`; each other sheet is one lone triangle, `representative`.
void collect_faces(Refinement& refinement, const IdVector<SheetId, SourceId>& representative,
                   const std::vector<SheetId>& work, const std::vector<SheetFaces>& results);

}  // namespace cnrg
