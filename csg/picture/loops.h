// Loops of facets, into a soup and out of a complex.
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

/// Takes away loops that enclose nothing: an edge inside of a face, walked there and back.
template <class Loop>
void drop_slits(std::vector<Loop>& loops) {
  std::erase_if(loops, [](const Loop& loop) { return loop.size() < 3; });
}

/// The loops of a soup's face; `point` is the soup's point of a number.
template <class Loop, class PointOf>
std::vector<std::vector<PointId>> soup_loops(const std::vector<Loop>& loops, PointOf point) {
  std::vector<std::vector<PointId>> out;
  for (const Loop& loop : loops) {
    std::vector<PointId>& corners = out.emplace_back();
    for (const std::uint32_t p : loop) corners.push_back(point(p));
  }
  return out;
}

/// The loops of a face of a complex, as seen from its front, without slits; `number` is that of a vertex.
template <class Loop, class NumberOf>
std::vector<Loop> facet_loops(const Complex& complex, FaceId f, NumberOf number) {
  std::vector<Loop> out;
  for (const LoopId l : complex.face_loops[f]) {
    Loop& loop = out.emplace_back();
    for (const HalfEdge h : complex.loop[l]) loop.push_back(number(complex.origin(h)));
  }
  drop_slits(out);
  return out;
}

template <class Loop>
void turn(std::vector<Loop>& loops) {
  for (Loop& loop : loops) std::reverse(loop.begin(), loop.end());
}

}  // namespace cnrg
