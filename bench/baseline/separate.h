// How null edges are made of pairs of crossings.
#pragma once

#include <vector>

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {

/// Two rays of a crossing that become the ends of a pair of null edges.
struct RayPair {
  std::uint32_t forward, backward;
};

/// A ring of one vertex at p: a strut from the outer loop, whose edge is killed (the book's makering).
template <class N>
HalfEdgeId make_ring(Scene<N>& scene, FaceId face, const Vec<N>& p);

/// Makes the null edges of A and B for each pair without the departure `order`.
template <class N>
std::vector<std::array<EdgeId, 2>> separate(Scene<N>& scene, const Crossing<N>& crossing,
                                            const std::vector<RayPair>& pairs);

}  // namespace cnrg::bench::mantyla
