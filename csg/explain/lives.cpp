// Instances outside, pieces inside: what a step needs of a whole value (its components, a Boolean's groups) is
// made once for all pieces, and lives no longer than its instance.
#include "csg/explain/lives.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <type_traits>

#include "csg/evaluate/leaf_numbers.h"
#include "csg/materials/grade.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/material_levels.h"
#include "csg/operators/pair_refinement.h"
#include "csg/tree/unfold.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/interior.h"
#include "kernel/selection/canonical.h"
#include "kernel/selection/simplify.h"

namespace cnrg {
namespace {

using Words = std::map<std::string, std::string>;  // what is said, by key

/// A text of an attribute is in quotes, since a number is none.
Words words_of(const Attributes* said) {
  Words words;
  if (said == nullptr) return words;
  if (!said->name.empty()) words["name"] = said->name;
  if (!said->material.empty()) words["material"] = said->material.name();
  for (const auto& [key, value] : said->properties) {
    const bool is_text = std::holds_alternative<std::string>(value);
    words[key] = is_text ? '"' + to_text(value) + '"' : to_text(value);
  }
  return words;
}

bool gives(const Node& node, const std::string& key) {
  if (key == "name") return !node.label.empty();
  if (key == "material") return !node.material.empty();
  return node.properties.contains(key);
}

/// Operators made one name, or one material, of several.
bool is_joined(const Attributes* said, const std::string& key) {
  if (said == nullptr) return false;
  if (key == "name") return said->name.parts().size() > 1;
  const PlacedGrade* const grade = said->material.grade();
  return key == "material" && grade != nullptr && std::holds_alternative<BlendGrade>(grade->grade.along);
}

std::string value_in(const Words& words, const std::string& key) {
  const auto it = words.find(key);
  return it == words.end() ? std::string() : it->second;
}

bool has(const Group& group, const Location& cell) {
  return with_id(cell, [&](auto id) {
    if constexpr (std::is_same_v<decltype(id), RegionId>) return false;
    else return group.has(id);
  });
}

RegionId region_at(const Complex& complex, const Location& cell) {
  return with_id(cell, [&](auto id) {
    if constexpr (std::is_same_v<decltype(id), RegionId>) return id;
    else return complex.some_region(id);
  });
}

CellState region_state(const Group& group, std::uint32_t region) {
  return {region, region == 0 ? "" : group.regions[region - 1].name, true, false};
}

Component component_at(const Selection& selection, const Location& cell) {
  return with_id(cell, [&](auto id) { return component_in(list_for(selection, id), id); });
}

CellState component_state(const Components& x, const Location& cell) {
  const Component c = component_at(x.selection, cell);
  return {c, c == 0 ? "" : x.attributes[c - 1].name, false, false};
}

int number_of_regions(const Group& group, const std::array<RegionId, 2>& sides) {
  const std::uint32_t a = group.region_of(sides[0]), b = group.region_of(sides[1]);
  return a == b ? 0 : a == 0 || b == 0 ? 1 : 2;
}

void add_face_facts(const Complex& complex, const Group& group, const CellSide& piece, OperandFacts& out) {
  const std::array<RegionId, 2>& regions = complex.face_regions[piece.cell.face];
  for (unsigned s : {0u, 1u}) out.sides[s] = region_state(group, group.region_of(regions[s ^ piece.side]));
  out.regions = number_of_regions(group, regions);
}

void add_around(const Group& group, const std::vector<RegionId>& regions, OperandFacts& out) {
  std::vector<std::uint32_t> numbers;
  for (const RegionId r : regions) numbers.push_back(group.region_of(r));
  sort_unique(numbers);
  for (const std::uint32_t n : numbers) out.around.push_back(region_state(group, n));
}

/// The entities of a group around an edge or a vertex, in the cells that the group and another one make, or in
/// those of the complex. `within`: faces in whose interior it lies; `bounded`: the others; `edges` at a vertex.
struct EntitiesAround {
  std::vector<FaceId> within, bounded;
  std::size_t edges = 0;
};

EntitiesAround around(const Complex& complex, const Group& group, const Location& cell, PairRefinement* pair) {
  EntitiesAround out;
  const auto add = [&](FaceId f, std::vector<FaceId>& to) {
    if (group.has(f)) to.push_back(pair == nullptr ? f : pair->place(f).face);
  };
  std::vector<FaceId> all;
  if (cell.dimension == 1) {
    for (const FaceUse& use : complex.edge_uses[cell.edge]) add(use.face, all);
    std::sort(all.begin(), all.end());
    const auto times = [&](FaceId f) { return std::count(all.begin(), all.end(), f); };
    std::copy_if(all.begin(), all.end(), std::back_inserter(out.bounded), [&](FaceId f) { return times(f) == 1; });
  } else {
    std::vector<FaceId> faces;
    complex.star_faces(cell.vertex, faces);
    for (const FaceId f : faces) add(f, all);
    for (const EdgeId e : complex.vertex_edges[cell.vertex]) {
      if (!group.has(e) || (pair != nullptr && !pair->is_kept(e))) continue;
      ++out.edges;
      for (const FaceUse& use : complex.edge_uses[e]) add(use.face, out.bounded);
    }
    sort_unique(out.bounded);
  }
  sort_unique(all);
  out.within = in_first_alone(all, out.bounded);
  return out;
}

void add_star_facts(const Complex& complex, const Group& group, const Location& cell, PairRefinement* pair,
                    OperandFacts& out) {
  std::vector<RegionId> regions;
  if (cell.dimension == 1) complex.star_regions(cell.edge, regions);
  else complex.star_regions(cell.vertex, regions);
  add_around(group, regions, out);
  const auto [within, bounded, edges] = around(complex, group, cell, pair);
  out.within = within.size();
  out.bounds = cell.dimension == 1 ? bounded.size() : edges;
  for (const auto& faces : {within, bounded}) {
    out.walls += static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](FaceId f) {
      return number_of_regions(group, complex.face_regions[f]) > 0;
    }));
  }
  out.free = out.state.entity && within.empty() && bounded.empty() && edges == 0;
}

