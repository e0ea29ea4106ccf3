// The Boolean as the sequence of its stages (mantyla1988, program 15.1).
#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

/// Runs a stage: what the structure or an array refuses fails in it.
template <class Step>
auto staged(Stage stage, Step&& step) {
  try {
    return step();
  } catch (const std::logic_error& error) {
    throw Failure(stage, error.what());
  }
}

}  // namespace

const char* to_string(Stage stage) {
  constexpr const char* names[] = {"input",      "reduction", "classification", "null_edges",
                                   "connecting", "finishing", "output"};
  return names[static_cast<int>(stage)];
}

template <class N>
Model evaluate(const Model& a, const Model& b, Operation operation, const N& epsilon) {
  auto scene = staged(Stage::input, [&] { return read_operands(a, b, operation, epsilon); });
  staged(Stage::reduction, [&] { reduce(scene); });
  staged(Stage::classification, [&] { classify(scene); });
  staged(Stage::null_edges, [&] { insert_null_edges(scene); });
  staged(Stage::connecting, [&] { connect(scene); });
  const std::vector<FaceId> faces = staged(Stage::finishing, [&] { return finish(scene); });
  return staged(Stage::output, [&] { return write_result(scene, faces); });
}

template Model evaluate(const Model&, const Model&, Operation, const double&);
template Model evaluate(const Model&, const Model&, Operation, const Rational&);

Model boolean_double(const Model& a, const Model& b, Operation operation, double epsilon) {
  return triangulated(evaluate<double>(a, b, operation, epsilon));
}

Model boolean_exact(const Model& a, const Model& b, Operation operation) {
  return evaluate<Rational>(a, b, operation, 0);
}

}  // namespace cnrg::bench::mantyla
