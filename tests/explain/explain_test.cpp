// Explanations against the evaluation that they explain: random trees with every operator on a small grid, every
// cell of the refinement asked about at every node.
#include "csg/explain/explain.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "csg/explain/fates.h"
#include "csg/explain/lives.h"
#include "csg/result/result.h"
#include "kernel/base/union_find.h"
#include "tests/catch.h"
#include "tests/oracles/dag.h"
#include "tests/oracles/evaluation.h"

namespace cnrg {
namespace {

struct Run {
  Tree tree;
  Evaluation evaluation;
};

Run run(const std::string& tree) {
  Run r{parse_tree(tree, "t.yaml"), {}};
  EvaluateOptions options;
  options.keep_all = true;
  r.evaluation = evaluate(r.tree, options);
  return r;
}
Run run(const std::string& nodes, const std::string& result) {
  return run("cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n");
}

/// Every operator over leaves on a small grid, or group Booleans alone.
std::string random_tree(std::uint64_t seed) {
  constexpr auto kGrid = scenes::Position::degenerate;
  if (seed % 2 == 0) return properties::tree_file(properties::random_dag(seed, kGrid));
  scenes::Random random(seed);
  return properties::tree_file(properties::boolean_tree(random, scenes::random_leaves(seed, 6, kGrid)));
}

std::vector<CellSide> all_pieces(const Complex& complex) {
  std::vector<CellSide> out;
  const CellSet all = all_cells(complex);
  for (const VertexId v : all.vertices) out.push_back({{0, v, {}, {}, {}}, 0});
  for (const EdgeId e : all.edges) out.push_back({{1, {}, e, {}, {}}, 0});
  for (const FaceId f : all.faces) out.push_back({{2, {}, {}, f, {}}, 1});
  for (const RegionId r : all.regions) out.push_back({{3, {}, {}, {}, r}, 0});
  return out;
}

/// The condition of the row, from nothing but the facts that are told.
bool condition_holds(const BooleanFacts& f) {
  const std::vector<CellState>& around = f.b.around;
  switch (f.verdict.row->condition) {
    case Condition::never: return false;
    case Condition::always: return true;
    case Condition::one_region_a: return f.a.regions == 1;
    case Condition::one_region_b: return f.b.regions == 1;
    case Condition::opposite_regions:
      return f.a.regions == 1 && f.b.regions == 1 &&
             (f.a.sides[0].component == 0) != (f.b.sides[0].component == 0);
    case Condition::parts_or_hangs_in_b:
      return f.b.regions == 2 || (f.b.regions == 0 && f.b.sides[0].component != 0);
    case Condition::no_new_region: return f.b.regions != 1;
    case Condition::no_side_survives: {
      bool survives = false;
      for (const std::size_t s : {0u, 1u}) {
        survives = survives || (f.a.sides[s].component != 0 && f.b.sides[s].component == 0);
      }
      return !survives || (f.a.regions == 0 && f.b.regions == 0);
    }
    case Condition::not_free_a: return !f.a.free;
    case Condition::not_free_b: return !f.b.free;
    case Condition::free_in_neither: return !f.a.free && !f.b.free;
    case Condition::inside_region_b: return around.size() == 1 && around[0].component != 0;
  }
  return false;
}

/// The operator's decision from the star of one set.
bool decided(Operator op, const StarFacts& s) {
  switch (op) {
    case Operator::interior: return s.in_set && s.whole;
    case Operator::closure: return s.touched;
    case Operator::boundary: return s.touched && !s.whole;
    default: return s.solid;
  }
}

/// Free is what bounds nothing of the operand: no face around an edge, no edge or face around a vertex.
bool is_free(const Complex& complex, const Group& group, const Location& cell) {
  const Selection s = selection_of(complex, group);
  const CellSet around =
      star(complex, cell.dimension == 0 ? CellSet{{cell.vertex}, {}, {}, {}} : CellSet{{}, {cell.edge}, {}, {}});
  const auto entities = static_cast<Component>(group.regions.size() + 1);
  const auto among = [&](const auto& list, const auto& cells) {
    return std::any_of(list.begin(), list.end(), [&](const auto& entry) {
      return entry.second == entities && std::binary_search(cells.begin(), cells.end(), entry.first);
    });
  };
  return !among(s.faces, around.faces) && (cell.dimension == 1 || !among(s.edges, around.edges));
}

std::string check_boolean_facts(const BooleanFacts& f) {
  const Verdict& v = f.verdict;
  if (v.entity != (f.a.state.entity || f.b.state.entity)) return "an entity of an operand has no verdict";
  if (!v.entity) {
    const bool a = f.a.state.component != 0, b = f.b.state.component != 0, r = f.result.component != 0;
    return r == (f.op == BooleanOp::unite       ? a || b
                 : f.op == BooleanOp::intersect ? a && b
                                                : a && !b)
               ? ""
               : "a cell inside of regions is not where the point sets say";
  }
  if (v.removed == f.result.entity) return "removed and still an entity, or the other way round";
  for (const OperandFacts* o : {&f.a, &f.b}) {
    // numFace > 0 or dangOrLoose, numEdge > 0 or loose: the paper's terms for what is not free.
    if (v.row->dimension < 2 && o->state.entity && o->free != (o->bounds == 0 && o->within == 0))
      return "free, and in the paper's terms not, or the other way round";
  }
  if (v.bounds_kept) return v.removed ? "removed though it bounds a kept cell" : "";
  const bool cut = v.row->condition == Condition::inside_region_b && v.removed;  // of a wall: see tables.h
  return condition_holds(f) == v.removed || cut ? "" : std::string("the facts do not explain ") + v.row->id;
}

/// How many cells each row removed in a step of a Boolean, as far as pieces are told: two that meet in a piece
/// that is inside of a larger cell are of one. `pieces` are all cells of the complex, by dimension in their order.
std::map<const TableRow*, std::size_t> told_to_remove(const Complex& complex, const std::vector<CellSide>& pieces,
                                                      const std::vector<const BooleanFacts*>& facts) {
  std::map<EdgeId, std::size_t> of_edge;
  std::map<FaceId, std::size_t> of_face;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].cell.dimension == 1) of_edge[pieces[p].cell.edge] = p;
    if (pieces[p].cell.dimension == 2) of_face[pieces[p].cell.face] = p;
  }
  UnionFind cells(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Location& at = pieces[p].cell;
    if (at.dimension > 1 || !facts[p]->verdict.entity || facts[p]->dimension != at.dimension + 1) continue;
    std::vector<std::size_t> beside;
    if (at.dimension == 1)
      for (const FaceUse& use : complex.edge_uses[at.edge]) beside.push_back(of_face.at(use.face));
    else
      for (const EdgeId e : complex.vertex_edges[at.vertex]) beside.push_back(of_edge.at(e));
    std::erase_if(beside, [&](std::size_t q) {
      return !facts[q]->verdict.entity || facts[q]->dimension != pieces[q].cell.dimension;
    });
    for (const std::size_t q : beside)
      cells.unite(static_cast<std::uint32_t>(beside[0]), static_cast<std::uint32_t>(q));
  }
  std::map<const TableRow*, std::size_t> out;
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    const BooleanFacts& f = *facts[p];
    if (f.verdict.removed && f.dimension == pieces[p].cell.dimension && cells.find(p) == p) ++out[f.verdict.row];
  }
  return out;
}

