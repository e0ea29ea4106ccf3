// Values as independent parts against values as whole groups: every list, number and count must be the same, on
// leaves that are scattered, touch and overlap, in chains and in graphs that share values.
#include <algorithm>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/cnrg.h"
#include "csg/operators/fold.h"
#include "kernel/selection/measure.h"
#include "tests/catch.h"
#include "tests/oracles/evaluation.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Random;
constexpr std::array kModes{SimplifyMode::features, SimplifyMode::points, SimplifyMode::raw};

/// Random leaves, each moved by steps that are about as long as a leaf is wide.
std::vector<scenes::Leaf> scattered_leaves(std::uint64_t seed, int count, scenes::Position position, int room) {
  auto leaves = scenes::random_leaves(seed, count, position);
  Random random(seed + 77);
  const int step = position == scenes::Position::general ? 15 : 3;
  for (scenes::Leaf& leaf : leaves) {
    scenes::Motion motion;
    for (auto& x : motion.offset) x = step * random.between(0, room);
    scenes::apply(motion, leaf);
  }
  return leaves;
}

std::vector<std::vector<Attributes>> random_attributes(const Complex& c, Random& random) {
  const std::array<std::string, 3> words{"", "rock", "ore"};
  std::vector<std::vector<Attributes>> out(c.leaf_count);
  for (std::size_t leaf = 0; leaf < out.size(); ++leaf) {
    for (std::uint32_t i = 0; i < c.leaf_regions[LeafId(leaf)]; ++i) {
      const auto word = [&] { return words[static_cast<std::size_t>(random.below(3))]; };
      out[leaf].push_back({word(), word(), {}});
    }
  }
  return out;
}

std::vector<std::vector<LeafId>> leaves_of(const Group& group, const std::vector<LeafSetId>& origins) {
  std::vector<std::vector<LeafId>> out;
  for (const LeafSetId set : origins) {
    const auto leaves = group.origins.sets[set];
    out.emplace_back(leaves.begin(), leaves.end());
  }
  return out;
}

void check_same(const Group& parts, const Group& plain) {
  CHECK((leaves_of(parts, parts.origins.faces) == leaves_of(plain, plain.origins.faces)));
  CHECK((leaves_of(parts, parts.origins.edges) == leaves_of(plain, plain.origins.edges)));
  CHECK((leaves_of(parts, parts.origins.vertices) == leaves_of(plain, plain.origins.vertices)));
  CHECK((parts.cells == plain.cells));
  CHECK((parts.faces == plain.faces));
  CHECK((parts.edges == plain.edges));
  CHECK((parts.vertices == plain.vertices));
  CHECK((parts.features.edges == plain.features.edges));
  CHECK((parts.features.vertices == plain.features.vertices));
  CHECK(parts.dominance == plain.dominance);
  REQUIRE(parts.regions.size() == plain.regions.size());
  for (std::size_t i = 0; i < parts.regions.size(); ++i) {
    CHECK(parts.regions[i].name == plain.regions[i].name);
    CHECK(parts.regions[i].material == plain.regions[i].material);
    CHECK((parts.regions[i].leaves == plain.regions[i].leaves));
  }
}

void check_same(const std::vector<AttributeConflict>& a, const std::vector<AttributeConflict>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].kept == b[i].kept);
    CHECK(a[i].other == b[i].other);
    CHECK((a[i].cells == b[i].cells));
  }
}

/// A Boolean of two values in parts.
FoldResult fold_of_two(const Complex& complex, BooleanOp op, Dominance dominance, PartedGroup left,
                       PartedGroup right) {
  return boolean_fold(complex, op, std::span(&dominance, 1), {std::move(left), std::move(right)});
}

