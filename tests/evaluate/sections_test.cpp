// Sections and steps: which nodes are refined apart, what that saves, and that nothing else tells of it.
#include "csg/evaluate/sections.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

Tree tree_of(const std::string& nodes, const std::string& materials = "{}") {
  return parse_tree("cnrg: 1\nmaterials: " + materials + "\nnodes:\n" + nodes + "result: r\n", "t.yaml");
}

Evaluation refined(const Tree& tree, Refining refining, std::vector<NodeId> nodes = {}) {
  EvaluateOptions options;
  options.refining = refining;
  options.nodes = std::move(nodes);
  return evaluate(tree, options);
}

std::string bytes_of(const Result& result, const std::string& ending) {
  const std::string path = (std::filesystem::temp_directory_path() / ("evaluate_sections." + ending)).string();
  write(path, result, FileOptions{true});
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  return text.str();
}

/// Refined apart and together the result has the same files; returns both evaluations.
std::pair<Evaluation, Evaluation> same(const Tree& tree) {
  std::pair<Evaluation, Evaluation> both{refined(tree, Refining::apart), refined(tree, Refining::together)};
  for (const char* ending : {"json", "vtu"})
    CHECK(bytes_of(both.first.result(), ending) == bytes_of(both.second.result(), ending));
  REQUIRE(both.first.rows.size() == both.second.rows.size());
  for (std::size_t i = 0; i < both.first.rows.size(); ++i) {
    const NodeRow &a = both.first.rows[i], &b = both.second.rows[i];
    CHECK(a.name == b.name);
    CHECK(a.cells == b.cells);
    CHECK(a.regions == b.regions);
    CHECK(a.total == b.total);
  }
  return both;
}

/// Balls around the corners of a grid that all reach far out of a box, each cut to it.
std::string cut_balls(int count, int segments) {
  std::string nodes = "  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n", all;
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    nodes += "  ball" + n + ": {sphere: {center: [" + std::to_string(i % 3 - 1) + ", " +
             std::to_string(i / 3 % 3) + ", \"" + n + "/7\"], radius: \"" + std::to_string(11 + i) +
             "/8\", segments: " + std::to_string(segments) + "}}\n  cut" + n + ": {intersection: [ball" + n +
             ", box]}\n";
    all += (i == 0 ? "" : ", ") + ("cut" + n);
  }
  return nodes + "  r: {union: [" + all + "]}\n";
}

TEST_CASE("what dies before it meets others is refined apart, and meets nothing", "[sections]") {
  const Tree tree = tree_of(cut_balls(9, 24));
  const Evaluation chosen = refined(tree, Refining::chosen), together = refined(tree, Refining::together);
  CHECK(bytes_of(chosen.result(), "json") == bytes_of(together.result(), "json"));
  CHECK(chosen.complex->face_count() * 4 < together.complex->face_count());
  CHECK(chosen.refine.contacts[0] * 2 < together.refine.contacts[0]);
}

TEST_CASE("where little dies all is refined together", "[sections]") {
  std::string nodes = "  plate: {box: {min: [0, 0, 0], max: [20, 20, 1]}}\n", last = "plate";
  for (int i = 0; i < 8; ++i) {
    const std::string n = std::to_string(i), x = std::to_string(2 * i + 2);
    nodes += "  drill" + n + ": {cylinder: {from: [" + x + ", 5, -1], to: [" + x +
             ", 5, 2], radius: \"1/2\", segments: 64}}\n  d" + n + ": {difference: [" + last + ", drill" + n +
             "]}\n";
    last = "d" + n;
  }
  const Tree tree = tree_of(nodes + "  r: {simplify: " + last + "}\n");
  const Evaluation chosen = refined(tree, Refining::chosen), together = refined(tree, Refining::together);
  CHECK(chosen.complex->face_count() == together.complex->face_count());
  CHECK(chosen.refine.candidates == together.refine.candidates);
  same(tree);
}

TEST_CASE("an intersection of many is formed in steps, of which none meets what died before", "[sections]") {
  std::string all;
  for (int i = 0; i < 12; ++i) {
    all += (i == 0 ? "" : ", ") + std::string("{sphere: {center: [\"") + std::to_string(i) + "/5\", \"" +
           std::to_string(i * i % 7) + "/9\", 0], radius: \"3/2\", segments: 20}}";
  }
  const Tree tree = tree_of("  r: {intersection: [" + all + "]}\n");
  const auto [apart, together] = same(tree);
  CHECK(apart.complex->face_count() * 4 < together.complex->face_count());
}

