// Trees of curved leaves: a finer tessellation moves vertices and changes no count; cells are those of patches.
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Cells = std::array<std::size_t, 4>;

/// Counts and volume of every node of a tree, everything validated.
std::map<std::string, std::pair<Cells, double>> rows_of(const std::string& text,
                                                        AskedProof proof = AskedProof::within_budget) {
  const Tree tree = parse_tree(text, "papers/pereira2012/t.yaml");
  EvaluateOptions options;
  options.validate = true;
  options.proof = proof;
  for (NodeId id : IdRange<NodeId>(tree.nodes.size())) options.nodes.push_back(id);
  std::map<std::string, std::pair<Cells, double>> result;
  for (const NodeRow& row : evaluate(tree, options).rows) result[row.name] = {row.cells, to_double(*row.volume())};
  return result;
}

std::string with_chord(std::string text, const std::string& chord) {
  const std::string mark = "chord: 1/50";
  for (std::size_t at; (at = text.find(mark)) != std::string::npos;)
    text.replace(at, mark.size(), "chord: " + chord);
  return text;
}

std::string read_file(const std::string& path) {
  std::ifstream in(path);
  REQUIRE(in);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Counts at e, e / 4 and e / 16 are equal; volumes come nearer to each other.
void check_refinement(const std::string& text, const std::array<const char*, 3>& chords,
                      const std::map<std::string, Cells>& expected) {
  std::map<std::string, double> last, moved;
  for (const char* chord : chords) {
    INFO("chord " << chord);
    const auto rows = rows_of(with_chord(text, chord));
    for (const auto& [name, cells] : expected) {
      INFO(name);
      REQUIRE(rows.count(name) == 1);
      CHECK(rows.at(name).first == cells);
    }
    // Validated nodes are drawn together, with the further lines of all.
    for (const auto& [name, row] : rows_of(with_chord(text, chord), AskedProof::none)) {
      INFO(name);
      const double change = last.count(name) ? std::abs(row.second - last[name]) : HUGE_VAL;
      if (moved.count(name)) CHECK(change <= 0.6 * moved[name]);
      moved[name] = change;
      last[name] = row.second;
    }
  }
}

TEST_CASE("Fig. 7 of Pereira et al. has the same cells at any fineness", "[evaluate][curved]") {
  // The bottle: two discs of four sectors and a wall of four patches, 10 - 20 + 12 = 2. The difference has one
  // pit: 19 - 31 + 14 = 2.
  check_refinement(read_file("papers/pereira2012/fig07.yaml"), {"1/10", "1/40", "1/160"},
                   {{"cube", {8, 12, 6, 1}},
                    {"bottle", {10, 20, 12, 1}},
                    {"both", {24, 43, 22, 2}},
                    {"intersection", {11, 19, 10, 1}},
                    {"difference", {19, 31, 14, 1}}});
}

TEST_CASE("borders of open curved sheets are whole, however sharply coarse facets turn there",
          "[evaluate][curved]") {
  for (int segments = 3; segments < 10; ++segments) {
    const std::string fine = ", segments: " + std::to_string(segments);
    const auto rows =
        rows_of("cnrg: 1\nnodes:\n  cone: {revolve: {curve: [[1, 0], [2, 1]]" + fine +
                "}}\n  wells: {bezier: {patch: [[[0, 0, 2], [0, 1, -1], [0, 2, 3], [0, 3, -1], [0, 4, 2]], "
                "[[4, 0, 2], [4, 1, -1], [4, 2, 3], [4, 3, -1], [4, 4, 2]]]" +
                fine +
                "}}\n  dune: {extrude: {curve: [[0, 0, 9], {bezier: [[0, 1, 14], [0, 2, 14]]}, [0, 3, 9]], "
                "vector: [4, 0, 0]" +
                fine + "}}\n  all: {union: [cone, wells, dune]}\nresult: all\n");
    INFO(segments);
    CHECK(rows.at("cone").first == Cells{0, 2, 1, 0});
    CHECK(rows.at("wells").first == Cells{4, 4, 1, 0});
    CHECK(rows.at("dune").first == Cells{4, 4, 1, 0});
  }
}

TEST_CASE("Booleans of a bottle and a twisted cube with boxes are stable", "[evaluate][curved]") {
  const std::string text = R"(cnrg: 1
nodes:
  bottle:
    revolve:
      profile: [[0, 0], [1.2, 0], {bezier: [[1.5, 2], [1, 3.6]]}, [0.4, 3.5], [0.4, 4.5], [0, 4.5]]
      chord: 1/50
  cube:
    extrude:
      profile: [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
      vector: [0, 0, 3]
      center: [0, 0, 0]
      twist: 90
      chord: 1/50
  block: {box: {min: [0.1, 0.2, 1.1], max: [3, 3, 3.9]}}
  d: {difference: [bottle, block]}
  u: {union: [bottle, block], dominance: left}
  i: {intersection: [cube, block]}
  c: {difference: [cube, block]}
  all: {union: [d, u, i, c], dominance: left}
result: all
)";
  // The bottle has a bottom, a wall, a neck, a top and the three circles between. The block opens wall and neck by
  // four of its planes. Of the cube it cuts a piece with three of them, under its top and three of its walls:
  // 10 - 15 + 7 = 2, and what is left has 16 - 24 + 10 = 2.
  check_refinement(text, {"1/10", "1/40", "1/160"},
                   {{"bottle", {0, 3, 4, 1}},
                    {"cube", {8, 12, 6, 1}},
                    {"d", {8, 14, 8, 1}},
                    {"i", {10, 15, 7, 1}},
                    {"c", {16, 24, 10, 1}}});
}

TEST_CASE("two bottles that cross", "[evaluate][curved]") {
  const std::string bottle =
      R"(revolve: {profile: [[0, 0], [1, 0], {bezier: [[1.3, 1], [0, 2]]}, [0.3, 2.5], [0, 2.5]], chord: 1/50})";
  const std::string text = "cnrg: 1\nnodes:\n  a: {" + bottle + "}\n  b: {" + bottle +
                           ", rotate: {axis: [1, 1, 0], degrees: 70}, translate: [-0.7, 0.9, 0.4]}\n" +
                           R"(  u: {union: [a, b], dominance: equal}
  i: {intersection: [a, b], dominance: equal}
  d: {difference: [a, b]}
  all: {union: [u, i, d], dominance: equal}
result: all
)";
  const auto rows = rows_of(text);
  CHECK(rows.at("u").second + rows.at("i").second == Approx(rows.at("a").second + rows.at("b").second));
  CHECK(rows.at("d").second + rows.at("i").second == Approx(rows.at("a").second));
  CHECK(rows.at("i").second > 0.1);
  CHECK(rows.at("all").second == Approx(rows.at("u").second));
}