OperandFacts facts_of(const Complex& complex, const Group& group, const CellSide& piece, const std::string& name,
                      bool closed_complement, PairRefinement* pair) {
  OperandFacts out;
  out.name = name;
  out.closed_complement = closed_complement;
  out.state = state_in(complex, group, piece.cell);
  if (piece.cell.dimension == 2) add_face_facts(complex, group, piece, out);
  if (piece.cell.dimension < 2) add_star_facts(complex, group, piece.cell, pair, out);
  return out;
}

std::size_t kept_around(const Complex& complex, const Group& result, const Location& cell, PairRefinement& pair) {
  if (cell.dimension > 1) return 0;
  const EntitiesAround kept = around(complex, result, cell, &pair);
  return cell.dimension == 1 ? kept.bounded.size() : kept.edges;
}

/// The piece of a face at a cell inside of it, from the side on which its normal is positive: the first of x, y
/// and z that is not 0 is.
CellSide piece_at(const Complex& complex, PairRefinement& pair, FaceId face, const Location& cell) {
  std::vector<FaceId> around;
  if (cell.dimension == 1) complex.star_faces(cell.edge, around);
  else complex.star_faces(cell.vertex, around);
  const auto of_face = [&](FaceId f) { return pair.place(f).face == face; };
  const FaceId piece = *std::find_if(around.begin(), around.end(), of_face);
  const bool positive = shortest_normal(complex, {piece, 0}) > std::array<Integer, 3>{0, 0, 0};
  return {{2, {}, {}, piece, {}}, positive ? 0u : 1u};
}

/// What A and B of a step have where a piece is: it, or what it is inside of.
CellSide made_by_both(const Complex& complex, PairRefinement& pair, const BooleanStep& step,
                      const CellSide& piece) {
  return with_id(piece.cell, [&](auto id) -> CellSide {
    if constexpr (!std::is_same_v<decltype(id), RegionId>) {
      if (!step.left.has(id) && !step.right.has(id)) return piece;
      const Location in = pair.place(id);
      if (in.dimension == piece.cell.dimension) return piece;
      return in.dimension == 2 ? piece_at(complex, pair, in.face, piece.cell) : CellSide{in, 0};
    }
    return piece;
  });
}

