// Facets of curved faces of snapped and joined results, as large as they are flat but for last digits.
//
// What was snapped or joined was a drawing of triangles (csg/result/relabel.h), and those of a facet that changed
// some last digits lie in planes of their own. A mesh would keep the lines between them for nothing, and where
// facets are long and thin, as those of a shaft are, such a line meets their sides in an angle of a degree. So
// they are one facet again: rounding moves points of facets that are whole off their planes as far.
#pragma once

#include "csg/result/flat.h"
#include "csg/result/snap_drawing.h"

namespace cnrg {

/// So many units in the last place of the largest coordinate may points be off the plane of their facet.
inline constexpr double kPlanarDigits = kSnapFirstCell;

inline bool is_curved(const FlatComplex::Face& face) { return face.facets.size() > 1; }

/// The result flattened for meshes. Of a curved face of a snapped or joined result, facets beside each other are
/// one where they are so near to one plane, and their triangles are seen from one side; edges and points of the
/// result stay what they are. Loops of such facets may pass a point more than once.
FlatComplex flatten_for_mesh(const ResultView& view);

}  // namespace cnrg
