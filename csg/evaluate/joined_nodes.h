// Nodes whose near features are joined inside of a tree: `simplify: {of: node, within: d}`.
//
// All that operators do is to select cells of one complex, in which all leaves have met. Joining moves points, and
// what is moved has other cells, which no complex has that was refined before. So the operand is evaluated by
// itself, as the root of a complex of its own, and joined there (csg/result/join.h); the result is a leaf of the
// complex of those who use the node, exact and with all that a `.json` of it tells: components, names, materials,
// attributes, open sets, sheets, wires and points. Distances are those of the operand where it stands below the
// node: the node's own transform, and those above, move what was joined, once, however many instances there are.
//
// Cells know the leaves below that made them: `join` tells of each new cell which old ones it is of, and the leaf
// keeps that (StoredValue). In the users' complex these leaves have numbers of their own (leaf_numbers.h), so what
// is asked of leaves, as `from` and `size`, finds them. What is lost are true surfaces, where something was
// joined.
#pragma once

#include <functional>
#include <vector>

#include "csg/certify/certificate.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/leaf_numbers.h"

namespace cnrg {

class JoinedNodes {
 public:
  /// Evaluates one node with the joined nodes below it.
  using Evaluate = std::function<Evaluation(NodeId, const EvaluateOptions&, const JoinedLeaves&)>;

  /// Evaluates and joins the operands of all nodes below the roots that ask for it, operands before users. Throws
  /// as `evaluate` does; TreeError, at the node, where `join` refuses.
  JoinedNodes(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
              const Evaluate& evaluate);

  const JoinedLeaves& leaves() const { return leaves_; }
  /// Adds what was joined to the evaluation of the roots, and its diagnostics before those that are there.
  void tell(Evaluation& evaluation);

 private:
  JoinedLeaves leaves_;
  std::vector<JoinedNode> joined_;
  std::vector<Diagnostic> diagnostics_;
  Certificate certificate_;
  double refine_seconds_ = 0;

  void add_diagnostics(std::vector<Diagnostic> more);
  void join_operand(const Tree& tree, NodeId id, const EvaluateOptions& options, const Evaluate& evaluate);
};

}  // namespace cnrg
