// Sets are given in layers of closed sets: the closure of the cells, from which the closure of what it has too
// much is taken, and so on; each layer is of a lower dimension. What is unbounded is given by its complement.
#include "bench/sweep/tree_node.h"

#include <algorithm>

#include "bench/cases/face_loops.h"
#include "bench/cases/value_model.h"
#include "bench/peers/system.h"
#include "bench/sweep/facts.h"
#include "csg/evaluate/operate.h"
#include "kernel/selection/measure.h"

namespace cnrg::bench {
namespace {

// --- sets

bool is_unbounded(const Complex& complex, const CellSet& set) {
  return std::any_of(set.regions.begin(), set.regions.end(), [&](RegionId r) { return complex.unbounded(r); });
}

bool reaches_frame(const Complex& complex, const CellSet& set) {
  if (!complex.frame.valid()) return false;
  std::vector<EdgeId> edges;
  for (const FaceId f : set.faces) {
    complex.closure_edges(f, edges);
    if (std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return complex.on_frame(e); })) return true;
  }
  return std::any_of(set.edges.begin(), set.edges.end(), [&](EdgeId e) {
    const auto& [a, b] = complex.edge_ends[e];
    return complex.on_frame(a) || complex.on_frame(b);
  });
}

/// Of a closed, bounded set.
Model closed_model(const Complex& complex, const CellSet& set) {
  Model model = model_of(complex, simplify(complex, as_one(set), {}, SimplifyMode::points));
  cut_holes(model);
  return model;
}

void require_bounded(const Complex& complex, const CellSet& set, const char* stage) {
  if (is_unbounded(complex, set) || reaches_frame(complex, set))
    throw Refusal(stage, "a plane or half-space, or what it bounds, has no end");
}

MarkedSet marked(const Complex& complex, CellSet set, const char* stage) {
  MarkedSet marked;
  marked.complement = is_unbounded(complex, set);
  if (marked.complement) set = subtract(all_cells(complex), set);
  require_bounded(complex, set, stage);
  while (!set.empty()) {
    const CellSet closed = closure(complex, set);
    marked.layers.push_back(closed_model(complex, closed));
    set = subtract(closed, set);
  }
  return marked;
}

// --- operators

bool is_boolean(Operator op) {
  return op == Operator::unite || op == Operator::intersect || op == Operator::subtract;
}

/// All others are folds, also of one operand.
bool is_unary(Operator op) { return is_topological(op) || op == Operator::complement; }

/// As SetProblem has it; empty: the set stays.
std::string word_of(const Node& node) {
  switch (node.op) {
    case Operator::unite:
    case Operator::aggregate:
    case Operator::sum: return "union";
    case Operator::intersect:
    case Operator::product: return "intersection";
    case Operator::subtract: return "difference";
    case Operator::cnrg_subtract: return "without";
    case Operator::complement: return "complement";
    case Operator::interior: return "interior";
    case Operator::closure: return "closure";
    case Operator::boundary: return "boundary";
    case Operator::regularize: return "regularization";
    case Operator::unify: return "";
    case Operator::simplify:
      if (!node.within) return "";
      throw Refusal("operator", "`simplify` that joins moves points: no other system has it");
    default: throw Refusal("operator", "no other system has `" + node.operator_name + "`");
  }
}

/// An operand of a Boolean as a group, as csg/SEMANTICS.md has it (From one family to the other).
Group group_operand(const Complex& complex, const NodeValue& value) {
  if (value.is_group()) return value.group();
  return value.stands_for ? *value.stands_for : group_of(complex, value.components());
}

// --- regions

using Numbered = std::vector<std::pair<RegionId, std::uint32_t>>;

struct Parcelled {
  Numbered cells;
  std::vector<FaceId> faces;  // of a group
};

Parcelled parcelled(const Complex& complex, const NodeValue& value, bool as_group) {
  if (!as_group) return {selection_of(complex, value).regions, {}};
  Group group = group_operand(complex, value);
  return {std::move(group.cells), std::move(group.faces)};
}