/// Everything told of every cell at every node, against the kept values and the counts of the rows.
std::string check_stories(const Run& r, std::set<std::string>& rows) {
  const Complex& complex = *r.evaluation.complex;
  const std::vector<CellSide> pieces = all_pieces(complex);
  const std::vector<Life> lives = Lives(r.tree, r.evaluation, r.tree.result).of(pieces, false);
  std::map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < r.evaluation.rows.size(); ++i) place[r.evaluation.rows[i].name] = i;
  for (std::size_t s = 0; s < lives.front().size(); ++s) {
    const std::string& name = lives.front()[s].name;
    const std::size_t i = place.at(name);
    const Node& node = r.tree.nodes[lives.front()[s].node];
    const Selection selection = selection_of(complex, *r.evaluation.values[InstanceId(i)]);
    std::map<const TableRow*, std::size_t> removals;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const LifeStep& step = lives[p][s];
      if (step.state.component != properties::component_at(selection, pieces[p].cell))
        return name + ": wrong state";
      for (const BooleanFacts& f : step.booleans) {
        const std::string fault = check_boolean_facts(f);
        if (!fault.empty()) return name + ": " + fault;
        if (f.verdict.entity && !f.verdict.bounds_kept) rows.insert(f.verdict.row->id);
      }
      if (node.op != Operator::leaf && pieces[p].cell.dimension < 2 && !step.booleans.empty()) {
        const BooleanFacts& f = step.booleans.front();
        const NodeValue& left = *r.evaluation.values[r.evaluation.instances[InstanceId(i)].operands[0]];
        const OperandFacts& told = f.a.name == step.operands[0].first ? f.a : f.b;
        if (f.dimension == pieces[p].cell.dimension && told.state.entity && left.is_group() &&
            told.free != is_free(complex, left.group(), pieces[p].cell)) {
          return name + ": free is told wrongly";
        }
      }
      const CellState& made = step.attribute ? step.attribute->before : step.state;
      if (step.booleans.empty() && !step.stars.empty()) {
        const bool active = std::any_of(step.stars.begin(), step.stars.end(),
                                        [&](const StarFacts& star) { return decided(node.op, star); });
        if (active != (made.component != 0)) return name + ": the star does not explain the result";
      }
      if (!step.booleans.empty() && step.booleans.back().result != made)
        return name + ": the last step is not the result";
    }
    for (std::size_t k = 0; k < lives.front()[s].booleans.size(); ++k) {
      std::vector<const BooleanFacts*> facts;
      for (const Life& life : lives) facts.push_back(&life[s].booleans[k]);
      for (const auto& [row, count] : told_to_remove(complex, pieces, facts)) removals[row] += count;
    }
    std::map<const TableRow*, std::size_t> counted;
    for (const auto& [row, count] : r.evaluation.rows[i].removals) counted[&table_rows()[row]] = count;
    if (removals != counted) {
      return name + ": removals of its rows do not add up";
    }
  }
  return "";
}

