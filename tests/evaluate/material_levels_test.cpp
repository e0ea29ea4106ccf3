// Unions and intersections in which materials decide, against rules for the faces of a grid that know nothing of
// levels as groups: they look at the two sides of a face and at who wins there.
#include <array>
#include <optional>
#include <random>
#include <string>

#include "csg/explain/explain.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/evaluate/evaluated_tree.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

const std::string kMaterials =
    "cnrg: 1\nmaterials: {steel: {dominance: 3}, rock: {}, clay: {dominance: 1}, air: "
    "{dominance: -1}}\nnodes:\n";

const NodeValue& value_of(const EvaluatedTree& r) { return *r.evaluation.value(r.tree.result).value; }

/// Counts of the simplified result: vertices, edges, faces, regions.
std::array<std::size_t, 4> counts(const EvaluatedTree& r) {
  const NodeValue& value = value_of(r);
  return simplified_counts(*r.evaluation.complex, value, selection_of(*r.evaluation.complex, value));
}

std::string material_at(const EvaluatedTree& r, const RationalPoint& p) {
  const Location at = Locator(*r.evaluation.complex).locate(p);
  REQUIRE(at.dimension == 3);
  const std::uint32_t region = value_of(r).group().region_of(at.region);
  return region == 0 ? "outside" : value_of(r).group().regions[region - 1].material.name();
}

TEST_CASE("what a node or a number says comes before the dominance of materials", "[material-levels]") {
  const std::string nodes = kMaterials +
                            "  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock}\n"
                            "  beam: {box: {min: [2, 1, 1], max: [6, 3, 3]}, material: steel}\n";
  CHECK(material_at(evaluated_tree(nodes + "  r: {union: [block, beam], dominance: left}\nresult: r\n"),
                    {3, 2, 2}) == "rock");
  CHECK(material_at(evaluated_tree(nodes + "  r: {union: [{simplify: block, dominance: 1}, beam]}\nresult: r\n"),
                    {3, 2, 2}) == "rock");
  const EvaluatedTree equal = evaluated_tree(nodes + "  r: {union: [block, beam], dominance: equal}\nresult: r\n");
  CHECK(counts(equal)[3] == 1);
  CHECK(equal.evaluation.diagnostics.size() == 1);
}

TEST_CASE("where all is of one level, and where nothing has a dominance, nothing changes", "[material-levels]") {
  const std::string nodes =
      "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: one}\n"
      "  b: {box: {min: [2, 1, 1], max: [6, 3, 3]}, material: two}\n"
      "  r: {union: [a, b]}\nresult: r\n";
  const EvaluatedTree plain = evaluated_tree("cnrg: 1\nmaterials: {one: {}, two: {}}\nnodes:\n" + nodes);
  const EvaluatedTree same =
      evaluated_tree("cnrg: 1\nmaterials: {one: {dominance: 1/2}, two: {dominance: 0.5}}\nnodes:\n" + nodes);
  CHECK(counts(plain) == counts(same));
  CHECK(plain.evaluation.rows.back().removals == same.evaluation.rows.back().removals);
  CHECK(same.evaluation.diagnostics.size() == 1);
}

TEST_CASE("a sheet, a wire and a point are of the level of the region around them", "[material-levels]") {
  const std::string nodes = kMaterials +
                            "  rock: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock}\n"
                            "  steel: {box: {min: [6, 0, 0], max: [10, 4, 4]}, material: steel}\n"
                            "  sheet: {polygon: [[-1, -1, 2], [11, -1, 2], [11, 5, 2], [-1, 5, 2]]}\n"
                            "  cut: {polygon: [[6, 0, 1], [10, 0, 1], [10, 4, 1], [6, 4, 1]]}\n"
                            "  both: {union: [rock, steel]}\n";
  const EvaluatedTree r = evaluated_tree(nodes + "  r: {union: [both, sheet]}\nresult: r\n");
  CHECK(material_at(r, {8, 2, 1}) == "steel");
  // The sheet stays in rock, of its own level, and parts it; it goes from the steel.
  CHECK(value_of(r).group().regions.size() == 3);
  const EvaluatedTree inside =
      evaluated_tree(nodes +
                     "  parted: {union: [cut, steel], dominance: left}\n"
                     "  r: {union: [parted, {box: {min: [7, 1, -1], max: [9, 3, 3]}, material: rock}]}\n"
                     "result: r\n");
  CHECK(value_of(inside).group().regions.size() == 3);  // two of steel, and what of the rock sticks out
}