/// By cell of the complex.
IdVector<RegionId, std::uint32_t> numbers_of(const Complex& complex, const Numbered& cells) {
  IdVector<RegionId, std::uint32_t> numbers(complex.region_count, 0);
  for (const auto& [cell, number] : cells) numbers[cell] = number;
  return numbers;
}

ParcelledOperand::Region solid_region(const Complex& complex, CellSet cells) {
  const bool outside = is_unbounded(complex, cells);
  if (outside) {
    CellSet rest;
    for (const RegionId r : IdRange<RegionId>(complex.region_count))
      if (!std::binary_search(cells.regions.begin(), cells.regions.end(), r)) rest.regions.push_back(r);
    cells = rest;
  }
  const CellSet closed = closure(complex, cells);
  require_bounded(complex, closed, "operand");
  return {closed_model(complex, closed), outside};
}

ParcelledOperand parcelled_operand(const Complex& complex, const Parcelled& of) {
  std::map<std::uint32_t, CellSet> regions;
  for (const auto& [cell, number] : of.cells) regions[number].regions.push_back(cell);
  const IdVector<RegionId, std::uint32_t> numbers = numbers_of(complex, of.cells);
  ParcelledOperand operand;
  for (const auto& [number, cells] : regions) {
    operand.regions.resize(number);  // components without 3-cells are regions without a solid
    operand.regions.back() = solid_region(complex, cells);
  }
  CellSet sheets;
  for (const FaceId f : of.faces)
    if (numbers[complex.face_regions[f][0]] == numbers[complex.face_regions[f][1]]) sheets.faces.push_back(f);
  const CellSet closed = closure(complex, sheets);
  require_bounded(complex, closed, "operand");
  operand.sheets = closed_model(complex, closed);
  return operand;
}

/// Regions of the value with exact volumes, by where they lie in the operands, and the walls between them.
void add_exact_regions(const Complex& complex, const Numbered& cells,
                       const std::vector<IdVector<RegionId, std::uint32_t>>& operands, RegionProblem& problem) {
  std::map<std::pair<std::uint32_t, Place>, std::vector<RegionId>> pieces;
  for (const auto& [cell, number] : cells) {
    if (complex.unbounded(cell)) throw Refusal("value", "a region is unbounded and has no volume");
    Place place;
    for (const auto& numbers : operands) place.push_back(numbers[cell]);
    pieces[{number, place}].push_back(cell);
  }
  struct PieceOf {
    std::size_t region;
    ExactVolume* volume;
  };
  std::map<std::uint32_t, std::size_t> places;
  for (const auto& [key, piece] : pieces) places.emplace(key.first, places.size());
  problem.regions.resize(places.size());
  IdVector<RegionId, std::uint32_t> piece_of(complex.region_count, 0);
  std::vector<PieceOf> known{{0, nullptr}};
  for (const auto& [key, piece] : pieces) {
    const std::size_t region = places.at(key.first);
    ExactVolume& exact = problem.regions[region][key.second];
    exact.volume = volume(complex, piece).value();
    for (const RegionId r : piece) piece_of[r] = static_cast<std::uint32_t>(known.size());
    known.push_back({region, &exact});
  }
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const std::uint32_t front = piece_of[complex.face_regions[f][0]], back = piece_of[complex.face_regions[f][1]];
    if (front == back) continue;
    const double part = area(complex, {f});
    if (front != 0) known[front].volume->area += part;
    if (back != 0) known[back].volume->area += part;
    const auto sides = std::minmax(known[front].region, known[back].region);
    if (front != 0 && back != 0 && sides.first != sides.second) problem.walls[sides] += part;
  }
}

