// Loops of facets, into a soup and out of a complex.
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

/// A walk around a facet by numbers of points.
using FacetLoop = std::vector<std::uint32_t>;

/// Takes away loops that enclose nothing: an edge inside of a face, walked there and back.
inline void drop_slits(std::vector<FacetLoop>& loops) {
  std::erase_if(loops, [](const FacetLoop& loop) { return loop.size() < 3; });
}

/// The loops of a soup's face; `point` is the soup's point of a number.
template <class PointOf>
std::vector<std::vector<PointId>> soup_loops(const std::vector<FacetLoop>& loops, PointOf point) {
  std::vector<std::vector<PointId>> out;
  for (const FacetLoop& loop : loops) {
    std::vector<PointId>& corners = out.emplace_back();
    for (const std::uint32_t p : loop) corners.push_back(point(p));
  }
  return out;
}

/// The loops of a face of a complex, as seen from its front, without slits; `number` is that of a vertex.
template <class NumberOf>
std::vector<FacetLoop> facet_loops(const Complex& complex, FaceId f, NumberOf number) {
  std::vector<FacetLoop> out;
  for (const LoopId l : complex.face_loops[f]) {
    FacetLoop& loop = out.emplace_back();
    for (const HalfEdge h : complex.loop[l]) loop.push_back(number(complex.origin(h)));
  }
  drop_slits(out);
  return out;
}

inline void turn(std::vector<FacetLoop>& loops) {
  for (FacetLoop& loop : loops) std::reverse(loop.begin(), loop.end());
}

}  // namespace cnrg
