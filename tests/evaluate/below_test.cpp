// What is below a surface: counted by hand, and against surfaces that are graphs, where heights decide and volumes
// are integrals.
#include "csg/operators/below.h"

#include <set>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/identities.h"
#include "csg/operators/node_value.h"
#include "kernel/complex/interior.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/measure.h"
#include "tests/catch.h"
#include "tests/scenes/scene.h"

namespace cnrg {
namespace {

using scenes::Random;

Evaluation evaluated(const std::string& text, const std::vector<std::string>& nodes) {
  const Tree tree = parse_tree(text, "t.yaml");
  EvaluateOptions options;
  options.validate = true;
  for (const std::string& node : nodes) options.nodes.push_back(tree.find(node));
  return evaluate(tree, options);
}

std::string fault_of(const std::string& nodes) {
  try {
    evaluated("cnrg: 1\nnodes:\n" + nodes + "result: r\n", {});
    return "";
  } catch (const TreeError& e) {
    return e.what();
  }
}

Rational volume_of(const Evaluation& e, const Group& g) {
  std::vector<RegionId> cells;
  for (const auto& cell : g.cells) cells.push_back(cell.first);
  return cells.empty() ? Rational(0) : *volume(*e.complex, cells);
}

/// A graph z(x, y) over squares of side `side` from (-side, -side), each in two triangles.
struct Graph {
  int n, side;
  std::vector<std::vector<Rational>> z;  // by corner: [i along x][j along y]

  /// The height over a point, from the triangle that holds it.
  Rational at(const Rational& x, const Rational& y) const {
    const Rational u = x / side + 1, v = y / side + 1;
    const auto i = static_cast<std::size_t>(std::min<long>(n - 1, mpz_class(u.get_num() / u.get_den()).get_si()));
    const auto j = static_cast<std::size_t>(std::min<long>(n - 1, mpz_class(v.get_num() / v.get_den()).get_si()));
    const Rational s = u - static_cast<long>(i), t = v - static_cast<long>(j);
    const Rational &a = z[i][j], &b = z[i + 1][j], &c = z[i + 1][j + 1], &d = z[i][j + 1];
    return s >= t ? a + s * (b - a) + t * (c - b) : a + t * (d - a) + s * (c - d);
  }
  std::string mesh() const {
    std::string points, faces;
    const auto number = [&](int i, int j) { return std::to_string(i * (n + 1) + j); };
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        points += (points.empty() ? "[" : ", [") + std::to_string(side * (i - 1)) + ", " +
                  std::to_string(side * (j - 1)) + ", " +
                  to_string(z[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) + "]";
        if (i == n || j == n) continue;
        faces += (faces.empty() ? "[" : ", [") + number(i, j) + ", " + number(i + 1, j) + ", " +
                 number(i + 1, j + 1) + "], [" + number(i, j) + ", " + number(i + 1, j + 1) + ", " +
                 number(i, j + 1) + "]";
      }
    }
    return "{points: [" + points + "], faces: [" + faces + "], fill: none}";
  }
};

Graph random_graph(Random& random, int n, int side, int low, int high) {
  Graph g{n, side, {}};
  g.z.resize(static_cast<std::size_t>(n) + 1);
  for (auto& row : g.z) {
    for (int j = 0; j <= n; ++j)
      row.push_back(fraction(low * 4 + static_cast<int>(random.below((high - low) * 4 + 1)), 4));
  }
  return g;
}

TEST_CASE("what is below a random graph has its cells under it, and the volume of the integral", "[below]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int n = 3 + static_cast<int>(random.below(3)), side = 2;
    const int width = side * (n - 2);   // of the block: the graph reaches beyond it by a square on each side
    const bool within = seed % 2 == 0;  // it meets neither the top nor the bottom
    const Graph graph = random_graph(random, n, side, within ? 1 : -2, within ? 5 : 8);
    const std::string w = std::to_string(width);
    const Evaluation e = evaluated(
        "cnrg: 1\nnodes:\n  sheet: {mesh: " + graph.mesh() + "}\n  left: {box: {min: [0, 0, 0], max: [1, " + w +
            ", 6]}}\n  right: {box: {min: [1, 0, 0], max: [" + w + ", " + w +
            ", 6]}}\n  block: {union: [left, right], dominance: left}\n"
            "  low: {below: sheet, within: block}\n  high: {above: sheet, within: block}\n"
            "  all: {union: [low, high], dominance: left}\nresult: all\n",
        {"low", "high"});
    const Group &all = e.kept[0].group(), &low = e.kept[1].group(), &high = e.kept[2].group();
    CHECK(check_group(*e.complex, low) == "");
    CHECK(check_group(*e.complex, high) == "");
    const Locator locator(*e.complex);
    for (const Group* side_group : {&low, &high}) {
      for (const auto& [cell, region] : side_group->cells) {
        const RationalPoint p = interior_point(*e.complex, locator, cell);
        CHECK((p[2] < graph.at(p[0], p[1])) == (side_group == &low));
      }
    }
    CHECK(volume_of(e, all) == Rational(width) * width * 6);
    CHECK(volume_of(e, low) + volume_of(e, high) == volume_of(e, all));
    if (!within) continue;
    Rational integral = 0;
    for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(n); ++i) {
      for (std::size_t j = 1; j + 1 < static_cast<std::size_t>(n); ++j) {
        const auto& z = graph.z;
        integral += Rational(side * side, 6) * (2 * z[i][j] + z[i + 1][j] + z[i][j + 1] + 2 * z[i + 1][j + 1]);
      }
    }
    integral.canonicalize();
    CHECK(volume_of(e, low) == integral);
  }
}

