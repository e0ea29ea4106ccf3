// How the leaves of a run are drawn, and which nodes are drawn otherwise when they stand alone.
//
// Curved leaves that share a surface are drawn on common lines (csg/carriers/common_lines.h), near leaves are
// welded (csg/weld), and leaves have finer facets where these would not meet as surfaces do (proven_lines.h): how
// a leaf is drawn depends on the others of its run. What is said of a node must not depend on leaves that are not
// below it. So a node whose leaves are drawn otherwise with all leaves of the run than with those below it alone
// has its row from a scope of its own.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "csg/carriers/drawn_leaves.h"
#include "csg/carriers/placed_leaves.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/evaluate/proven_lines.h"

namespace cnrg {

class Drawings {
 public:
  /// Draws all leaves of the unfolding; tells of near surfaces and of what was welded. Throws TreeError. All that
  /// is given but `diagnostics` must outlive this.
  Drawings(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves,
           const EvaluateOptions& options, std::vector<Diagnostic>& diagnostics);

  const PlacedLeaves& whole() const { return whole_; }
  /// What is proven of it; null if nothing was asked. `evaluation` has the names.
  std::shared_ptr<const Certificate> certificate(const Evaluation& evaluation) const {
    return proven_->certificate(evaluation);
  }
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
  using Leaves = std::vector<LeafId>;
  Relevance relevance_for(const std::vector<InstanceId>& roots) const;
  void find_affected(bool any_refused);
  void find_representatives();
  const Drawn& drawn_alone(InstanceId representative);
  /// Further lines of the leaves below an instance when it stands alone.
  ExtraOfInstances lines_alone(InstanceId id);
  /// True if leaves below an instance have the same facets alone as in `first_`, all without further lines.
  bool first_alike(const Leaves& below);
  /// What all of these leaves, or most of them, were moved by, where that stretches all lengths alike.
  Transform motion_of(const Leaves& leaves) const;
  /// Some leaves drawn without the others.
  PlacedLeaves draw_only(const Leaves& leaves, const ExtraOfInstances& lines);
  /// Leaves of one group as they are drawn without the others.
  const std::vector<LeafInstance>& drawn(const Leaves& leaves, const ExtraOfInstances& lines);

  const Tree& tree_;
  const Unfolding& unfolding_;
  const PreparedLeaves& leaves_;
  const EvaluateOptions& options_;
  Moulds moulds_;
  DrawnLeaves drawn_leaves_;
  PlacedLeaves whole_, first_;  // the second without further lines
  Transform motion_;            // of all leaves
  std::unique_ptr<const ProvenLines> proven_;
  std::vector<std::uint32_t> group_;  // by leaf: only those of one group have lines in common
  std::vector<std::size_t> size_;     // of each group
  std::vector<char> affected_;        // by group: its leaves may be drawn otherwise if they are fewer
  IdVector<InstanceId, InstanceId> representative_;  // first instance with the same leaves; none: none is affected
  std::map<std::pair<Leaves, ExtraOfInstances>, std::vector<LeafInstance>> drawn_;
  std::map<InstanceId, Drawn> alone_;  // of representatives: the affected leaves below them
  std::map<Leaves, ExtraOfInstances> lines_alone_;
};

}  // namespace cnrg