TEST_CASE("sheets, wires, points and what is said of them are carried", "[sections]") {
  const Tree tree = tree_of(R"(  rock: {box: {min: [0, 0, 0], max: [6, 6, 6]}, material: rock}
  ore: {box: {min: [2, 2, 2], max: [4, 4, 8]}, material: ore, dominance: 2}
  fault: {polygon: [[1, -1, -1], [1, 7, -1], [5, 7, 7], [5, -1, 7]], name: fault, attributes: {aperture: 2}}
  bolt: {polyline: [[3, 3, -2], [3, 3, 3], [3, 5, 5], [9, 5, 5]], material: steel, attributes: {diameter: 25}}
  ends: {points: [[3, 3, 3], [1, 1, 1], [9, 9, 9]], name: gauge}
  ground: {union: [rock, ore]}
  cracked: {union: [fault, bolt, ends], dominance: equal}
  inside: {intersection: [cracked, ground]}
  model: {union: [ground, inside], dominance: right}
  shaft: {cylinder: {from: [2, 3, -1], to: [2, 3, 7], radius: 1, segments: 12}}
  dug: {difference: [model, shaft]}
  lid: {box: {min: [-1, -1, 5], max: [7, 7, 7]}}
  cut: {intersection: [dug, lid]}
  r: {union: [cut, {difference: [dug, lid]}]}
)",
                            "{rock: {}, ore: {dominance: 3}, steel: {}}");
  same(tree);
}

TEST_CASE("faces keep their planes however often they are carried", "[sections]") {
  // Oblique cuts of cuts: were planes made of constructed corners, their numbers would double at each level.
  std::string nodes = "  d0: {sphere: {center: [0, 0, 0], radius: 4, segments: 9}}\n";
  for (int i = 1; i <= 8; ++i) {
    const std::string n = std::to_string(i);
    nodes += "  k" + n + ": {box: {min: [-4, -4, -4], max: [4, 4, 3]}, rotate: {axis: [" +
             std::to_string(i % 3 + 1) + ", " + std::to_string(i % 4 - 2) +
             ", 1], degrees: " + std::to_string(17 * i) + "}}\n  d" + n + ": {intersection: [d" +
             std::to_string(i - 1) + ", k" + n + "]}\n";
  }
  const auto [apart, together] = same(tree_of(nodes + "  r: {simplify: d8}\n"));
  std::size_t most = 0, before = 0;
  const auto longest = [](const Complex& complex) {
    std::size_t bits = 0;
    for (const VertexId v : complex.vertices)
      bits = std::max(bits, mpz_sizeinbase(complex.points.exact(v).w.get_mpz_t(), 2));
    return bits;
  };
  most = longest(*apart.complex), before = longest(*together.complex);
  CHECK(most <= before);
}

TEST_CASE("a node that was asked for is on the complex of the result", "[sections]") {
  const Tree tree = tree_of(cut_balls(4, 12));
  const Evaluation asked = refined(tree, Refining::apart, {tree.find("cut2")});
  const Evaluation together = refined(tree, Refining::together, {tree.find("cut2")});
  CHECK(bytes_of(asked.result("cut2"), "json") == bytes_of(together.result("cut2"), "json"));
  CHECK(bytes_of(asked.result(), "json") == bytes_of(together.result(), "json"));
}

TEST_CASE("an intersection in which materials conflict is formed at once", "[sections]") {
  const Tree tree = tree_of(R"(  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock}
  b: {box: {min: [1, 1, 1], max: [5, 5, 5]}, material: sand}
  c: {box: {min: [2, 0, 2], max: [6, 6, 6]}, material: ore}
  r: {intersection: [a, b, c], dominance: equal}
)",
                            "{rock: {}, sand: {}, ore: {}}");
  const auto [apart, together] = same(tree);
  REQUIRE(apart.diagnostics.size() == together.diagnostics.size());
  for (std::size_t i = 0; i < apart.diagnostics.size(); ++i)
    CHECK(apart.diagnostics[i].message == together.diagnostics[i].message);
}

