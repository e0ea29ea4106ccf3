// Joined demands, and the most steps that they come to; see the header.
#include "csg/carriers/common_steps.h"

#include <algorithm>

namespace cnrg {

std::uint32_t CommonSteps::number(const BezierCurve& curve, std::size_t kind) {
  BezierCurve least = canonical(curve).curve;
  const auto [it, is_new] = numbers_.try_emplace({kind, least.net}, std::uint32_t(classes_.size()));
  if (is_new) {
    asked_.push_back({std::move(least), std::nullopt, {}});
    classes_.add();
  }
  return it->second;
}

std::uint32_t CommonSteps::ask(const BezierCurve& curve, const Fineness& fineness,
                               const std::vector<Rational>& lines) {
  const std::uint32_t i = number(curve, 0);
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
  std::map<std::uint32_t, Fineness> joined;
  for (std::uint32_t i = 0; i < asked_.size(); ++i) {
    if (!asked_[i].fineness) continue;
    const auto [it, is_new] = joined.try_emplace(classes_.find(i), *asked_[i].fineness);
    if (!is_new) it->second.join(*asked_[i].fineness);
  }
  std::map<std::uint32_t, int> most;
  for (std::uint32_t i = 0; i < asked_.size(); ++i) {
    if (!asked_[i].fineness) continue;
    int& steps = most[classes_.find(i)];
    steps = std::max(steps, BoundaryCurves(joined.at(classes_.find(i))).steps(asked_[i].curve));
  }
  AgreedSteps result;
  for (std::uint32_t i = 0; i < asked_.size(); ++i) {
    if (asked_[i].fineness)
      result[asked_[i].curve.net] = {most.at(classes_.find(i)), rounded_lines(asked_[i].lines)};
  }
  return result;
}

}  // namespace cnrg