Verdict verdict_of(const Complex& complex, const BooleanStep& step, const Location& cell) {
  return with_id(cell, [&](auto id) -> Verdict {
    if constexpr (std::is_same_v<decltype(id), RegionId>) return {};
    else return verdict(complex, step, id);
  });
}

LevelsAt levels_of(const Complex& complex, const BooleanStep& step, const Location& cell) {
  return with_id(cell, [&](auto id) { return levels_at(complex, step.left, step.right, id); });
}

/// Of a blend: the operand whose entity it is.
Dominance owner_of(const BooleanStep& step, const Location& cell) {
  return has(step.left, cell) ? Dominance::left : has(step.right, cell) ? Dominance::right : Dominance::equal;
}

CellSet only(const Location& cell) {
  CellSet out;
  with_id(cell, [&](auto id) { list_for(out, id) = {id}; });
  return out;
}

// f(location) for the cells of a set, from regions down.
template <class F>
void for_each_cell(const CellSet& set, F f) {
  for (const RegionId r : set.regions) f(Location{3, {}, {}, {}, r});
  for (const FaceId x : set.faces) f(Location{2, {}, {}, x, {}});
  for (const EdgeId e : set.edges) f(Location{1, {}, e, {}, {}});
  for (const VertexId v : set.vertices) f(Location{0, v, {}, {}, {}});
}

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

bool is_closed_complement(const NodeValue& value) { return !value.is_group() && value.stands_for.has_value(); }

NodePlace place_of(const Evaluation& evaluation, InstanceId id) {
  return {evaluation.instances[id].transform, {}, evaluation.leaves->order_below(evaluation.instances, id)};
}

}  // namespace

const Attributes* SaidAt::of(const NodeValue& value, const Location& cell, const CellState& state) {
  if (state.component == 0) return nullptr;
  const bool of_component = cell.dimension == 3 || (state.group && !state.entity);
  if (!of_component) {
    const ValueSources& all = sources(value);
    const Attributes* const own = cell.dimension == 2   ? all.said(cell.face)
                                  : cell.dimension == 1 ? all.said(cell.edge)
                                                        : all.said(cell.vertex);
    if (own != nullptr || state.group) return own;
  }
  return &value.attributes(state.component);
}

const Attributes* SaidAt::around(const NodeValue& value, const Location& cell) {
  const ValueSources& all = sources(value);
  return cell.dimension == 2   ? all.said_around(cell.face)
         : cell.dimension == 1 ? all.said_around(cell.edge)
                               : all.said_around(cell.vertex);
}

const ValueSources& SaidAt::sources(const NodeValue& value) {
  std::unique_ptr<const ValueSources>& known = sources_[&value];
  if (known == nullptr) known = sources_of(complex_, value);
  return *known;
}

std::vector<Word> SaidAt::changes(const Node& node, const Attributes* said,
                                  const std::vector<std::pair<std::string, const Attributes*>>& operands,
                                  bool by_itself) {
  const bool is_leaf = operands.empty();
  const Words here = words_of(said);
  std::vector<std::pair<std::string, Words>> below;
  std::set<std::string> keys;
  for (const auto& [key, value] : here) keys.insert(key);
  for (const auto& [name, what] : operands) {
    below.emplace_back(name, words_of(what));
    for (const auto& [key, value] : below.back().second) keys.insert(key);
  }
  std::vector<Word> out;
  for (const std::string& key : keys) {
    Word word{key, value_in(here, key), {}, {}, {}};
    word.given = !word.value.empty() && (gives(node, key) || is_leaf);
    for (const auto& [name, words] : below) {
      const std::string other = value_in(words, key);
      if (other == word.value && !other.empty()) word.from.push_back(name);
      else if (!other.empty()) word.gave_way.emplace_back(name, other);
    }
    if (is_joined(said, key) && !word.given && word.from.empty()) {
      for (const auto& [name, value] : word.gave_way) word.from.push_back(name);
      word.gave_way.clear();
      out.push_back(std::move(word));
      continue;
    }
    if (key == "name" && !by_itself && node.label.empty()) {
      // A region is called after its leaf where nobody names it: that is told with its number.
      if (is_leaf || word.from.empty() || word.gave_way.empty()) continue;
    }
    if (word.given || !word.gave_way.empty()) out.push_back(std::move(word));
  }
  return out;
}

