#include "bench/cases/family.h"

#include <algorithm>
#include <charconv>
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
    if (maker.family.name == name) return maker;
    known.push_back(maker.family.name);
  }
  throw std::runtime_error("no family of problems is called '" + name + "'; there are " + list(known));
}

void check(const FamilyMaker& maker, const ProblemId& id) {
  const Family& family = maker.family;
  const auto& operations = family.operations;
  if (std::find(operations.begin(), operations.end(), id.operation) == operations.end())
    throw std::runtime_error("family '" + family.name + "' has no operation '" + id.operation + "'; it has " +
                             list(operations));
  if (id.size < maker.smallest || id.size > maker.largest)
    throw std::runtime_error("family '" + family.name + "' has no size " + std::to_string(id.size) + " (" +
                             family.size_means + "); sizes are " + std::to_string(maker.smallest) + " to " +
                             std::to_string(maker.largest));
  if (!id.distance) return;
  if (!family.has_distance)
    throw std::runtime_error("family '" + family.name + "' has no distance to degeneracy; leave it out");
  if (*id.distance < 0 || *id.distance > kLargestExponent)
    throw std::runtime_error("distance 10^-" + std::to_string(*id.distance) + " is none: k is from 0 to " +
                             std::to_string(kLargestExponent));
}

/// Takes `-<letter><text>` off the end of `rest`; nothing when it does not end so.
std::optional<std::string> take_last(std::string& rest, char letter) {
  const std::size_t dash = rest.rfind('-');
  if (dash == std::string::npos || dash + 1 >= rest.size() || rest[dash + 1] != letter) return {};
  std::string text = rest.substr(dash + 2);
  rest.erase(dash);
  return text;
}

/// The number that the text is, all of it.
template <class Number>
std::optional<Number> number(const std::optional<std::string>& text) {
  Number value{};
  if (!text) return {};
  const char* end = text->data() + text->size();
  const auto [stop, error] = std::from_chars(text->data(), end, value);
  if (error != std::errc() || stop != end || text->empty()) return {};
  return value;
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

ProblemId ProblemId::parse(const std::string& name) {
  ProblemId id;
  std::string rest = name;
  const auto seed = number<unsigned>(take_last(rest, 'r'));
  const auto distance = take_last(rest, 'k');
  const auto exponent = number<int>(distance);
  const auto size = number<long>(take_last(rest, 's'));
  const std::size_t dash = rest.rfind('-');
  if (seed && size && (exponent || distance == "exact") && dash != std::string::npos) {
    id = {rest.substr(0, dash), rest.substr(dash + 1), *size, exponent, *seed};
    const bool operation = id.operation == "fold" ||
                           std::find(kOperations.begin(), kOperations.end(), id.operation) != kOperations.end();
    if (operation && !id.family.empty() && id.name() == name) return id;
  }
  throw std::runtime_error("'" + name +
                           "' names no problem; names are FAMILY-OPERATION-sSIZE-kDISTANCE-rSEED "
                           "as in edge-union-s4-k7-r3, or kexact in place of a distance");
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> families;
    for (const FamilyMaker& maker : makers()) families.push_back(maker.family);
    return families;
  }();
  return all;
}

Problem make_problem(const ProblemId& id) {
  const FamilyMaker& maker = maker_of(id.family);
  check(maker, id);
  Problem problem = maker.make(id);
  problem.name = id.name();
  return problem;
}

Operation operation_of(const ProblemId& id) {
  for (const Operation operation : {Operation::unite, Operation::subtract, Operation::intersect})
    if (id.operation == to_string(operation)) return operation;
  throw std::logic_error("operation " + id.operation + " is none");
}

Problem problem_of(const ProblemId& id, std::vector<Model> operands) {
  Problem problem;
  problem.steps.assign(operands.size() - 1, operation_of(id));
  problem.operands = std::move(operands);
  return problem;
}

}  // namespace cnrg::bench