TEST_CASE("leaves that share a patch meet without a gap", "[evaluate][curved]") {
  // Below and above one bent sheet, each closed by its own walls (cells finds them); the sheet is given in both.
  const std::string sheet =
      "[[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 1, 1], [1, 1, -3], [2, 1, 0]], [[0, 2, 0], [1, 2, 1], [2, 2, 0]]]";
  const std::string turned =
      "[[[2, 0, 0], [1, 0, 1], [0, 0, 0]], [[2, 1, 0], [1, 1, -3], [0, 1, 1]], [[2, 2, 0], [1, 2, 1], [0, 2, 0]]]";
  const auto solid = [](const std::string& patch, const std::string& z) {
    const auto wall = [&](const std::string& side, const std::string& foot) {
      return "[" + side + ", " + foot + "], ";
    };
    const std::string a = "[0, 0, " + z + "]", b = "[2, 0, " + z + "]", c = "[2, 2, " + z + "]",
                      d = "[0, 2, " + z + "]";
    const auto mid = [&](const std::string& x, const std::string& y) {
      return "[" + x + ", " + y + ", " + z + "]";
    };
    return "bezier: {fill: cells, chord: 1/50, patches: [" + patch + ", " +
           wall("[[0, 0, 0], [1, 0, 1], [2, 0, 0]]", "[" + a + ", " + mid("1", "0") + ", " + b + "]") +
           wall("[[2, 0, 0], [2, 1, 0], [2, 2, 0]]", "[" + b + ", " + mid("2", "1") + ", " + c + "]") +
           wall("[[2, 2, 0], [1, 2, 1], [0, 2, 0]]", "[" + c + ", " + mid("1", "2") + ", " + d + "]") +
           wall("[[0, 2, 0], [0, 1, 1], [0, 0, 0]]", "[" + d + ", " + mid("0", "1") + ", " + a + "]") + "[[" + a +
           ", " + b + "], [" + d + ", " + c + "]]]}";
  };
  const auto rows =
      rows_of("cnrg: 1\nnodes:\n  low: {" + solid(sheet, "-5") + "}\n  high: {" + solid(turned, "5") +
              "}\n  both: {union: [low, high], dominance: equal}\n  shared: {intersection: [low, high], "
              "dominance: equal}\n" +
              "  all: {union: [both, shared], dominance: equal}\nresult: all\n");
  CHECK(rows.at("low").first == Cells{8, 12, 6, 1});
  CHECK(rows.at("both").second == Approx(40).epsilon(1e-14));
  CHECK(rows.at("shared").second == 0);
}

}  // namespace
}  // namespace cnrg
