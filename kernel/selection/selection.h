// A selection on the complex (SCGC): for each cell of any dimension a component, or inactive.
//
// Sparse: only active cells are listed, sorted by id, so that a value costs what it touches. Components are
// numbered from 1; their attributes live with whoever numbered them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

using Component = std::uint32_t;  ///< 0: inactive

struct Selection {
  std::vector<std::pair<VertexId, Component>> vertices;
  std::vector<std::pair<EdgeId, Component>> edges;
  std::vector<std::pair<FaceId, Component>> faces;
  std::vector<std::pair<RegionId, Component>> regions;
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// Entities in their own right that `simplify` keeps (SEMANTICS 6); sorted.
struct Features {
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;
};

}  // namespace cnrg