TEST_CASE("every cell's life agrees with the evaluation, and every row of the tables occurs", "[explain]") {
  std::set<std::string> rows;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const std::string tree = random_tree(seed);
    INFO("seed " << seed << "\n" << tree);
    CHECK(check_stories(run(tree), rows) == "");
  }
  const std::string thin = R"(  b: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  w: {polyline: [[1, 1, 1], [2, 1, 1]]}
  p: {points: [[3, 3, 3]]}
  t: {union: [w, p]}
  i: {intersection: [b, t], dominance: equal}
  j: {intersection: [t, b], dominance: equal}
  k: {intersection: [t, b], dominance: left}
  l: {union: [p, b], dominance: left}
  result: {union: [i, j, k, l]}
)";
  CHECK(check_stories(run(thin, "result"), rows) == "");
  for (const TableRow& row : table_rows()) {
    INFO(row.id);
    CHECK(rows.count(row.id) == 1);
  }
}

/// What a page draws as removed at a Boolean of two, by row.
std::map<std::size_t, std::size_t> drawn_removed(const Run& r, InstanceId id, BooleanOp op) {
  std::map<std::size_t, std::size_t> out;
  const std::optional<Selection> all = fates(r.tree, r.evaluation, id);
  if (!all) return out;
  const Result drawn(r.evaluation.complex, *all);
  const auto see = [&](const auto& cells, int dimension) {
    for (const auto& cell : cells) {
      if (cell.component == 0) continue;
      const Fate fate = Fate::of(cell.component);
      if (fate.table && fate.removed) ++out[table_row(op, fate.dominant, dimension, fate.relation)];
    }
  };
  see(drawn.cells().vertices, 0), see(drawn.cells().edges, 1), see(drawn.cells().faces, 2);
  return out;
}