TEST_CASE("a sheet has the level of its own material, where that is greater", "[material-levels]") {
  const std::string nodes = kMaterials +
                            "  steel: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: steel}\n"
                            "  rock: {box: {min: [0, 0, 0], max: [2, 4, 4]}, material: rock}\n"
                            "  clay: {box: {min: [1, 0, 0], max: [4, 4, 4]}, material: clay}\n";
  const auto sheet = [](const std::string& material) {
    return "  sheet: {polygon: [[2, 0, 0], [2, 4, 0], [2, 4, 4], [2, 0, 4]], material: " + material + "}\n";
  };
  const auto regions = [&](const std::string& material, const std::string& node) {
    return value_of(evaluated_tree(nodes + sheet(material) + "  r: {" + node + "}\nresult: r\n"))
        .group()
        .regions.size();
  };
  CHECK(regions("clay", "union: [steel, sheet]") == 1);
  CHECK(regions("steel", "union: [steel, sheet]") == 2);  // of equals a sheet stays
  CHECK(regions("steel", "union: [clay, sheet]") == 2);
  CHECK(regions("clay", "intersection: [steel, {union: [sheet, clay], dominance: left}]") == 1);
  CHECK(regions("steel", "intersection: [steel, {union: [sheet, clay], dominance: left}]") == 2);
  // A wall of rock that is a sheet of steel, too: the rock behind it gives way to clay, the sheet does not.
  const std::string lined = "union: [{union: [sheet, rock], dominance: left}, clay]";
  CHECK(regions("rock", lined) == 2);
  CHECK(regions("air", lined) == 2);
  CHECK(regions("steel", lined) == 3);
  const EvaluatedTree r = evaluated_tree(nodes + sheet("steel") + "  r: {" + lined + "}\nresult: r\n", true);
  CHECK_THAT(
      explanation_text(r.tree, r.evaluation, explain(r.tree, r.evaluation, r.tree.result, RationalPoint{2, 1, 1})),
      Catch::Contains("their dominance here is 3 in A and 1 in B: A > B"));
}

TEST_CASE("ties of components are decided by their materials", "[material-levels]") {
  const std::string nodes = kMaterials +
                            "  a: {unify: {box: {min: [0, 0, 0], max: [2, 2, 2]}, material: rock}}\n"
                            "  b: {unify: {box: {min: [1, 0, 0], max: [3, 2, 2]}, material: steel}}\n"
                            "  c: {unify: {box: {min: [1, 0, 0], max: [4, 2, 2]}, material: clay}}\n";
  for (const std::string op : {"product: [a, b]", "product: [b, a]", "product: [c, b, a]"}) {
    const EvaluatedTree r = evaluated_tree(nodes + "  r: {" + op + "}\nresult: r\n");
    CHECK(value_of(r).attributes(1).material.name() == "steel");
    CHECK(value_of(r).attributes(1).name == "b");
    CHECK(r.evaluation.diagnostics.empty());
  }
  const EvaluatedTree many = evaluated_tree(nodes + "  r: {sum: [a, b, c]}\nresult: r\n");
  CHECK(many.evaluation.diagnostics.empty());
  CHECK(value_of(evaluated_tree(nodes + "  r: {product: [a, b], dominance: left}\nresult: r\n"))
            .attributes(1)
            .material.name() == "rock");
  const EvaluatedTree one = evaluated_tree(nodes + "  r: {unify: {sum: [a, b]}}\nresult: r\n");
  CHECK(value_of(one).attributes(1).material.name() == "steel");
  CHECK(one.evaluation.diagnostics.empty());
}

