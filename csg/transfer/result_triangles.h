// Triangles of a face of a result file, and the cells of its patch, against the face. They are not made again:
// which of two diagonals halves a rectangle is left to who writes.
#pragma once

#include "csg/transfer/stored_value.h"
#include "kernel/complex/complex.h"

namespace cnrg::result {

/// The face that a facet of the file has become, and whether it has the same front.
struct PlacedFacet {
  FaceId cell;
  bool same = true;
};

/// `face` is what the cells of the file make of a face, `placed` its facets, `at` its place in the file, whose
/// points have their numbers in the complex. Throws LeafFileError.
void require_triangles(const Complex& complex, const FlatComplex::Face& face, const PlacedFacet* placed,
                       const Cursor& at);
/// Each facet lies in the cells of its patch.
void require_cells(const std::vector<RationalPoint>& points, const FlatComplex::Face& face, const Cursor& at);

}  // namespace cnrg::result
