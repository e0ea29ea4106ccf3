// A random dag through the whole front end: its text is parsed and evaluated, every node's value is kept.
#pragma once

#include <map>
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

/// How often things occurred in the dags of a test, for its report and for checks that it tests what it says.
class Coverage {
 public:
  void add(const RandomDag& dag);
  std::size_t dags() const { return dags_; }
  std::string text() const;
  /// Every operator, with and without `each`, shared nodes and the greatest depth occurred.
  bool complete() const;

 private:
  std::size_t dags_ = 0, inner_ = 0, shared_ = 0, each_ = 0, regularized_ = 0;
  std::map<std::string, std::size_t> operators_;
  std::map<int, std::size_t> depths_;
};

}  // namespace cnrg::properties