void check_totals(const Complex& complex, PartedGroup& parts, const Group& plain) {
  const Totals& totals = totals_of(complex, parts);
  const Selection s = selection_of(complex, plain);
  CHECK((totals.raw == std::array{s.vertices.size(), s.edges.size(), s.faces.size(), s.regions.size()}));
  CHECK((totals.simplified == active_counts(simplify(complex, s, plain.features))));
  CHECK(totals.regions == plain.regions.size());
  const auto by_region = volumes(complex, parts);
  REQUIRE(by_region.size() == plain.regions.size());
  std::optional<Rational> sum = 0;
  for (std::size_t i = 0; i < by_region.size(); ++i) {
    std::vector<RegionId> cells;
    for (const auto& [cell, region] : plain.cells) {
      if (region == i + 1) cells.push_back(cell);
    }
    CHECK((by_region[i] == cnrg::volume(complex, cells)));
    if (!by_region[i]) sum.reset();
    else if (sum) *sum += *by_region[i];
  }
  CHECK((totals.volume() == sum));
}

template <class IdT>
Component state_of(const std::vector<std::pair<IdT, Component>>& list, IdT id) {
  const auto it = std::lower_bound(list.begin(), list.end(), std::pair(id, Component(0)));
  return it != list.end() && it->first == id ? it->second : 0;
}

/// What csg/SEMANTICS.md#simplification says of each cell of the complex that needs no merged neighbour to tell,
/// in mode `features`.
void check_places(const Complex& c, const Selection& s, const Features& features) {
  const SimplifiedComplex simplified = simplify(c, s, features);
  for (FaceId f : IdRange<FaceId>(c.face_count())) {
    const Component state = state_of(s.faces, f);
    const auto& [front, back] = c.face_regions[f];
    const bool vanishes = state == state_of(s.regions, front) && state == state_of(s.regions, back);
    CHECK(simplified.face_place[f.index()].dimension == (vanishes ? 3 : 2));
  }
  for (EdgeId e : IdRange<EdgeId>(c.edge_count())) {
    const auto uses = c.edge_uses[e];
    const auto faces = std::count_if(uses.begin(), uses.end(), [&](const FaceUse& use) {
      return simplified.face_place[use.face.index()].dimension == 2;
    });
    const bool inside = faces == 0 && state_of(s.edges, e) == state_of(s.regions, c.some_region(e));
    const int dimension = simplified.edge_place[e.index()].dimension;
    if (std::binary_search(features.edges.begin(), features.edges.end(), e)) CHECK(dimension == 1);
    else if (faces == 2) CHECK(dimension <= 2);
    else CHECK(dimension == (inside ? 3 : 1));
  }
  for (VertexId v : c.vertices) {
    const auto edges = c.vertex_edges[v];
    const auto kept = std::count_if(edges.begin(), edges.end(),
                                    [&](EdgeId e) { return simplified.edge_place[e.index()].dimension == 1; });
    const int dimension = simplified.vertex_place[v.index()].dimension;
    const bool feature = std::binary_search(features.vertices.begin(), features.vertices.end(), v);
    if (feature || kept == 1 || kept > 2) CHECK(dimension == 0);
    else if (kept == 2) CHECK(dimension <= 1);
    else CHECK(dimension != 1);
  }
}

struct Value {
  Group plain;
  PartedGroup parts;
};

/// Operators on random values made so far, or on the last value and the next leaf. Returns the most parts seen.
std::size_t check_evaluation(const Complex& complex, std::vector<Group> leaves, bool chain, Random& random) {
  std::vector<Value> values;
  for (Group& leaf : leaves) {
    leaf.dominance = random.below(3);
    values.push_back({leaf, parted(complex, leaf)});
    if (random.one_in(2)) totals_of(complex, values.back().parts);  // totals are kept up to date or made later
  }
  std::size_t most = 0;
  const std::size_t count = leaves.size();
  for (std::size_t i = 1; i < count; ++i) {
    const auto pick = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(values.size()))); };
    const std::size_t left = chain ? (i == 1 ? 0 : values.size() - 1) : pick(), right = chain ? i : pick();
    const auto op = random.one_in(2) ? BooleanOp::unite : static_cast<BooleanOp>(random.below(3));
    const auto dominance = static_cast<Dominance>(random.below(3));
    INFO(i << ": " << name(op) << ' ' << static_cast<int>(dominance) << " of " << left << ", " << right);
    const BooleanResult plain = boolean_operation(complex, op, dominance, values[left].plain, values[right].plain);
    FoldResult parts = fold_of_two(complex, op, dominance, values[left].parts, values[right].parts);
    check_same(whole(parts.group), plain.group);
    CHECK((parts.removals == plain.removals));
    check_same(parts.conflicts, plain.conflicts);
    if (random.one_in(3)) parts.group.totals.reset();
    check_totals(complex, parts.group, plain.group);
    most = std::max(most, parts.group.parts.size());
    values.push_back({plain.group, parts.group});
    if (!chain && random.one_in(4)) {
      const Group other = complement(complex, plain.group);
      values.push_back({other, parted(complex, other)});
    }
  }
  return most;
}

