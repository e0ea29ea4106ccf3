// The baseline, two operands at a time: results are operands of the next step.
#include <algorithm>
#include <regex>

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

const mantyla::Departure& departure_of(const std::string& word, const std::string& name) {
  std::string known;
  for (const mantyla::Departure& departure : mantyla::kDepartures) {
    if (word == departure.name) return departure;
    known += (known.empty() ? "" : ", ") + std::string(departure.name);
  }
  throw std::runtime_error("'" + name + "' has no rule '" + word + "'; rules are " + known);
}

struct Change {
  const mantyla::Departure* departure;
  bool on;
};

/// `+RULE` and `-RULE` after another; each changes something.
std::vector<Change> change_rules(mantyla::Departures& departures, const std::string& rules,
                                 const std::string& name) {
  static const std::regex rule("[+-][a-z]+");
  std::vector<Change> changes;
  for (auto it = std::sregex_iterator(rules.begin(), rules.end(), rule); it != std::sregex_iterator(); ++it) {
    const std::string text = it->str(), word = text.substr(1);
    const bool on = text[0] == '+';
    const mantyla::Departure& departure = departure_of(word, name);
    bool& value = departures.*departure.rule;
    if (value == on)
      throw std::runtime_error("'" + name + "': the rule '" + word + "' is " + (on ? "on" : "off") + " already");
    value = on;
    changes.push_back({&departure, on});
  }
  return changes;
}

double epsilon_of(const std::string& text, const std::string& name) {
  const std::optional<Rational> epsilon = parse_rational(text);
  if (!epsilon || *epsilon <= 0 || *epsilon >= 1)
    throw std::runtime_error("'" + name + "' has no epsilon between 0 and 1, such as mantyla-double:1e-8");
  return to_double(*epsilon);
}

constexpr double kEpsilon = 1e-10;

}  // namespace

System mantyla_double_system() { return in_doubles("double", kEpsilon, {}); }
System mantyla_exact_system() { return in_fractions("exact", {}); }
std::vector<System> mantyla_published_systems() {
  std::vector<System> both = {in_doubles("published", kEpsilon, mantyla::published()),
                              in_fractions("published-exact", mantyla::published())};
  for (System& system : both) system.if_named = true;
  return both;
}

std::optional<System> mantyla_variant(const std::string& name) {
  static const std::regex form("mantyla-(double|exact|published-exact|published)(:(.*?))?(([+-][a-z]+)*)");
  std::smatch parts;
  if (!std::regex_match(name, parts, form)) return {};
  const std::string kind = parts[1], rules = parts[4];
  const bool fractions = kind.ends_with("exact");
  if (fractions && parts[2].matched) throw std::runtime_error("'" + name + "': fractions have no epsilon");
  mantyla::Departures departures = kind.starts_with("published") ? mantyla::published() : mantyla::Departures();
  const std::vector<Change> changes = change_rules(departures, rules, name);
  const std::string rest = name.substr(std::string("mantyla-").size());
  System system = fractions
                      ? in_fractions(rest, departures)
                      : in_doubles(rest, parts[2].matched ? epsilon_of(parts[3], name) : kEpsilon, departures);
  for (const auto& [departure, on] : changes)
    system.guarantee += std::string("; ") + departure->name + (on ? " on: " : " off: ") +
                        (on ? departure->ours : departure->published);
  if (changes.empty()) return system;
  system.title = name;
  const Change& last = changes.back();
  const std::string of = name.substr(0, name.size() - 1 - std::string(last.departure->name).size());
  system.varies = {of, last.departure->name, last.on};
  return system;
}

}  // namespace cnrg::bench
