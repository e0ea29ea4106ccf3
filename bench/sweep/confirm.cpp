#include "bench/sweep/confirm.h"

#include <sstream>

#include "bench/sweep/experiment.h"
#include "bench/witness/points.h"

namespace cnrg::bench {
namespace {

constexpr std::size_t kSteps = 200000, kPoints = 256;

witness::Cycle cycle_of(const Model& model) {
  witness::Cycle cycle{model.points, {}};
  for (const Model::Face& face : model.faces)
    if (face.solid)
      for (const auto& loop : face.loops) cycle.add_loop(loop);
  return cycle;
}

witness::Operation operation_of(Operation operation) {
  switch (operation) {
    case Operation::unite: return witness::Operation::unite;
    case Operation::intersect: return witness::Operation::intersect;
    case Operation::subtract: break;
  }
  return witness::Operation::subtract;
}

/// What a witness says: the answer's solid is right, is not, or nothing that counts.
struct Finding {
  std::optional<bool> right;
  std::string by, reason;
};

/// By integrals: what moving all faces of the operands by the rounding makes is no difference.
std::optional<Finding> by_integrals(const witness::Question& q, double rounding) {
  if (q.operands.size() != 2) return {};
  const std::optional<witness::Distance> apart =
      witness::distance(q.operands[0], q.steps[0], q.operands[1], q.answer, kSteps);
  if (!apart || !apart->operands_once) return {};
  double extent = 0, area = 0;
  for (const witness::Cycle& operand : q.operands) {
    extent = std::max(extent, witness::extent(operand));
    area += witness::area(operand);
  }
  const bool right = apart->zero || (rounding > 0 && apart->value <= 16 * rounding * extent * area);
  std::ostringstream reason;
  reason << "the volume of the difference is " << apart->value;
  return Finding{right, "integrals", reason.str()};
}

std::string text_of(const witness::Points& points) {
  std::ostringstream text;
  if (!points.differs) {
    text << points.asked << " points are in both or in none";
    return text.str();
  }
  const witness::Point& p = *points.differs;
  text << "(" << p[0] << ", " << p[1] << ", " << p[2] << ") is " << (points.expected ? "" : "not ")
       << "in the Boolean, and the answer goes around it " << points.winding << " times";
  return text.str();
}

Finding found(const witness::Question& q, double rounding, bool with_integrals) {
  if (!witness::is_closed(q.answer)) return {false, "integrals", "its faces are not closed"};
  const std::optional<Finding> integrals = with_integrals ? by_integrals(q, rounding) : std::nullopt;
  if (integrals && (rounding == 0 || !*integrals->right)) return *integrals;
  const witness::Points points = witness::ask(q, kPoints);
  if (points.differs) return {false, "points", text_of(points)};
  if (integrals) return *integrals;
  if (points.asked < kPoints / 4)
    return {{}, "none", "only " + std::to_string(points.asked) + " points could be asked"};
  return {true, "points", text_of(points)};
}

}  // namespace

Confirmation confirm_by_witness(const Problem& problem, const Model& answer, double rounding, Verdict verdict,
                                const std::string& stage, bool integrals) {
  if (!problem.solids()) return {"none", "an operand is no solid"};
  witness::Question q;
  double extent = 0;
  for (const Model& operand : problem.operands) {
    q.operands.push_back(cycle_of(operand));
    if (!witness::is_closed(q.operands.back())) return {"none", "an operand is not closed"};
    extent = std::max(extent, witness::extent(q.operands.back()));
  }
  for (const Operation step : problem.steps) q.steps.push_back(operation_of(step));
  q.answer = cycle_of(answer);
  q.rounding = witness::Number(64 * rounding * extent);
  q.seed = std::stoull(digest(problem.name));
  const Finding finding = found(q, rounding, integrals);
  if (!finding.right) return {finding.by, finding.reason};
  const bool said_right = !is_failure(verdict);
  if (*finding.right == said_right) return {finding.by, finding.reason};
  // Points do not find everything, bounds of rounding are not equal, and what has no volume is another question.
  if (*finding.right && (finding.by == "points" || rounding > 0 || stage == "dangling"))
    return {"none", finding.reason};
  return {"DISPUTED", finding.by + ": " + finding.reason};
}

}  // namespace cnrg::bench
