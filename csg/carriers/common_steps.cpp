// Joined demands, and the most steps that they come to; see the header.
#include "csg/carriers/common_steps.h"

#include <algorithm>

namespace cnrg {

std::size_t CommonSteps::number(const BezierCurve& curve, std::size_t kind) {
  BezierCurve least = canonical(curve).curve;
  const auto [it, is_new] = numbers_.try_emplace({kind, least.net}, asked_.size());
  if (is_new) {
    asked_.push_back({std::move(least), std::nullopt, {}});
    classes_.add();
  }
  return it->second;
}

std::size_t CommonSteps::ask(const BezierCurve& curve, const Fineness& fineness,
                             const std::vector<Rational>& lines) {
  const std::size_t i = number(curve, 0);
  if (!lines.empty()) {
    const bool reversed = canonical(curve).reversed;
    for (const Rational& t : lines) asked_[i].lines.insert(reversed ? Rational(1 - t) : t);
  }
  std::optional<Fineness>& all = asked_[i].fineness;
  if (all) all->join(fineness);
  else all = fineness;
  return i;
}

AgreedSteps CommonSteps::agree() {
  std::map<std::size_t, Fineness> joined;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    if (!asked_[i].fineness) continue;
    const auto [it, is_new] = joined.try_emplace(classes_.first_of(i), *asked_[i].fineness);
    if (!is_new) it->second.join(*asked_[i].fineness);
  }
  std::map<std::size_t, int> most;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    if (!asked_[i].fineness) continue;
    int& steps = most[classes_.first_of(i)];
    steps = std::max(steps, BoundaryCurves(joined.at(classes_.first_of(i))).steps(asked_[i].curve));
  }
  AgreedSteps result;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    if (asked_[i].fineness)
      result[asked_[i].curve.net] = {most.at(classes_.first_of(i)), rounded_lines(asked_[i].lines)};
  }
  return result;
}

}  // namespace cnrg