/// A fold of values, told step by step, against folds of two. Returns how many steps had totals.
std::size_t check_steps(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                        const std::vector<PartedGroup>& values) {
  const FoldInSteps fold = boolean_fold_in_steps(complex, op, dominances, values, true);
  REQUIRE(fold.steps.size() == dominances.size());
  PartedGroup left = values[0];
  std::size_t told = 0;
  for (std::size_t k = 0; k < dominances.size(); ++k) {
    FoldResult step = fold_of_two(complex, op, dominances[k], left, values[k + 1]);
    left = std::move(step.group);
    CHECK((fold.steps[k].removals == step.removals));
    check_same(fold.steps[k].conflicts, step.conflicts);
    if (!fold.steps[k].totals) continue;
    ++told;
    const Totals &totals = *fold.steps[k].totals, &expected = totals_of(complex, left);
    INFO("step " << k);
    CHECK((totals.raw == expected.raw));
    CHECK((totals.simplified == expected.simplified));
    CHECK(totals.regions == expected.regions);
    CHECK(totals.unbounded == expected.unbounded);
    CHECK((totals.bounded_volume == expected.bounded_volume));
  }
  check_same(whole(fold.group), whole(left));
  return told;
}

/// A fold of values with any number of parts, at once, in folds of two, and of whole groups step by step. Returns
/// how many conflicts there were.
std::size_t check_fold(const Complex& complex, const std::vector<PartedGroup>& values, Random& random,
                       std::size_t& steps_told) {
  const auto op = static_cast<BooleanOp>(random.below(3));
  const bool by_number = random.one_in(2);
  std::vector<Dominance> dominances;
  Removals removals, plain_removals;
  std::vector<AttributeConflict> conflicts, plain_conflicts;
  PartedGroup left = values[0];
  Group plain = whole(left);
  for (std::size_t k = 1; k < values.size(); ++k) {
    const auto any = random.one_in(2) ? Dominance::equal : static_cast<Dominance>(random.below(3));
    const Dominance greater = left.dominance == values[k].dominance  ? Dominance::equal
                              : left.dominance > values[k].dominance ? Dominance::left
                                                                     : Dominance::right;
    dominances.push_back(by_number ? greater : any);
    FoldResult step = fold_of_two(complex, op, dominances.back(), left, values[k]);
    removals.add(step.removals);
    conflicts.insert(conflicts.end(), step.conflicts.begin(), step.conflicts.end());
    left = std::move(step.group);
    BooleanResult one = boolean_operation(complex, op, dominances.back(), plain, whole(values[k]));
    plain_removals.add(one.removals);
    plain_conflicts.insert(plain_conflicts.end(), one.conflicts.begin(), one.conflicts.end());
    plain = std::move(one.group);
  }
  const FoldResult at_once = boolean_fold(complex, op, dominances, values);
  INFO(name(op) << " of " << values.size());
  check_same(whole(at_once.group), whole(left));
  check_same(whole(at_once.group), plain);
  CHECK((at_once.removals == removals));
  CHECK((at_once.removals == plain_removals));
  check_same(at_once.conflicts, conflicts);
  check_same(at_once.conflicts, plain_conflicts);
  for (std::size_t i = 1; i < at_once.group.parts.size(); ++i) {
    CHECK(before(at_once.group.parts[i - 1], at_once.group.parts[i]));
  }
  steps_told += check_steps(complex, op, dominances, values);
  return conflicts.size();
}

