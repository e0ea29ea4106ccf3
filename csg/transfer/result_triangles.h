// Triangles of a face of a result file, and the cells of its patch, against the face. They are not made again:
// which of two diagonals halves a rectangle is left to who writes.
#pragma once

#include <vector>

#include "csg/imports/result_content.h"
#include "kernel/complex/complex.h"

namespace cnrg::result {

/// The face that a facet of the file has become, and whether it has the same front.
struct PlacedFacet {
  FaceId cell;
  bool same = true;
};

/// `at` is the face in the file, whose points have their numbers in the complex. Throws LeafFileError.
void require_triangles(const Complex& complex, const Content& content, const Face& face,
                       const std::vector<PlacedFacet>& facets, const Cursor& at);

}  // namespace cnrg::result
