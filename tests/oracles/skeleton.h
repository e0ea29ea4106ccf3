// The canonical form of a polyhedral point set, in numbers that any system can give: what two independent
// systems must agree on, and nothing that depends on how either of them stores it.
//
// Vertices, edges and facets are maximal: two collinear edges with equal neighbourhoods are one, and so on
// (Nef's simplification; `SimplifyMode::points` of ours). Two bounded point sets with equal skeletons are equal:
// a facet is determined by its boundary, and the marks on the sides of facets tell what is solid.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg::properties {

struct Skeleton {
  struct Vertex {
    RationalPoint point;
    bool mark = true;
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  struct Edge {
    std::array<std::uint32_t, 2> ends{};  ///< ascending
    bool mark = true;
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };
  struct Facet {
    /// Every edge of the boundary once for each side that the facet has on it, ends ascending; sorted.
    std::vector<std::array<std::uint32_t, 2>> boundary;
    std::vector<std::uint32_t> isolated;  ///< vertices in the interior, ascending
    bool mark = true;
    /// Marks of the volumes next to it; above is where the first coordinate that is not zero of the normal grows.
    bool above = false, below = false;
    friend auto operator<=>(const Facet&, const Facet&) = default;
  };
  std::vector<Vertex> vertices;  ///< in lexicographic order
  std::vector<Edge> edges;
  std::vector<Facet> facets;
  std::size_t volumes = 1;  ///< with the unbounded one

  /// Puts everything in order and renumbers the vertices.
  void sort();
  friend bool operator==(const Skeleton&, const Skeleton&) = default;
};

/// Where two sorted skeletons differ, in words; empty when they are equal.
std::string difference(const Skeleton& a, const Skeleton& b);

}  // namespace cnrg::properties
