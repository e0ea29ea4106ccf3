// The planar facets of the faces of a flattened result.
#pragma once

#include "csg/result/flat.h"

namespace cnrg {

/// `body(loops, isolated, begin, end)` of each facet of a face, in order, with the places of its triangles; a flat
/// face is one.
template <class Body>
void for_each_facet(const FlatComplex::Face& face, const Body& body) {
  if (face.facets.empty()) {
    body(face.loops, face.isolated, FlatComplex::Index(0), FlatComplex::Index(face.triangles.size()));
    return;
  }
  FlatComplex::Index begin = 0;
  for (std::size_t k = 0; k < face.facets.size(); ++k) {
    body(face.facets[k].loops, face.facets[k].isolated, begin, face.facet_ends[k]);
    begin = face.facet_ends[k];
  }
}

}  // namespace cnrg
