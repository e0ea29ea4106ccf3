// Further lines of facets with which surfaces are proven to meet as facets do (csg/certify/proof.h).
//
// Leaves are drawn and asked; where facets are too coarse for the proof they get lines, and are drawn and asked
// again. So the facets of a leaf depend on what it meets; it costs only where surfaces are nearer to a contact
// than facets are to surfaces. Leaves that meet others nowhere near them have the same lines with these and
// without: each set of leaves has a budget of its own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "csg/carriers/extra_lines.h"
#include "csg/certify/certificate.h"
#include "csg/certify/proof.h"
#include "csg/evaluate/evaluate.h"

namespace cnrg {

class ProvenLines {
 public:
  /// The leaves of a run, drawn with lines. What it gives may go with the next call.
  using Draw = std::function<const PlacedLeaves&(const ExtraOfInstances&)>;

  /// Draws at least once; `relevance` is made where something is asked. The last drawing is that with `lines()`.
  /// What is drawn is asked as it is before `motion`, which stretches all lengths alike: where leaves that were
  /// moved together stand decides nothing.
  ProvenLines(const Draw& draw, const std::function<Relevance()>& relevance, const EvaluateOptions& options,
              Moulds& moulds, Transform motion);

  const ExtraOfInstances& lines() const { return lines_; }
  /// Sets of leaves, ascending, of which something was not proven of the facets of some drawing.
  const std::set<std::vector<LeafId>>& undecided() const { return undecided_; }
  /// The same of which something dies, and was not asked.
  const std::set<std::vector<LeafId>>& dead() const { return dead_; }
  /// Of the last drawing; nothing if nothing was asked. `evaluation` has the names.
  std::shared_ptr<const Certificate> certificate(const Evaluation& evaluation) const;

 private:
  bool add_lines();

  Transform motion_;
  ExtraOfInstances lines_;
  std::set<std::vector<LeafId>> undecided_, dead_;
  std::unique_ptr<Pieces> pieces_;
  std::optional<Proof> proof_;
};

}  // namespace cnrg