TEST_CASE("steps of one intersection are kept where another one is formed at once", "[sections]") {
  const auto balls = [](const std::string& name, int x, const std::array<std::string, 3>& materials) {
    std::string nodes, all;
    for (int i = 0; i < 3; ++i) {
      const std::string n = name + std::to_string(i);
      nodes += "  " + n + ": {sphere: {center: [" + std::to_string(x + i) + ", " + std::to_string(i * i) +
               ", 0], radius: 3, segments: 56}, material: " + materials[static_cast<std::size_t>(i)] + "}\n";
      all += (i == 0 ? "" : ", ") + n;
    }
    return nodes + "  " + name + ": {intersection: [" + all + "], dominance: equal}\n";
  };
  const std::string one = balls("one", 0, {"rock", "rock", "rock"}),
                    two = balls("two", 90, {"rock", "sand", "ore"});
  const std::string materials = "{rock: {}, sand: {}, ore: {}}";
  const Evaluation kept = refined(tree_of(one + two + "  r: {union: [one, two]}\n", materials), Refining::chosen);
  const Evaluation turned =
      refined(tree_of(two + one + "  r: {union: [two, one]}\n", materials), Refining::chosen);
  const Evaluation together =
      refined(tree_of(one + two + "  r: {union: [one, two]}\n", materials), Refining::together);
  CHECK(kept.refine.candidates == turned.refine.candidates);
  CHECK(kept.complex->face_count() == turned.complex->face_count());
  CHECK(kept.complex->face_count() < together.complex->face_count());
  CHECK(bytes_of(kept.result(), "json") == bytes_of(together.result(), "json"));
}

TEST_CASE("leaves that have several regions, or none that is bounded, are refined together", "[sections]") {
  const Tree half = tree_of(R"(  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  b: {halfspace: {point: [1, 1, 1], normal: [1, 2, 3]}}
  c: {box: {min: [2, 0, 2], max: [6, 6, 6]}}
  r: {union: [{intersection: [a, b]}, c]}
)");
  const auto [apart, together] = same(half);
  CHECK(apart.complex->face_count() == together.complex->face_count());
}

// Regions melt in any order here, and several of one operand at once.
std::string random_boxes(std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto point = [](const std::array<std::size_t, 3>& p) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
  };
  const char* const materials[] = {"", "", ", material: rock", ", material: sand", ", material: ore"};
  const char* const operators[] = {"union", "union", "difference", "intersection"};
  const std::size_t leaves = 5 + below(10), nodes = 2 + below(5);
  std::string out;
  for (std::size_t i = 0; i < leaves; ++i) {
    std::array<std::size_t, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) low[k] = below(6), high[k] = low[k] + 1 + below(4);
    out += "  n" + std::to_string(i) + ": {box: {min: " + point(low) + ", max: " + point(high) + "}" +
           materials[below(5)] + "}\n";
  }
  for (std::size_t i = leaves; i <= leaves + nodes; ++i) {
    const bool last = i == leaves + nodes;
    std::string operands;
    for (std::size_t k = 0; k < 2 + below(3); ++k)
      operands += (k == 0 ? "n" : ", n") + std::to_string(k == 0 ? i - 1 : below(i));
    out += "  " + (last ? "r" : "n" + std::to_string(i)) + ": {" + operators[last ? 0 : below(4)] + ": [" +
           operands + "]}\n";
  }
  return out;
}

/// What is said of each region, without its number.
std::vector<std::tuple<Rational, std::string, std::string>> words_of(const Result& result) {
  std::vector<std::tuple<Rational, std::string, std::string>> out;
  for (Component c = 1; c <= result.component_count(); ++c) {
    const RegionAttributes& attributes = result.attributes(c);
    out.emplace_back(*result.volume(c), attributes.name, attributes.material.name());
  }
  std::sort(out.begin(), out.end());
  return out;
}

TEST_CASE("which of the regions that melt keeps its name does not depend on the refinement", "[sections]") {
  const auto [first, end] = scenes::seeds(300);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    std::mt19937_64 random(seed);
    const std::string nodes = random_boxes(random);
    INFO("seed " << seed << "\n" << nodes);
    const Tree tree = tree_of(nodes, "{rock: {}, sand: {}, ore: {}}");
    const Evaluation apart = refined(tree, Refining::apart), together = refined(tree, Refining::together);
    REQUIRE(words_of(apart.result()) == words_of(together.result()));
    REQUIRE(apart.diagnostics.size() == together.diagnostics.size());
    for (std::size_t i = 0; i < apart.diagnostics.size(); ++i)
      REQUIRE(apart.diagnostics[i].message == together.diagnostics[i].message);
  }
}