TEST_CASE("a layer's name is not that of the horizon at which it ends", "[below]") {
  const Evaluation e = evaluated(
      "cnrg: 1\nmaterials: {sand: {}, clay: {}}\nnodes:\n"
      "  block:   {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: sand}\n"
      "  horizon: {polygon: [[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]], name: horizon, attributes: {age: "
      "3}}\n"
      "  low:     {below: horizon, within: block, material: clay, name: low, attributes: {age: 5}}\n"
      "result: low\n",
      {});
  const Group& low = e.kept.front().value->group();
  REQUIRE(low.regions.size() == 1);
  CHECK(low.regions[0].name == "low");
  CHECK(low.regions[0].material.name() == "clay");
  std::size_t named = 0;
  for (const LeafSetId set : low.origins.faces) {
    const SaidPointer& said = low.origins.sets.said(set);
    if (!said) continue;
    ++named;
    CHECK(said->attributes.name == "horizon");
    CHECK(said->attributes.material.empty());
    CHECK(to_text(said->attributes.properties.at("age")) == "3");
  }
  CHECK(named == 1);
}

TEST_CASE("a fold that hangs over, a bowl, a steep fault", "[below]") {
  const Evaluation e = evaluated(R"(cnrg: 1
nodes:
  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  lower: {polygon: [[-1, -1, 1], [5, -1, 1], [5, 3, 1], [-1, 3, 1]]}
  limb:  {polygon: [[-1, 3, 1], [5, 3, 1], [5, 1, 2], [-1, 1, 2]]}
  upper: {polygon: [[-1, 1, 2], [5, 1, 2], [5, 5, 3], [-1, 5, 3]]}
  fold:  {union: [lower, limb, upper]}
  core:  {below: fold, within: block}
  cup:   {difference: [{boundary: {box: {min: [1, 1, 2], max: [3, 3, 6]}}}, {halfspace: {point: [0, 0, 5], normal: [0, 0, -1]}}]}
  bowl:  {closure: {interior: {below: cup, within: block}}}
  steep: {polygon: [[1, -1, -1], [3, -1, 5], [3, 5, 5], [1, 5, -1]]}
  foot:  {below: steep, within: block}
  level: {plane: {point: [0, 0, 1], normal: [0, 1, 3]}}
  half:  {halfspace: {point: [0, 0, 3], normal: [0, 0, 1]}}
  slab:  {above: level, within: half}
  cut:   {intersection: [slab, block]}
result: core
)",
                                 {"foot", "cut"});
  CHECK(volume_of(e, e.kept[0].group()) == Rational(57, 2));
  CHECK(volume_of(e, e.kept[1].group()) == 32);
  // Above the plane y + 3 z = 3, up to z = 3: 48 less what is below, of area 1 * 3 / 2 in the y z plane.
  CHECK(volume_of(e, e.kept[2].group()) == 48 - 4 * Rational(3, 2));
}

TEST_CASE("nothing of a block under a surface is above it, whatever cuts the surface", "[below]") {
  // The other leaves cut the surface where a line upward from the block meets it.
  const Evaluation e = evaluated(
      "cnrg: 1\nnodes:\n  surface: {polygon: [[-9, -9, 4], [9, -9, 4], [9, 9, 4], [-9, 9, 4]]}\n"
      "  block: {box: {min: [1, 0, 0], max: [3, 1, 2]}}\n"
      "  left:  {box: {min: [1, -1, 3], max: [2, 2, 5]}}\n  right: {box: {min: [2, -1, 3], max: [3, 2, 5]}}\n"
      "  over:  {above: surface, within: block}\n  under: {below: surface, within: block}\n"
      "  all:   {sum: [left, right, over, under]}\nresult: all\n",
      {"over", "under"});
  CHECK(e.result("over").component_count() == 0);
  CHECK(e.result("under").volume(1) == Rational(4));
}