void check_same(const Components& a, const Components& b) {
  CHECK((a.selection == b.selection));
  CHECK((a.features.edges == b.features.edges));
  CHECK((a.features.vertices == b.features.vertices));
  REQUIRE(a.attributes.size() == b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    CHECK(a.attributes[i].name == b.attributes[i].name);
    CHECK(a.attributes[i].material == b.attributes[i].material);
    CHECK((a.attributes[i].leaves == b.attributes[i].leaves));
    CHECK(a.attributes[i].dominance == b.attributes[i].dominance);
  }
  const auto same = [&](const std::vector<LeafSetId>& x, const std::vector<LeafSetId>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [&](LeafSetId s, LeafSetId t) {
      return std::ranges::equal(a.origins.sets[s], b.origins.sets[t]);
    });
  };
  CHECK(same(a.origins.vertices, b.origins.vertices));
  CHECK(same(a.origins.edges, b.origins.edges));
  CHECK(same(a.origins.faces, b.origins.faces));
  CHECK(same(a.origins.regions, b.origins.regions));
}

/// sum and subtract of all operands at once and step by step, components open and closed.
std::size_t check_overlays(const Complex& complex, const std::vector<PartedGroup>& groups, Random& random) {
  std::vector<Components> values;
  for (const PartedGroup& group : groups) {
    values.push_back(components_of(complex, whole(group)));
    if (random.one_in(3))
      values.back() = topological_operation(complex, Topological::interior, values.back()).value;
  }
  std::vector<const Components*> pointers;
  for (const Components& value : values) pointers.push_back(&value);
  std::optional<Dominance> dominance;
  if (random.one_in(3)) dominance = static_cast<Dominance>(random.below(3));
  Components added = values[0], rest = values[0];
  std::vector<AttributeConflict> conflicts;
  for (std::size_t k = 1; k < values.size(); ++k) {
    ComponentsResult step = sum(complex, added, values[k], dominance);
    conflicts.insert(conflicts.end(), step.conflicts.begin(), step.conflicts.end());
    added = std::move(step.value);
    rest = subtract(complex, rest, values[k]).value;
  }
  const ComponentsResult at_once = sum(complex, pointers, dominance);
  check_same(at_once.value, added);
  check_same(at_once.conflicts, conflicts);
  check_same(subtract(complex, pointers).value, rest);
  return conflicts.size();
}

