// Options and report of refinement.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/progress.h"
#include "kernel/exact/points.h"

namespace cnrg {

/// What was dropped or noteworthy on the way, for reports.
struct RefineReport {
  std::vector<SourceId> zero_area;  ///< faces without area: dropped
  std::uint64_t candidates = 0;     ///< pairs from the broad phase
  /// Pairs in contact by kind (Gursoz et al. 1991): face-face, face-edge, face-vertex, edge-edge, edge-vertex,
  /// vertex-vertex; the last by places and pairs of leaves (refine.cpp).
  std::array<std::uint64_t, 6> contacts{};
  std::uint64_t constructed = 0;    ///< constructed vertices
  StageCounts stages;               ///< predicate calls by deciding stage
  std::vector<VertexId> vertex_of;  ///< by PointId: its vertex; filled if `RefineOptions::vertices` asks for it
};

/// Options of `build_complex`.
struct RefineOptions {
  int threads = 0;        ///< 0: all cores
  Watch watch{};          ///< told of the stages of refinement
  bool vertices = false;  ///< RefineReport::vertex_of is wanted
};

}  // namespace cnrg
