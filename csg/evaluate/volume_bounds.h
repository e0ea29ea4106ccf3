// How far the volumes of nodes may be from those between the true surfaces.
//
// A point of space changes sides where a cell of some leaf passes it on the way from facets to surfaces
// (csg/certify/swept_leaf.h), and whether it is in the value of a Boolean follows from the leaves in which it is.
// So volumes differ by no more than what all cells pass by; of operands that are intersected or subtracted only
// where the others are.
//
// Bounds are computed when somebody asks.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "csg/carriers/placed_leaves.h"
#include "csg/certify/relevance.h"
#include "csg/certify/swept_leaf.h"
#include "csg/evaluate/prepared_leaves.h"

namespace cnrg {

/// What the bounds of all drawings of a run share.
class SweptLeaves {
 public:
  SweptLeaves(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves);

 private:
  const SweptLeaf& of(const LeafInstance& leaf);
  IdVector<InstanceId, TreeStep> steps_;
  std::vector<char> curved_;  // the same: a leaf below has true surfaces
  std::map<std::pair<const PreparedLeaf*, const Transform*>, std::pair<LeafInstance, SweptLeaf>> known_;
  std::mutex mutex_;
  friend class VolumeBounds;
};

/// Of nodes below some roots, as they are drawn.
class VolumeBounds {
 public:
  VolumeBounds(std::shared_ptr<SweptLeaves> shared, const PlacedLeaves& placed);
  /// Of an instance; nothing if of curved faces below it only the facets are known.
  std::optional<double> of(InstanceId id) const;

 private:
  const std::vector<InstanceId>& operands(InstanceId id) const { return shared_->steps_[id].operands; }
  const SweptLeaf& swept(InstanceId id) const;
  const Slabs& held(InstanceId id) const;
  /// It and all below it, ascending: operands before users. Empty if they are too many.
  std::vector<InstanceId> below(InstanceId id) const;
  std::optional<double> of_few(const std::vector<InstanceId>& below) const;
  std::optional<double> of_any(InstanceId id) const;
  std::shared_ptr<SweptLeaves> shared_;
  std::map<LeafId, LeafInstance> leaves_;
  mutable std::map<InstanceId, Slabs> held_;
  mutable std::map<InstanceId, std::optional<double>> known_;  // of_any
  mutable std::map<InstanceId, std::optional<double>> told_;   // of
};

}  // namespace cnrg