CellState state_in(const Complex& complex, const Group& group, const Location& cell) {
  if (has(group, cell)) return {static_cast<Component>(group.regions.size() + 1), Name::of_entities(), true, true};
  return region_state(group, group.region_of(region_at(complex, cell)));
}

CellState state_in(const Complex& complex, const NodeValue& value, const Location& cell) {
  return value.is_group() ? state_in(complex, value.group(), cell) : component_state(value.components(), cell);
}

std::vector<LeafId> origins_in(const Components& x, const Location& cell) {
  return with_id(cell, [&](auto id) -> std::vector<LeafId> {
    const auto& list = list_for(x.selection, id);
    const std::size_t k = place_in(list, id);
    if (k == list.size()) return {};
    const auto leaves = x.origins.sets[list_for(x.origins, id)[k]];
    return {leaves.begin(), leaves.end()};
  });
}

std::vector<LeafId> origins_in(const Complex& complex, const NodeValue& value, const Location& cell) {
  return value.is_group() ? origins_in(components_of(complex, value.group()), cell)
                          : origins_in(value.components(), cell);
}

std::vector<LeafCell> leaf_cells_at(const Complex& complex, const Location& cell,
                                    const std::vector<LeafId>& leaves) {
  return with_id(cell, [&](auto id) { return leaf_cells(complex, id, leaves); });
}

Lives::Lives(const Tree& tree, const Evaluation& evaluation, NodeId node)
    : tree_(tree),
      evaluation_(evaluation),
      complex_(*evaluation.complex),
      leaf_of_(evaluation.leaves->by_instance()),
      said_(complex_) {
  require(!evaluation.values.empty(), "explain: the evaluation has not kept all values");
  const NodeValue* value = evaluation.value(node).value.get();
  InstanceId root;
  for (const InstanceId i : IdRange<InstanceId>(evaluation.instances.size())) {
    if (evaluation.values[i].get() == value) root = i;
  }
  require(root.valid(), "explain: the node is not among the instances");
  below_ = instances_below(evaluation.instances, root);
}

std::vector<Life> Lives::of(const std::vector<CellSide>& pieces, bool named) {
  std::vector<Life> out(pieces.size());
  for (const InstanceId id : below_) {
    std::vector<LifeStep> steps(pieces.size());
    add_steps(id, pieces, named, steps);
    for (std::size_t p = 0; p < pieces.size(); ++p) out[p].push_back(std::move(steps[p]));
  }
  return out;
}

std::vector<std::uint32_t> Lives::classes(const std::vector<CellSide>& pieces, std::vector<std::uint32_t> of) {
  std::size_t count = of.empty() ? 0 : of.back() + 1;
  for (const InstanceId id : below_) {
    std::vector<LifeStep> steps(pieces.size());
    add_steps(id, pieces, false, steps);
    std::vector<std::vector<std::size_t>> parts(count);  // of each class: the first piece of each new class in it
    std::vector<std::uint32_t> finer(pieces.size());
    count = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      std::vector<std::size_t>& firsts = parts[of[p]];
      const auto same = [&](std::size_t first) { return steps[first] == steps[p]; };
      const auto it = std::find_if(firsts.begin(), firsts.end(), same);
      finer[p] = it != firsts.end() ? finer[*it] : static_cast<std::uint32_t>(count++);
      if (it == firsts.end()) firsts.push_back(p);
    }
    of = std::move(finer);
  }
  return of;
}

void Lives::add_steps(InstanceId id, const std::vector<CellSide>& pieces, bool named,
                      std::vector<LifeStep>& steps) {
  const Instance& instance = evaluation_.instances[id];
  const Node& node = tree_.nodes[instance.node];
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    LifeStep& step = steps[p];
    step.node = instance.node;
    step.name = name_of(id);
    step.state = state_in(complex_, *evaluation_.values[id], pieces[p].cell);
    if (leaf_of_[id].valid()) step.leaf_cells = leaf_cells_at(complex_, pieces[p].cell, {leaf_of_[id]});
    for (const InstanceId operand : instance.operands) {
      step.operands.emplace_back(name_of(operand),
                                 state_in(complex_, *evaluation_.values[operand], pieces[p].cell));
    }
  }
  switch (node.op) {
    case Operator::unite:
    case Operator::intersect:
    case Operator::subtract:
    case Operator::below:
    case Operator::above: add_booleans(node, id, pieces, steps); break;
    case Operator::interior:
    case Operator::closure:
    case Operator::boundary:
    case Operator::regularize:
      add_topology(topological(node.op), node.each, *evaluation_.values[instance.operands[0]], pieces, named,
                   steps);
      break;
    default: break;
  }
  if (node.regularize && !leaf_of_[id].valid()) add_attribute(node, id, pieces, named, steps);
  if (named) add_words(id, pieces, steps);
}

