// Sectors of faces at a vertex, and what both ways of comparing two vertices have in common.
#pragma once

#include <vector>

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {

/// A corner of a face at a vertex, less than half a turn wide, clockwise from `from` to `to`.
template <class N>
struct Sector {
  Vec<N> from, to, normal;
  HalfEdgeId half_edge;  ///< along `to`; none where `to` bisects a wide corner
};

/// All sectors of a vertex, clockwise.
template <class N>
std::vector<Sector<N>> neighbourhood(const Scene<N>& scene, VertexId vertex);

template <class N>
bool same_direction(const Metric<N>& metric, const Vec<N>& p, const Vec<N>& q) {
  return metric.null_unit(cross(p, q)) && dot(p, q) > 0;
}

template <class N>
bool strictly_within(const Metric<N>& metric, const Vec<N>& p, const Sector<N>& s) {
  return metric.unit_sign(dot(s.normal, p)) == 0 && metric.unit_sign(dot(s.normal, cross(p, s.from))) > 0 &&
         metric.unit_sign(dot(s.normal, cross(s.to, p))) > 0;
}

/// Where a ray lies on a neighbourhood: start, inside or end of a sector.
enum class Within : std::uint8_t { start, inside, end };
struct Place {
  std::size_t sector = 0;
  Within within = Within::inside;
};

/// The star of a vertex: its half-edges, and rays by their places.
template <class N>
std::vector<StarItem> star_of(const std::vector<Sector<N>>& sectors, const std::vector<Place>& places,
                              const std::vector<Ray<N>>& rays);

/// A vertex of A and one of B by pairs of sectors, without the departure `arcs`.
template <class N>
Crossing<N> compare_pairs(const Scene<N>& scene, const VertexVertex& contact);

}  // namespace cnrg::bench::mantyla
