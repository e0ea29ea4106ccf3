// How the leaves of a run are drawn, and which nodes are drawn otherwise when they stand alone.
//
// Curved leaves that share a surface are drawn on common lines (csg/carriers/common_lines.h), and near leaves are
// welded (csg/weld): how a leaf is drawn depends on the others of its run. What is said of a node must not depend
// on leaves that are not below it. So a node whose leaves are drawn otherwise with all leaves of the run than with
// those below it alone has its row from a scope of its own.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "csg/carriers/placed_leaves.h"
#include "csg/evaluate/leaf_lines.h"
#include "csg/evaluate/prepared_leaves.h"

namespace cnrg {

class Drawings {
 public:
  /// Draws all leaves of the unfolding; tells of near surfaces and of what was welded. `lines`: of leaves, null
  /// for none. Throws TreeError. All that is given but `diagnostics` and `lines` must outlive this.
  Drawings(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves, const LeafLines* lines,
           std::vector<Diagnostic>& diagnostics);

  const PlacedLeaves& whole() const { return whole_; }
  /// Who has its lines there.
  const std::set<std::uint32_t>& with_lines() const { return with_lines_; }
  /// The leaves below an instance as they are drawn alone; the others have no geometry. Throws TreeError.
  PlacedLeaves alone(InstanceId id);
  /// True if the leaves below an instance are drawn in `placed` as they are alone.
  bool as_alone(InstanceId id, const PlacedLeaves& placed);
  /// True if planes and half-spaces are drawn no farther for other leaves: there are none, or no others.
  bool framed_as_alone(InstanceId root) const;
  /// The instances below `root`, without it, that are not drawn in `placed` as they are alone, nor is one between.
  std::vector<InstanceId> otherwise_below(InstanceId root, const PlacedLeaves& placed);

 private:
  using Drawn = std::map<LeafId, LeafInstance>;
  void find_lines(const LeafLines& lines);
  void find_affected(bool any_refused);
  /// True if a leaf is drawn anew for its own lines alone.
  bool by_its_lines(LeafId leaf);
  void find_representatives();
  const Drawn& drawn_alone(InstanceId representative);
  PlacedLeaves draw_only(const std::vector<LeafId>& leaves) const;
  /// Leaves of one group as they are drawn without the others.
  const std::vector<LeafInstance>& drawn(const std::vector<LeafId>& leaves);

  const Tree& tree_;
  const Unfolding& unfolding_;
  const PreparedLeaves& leaves_;
  ExtraOfInstances extra_;
  PlacedLeaves whole_;
  std::set<std::uint32_t> with_lines_;
  std::vector<std::uint32_t> group_;  // by leaf: only those of one group depend on each other
  std::vector<std::size_t> size_;     // of each group
  std::vector<char> affected_;        // by group: its leaves may be drawn otherwise if they are fewer
  IdVector<InstanceId, InstanceId> representative_;  // first instance with the same affected leaves; none: without
  std::map<std::vector<LeafId>, std::vector<LeafInstance>> drawn_;
  std::map<InstanceId, Drawn> alone_;  // of representatives: the affected leaves below them
};

}  // namespace cnrg
