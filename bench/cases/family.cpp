#include "bench/cases/family.h"

#include <algorithm>
#include <stdexcept>

#include "bench/cases/family_makers.h"

namespace cnrg::bench {
namespace {

constexpr int kLargestExponent = 16;

const std::vector<FamilyMaker>& makers() {
  static const std::vector<FamilyMaker> all = [] {
    std::vector<FamilyMaker> makers;
    for (const auto& theme : {generic_families(), contact_families(), turned_families(), fold_families(),
                              mixed_families(), ground_families()})
      makers.insert(makers.end(), theme.begin(), theme.end());
    return makers;
  }();
  return all;
}

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

const FamilyMaker& maker_of(const std::string& name) {
  std::vector<std::string> known;
  for (const FamilyMaker& maker : makers()) {
    if (maker.name == name) return maker;
    known.push_back(maker.name);
  }
  throw std::runtime_error("no family of problems is called '" + name + "'; there are " + list(known));
}

}  // namespace

bool Problem::solids() const {
  return std::all_of(operands.begin(), operands.end(), [](const Model& model) { return model.solid(); });
}

std::size_t Problem::triangle_count() const {
  std::size_t count = 0;
  for (const Model& model : operands) count += model.triangle_count();
  return count;
}

std::string ProblemId::name() const {
  return family + '-' + operation + "-s" + std::to_string(size) + "-k" +
         (distance ? std::to_string(*distance) : "exact") + "-r" + std::to_string(seed);
}

Problem make_problem(const ProblemId& id) {
  check_problem(id);
  Problem problem = maker_of(id.family).make(id);
  problem.name = id.name();
  return problem;
}

void check_problem(const ProblemId& id) {
  const FamilyMaker& maker = maker_of(id.family);
  const std::string& family = maker.name;
  const auto& operations = maker.operations;
  if (std::find(operations.begin(), operations.end(), id.operation) == operations.end())
    throw std::runtime_error("family '" + family + "' has no operation '" + id.operation + "'; it has " +
                             list(operations));
  if (id.size < maker.smallest || id.size > maker.largest)
    throw std::runtime_error("family '" + family + "' has no size " + std::to_string(id.size) + "; sizes are " +
                             std::to_string(maker.smallest) + " to " + std::to_string(maker.largest));
  if (!id.distance) return;
  if (!maker.has_distance)
    throw std::runtime_error("family '" + family + "' has no distance to degeneracy; leave it out");
  if (*id.distance < 0 || *id.distance > kLargestExponent)
    throw std::runtime_error("distance 10^-" + std::to_string(*id.distance) + " is none: k is from 0 to " +
                             std::to_string(kLargestExponent));
}

Operation operation_of(const ProblemId& id) {
  if (const auto operation = parse_operation(id.operation)) return *operation;
  throw std::logic_error("operation " + id.operation + " is none");
}

Problem problem_of(const ProblemId& id, std::vector<Model> operands) {
  Problem problem;
  problem.steps.assign(operands.size() - 1, operation_of(id));
  problem.operands = std::move(operands);
  return problem;
}

}  // namespace cnrg::bench