TEST_CASE("layers: each cell is in the layer of the first surface above it", "[below]") {
  std::set<std::string> met;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const std::vector<std::string> names{"a", "b", "c", "d"};
    std::vector<Graph> graphs;
    std::string nodes;
    for (int k = 0; k < 3; ++k) {
      // Some lie above the block or below it, and many cross.
      graphs.push_back(random_graph(random, 4, 2, static_cast<int>(random.below(9)) - 3, 7));
      nodes += "  s" + std::to_string(k) + ": {mesh: " + graphs.back().mesh() + "}\n";
    }
    const Evaluation e = evaluated("cnrg: 1\nmaterials: {m: {}, n: {}}\nnodes:\n" + nodes +
                                       "  block: {box: {min: [0, 0, 0], max: [4, 4, 6]}}\n"
                                       "  all: {layers: {within: block, surfaces: [s0, s1, s2], names: [a, b, c, "
                                       "d], materials: [m, n, m, n]}}\nresult: all\n",
                                   {});
    const Group& all = e.kept[0].group();
    CHECK(check_group(*e.complex, all) == "");
    CHECK(volume_of(e, all) == 96);
    const Locator locator(*e.complex);
    for (const auto& [cell, region] : all.cells) {
      const RationalPoint p = interior_point(*e.complex, locator, cell);
      std::size_t layer = 0;
      while (layer < 3 && p[2] > graphs[layer].at(p[0], p[1])) ++layer;
      CHECK(all.regions[region - 1].name == names[layer]);
      CHECK(all.regions[region - 1].material.name() == (layer % 2 == 0 ? "m" : "n"));
      met.insert(names[layer]);
    }
  }
  CHECK(met.size() == 4);
}

TEST_CASE("layers: a solid that is all below the first surface has one layer", "[below]") {
  const Evaluation e = evaluated(
      "cnrg: 1\nnodes:\n  block: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
      "  high: {plane: {point: [0, 0, 5], normal: [0, 0, 1]}}\n  low: {plane: {point: [0, 0, 1/2], normal: [0, 0, "
      "1]}}\n"
      "  r: {layers: {within: block, surfaces: [high, low], names: [x, y, z]}}\nresult: r\n",
      {});
  REQUIRE(e.kept[0].group().regions.size() == 1);
  CHECK(e.kept[0].group().regions[0].name == "x");
  const std::string block = "  block: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  s: {points: [[0, 0, 0]]}\n";
  CHECK(fault_of(block + "  r: {layers: {within: block, surfaces: [s], names: [x]}}\n")
            .find("t.yaml:5:53: error: `names` of layers must be a list of 2, one more than surfaces") == 0);
  CHECK(fault_of(block + "  r: {layers: {within: block, surfaces: []}}\n").find("a list of one node or more") !=
        std::string::npos);
  CHECK(fault_of(block + "  r: {layers: {within: block, surfaces: [s], materials: [x, y]}}\n")
            .find("the material `x` is not declared") != std::string::npos);
  CHECK(fault_of(block + "  r: {layers: {within: block, surfaces: [s]}, blend: linear}\n")
            .find("`blend` is for union; remove it from `layers`") != std::string::npos);
}

TEST_CASE("faults of surfaces are told with their places", "[below]") {
  const std::string block = "  b: {box: {min: [0, 0, 0], max: [4, 4, 4]}}\n";
  const auto fault = [&](const std::string& surface) {
    return fault_of(block + "  s: " + surface + "\n  r: {below: s, within: b}\n");
  };
  const std::string left = "polygon: [[-1, -1, 2], [3, -1, 2], [3, 5, 2], [-1, 5, 2]]";
  CHECK(fault("{" + left + "}") ==
        "t.yaml:5:7: error: `s` does not part `b`: it ends inside, at (3, 2, 2); let it reach beyond the block on "
        "all "
        "sides, or take away what ends there");
  CHECK(fault("{union: [{polygon: [[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]]}, {polygon: [[2, -1, 2], [2, "
              "5, 2], [2, "
              "5, 6], [2, -1, 6]]}]}")
            .find("it branches inside, at (2, 2, 2)") != std::string::npos);
  CHECK(fault("{polygon: [[2, -1, -1], [2, 5, -1], [2, 5, 5], [2, -1, 5]]}").find("is vertical inside of `b`") !=
        std::string::npos);
  CHECK(fault("{polygon: [[9, 0, 0], [10, 0, 0], [10, 1, 0]]}").find("neither over nor under a part of `b`") !=
        std::string::npos);
  CHECK(fault("{box: {min: [0, 0, 0], max: [1, 1, 1]}}").find("has regions, and a surface has none") !=
        std::string::npos);
  CHECK(fault("{points: [[0, 0, 0]]}").find("has no faces") != std::string::npos);
  CHECK(fault_of("  b: {polygon: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}\n  r: {above: b, within: b}\n")
            .find("`b` has no region") != std::string::npos);
}

}  // namespace
}  // namespace cnrg