double largest_coordinate(const std::vector<ParcelledOperand>& operands) {
  Rational largest = 0;
  const auto look_at = [&](const Model& model) {
    for (const RationalPoint& p : model.points)
      for (const Rational& x : p) largest = std::max<Rational>(largest, abs(x));
  };
  for (const ParcelledOperand& operand : operands) {
    look_at(operand.sheets);
    for (const ParcelledOperand::Region& region : operand.regions) look_at(region.solid);
  }
  return to_double(largest);
}

/// Of the steps of a Boolean, as its node and the numbers of its operands say.
std::vector<Dominance> dominances_of(const Complex& complex, const Node& node,
                                     const std::vector<const NodeValue*>& operands) {
  std::vector<Dominance> dominances;
  PartedGroup left;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const NodeValue& value = *operands[k];
    const PartedGroup right = value.is_group() ? value.parts() : parted(complex, group_operand(complex, value));
    if (k > 0) {
      dominances.push_back(dominance_of(node, left, right));
      if (rule_of(node, dominances.back(), left, right) == StepRule::materials)
        throw Refusal("operator", "materials with a dominance of their own decide, which no other system has");
    }
    left.dominance = k == 0 ? right.dominance : std::max(left.dominance, right.dominance);
    left.ranked = left.ranked || right.ranked;
  }
  return dominances;
}

}  // namespace

TreeNode::TreeNode(Tree tree, NodeId node) : tree_(std::move(tree)), node_(node) {
  EvaluateOptions options;
  options.rows = Rows::none;
  options.result = node;
  options.keep_all = true;
  options.threads = 1;
  evaluation_ = evaluate(tree_, options);
  const InstanceId root = evaluation_.kept.at(0).instance;
  value_ = evaluation_.kept[0].value.get();
  for (const InstanceId operand : evaluation_.instances[root].operands)
    operands_.push_back(evaluation_.values[operand].get());
}

SetProblem TreeNode::set_problem() const {
  const Complex& complex = *evaluation_.complex;
  const std::string word = word_of(node());
  SetProblem problem;
  const auto add = [&](const CellSet& set) {
    problem.words.push_back(std::to_string(problem.operands.size()));
    problem.operands.push_back(marked(complex, set, "operand"));
  };
  const auto fold = [&](std::size_t count, const std::string& by, const auto& push) {
    for (std::size_t k = 0; k < count; ++k) {
      push(k);
      if (k > 0) problem.words.push_back(by);
    }
  };
  if (node().each) {
    const Selection selection = selection_of(complex, *operands_.at(0));
    const std::size_t count = operands_[0]->component_count();
    if (count == 0) add({});
    fold(count, "union", [&](std::size_t k) {
      add(support(selection, static_cast<Component>(k + 1)));
      problem.words.push_back(word);
    });
  } else {
    fold(operands_.size(), word, [&](std::size_t k) {
      add(support(selection_of(complex, *operands_[k])));
      // The complement of a group stands for its closure there.
      if (is_boolean(node().op) && operands_[k]->stands_for) problem.words.push_back("closure");
    });
    if (is_unary(node().op) && !word.empty()) problem.words.push_back(word);
  }
  if (node().regularize) problem.words.push_back("regularization");
  problem.value = marked(complex, support(selection_of(complex, *value_)), "value");
  return problem;
}

RegionProblem TreeNode::region_problem() const {
  const Complex& complex = *evaluation_.complex;
  word_of(node());
  RegionProblem problem;
  problem.op = node().op;
  problem.blend = node().blend;
  if (is_boolean(problem.op)) problem.dominances = dominances_of(complex, node(), operands_);
  std::vector<IdVector<RegionId, std::uint32_t>> numbers;
  for (const NodeValue* value : operands_) {
    const Parcelled operand = parcelled(complex, *value, is_boolean(problem.op));
    problem.operands.push_back(parcelled_operand(complex, operand));
    numbers.push_back(numbers_of(complex, operand.cells));
  }
  problem.extent = largest_coordinate(problem.operands);
  add_exact_regions(complex, selection_of(complex, *value_).regions, numbers, problem);
  return problem;
}

}  // namespace cnrg::bench