// Where only a feature parts cells of one fate they are drawn as one.
TEST_CASE("a page draws removed cells of the rows that removed some, and no more", "[explain]") {
  std::size_t nodes_seen = 0;
  for (std::uint64_t seed = 2000; seed < 2250; ++seed) {
    const std::string tree = random_tree(seed);
    INFO("seed " << seed << "\n" << tree);
    const Run r = run(tree);
    for (const InstanceId id : IdRange<InstanceId>(r.evaluation.instances.size())) {
      const Instance& instance = r.evaluation.instances[id];
      const Node& node = r.tree.nodes[instance.node];
      const bool boolean =
          node.op == Operator::unite || node.op == Operator::intersect || node.op == Operator::subtract;
      if (!boolean || instance.operands.size() != 2 || node.regularize) continue;
      ++nodes_seen;
      std::map<std::size_t, std::size_t> counted;
      for (const auto& [row, count] : r.evaluation.rows[id.index()].removals) counted[row] = count;
      INFO(node.name);
      const std::map<std::size_t, std::size_t> drawn = drawn_removed(r, id, boolean_op(node.op));
      CHECK(drawn.size() == counted.size());
      for (const auto& [row, count] : drawn) CHECK(count <= counted[row]);
    }
  }
  CHECK(nodes_seen > 100);
}

TEST_CASE("rows that a Boolean asked have removed what its row of the table counts", "[explain]") {
  std::size_t kept = 0, idle = 0, several = 0;
  for (std::uint64_t seed = 2000; seed < 2250; ++seed) {
    const std::string tree = random_tree(seed);
    INFO("seed " << seed << "\n" << tree);
    const Run r = run(tree);
    for (const InstanceId id : IdRange<InstanceId>(r.evaluation.instances.size())) {
      const AskedRows asked = asked_rows(r.tree, r.evaluation, id);
      INFO(r.tree.nodes[r.evaluation.instances[id].node].name);
      Removals removed;
      for (const auto& [row, cells] : asked.cells) {
        removed.add(row, cells[1]);
        kept += cells[0];
        idle += cells[0] + cells[1] == 0;
      }
      several += asked.steps.size() > 1;
      const Removals& counted = r.evaluation.rows[id.index()].removals;
      if (!asked.steps.empty()) CHECK(removed.total() == counted.total());
      for (const auto& [row, count] : removed) CHECK(count == counted.of(row));
    }
  }
  CHECK(kept > 1000);
  CHECK(idle > 1000);
  CHECK(several > 10);
}

// A box of 4 x 4 x 4 and one that goes 2 deep into a wall of it. By hand: of b's 6 faces 4 are cut in two, 1 is
// inside, 1 outside; what lies in a wall of a is 4 edges with 4 corners, and the part of that wall between them.
TEST_CASE("cells of each row, counted by hand", "[explain]") {
  const auto counts = [](const std::string& dominance) {
    const Run r =
        run("  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}}\n  b: {box: {min: [2, 1, 1], max: [6, 3, 3]}}\n"
            "  u: {union: [a, b], dominance: " +
                dominance + "}\n",
            "u");
    std::map<std::string, std::array<std::size_t, 2>> out;
    const InstanceId id = instance_of(r.evaluation, r.evaluation.kept.front());
    for (const auto& [row, cells] : asked_rows(r.tree, r.evaluation, id).cells) out[table_rows()[row].id] = cells;
    return out;
  };
  using Counts = std::map<std::string, std::array<std::size_t, 2>>;
  CHECK(counts("left") == Counts{{"union.face.AinB.dominant", {1, 0}},
                                 {"union.face.BinA.dominant", {0, 5}},
                                 {"union.face.INTERS.dominant", {0, 0}},
                                 {"union.face.AoutB.dominant", {6, 0}},
                                 {"union.face.BoutA.dominant", {5, 0}},
                                 {"union.edge.AinB.dominant", {0, 0}},
                                 {"union.edge.BinA.dominant", {0, 8}},
                                 {"union.edge.INTERS.dominant", {4, 0}},
                                 {"union.edge.AoutB.dominant", {12, 0}},
                                 {"union.edge.BoutA.dominant", {8, 0}},
                                 {"union.vertex.AinB.dominant", {0, 0}},
                                 {"union.vertex.BinA.dominant", {0, 4}},
                                 {"union.vertex.INTERS.dominant", {4, 0}},
                                 {"union.vertex.AoutB.dominant", {8, 0}},
                                 {"union.vertex.BoutA.dominant", {4, 0}}});
  const Counts equal = counts("equal");
  CHECK(equal.size() == 15);
  CHECK(equal.at("union.face.AinB.equal") == std::array<std::size_t, 2>{0, 1});
  CHECK(equal.at("union.face.BinA.equal") == std::array<std::size_t, 2>{0, 5});
  CHECK(equal.at("union.edge.INTERS.equal") == std::array<std::size_t, 2>{4, 0});
}