TEST_CASE("materials that tie are still at odds, but not where a third one wins", "[material-levels]") {
  const std::string nodes =
      "cnrg: 1\nmaterials: {rock: {}, ore: {}, steel: {dominance: 1}}\nnodes:\n"
      "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock}\n"
      "  b: {box: {min: [2, 0, 0], max: [6, 4, 4]}, material: ore}\n"
      "  s: {box: {min: [2, 0, 0], max: [6, 4, 4]}, material: steel}\n"
      "  bs: {union: [b, s], dominance: right}\n";
  CHECK(evaluated_tree(nodes + "  r: {union: [a, b, s]}\nresult: r\n").evaluation.diagnostics.size() == 1);
  CHECK(evaluated_tree(nodes + "  r: {union: [a, bs]}\nresult: r\n").evaluation.diagnostics.empty());
}

TEST_CASE("explain says which materials decided", "[material-levels]") {
  const EvaluatedTree r = evaluated_tree(kMaterials +
                                             "  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock}\n"
                                             "  beam: {box: {min: [2, 1, 1], max: [6, 3, 3]}, material: steel}\n"
                                             "  r: {union: [block, beam]}\nresult: r\n",
                                         true);
  const std::string text =
      explanation_text(r.tree, r.evaluation, explain(r.tree, r.evaluation, r.tree.result, RationalPoint{4, 2, 2}));
  CHECK_THAT(text, Catch::Contains("A = beam"));
  CHECK_THAT(text, Catch::Contains("their dominance here is 3 in A and 0 in B: A > B"));
  CHECK_THAT(text, Catch::Contains("removed by union.face.BinA.dominant"));
}

// --- a grid of unit cubes

constexpr int kSize = 5;

struct Grid {
  std::array<std::array<std::array<int, kSize + 2>, kSize + 2>, kSize + 2>
      region{};  // 0: none; a border around it
  std::vector<std::string> material{""};
  int& at(int x, int y, int z) { return region[std::size_t(x + 1)][std::size_t(y + 1)][std::size_t(z + 1)]; }
};

const std::vector<std::pair<std::string, std::optional<int>>> kKinds{{"air", -1},  {"rock", 0}, {"clay", 1},
                                                                     {"steel", 3}, {"iron", 3}, {"", 0}};

int level_of(const std::string& material) {
  for (const auto& [name, level] : kKinds) {
    if (name == material) return *level;
  }
  return 0;
}

/// Boxes of which each dominates those before; a box that has fallen apart is several regions.
std::string random_operand(std::mt19937& random, const std::string& name, Grid& grid) {
  std::string text, list;
  const int count = 1 + int(random() % 3);
  for (int i = 1; i <= count; ++i) {
    std::array<int, 3> low, high;
    for (int k = 0; k < 3; ++k) {
      low[std::size_t(k)] = int(random() % (kSize - 1));
      high[std::size_t(k)] = low[std::size_t(k)] + 1 + int(random() % unsigned(kSize - low[std::size_t(k)]));
    }
    const std::string material = kKinds[random() % kKinds.size()].first;
    for (int x = low[0]; x < high[0]; ++x) {
      for (int y = low[1]; y < high[1]; ++y) {
        for (int z = low[2]; z < high[2]; ++z) grid.at(x, y, z) = i;
      }
    }
    grid.material.push_back(material);
    const auto point = [](const std::array<int, 3>& p) {
      return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
    };
    text += "  " + name + std::to_string(i) + ": {box: {min: " + point(low) + ", max: " + point(high) + "}" +
            (material.empty() ? "" : ", material: " + material) + "}\n";
    list += (list.empty() ? "" : ", ") + name + std::to_string(i);
  }
  if (count == 1) return text + "  " + name + ": {simplify: " + list + "}\n";
  return text + "  " + name + ": {union: [" + list + "], dominance: right}\n";
}

