// The baseline, two operands at a time: results are operands of the next step.
#include <algorithm>

#include "bench/baseline/mantyla.h"
#include "bench/peers/built_in.h"

namespace cnrg::bench {
namespace {

/// `finish` makes the last result that of the fold.
template <class Boolean, class Finish>
Answer folded(const Problem& problem, Boolean boolean, Finish finish) {
  for (const Model& operand : problem.operands)
    if (!operand.solid()) throw Refusal(to_string(mantyla::Stage::input), "an operand is no solid");
  Measurement measurement;
  Answer answer;
  answer.model = problem.operands[0];
  std::size_t step = 1;
  try {
    for (; step <= problem.steps.size(); ++step)
      answer.model = boolean(answer.model, problem.operands[step], problem.steps[step - 1]);
    answer.model = finish(answer.model);
  } catch (const mantyla::Failure& failure) {
    throw Refusal(to_string(failure.stage()),
                  "step " + std::to_string(std::min(step, problem.steps.size())) + ": " + failure.what());
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
System mantyla_double_system(double epsilon) {
  return mantyla_system("double", epsilon, [epsilon](const Problem& problem) {
    return folded(
        problem,
        [&](const Model& a, const Model& b, Operation op) { return mantyla::step_double(a, b, op, epsilon); },
        mantyla::triangulated);
  });
}

System mantyla_exact_system() {
  return mantyla_system("exact", 0, [](const Problem& problem) {
    return folded(problem, mantyla::boolean_exact, [](const Model& model) { return model; });
  });
}

}  // namespace cnrg::bench
