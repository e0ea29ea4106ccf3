// The baseline, two operands at a time: results are operands of the next step.
#include "bench/baseline/mantyla.h"
#include "bench/peers/built_in.h"

namespace cnrg::bench {
namespace {

template <class Boolean>
Answer folded(const Problem& problem, Boolean boolean) {
  for (const Model& operand : problem.operands)
    if (!operand.solid()) throw Refusal(to_string(mantyla::Stage::input), "an operand is no solid");
  Measurement measurement;
  Answer answer;
  answer.model = problem.operands[0];
  for (std::size_t i = 0; i < problem.steps.size(); ++i) {
    try {
      answer.model = boolean(answer.model, problem.operands[i + 1], problem.steps[i]);
    } catch (const mantyla::Failure& failure) {
      throw Refusal(to_string(failure.stage()), "step " + std::to_string(i + 1) + ": " + failure.what());
    }
  }
  measurement.lap("Boolean");
  answer.measures = measurement.stop();
  return answer;
}

System mantyla_system(const std::string& numbers, double rounding,
                      std::function<Answer(const Problem&)> evaluate) {
  return {.name = "mantyla-" + numbers,
          .title = "Mäntylä, " + numbers,
          .guarantee =
              "closed 2-manifolds of planar faces; gaps of the published programs closed, no repair of geometry",
          .version = [] { return std::string(CNRG_VERSION); },
          .rounding = rounding,
          .regularized = true,
          .absent = "",
          .evaluate = std::move(evaluate)};
}

}  // namespace

/// Rounding: the epsilon of its comparisons, within which points become one.
System mantyla_double_system() {
  return mantyla_system("double", 1e-10, [](const Problem& problem) {
    return folded(problem,
                  [](const Model& a, const Model& b, Operation op) { return mantyla::boolean_double(a, b, op); });
  });
}

System mantyla_exact_system() {
  return mantyla_system("exact", 0,
                        [](const Problem& problem) { return folded(problem, mantyla::boolean_exact); });
}

}  // namespace cnrg::bench
