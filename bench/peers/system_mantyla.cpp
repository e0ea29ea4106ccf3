// The baseline, two operands at a time: results are operands of the next step.
#include <algorithm>

#include "bench/baseline/variant.h"
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

/// `kind`: what follows `mantyla-` in its name, rules and epsilon included.
System mantyla_system(const std::string& kind, double rounding, std::function<Answer(const Problem&)> evaluate) {
  return {
      .name = "mantyla-" + kind,
      .title = "Mäntylä, " + kind,
      .guarantee = kind.starts_with("published")
                       ? "closed 2-manifolds of planar faces; the algorithm of the published programs"
                       : "closed 2-manifolds of planar faces; gaps of the published programs closed, no repair "
                         "of geometry",
      .version = [] { return std::string(CNRG_VERSION); },
      .rounding = rounding,
      .regularized = true,
      .absent = "",
      .evaluate = std::move(evaluate)};
}

/// Rounding: the epsilon of its comparisons, within which points become one.
System in_doubles(const std::string& kind, double epsilon, const mantyla::Departures& departures) {
  return mantyla_system(kind, epsilon, [epsilon, departures](const Problem& problem) {
    return folded(
        problem,
        [&](const Model& a, const Model& b, Operation op) {
          return mantyla::step_double(a, b, op, epsilon, departures);
        },
        mantyla::triangulated);
  });
}

System in_fractions(const std::string& kind, const mantyla::Departures& departures) {
  return mantyla_system(kind, 0, [departures](const Problem& problem) {
    return folded(
        problem,
        [&](const Model& a, const Model& b, Operation op) { return mantyla::boolean_exact(a, b, op, departures); },
        [](const Model& model) { return model; });
  });
}

}  // namespace

System mantyla_double_system() { return in_doubles("double", mantyla::kEpsilon, {}); }
System mantyla_exact_system() { return in_fractions("exact", {}); }
std::vector<System> mantyla_published_systems() {
  std::vector<System> both = {in_doubles("published", mantyla::kEpsilon, mantyla::published()),
                              in_fractions("published-exact", mantyla::published())};
  for (System& system : both) system.if_named = true;
  return both;
}

std::optional<System> mantyla_variant(const std::string& name) {
  const std::optional<mantyla::Variant> variant = mantyla::parse_variant(name);
  if (!variant) return {};
  const std::string rest = name.substr(std::string("mantyla-").size());
  System system = variant->fractions ? in_fractions(rest, variant->departures)
                                     : in_doubles(rest, variant->epsilon, variant->departures);
  for (const auto& [departure, on] : variant->changes)
    system.guarantee += std::string("; ") + departure->name + (on ? " on: " : " off: ") +
                        (on ? departure->ours : departure->published);
  if (variant->changes.empty()) return system;
  system.title = name;
  const mantyla::Change& last = variant->changes.back();
  const std::string of = name.substr(0, name.size() - 1 - std::string(last.departure->name).size());
  system.varies = {of, last.departure->name, last.on};
  return system;
}

}  // namespace cnrg::bench