void Lives::add_words(InstanceId id, const std::vector<CellSide>& pieces, std::vector<LifeStep>& steps) {
  const Instance& instance = evaluation_.instances[id];
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    LifeStep& step = steps[p];
    const Location& cell = pieces[p].cell;
    const Attributes* const here = said_.of(*evaluation_.values[id], cell, step.state);
    const bool by_itself = cell.dimension < 3 && step.state.group && step.state.entity;
    std::vector<std::pair<std::string, const Attributes*>> operands;
    for (std::size_t k = 0; k < instance.operands.size(); ++k) {
      const auto& [name, state] = step.operands[k];
      // What is said of a bolt does not give way to what is said of the rock around it, nor the other way round.
      const bool both_groups = state.group && step.state.group && cell.dimension < 3;
      if (both_groups && state.entity != step.state.entity) continue;
      const NodeValue& value = *evaluation_.values[instance.operands[k]];
      const Attributes* said = said_.of(value, cell, state);
      // Where a bolt lies in a sheet it is the bolt.
      if (said == nullptr && here != nullptr && by_itself && state.entity) said = said_.around(value, cell);
      operands.emplace_back(name, said);
    }
    step.said = SaidAt::changes(tree_.nodes[instance.node], here, operands, by_itself);
  }
}

std::vector<Operand> Lives::operands_of(InstanceId id) const {
  const Instance& instance = evaluation_.instances[id];
  const Node& node = tree_.nodes[instance.node];
  std::vector<Operand> out;
  for (const InstanceId operand : instance.operands) {
    Operand& added = out.emplace_back();
    added.value = evaluation_.values[operand].get();
    added.name = name_of(operand);
    for (const std::span<const NodeId> wanted : leaves_wanted(node, out.size() == 1)) {
      added.below.push_back(std::make_shared<const std::vector<LeafId>>(
          evaluation_.leaves->below(evaluation_.instances, operand, wanted)));
    }
  }
  return out;
}

void Lives::add_booleans(const Node& node, InstanceId id, const std::vector<CellSide>& pieces,
                         std::vector<LifeStep>& steps) {
  const std::vector<Operand> operands = operands_of(id);
  for_each_step(complex_, node, operands, place_of(evaluation_, id), [&](const BooleanStep& s) {
    const bool first = s.operand == 1;
    const bool is_side = node.op == Operator::below || node.op == Operator::above;
    const std::string left = is_side ? operands[1].name
                             : first ? operands[0].name
                                     : "step " + std::to_string(s.operand - 1);
    const std::string right =
        is_side ? "what is " + node.operator_name + " " + operands[0].name : operands[s.operand].name;
    PairRefinement pair(complex_);
    pair.refine(s.left, s.right);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const CellSide piece = made_by_both(complex_, pair, s, pieces[p]);
      BooleanFacts facts;
      facts.op = s.op;
      facts.rule = s.rule;
      facts.dimension = piece.cell.dimension;
      if (facts.dimension == 2 && pieces[p].cell.dimension < 2)
        facts.normal = shortest_normal(complex_, {piece.cell.face, piece.side});
      const LevelsAt levels = s.rule == StepRule::materials ? levels_of(complex_, s, piece.cell) : LevelsAt();
      const Dominance dominance = s.rule == StepRule::materials ? levels.dominance()
                                  : s.rule == StepRule::blend   ? owner_of(s, piece.cell)
                                                                : s.dominance;
      facts.dominant = s.op != BooleanOp::subtract && dominance != Dominance::equal;
      facts.a = facts_of(complex_, s.left, piece, left,
                         first && is_closed_complement(*operands[is_side ? 1 : 0].value), &pair);
      facts.b = facts_of(complex_, s.right, piece, right,
                         !is_side && is_closed_complement(*operands[s.operand].value), &pair);
      if (levels.left) facts.level_a = to_decimal(*levels.left);
      if (levels.right) facts.level_b = to_decimal(*levels.right);
      if (s.op != BooleanOp::subtract && dominance == Dominance::right) {
        std::swap(facts.a, facts.b);
        std::swap(facts.level_a, facts.level_b);
      }
      facts.verdict = verdict_of(complex_, s, piece.cell);
      facts.kept_around = kept_around(complex_, s.result, piece.cell, pair);
      facts.result = state_in(complex_, s.result, pieces[p].cell);
      steps[p].booleans.push_back(std::move(facts));
    }
  });
}

