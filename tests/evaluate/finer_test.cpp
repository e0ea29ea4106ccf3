// Trees made finer: counts stay, volumes go to those of the exact shapes.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

/// One of each curved leaf; curves of none are straight.
const char* const kLeafOfEachKind = R"(cnrg: 1
nodes:
  cylinder: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 8}}
  cone: {cone: {from: [9, 0, 0], to: [9, 0, 3], radius: 1, segments: 6}}
  sphere: {sphere: {center: [18, 0, 0], radius: 1, segments: 8}}
  odd: {sphere: {center: [18, 9, 0], radius: 1, segments: 7, rings: 5}}
  torus: {torus: {center: [27, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1}}
  turned: {revolve: {profile: [[0, 0], [2, 0], [2, 1], [0, 1]], center: [36, 0, 0], degrees: 90}}
  by_chord: {revolve: {profile: [[0, 0], [1, 0], [1, 1], [0, 1]], center: [45, 0, 0], chord: 1/10}}
  all: {union: [cylinder, cone, sphere, odd, torus, turned, by_chord]}
result: all
)";

/// What the exact shapes have.
const std::map<std::string, double> kExact{{"cylinder", 2 * kHalfTurn},
                                           {"cone", kHalfTurn},
                                           {"sphere", 4 * kHalfTurn / 3},
                                           {"odd", 4 * kHalfTurn / 3},
                                           {"torus", 6 * kHalfTurn* kHalfTurn},
                                           {"turned", kHalfTurn},
                                           {"by_chord", kHalfTurn}};

std::vector<NodeRow> finer_rows(Tree tree, int times) {
  make_finer(tree, times);
  EvaluateOptions options;
  options.validate = true;
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) options.nodes.push_back(id);
  return evaluate(tree, options).rows;
}

/// A leaf of the tree after it was made finer.
template <class S>
S shape_of(const std::string& leaf, int times) {
  Tree tree = parse_tree("cnrg: 1\nnodes:\n  a: {" + leaf + "}\nresult: a\n", "t.yaml");
  make_finer(tree, times);
  return std::get<S>(*tree.nodes[tree.result].shape);
}

TEST_CASE("segments and rings are multiplied, a chord is divided by the square", "[evaluate][finer]") {
  const auto given = shape_of<SphereShape>("sphere: {center: [0, 0, 0], radius: 1, segments: 7, rings: 5}", 3);
  CHECK(given.segments == 21);
  CHECK(given.rings == 15);
  const auto odd = shape_of<SphereShape>("sphere: {center: [0, 0, 0], radius: 1, segments: 7}", 2);
  CHECK(odd.rings ==
        6);  // 7 segments have 3 rings, so that points of the coarse sphere are points of the fine one
  const auto torus = shape_of<TorusShape>("torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 2, tube: 1}", 2);
  CHECK(torus.segments == 64);
  CHECK(torus.rings == 32);
  const auto usual = shape_of<BezierShape>("bezier: {curve: [[0, 0, 0], [1, 1, 0], [2, 0, 0]]}", 5);
  CHECK(usual.tessellation.segments == 80);
  CHECK(!usual.tessellation.chord);
  const auto chord = shape_of<BezierShape>("bezier: {curve: [[0, 0, 0], [1, 1, 0], [2, 0, 0]], chord: 1/10}", 3);
  CHECK(!chord.tessellation.segments);
  CHECK(*chord.tessellation.chord == Rational(1, 90));
  CHECK(shape_of<CylinderShape>("cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1}", 1).segments == 32);
}

TEST_CASE("curved leaves made finer keep their counts and approach the exact volume", "[evaluate][finer]") {
  const std::vector<NodeRow> coarse = finer_rows(parse_tree(kLeafOfEachKind, "t.yaml"), 1);
  std::map<std::string, Rational> last;
  for (const NodeRow& row : coarse) last[row.name] = *row.volume();
  for (const int times : {2, 4, 8}) {
    const std::vector<NodeRow> fine = finer_rows(parse_tree(kLeafOfEachKind, "t.yaml"), times);
    REQUIRE(fine.size() == coarse.size());
    for (std::size_t i = 0; i < fine.size(); ++i) {
      INFO(fine[i].name << " made " << times << " times finer");
      CHECK(fine[i].cells == coarse[i].cells);
      CHECK(last[fine[i].name] < *fine[i].volume());
      const auto exact = kExact.find(fine[i].name);
      if (exact != kExact.end()) {
        const double before = exact->second - to_double(last[fine[i].name]);
        const double now = exact->second - to_double(*fine[i].volume());
        CHECK(now > 0);
        CHECK(now <= 0.3 * before);  // 1/4 in the limit
      }
      last[fine[i].name] = *fine[i].volume();
    }
  }
}

TEST_CASE("trees of the papers keep their counts when they are made finer", "[evaluate][finer]") {
  std::size_t curved = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("papers")) {
    if (entry.path().extension() != ".yaml" || entry.path().stem() == "exercise") continue;  // one has holes
    Tree tree = read_tree(entry.path().string());
    const auto has = [&](const std::set<std::string>& names) {
      return std::any_of(tree.nodes.begin(), tree.nodes.end(),
                         [&](const Node& node) { return names.contains(node.operator_name); });
    };
    if (has({"cnrg"})) continue;  // a result that papers/run writes first
    const bool is_curved = has({"cylinder", "bspline", "sphere"});
    if (!is_curved) continue;
    ++curved;
    const std::vector<NodeRow> coarse = finer_rows(std::move(tree), 1);
    for (const int times : {2, 3}) {
      const std::vector<NodeRow> fine = finer_rows(read_tree(entry.path().string()), times);
      REQUIRE(fine.size() == coarse.size());
      for (std::size_t i = 0; i < fine.size(); ++i) {
        INFO(entry.path() << ": " << fine[i].name << " made " << times << " times finer");
        CHECK(fine[i].cells == coarse[i].cells);
      }
    }
  }
  CHECK(curved >= 4);
}

TEST_CASE("a leaf that cannot be made so fine is named with its place", "[evaluate][finer]") {
  Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 300000}}
  u: {union: [a, b]}
result: u
)",
                         "t.yaml");
  CHECK_THROWS_WITH(make_finer(tree, 2),
                    "t.yaml:4:7: error: made 2 times finer, `cylinder` would have 600000 segments, more than "
                    "500000; make it less fine, or give it fewer segments");
  CHECK_THROWS_WITH(make_finer(tree, 0), "finer: give 1 or more, not 0");
}

}  // namespace
}  // namespace cnrg