/// Folds of leaves, of some of them united before, of complements and of surfaces that lie in others. Returns how
/// many conflicts the folds of both families had at least; adds how many steps had totals.
std::size_t check_folds(const Complex& complex, std::vector<Group> leaves, Random& random,
                        std::size_t& steps_told) {
  std::vector<PartedGroup> values;
  for (Group& leaf : leaves) {
    leaf.dominance = random.below(3);
    values.push_back(parted(complex, leaf));
    if (random.one_in(4)) {
      Group walls = leaf;  // its faces without its regions
      walls.cells.clear(), walls.regions.clear();
      values.push_back(parted(complex, std::move(walls)));
    }
  }
  for (int i = 0; i < 3; ++i) {
    const auto pick = [&]() -> const PartedGroup& {
      return values[static_cast<std::size_t>(random.below(static_cast<int>(values.size())))];
    };
    const auto op = static_cast<BooleanOp>(random.below(3));
    PartedGroup made = fold_of_two(complex, op, static_cast<Dominance>(random.below(3)), pick(), pick()).group;
    values.push_back(random.one_in(4) ? parted(complex, complement(complex, whole(made))) : std::move(made));
  }
  std::size_t conflicts = 0, overlay_conflicts = 0;
  for (int round = 0; round < 4; ++round) {
    std::vector<PartedGroup> some;
    for (const PartedGroup& value : values) {
      if (!random.one_in(3)) some.push_back(value);
    }
    if (some.empty()) continue;
    for (std::size_t i = some.size(); i > 1; --i) {
      std::swap(some[i - 1], some[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    conflicts += check_fold(complex, some, random, steps_told);
    if (some.size() > 1) overlay_conflicts += check_overlays(complex, some, random);
  }
  return std::min(conflicts, overlay_conflicts);
}

}  // namespace

TEST_CASE("Values in parts are the values as whole groups", "[parts]") {
  const auto [first, last] = scenes::seeds(20);
  std::size_t most = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    for (const auto position : {scenes::Position::general, scenes::Position::degenerate}) {
      for (const bool chain : {true, false}) {
        INFO("seed " << seed << ", position " << static_cast<int>(position) << ", chain " << chain);
        Random random(seed);
        const int room = static_cast<int>(seed % 4);
        const auto leaves = scattered_leaves(seed, 9, position, room);
        const auto built_complex = build_complex(scenes::make_soup(leaves), {.threads = 1});
        const Complex& complex = *built_complex;
        const auto groups = leaf_groups(complex, random_attributes(complex, random));
        most = std::max(most, check_evaluation(complex, groups, chain, random));
      }
    }
  }
  CHECK(most >= 4);
}

TEST_CASE("Values in parts: unbounded leaves", "[parts]") {
  const Tree tree = parse_tree(R"(cnrg: 1
materials: {rock: {}, ore: {}}
nodes:
  h: {halfspace: {point: [0, 0, 1], normal: [0, 0, 1]}, material: rock}
  p: {plane: {point: [0, 0, 5], normal: [0, 0, 1]}}
  q: {plane: {point: [3, 0, 0], normal: [1, 0, 0]}}
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}, material: ore}
  b: {box: {min: [5, 0, 2], max: [6, 2, 3]}}
  c: {box: {min: [5, 5, 5], max: [6, 6, 6]}}
  d: {polyline: [[10, 10, 10], [10, 11, 10]]}
  all: {union: [h, p, q, a, b, c, d]}
result: all
)",
                               "test.yaml");
  EvaluateOptions options;
  options.threads = 1;
  options.drawn_together = true;  // all on one complex
  for (std::size_t i = 0; i + 1 < tree.nodes.size(); ++i) options.nodes.push_back(NodeId(i));
  const Evaluation evaluation = evaluate(tree, options);
  REQUIRE(evaluation.complex->frame.valid());
  std::vector<Group> leaves;
  for (const KeptValue& kept : evaluation.kept) {
    if (kept.node != tree.result) leaves.push_back(kept.group());
  }
  REQUIRE(leaves.size() == 7);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    for (std::size_t i = leaves.size(); i > 1; --i) {
      std::swap(leaves[i - 1], leaves[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    INFO("seed " << seed);
    check_evaluation(*evaluation.complex, leaves, seed % 2 == 0, random);
    std::size_t steps_told = 0;
    check_folds(*evaluation.complex, leaves, random, steps_told);
    CHECK(steps_told == 0);  // the space has a frame
  }
}

TEST_CASE("A fold at once is the fold step by step", "[parts]") {
  const auto [first, last] = scenes::seeds(30);
  std::size_t conflicts = 0, steps_told = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    for (const auto position : {scenes::Position::general, scenes::Position::degenerate}) {
      INFO("seed " << seed << ", position " << static_cast<int>(position));
      Random random(seed);
      const auto leaves = scattered_leaves(seed, 8, position, static_cast<int>(seed % 3));
      const auto built_complex = build_complex(scenes::make_soup(leaves), {.threads = 1});
      const Complex& complex = *built_complex;
      conflicts +=
          check_folds(complex, leaf_groups(complex, random_attributes(complex, random)), random, steps_told);
    }
  }
  CHECK(conflicts > 0);
  CHECK(steps_told > 0);
}

TEST_CASE("A fold at once: a sheet taken from a wall and from a crack", "[parts]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {box: {min: [1, 0, 0], max: [2, 1, 1]}}
  corner: {box: {min: [0, 0, 0], max: [0.5, 0.5, 0.5]}}
  wall: {polygon: [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]]}
  crack: {polygon: [[1.5, 0.2, 0.2], [1.5, 0.8, 0.2], [1.5, 0.8, 0.8], [1.5, 0.2, 0.8]]}
  two: {union: [a, b], dominance: left}
  cracked: {union: [two, crack], dominance: equal}
  rest: {difference: [cracked, corner, wall, crack]}