/// What is on the two sides of a face, in one operand.
struct Sides {
  std::array<int, 2> region;
  std::array<std::optional<int>, 2> level;
  bool entity() const { return region[0] != region[1]; }
  int regions() const { return !entity() ? 0 : region[0] != 0 && region[1] != 0 ? 2 : 1; }
  /// The same with what is at another level left out.
  Sides at(int l) const {
    Sides out = *this;
    for (std::size_t s = 0; s < 2; ++s) {
      if (out.level[s] != l) out.region[s] = 0;
    }
    return out;
  }
};

bool stays_in_equal_union(const Sides& a, const Sides& b) {
  if (a.entity() && b.entity()) {
    return !(a.regions() == 1 && b.regions() == 1 && (a.region[0] != 0) != (b.region[0] != 0));
  }
  if (!a.entity() && !b.entity()) return false;
  const Sides &own = a.entity() ? a : b, &other = a.entity() ? b : a;
  return other.region[0] == 0 || own.regions() == 2;
}

bool stays_in_union(const Sides& a, const Sides& b) {
  std::array<std::optional<int>, 2> winner;
  for (std::size_t s = 0; s < 2; ++s) winner[s] = std::max(a.level[s], b.level[s]);
  if (winner[0] != winner[1]) return true;
  return winner[0] && stays_in_equal_union(a.at(*winner[0]), b.at(*winner[0]));
}

bool stays_in_intersection(const Sides& a, const Sides& b) {
  if (a.entity() && b.entity()) return true;
  if (!a.entity() && !b.entity()) return false;
  const Sides &own = a.entity() ? a : b, &other = a.entity() ? b : a;
  if (other.region[0] == 0) return false;
  const bool loses = other.level[0] > own.level[0] && other.level[0] > own.level[1];
  return own.regions() == 1 || !loses;
}

TEST_CASE("unions and intersections by material, face by face of a grid", "[material-levels]") {
  std::string materials = "cnrg: 1\nmaterials: {";
  for (const auto& [name, level] : kKinds) {
    if (!name.empty()) materials += name + ": {dominance: " + std::to_string(*level) + "}, ";
  }
  materials += "none: {}}\nnodes:\n";
  const auto [first, last] = scenes::seeds(120);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    Grid a, b;
    std::string text = materials + random_operand(random, "a", a) + random_operand(random, "b", b);
    const bool is_union = random() % 2 == 0;
    text += std::string("  r: {") + (is_union ? "union" : "intersection") + ": [a, b]}\nresult: r\n";
    INFO(text);
    const EvaluatedTree r = evaluated_tree(text);
    const Group& group = value_of(r).group();
    const Locator locator(*r.evaluation.complex);
    const auto point = [](int x, int y, int z, int axis, bool face) {
      RationalPoint p{Rational(2 * x + 1, 2), Rational(2 * y + 1, 2), Rational(2 * z + 1, 2)};
      if (face) p[axis] -= Rational(1, 2);
      return p;
    };
    for (int x = 0; x <= kSize; ++x) {
      for (int y = 0; y <= kSize; ++y) {
        for (int z = 0; z <= kSize; ++z) {
          const auto levels = [&](Grid& grid, int region) {
            return region == 0 ? std::nullopt : std::optional(level_of(grid.material[std::size_t(region)]));
          };
          for (int axis = 0; axis < 3; ++axis) {
            const auto sides = [&](Grid& grid) {
              Sides out{{grid.at(x - (axis == 0), y - (axis == 1), z - (axis == 2)), grid.at(x, y, z)}, {}};
              for (std::size_t s = 0; s < 2; ++s) out.level[s] = levels(grid, out.region[s]);
              return out;
            };
            const Location at = locator.locate(point(x, y, z, axis, true));
            const bool is_face = at.dimension == 2 && group.has(at.face);
            INFO("face at " << x << " " << y << " " << z << ", axis " << axis);
            CHECK(is_face == (is_union ? stays_in_union : stays_in_intersection)(sides(a), sides(b)));
          }
          const int in_a = a.at(x, y, z), in_b = b.at(x, y, z);
          const auto level_a = levels(a, in_a), level_b = levels(b, in_b);
          const bool inside = is_union ? in_a != 0 || in_b != 0 : in_a != 0 && in_b != 0;
          const std::uint32_t region = group.region_of(locator.locate(point(x, y, z, 0, false)).region);
          CHECK((region != 0) == inside);
          if (region == 0 || !inside || level_a == level_b) continue;
          const std::string& won =
              level_a > level_b ? a.material[std::size_t(in_a)] : b.material[std::size_t(in_b)];
          INFO("cube at " << x << " " << y << " " << z);
          const std::string& made_of = group.regions[region - 1].material.name();
          // Regions of one level that touch are one, of the material of one of them.
          CHECK(level_of(made_of) == level_of(won));
        }
      }
    }
  }
}