// Round leaves cut sheets, wires and each other, and many are gone before their cuts meet anything.
std::string random_rounds(std::mt19937_64& random) {
  const auto number = [&](int low, int high) {
    return std::to_string(low + static_cast<int>(random() % static_cast<std::size_t>(high - low + 1)));
  };
  const auto point = [&](const char* z = nullptr) {
    return "[" + number(0, 5) + ", " + number(0, 5) + ", " + (z != nullptr ? z : number(0, 5)) + "]";
  };
  const auto leaf = [&]() -> std::string {
    const std::string round = ", segments: " + std::to_string(8 + 4 * (random() % 4)) + "}";
    switch (random() % 6) {
      case 0: return "sphere: {center: " + point() + ", radius: " + number(1, 3) + round;
      case 1:
        return "cylinder: {from: " + point("-1") + ", to: " + point("7") + ", radius: " + number(1, 2) + round;
      case 2: return "cone: {from: " + point("-1") + ", to: " + point("6") + ", radius: " + number(1, 3) + round;
      case 3: {
        const std::string x = number(0, 5), top = number(0, 5);
        return "polygon: [[" + x + ", -1, -1], [" + x + ", 7, -1], [" + top + ", 7, 7], [" + top + ", -1, 7]]";
      }
      case 4: return "polyline: [" + point("-1") + ", " + point("3") + ", " + point("8") + "]";
      default: return "box: {min: " + point("-1") + ", max: [6, 6, " + number(2, 7) + "]}";
    }
  };
  const char* const operators[] = {"union", "difference", "intersection", "intersection"};
  const char* const dominance[] = {"", ", dominance: left", ", dominance: right"};
  std::string out;
  for (std::size_t i = 0; i < 9; ++i) {
    out += "  " + (i == 8 ? "r" : "n" + std::to_string(i)) + ": {";
    if (i < 5) {
      out += leaf() + "}\n";
      continue;
    }
    out += std::string(operators[random() % 4]) + ": [n" + std::to_string(i == 8 ? 7 : random() % i) + ", n" +
           std::to_string(random() % i) + "]" + dominance[random() % 3] + "}\n";
  }
  return out;
}

TEST_CASE("what a node joins depends on its operand's value alone", "[sections]") {
  // A corner where boxes cross is constructed if they are refined together, and given if one comes from a section.
  const Tree tree = tree_of(R"(  a: {box: {min: [0, -1.75, -1], max: [2.5, 0.25, 1.5]}, translate: [0.03, 0, 0]}
  b: {box: {min: [1, -1.25, -1], max: [3.5, 1.25, 1.5]}, translate: [0.05, 0, 0.05]}
  c: {box: {min: [-0.75, -0.25, 1], max: [1.75, 2.25, 3.5]}, translate: [0.05, 0, 0]}
  v: {difference: [{union: [a, b]}, c]}
  r: {simplify: {of: v, within: 0.1}}
)");
  const auto [apart, together] = same(tree);
  CHECK(*apart.rows.back().total == Rational(43389, 2000));
}

TEST_CASE("curves of round leaves that are gone stay whole", "[sections]") {
  const Tree disc = tree_of(R"(  ball: {sphere: {center: [2, 2, 3], radius: 1, segments: 64}}
  wall: {polygon: [[2, "3/2", 0], ["21/10", "3/2", 0], ["21/10", "3/2", 9], [2, "3/2", 9]]}
  bare: {intersection: [wall, ball]}
  big: {box: {min: [-1, -1, -1], max: [8, 8, 8]}}
  r: {union: [bare, big], dominance: left}
)");
  const Evaluation carried = refined(disc, Refining::apart);
  CHECK(carried.rows.back().cells == std::array<std::size_t, 4>{12, 16, 7, 1});
  const auto [first, end] = scenes::seeds(150);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    std::mt19937_64 random(seed);
    const std::string nodes = random_rounds(random);
    INFO("seed " << seed << "\n" << nodes);
    const Tree tree = tree_of(nodes);
    const Evaluation apart = refined(tree, Refining::apart), together = refined(tree, Refining::together);
    REQUIRE(apart.rows.size() == together.rows.size());
    for (std::size_t i = 0; i < apart.rows.size(); ++i) {
      INFO(apart.rows[i].name);
      REQUIRE(apart.rows[i].cells == together.rows[i].cells);
      REQUIRE(apart.rows[i].total == together.rows[i].total);
    }
    REQUIRE(bytes_of(apart.result(), "vtu") == bytes_of(together.result(), "vtu"));
  }
}

}  // namespace
}  // namespace cnrg