void Lives::add_topology(Topological op, bool each, const NodeValue& x, const std::vector<CellSide>& pieces,
                         bool named, std::vector<LifeStep>& steps) {
  if (x.is_group() && !each && op == Topological::closure) return;  // a group is closed
  if (x.is_group() && !each && op == Topological::regularize) {
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      steps[p].regularized = facts_of(complex_, x.group(), pieces[p], "", false, nullptr);
    }
    return;
  }
  const Components made = x.is_group() ? components_of(complex_, x.group()) : Components();
  const Components& components = x.is_group() ? made : x.components();
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Location& cell = pieces[p].cell;
    const CellSet around = star(complex_, only(cell));
    std::vector<Component> sets;
    if (each && op == Topological::interior) {
      sets = {component_at(components.selection, cell)};
    } else if (each) {
      for_each_cell(around, [&](const Location& c) {
        if (const Component found = component_at(components.selection, c)) sets.push_back(found);
      });
      sort_unique(sets);
    }
    if (sets.empty()) sets = {0};
    for (const Component c : sets) steps[p].stars.push_back(star_of(components, c, around, cell, x, named));
  }
}

StarFacts Lives::star_of(const Components& x, Component only, const CellSet& star, const Location& cell,
                         const NodeValue& value, bool named) {
  const auto in_set = [&](const Location& c) {
    const Component found = component_at(x.selection, c);
    return only == 0 ? found != 0 : found == only;
  };
  StarFacts out;
  out.component = only;
  if (only != 0) out.name = x.attributes[only - 1].name;
  out.in_set = in_set(cell);
  out.whole = true;
  for_each_cell(star, [&](const Location& c) {
    const bool in = in_set(c);
    out.whole = out.whole && in;
    out.touched = out.touched || in;
    out.solid = out.solid || (in && c.dimension == 3);
    if (!named) return;
    ++(in ? out.inside : out.outside)[static_cast<std::size_t>(c.dimension)];
    const SimplifiedComplex::Place place = simplified(value).place(complex_, c);
    if (place.index != SimplifiedComplex::kNowhere) {
      add_name(in ? out.named_inside : out.named_outside, cell_name(place.dimension, place.index));
    }
  });
  return out;
}

void Lives::add_attribute(const Node& node, InstanceId id, const std::vector<CellSide>& pieces, bool named,
                          std::vector<LifeStep>& steps) {
  Node without = node;
  without.regularize = false;
  const std::vector<Operand> operands = operands_of(id);
  made_.push_back(std::make_unique<NodeValue>(
      operate(complex_, without, without.material, operands, false, place_of(evaluation_, id)).value));
  const NodeValue& before = *made_.back();
  std::vector<LifeStep> after(pieces.size());
  add_topology(Topological::regularize, false, before, pieces, named, after);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    steps[p].attribute = Regularization{state_in(complex_, before, pieces[p].cell),
                                        std::move(after[p].regularized), std::move(after[p].stars)};
  }
}

const SimplifiedComplex& Lives::simplified(const NodeValue& value) {
  const auto it = simplified_.find(&value);
  if (it != simplified_.end()) return it->second;
  SimplifiedComplex made = simplify(complex_, value, selection_of(complex_, value));
  put_in_order(complex_, made);
  return simplified_.emplace(&value, std::move(made)).first->second;
}

}  // namespace cnrg
