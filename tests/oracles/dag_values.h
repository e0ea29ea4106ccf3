// A random dag through the whole front end: its text is parsed and evaluated, every node's value is kept.
#pragma once

#include <memory>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "tests/oracles/dag.h"

namespace cnrg::properties {

struct DagValues {
  Evaluation evaluation;
  std::vector<std::shared_ptr<const NodeValue>> values;  ///< by node of the dag
  const Complex& complex() const { return *evaluation.complex; }
  /// Those of a node's operands.
  std::vector<const NodeValue*> operands(const DagNode& node) const;
};

/// With every check that evaluation has. Throws as `evaluate` does.
DagValues evaluate(const RandomDag& dag, int threads = 1);
/// As people evaluate: values are given up as soon as nobody needs them, only that of the result is kept.
Evaluation evaluate_result(const RandomDag& dag);

/// The same, TreeError told as `refused: ...` and other exceptions as `thrown: ...` in `failure`.
struct Attempt {
  std::unique_ptr<DagValues> values;
  std::string failure;
};
Attempt attempt(const RandomDag& dag);

}  // namespace cnrg::properties