const char* const kBoxes = R"(  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b: {box: {min: [1, 1, 0], max: [3, 3, 2]}}
  u: {union: [a, b]}
)";

TEST_CASE("a wall that vanished: the row and the facts that removed it", "[explain]") {
  const Run r = run(kBoxes, "u");
  const Explanation e = explain(r.tree, r.evaluation, r.tree.result, RationalPoint{1, Rational(3, 2), 1});
  CHECK(e.state.component == 1);
  CHECK_FALSE(e.state.entity);
  REQUIRE(e.classes.size() == 1);
  const Life& life = e.classes[0].life;
  REQUIRE(life.size() == 3);
  CHECK(life[0].state.name == "a");
  CHECK(life[1].state.entity);
  CHECK(life[1].leaf_cells == std::vector<LeafCell>{{LeafId(1), 2, 0}, {LeafId(1), 3, 1}});
  REQUIRE(life[2].booleans.size() == 1);
  const BooleanFacts& f = life[2].booleans[0];
  CHECK(f.verdict.row->id == std::string("union.face.BinA.equal"));
  CHECK(f.verdict.removed);
  CHECK(f.a.name == "a");
  CHECK(f.b.regions == 1);
  // n points to the side where b is not.
  REQUIRE(e.classes[0].normal);
  const bool outward = *e.classes[0].normal == std::array<Integer, 3>{-1, 0, 0};
  CHECK(f.b.sides[outward ? 0 : 1].component == 0);
  CHECK(f.b.sides[outward ? 1 : 0].component == 1);
}

TEST_CASE("n points to the side that is told first, on every facet of a curved face too", "[explain]") {
  const Run r = run(R"(  s: {sphere: {center: [0, 0, 0], radius: 3, segments: 12}}
  c: {cylinder: {from: [0, 0, -5], to: [0, 0, 5], radius: 1, segments: 12}}
  u: {union: [s, c], dominance: left}
)",
                    "u");
  const Complex& complex = *r.evaluation.complex;
  const Locator locator(complex);
  const SimplifiedComplex& simplified = *r.evaluation.value(r.tree.result).simplified;
  std::vector<CellSide> pieces;
  for (const SimplifiedComplex::Face& face : simplified.faces) {
    for (const HalfFace h : face.cells) {
      pieces.push_back({{2, {}, {}, h.face(), {}}, h.side()});
      pieces.push_back({{2, {}, {}, h.face(), {}}, h.opposite().side()});
    }
  }
  const std::vector<Life> lives = Lives(r.tree, r.evaluation, r.tree.result).of(pieces, false);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const BooleanFacts& f = lives[p].back().booleans.at(0);
    for (const std::size_t side : {0u, 1u}) {
      const RegionId next =
          complex.region(HalfFace(pieces[p].cell.face, pieces[p].side ^ static_cast<unsigned>(side)));
      CHECK(f.a.sides[side].component == r.evaluation.values[InstanceId(0)]->group().region_of(next));
      CHECK(f.b.sides[side].component == r.evaluation.values[InstanceId(1)]->group().region_of(next));
    }
  }
  for (std::size_t k = 0; k < simplified.faces.size(); ++k) {
    for (const LifeClass& c : explain(r.tree, r.evaluation, r.tree.result, "f" + std::to_string(k)).classes) {
      RationalPoint off = c.point;
      Integer size = 0;
      for (const Integer& n : *c.normal) size += abs(n);
      for (std::size_t i = 0; i < 3; ++i) off[i] += Rational((*c.normal)[i], size * 1000000);
      const RegionId there = locator.locate(off).region;
      const OperandFacts& a = c.life.back().booleans[0].a;
      CHECK(a.sides[0].component == r.evaluation.values[InstanceId(0)]->group().region_of(there));
    }
  }
}