/// A box, a sheet, a wire or a point, of a material or of none.
std::string random_leaf(std::mt19937& random) {
  const auto below = [&](int n) { return int(random() % unsigned(n)); };
  const auto point = [](const std::array<int, 3>& p) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
  };
  std::array<int, 3> low{below(4), below(4), below(4)}, high;
  for (std::size_t k = 0; k < 3; ++k) high[k] = low[k] + 1 + below(3);
  const std::string material = kKinds[random() % kKinds.size()].first;
  const std::string said = (material.empty() ? "" : ", material: " + material) + std::string("}");
  const int kind = below(20);
  if (kind < 11) return "{box: {min: " + point(low) + ", max: " + point(high) + "}" + said;
  if (kind < 17) {
    const auto axis = static_cast<std::size_t>(below(3));
    std::array<int, 3> b = high, c = high, d = low;
    b[axis] = c[axis] = low[axis];
    b[(axis + 1) % 3] = low[(axis + 1) % 3];
    d[(axis + 1) % 3] = high[(axis + 1) % 3];
    return "{polygon: [" + point(low) + ", " + point(b) + ", " + point(c) + ", " + point(d) + "]" + said;
  }
  if (kind < 19) return "{polyline: [" + point(low) + ", " + point(high) + "]" + said;
  return "{points: [" + point(low) + "]" + said;
}

std::string random_node(std::mt19937& random, int depth) {
  if (depth == 0) return random_leaf(random);
  const bool is_union = random() % 3 != 0;
  std::string text = is_union ? "{union: [" : "{intersection: [";
  const int count = 2 + int(random() % 2);
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + random_node(random, depth - 1);
  return text + (is_union && random() % 4 == 0 ? "], blend: linear}" : "]}");
}

TEST_CASE("point sets are right and groups whole with sheets and wires of any level, and where they blend",
          "[material-levels][blend]") {
  const auto [first, last] = scenes::seeds(150);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::string text = "cnrg: 1\nmaterials: {";
    for (const auto& [name, level] : kKinds) {
      if (!name.empty()) text += name + ": {dominance: " + std::to_string(*level) + "}, ";
    }
    text += "none: {}}\nnodes: {r: " + random_node(random, 2) + "}\nresult: r\n";
    INFO("seed " << seed << "\n" << text);
    const EvaluatedTree r = evaluated_tree(text);  // each step is checked against the identities of its point sets
    for (const NodeRow& row : r.evaluation.rows) {
      for (const auto& [rule, count] : row.removals) CHECK(table_rows()[rule].condition != Condition::never);
    }
  }
}

}  // namespace
}  // namespace cnrg