result: rest
)",
                               "test.yaml");
  EvaluateOptions options;
  options.threads = 1;
  const Evaluation at_once = evaluate(tree, options);
  options.validate = true;  // step by step
  const Evaluation in_steps = evaluate(tree, options);
  const Group &rest = at_once.kept[0].group(), &plain = in_steps.kept[0].group();
  CHECK(rest.regions.size() == 2);
  check_same(rest, plain);
}

TEST_CASE("A union far away carries the parts of its operands", "[parts]") {
  std::vector<scenes::Leaf> leaves;
  for (int i = 0; i < 3; ++i) {
    leaves.push_back(scenes::solid_leaf(scenes::box_solid({3 * i, 0, 0}, {3 * i + 2, 1, 1})));
  }
  leaves.push_back(scenes::solid_leaf(scenes::box_solid({5, 0, 0}, {6, 1, 1})));  // touches the second and third
  const auto built_complex = build_complex(scenes::make_soup(leaves), {.threads = 1});
  const Complex& complex = *built_complex;
  const std::vector<Group> groups = leaf_groups(complex);
  std::vector<PartedGroup> v;
  for (const Group& g : groups) v.push_back(parted(complex, g));
  const auto unite = [&](const PartedGroup& a, const PartedGroup& b) {
    return fold_of_two(complex, BooleanOp::unite, Dominance::left, a, b).group;
  };
  const PartedGroup three = unite(unite(v[0], v[1]), v[2]);
  REQUIRE(three.parts.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::count(three.parts.begin(), three.parts.end(), v[i].parts[0]) == 1);
  }
  const PartedGroup four = unite(three, v[3]);
  REQUIRE(four.parts.size() == 2);
  CHECK(std::count(four.parts.begin(), four.parts.end(), v[0].parts[0]) == 1);
  CHECK(fold_of_two(complex, BooleanOp::intersect, Dominance::equal, v[0], v[2]).group.parts.empty());
}

TEST_CASE("Simplified counts are those of the simplified complex", "[simplify]") {
  const auto [first, last] = scenes::seeds(40);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    for (const auto position : {scenes::Position::general, scenes::Position::degenerate}) {
      INFO("seed " << seed << ", position " << static_cast<int>(position));
      const auto leaves = scattered_leaves(seed, 4, position, static_cast<int>(seed % 3));
      const auto built_complex = build_complex(scenes::make_soup(leaves), {.threads = 1});
      const Complex& complex = *built_complex;
      const auto check = [&](const Selection& s, const Features& features) {
        check_places(complex, s, features);
        for (const SimplifyMode mode : kModes) {
          CHECK((simplified_counts(complex, s, features, mode) ==
                 active_counts(simplify(complex, s, features, mode))));
        }
      };
      for (const Group& g : leaf_groups(complex)) check(selection_of(complex, g), g.features);
      // Cells at random, open sets and features that are not active included.
      Random random(seed);
      const CellSet all = all_cells(complex);
      for (int one_in = 1; one_in <= 4; ++one_in) {
        Selection s;
        Features features;
        const auto pick = [&](const auto& cells, auto& list, int rarity) {
          for (auto cell : cells) {
            if (random.one_in(rarity)) list.emplace_back(cell, static_cast<Component>(random.between(1, 2)));
          }
        };
        pick(all.vertices, s.vertices, one_in);
        pick(all.edges, s.edges, one_in);
        pick(all.faces, s.faces, one_in);
        pick(all.regions, s.regions, 2);
        for (EdgeId e : all.edges) {
          if (random.one_in(6)) features.edges.push_back(e);
        }
        for (VertexId v : all.vertices) {
          if (random.one_in(8)) features.vertices.push_back(v);
        }
        check(s, features);
      }
    }
  }
}

}  // namespace cnrg::properties