TEST_CASE("pieces of a simplified cell are told in classes", "[explain]") {
  // Without features bottom and top are one face each, with pieces of a alone, of both, of b alone.
  const Run r = run(std::string(kBoxes) + "  p: {simplify: {of: u, mode: points}}\n", "p");
  const SimplifiedComplex& s = *r.evaluation.value(r.tree.result).simplified;
  const Complex& complex = *r.evaluation.complex;
  const Locator locator(complex);
  bool three = false;
  for (std::size_t k = 0; k < s.faces.size(); ++k) {
    const Explanation e = explain(r.tree, r.evaluation, r.tree.result, "f" + std::to_string(k));
    CHECK(e.pieces == s.faces[k].cells.size());
    std::size_t pieces = e.pieces_left_out;
    for (const LifeClass& c : e.classes) {
      pieces += c.pieces;
      const Location at = locator.locate(c.point);
      CHECK(at.dimension == 2);
      CHECK(at.face == c.example.face);
      CHECK_FALSE(c.origins.empty());
    }
    CHECK(pieces == e.pieces);
    three = three || e.classes.size() == 3;
    if (e.classes.size() != 3) continue;
    const Explanation one = explain(r.tree, r.evaluation, r.tree.result, "f" + std::to_string(k), 1);
    CHECK(one.classes.size() == 1);
    CHECK(one.classes_left_out == 2);
    CHECK(one.classes[0].pieces + one.pieces_left_out == one.pieces);
  }
  CHECK(three);
}

TEST_CASE("the point of a region lies in it, bounded or not", "[explain]") {
  const Run r = run(R"(  a: {box: {min: [0, 0, 0], max: ["1/1000", 1, 1]}}
  w: {polyline: [["1/2000", -1, "1/2"], ["1/2000", 2, "1/2"]]}
  s: {sphere: {center: [0, 0, 5], radius: 1, segments: 8}}
  u: {union: [a, w, s], dominance: left}
)",
                    "u");
  const SimplifiedComplex& s = *r.evaluation.value(r.tree.result).simplified;
  const Locator locator(*r.evaluation.complex);
  REQUIRE(s.regions.size() == 3);
  for (std::size_t k = 0; k < s.regions.size(); ++k) {
    const Explanation e = explain(r.tree, r.evaluation, r.tree.result, "r" + std::to_string(k));
    for (const LifeClass& c : e.classes) CHECK(locator.locate(c.point).region == c.example.region);
  }
  const Run wires = run("  w: {polyline: [[0, 0, 0], [5, 0, 0]]}\n", "w");
  const Explanation e = explain(wires.tree, wires.evaluation, wires.tree.result, "r0");
  CHECK(Locator(*wires.evaluation.complex).locate(e.classes.at(0).point).dimension == 3);
}

TEST_CASE("cells that are none are refused with those that there are", "[explain][errors]") {
  const Run r = run(kBoxes, "u");
  const auto fault = [&](const std::string& cell) {
    try {
      explain(r.tree, r.evaluation, r.tree.result, cell);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::size_t faces = r.evaluation.kept[0].simplified->faces.size();
  CHECK(fault("f99") == "`f99`: the node `u` has faces f0 to f" + std::to_string(faces - 1));
  CHECK(fault("r99999999999999") == "`r99999999999999`: the node `u` has regions r0 to r1");
  for (const char* cell : {"", "f", "x1", "f-1", "f1x", "12", "-"}) {
    CHECK_THAT(fault(cell), Catch::StartsWith("`" + std::string(cell) + "` names no cell"));
  }
  const Run half =
      run("  h: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\n  b: {box: {min: [0, 0, 0], max: "
          "[1, 1, 1]}}\n  u: {union: [h, b]}\n",
          "u");
  CHECK_THROWS_AS(explain(half.tree, half.evaluation, half.tree.result, RationalPoint{1000000, 0, 0}), InputError);
}

}  // namespace
}  // namespace cnrg
