// Sharing: which nodes become how many instances, and under which matrices.
#include "csg/tree/unfold.h"

#include <catch2/catch.hpp>
#include <string>

namespace cnrg {
namespace {

Unfolding unfold_text(const std::string& nodes) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: r\n", "t.yaml");
  return unfold(tree, {tree.result});
}

std::size_t instances_of(const Unfolding& u, std::size_t node) { return u.count[NodeId(node)]; }

TEST_CASE("a node used twice under one transform is one instance", "[tree][unfold]") {
  const Unfolding u = unfold_text("  a: {points: [[0, 0, 0]]}\n  b: {complement: a}\n  r: {union: [a, b, a]}\n");
  CHECK(u.instances.size() == 3);
  const Instance& r = u.instances[u.roots[0]];
  REQUIRE(r.operands.size() == 3);
  CHECK(r.operands[0] == r.operands[2]);
}

TEST_CASE("a node shared under two transforms is two instances", "[tree][unfold]") {
  const Unfolding u = unfold_text(R"(  a: {points: [[1, 0, 0]], translate: [1, 0, 0]}
  b: {complement: a, translate: [10, 0, 0]}
  c: {complement: a, scale: 2}
  r: {union: [a, b, c]}
)");
  CHECK(instances_of(u, 0) == 3);
  std::vector<RationalPoint> images;
  for (const Instance& i : u.instances) {
    if (i.node == NodeId(0)) images.push_back(i.transform->apply({1, 0, 0}));
  }
  CHECK(images == std::vector<RationalPoint>{{2, 0, 0}, {12, 0, 0}, {4, 0, 0}});
}

TEST_CASE("equal accumulated matrices are one instance, exactly", "[tree][unfold]") {
  const Unfolding u = unfold_text(R"(  a: {points: [[1, 0, 0]]}
  b: {complement: a, scale: 3, translate: [3, 0, 0]}
  c: {complement: a, translate: [1, 0, 0], scale: 3}
  d: {complement: a, rotate: {axis: [0, 0, 1], degrees: 180}}
  e: {complement: a, scale: [-1, -1, 1]}
  f: {complement: a, translate: [0.1, 0, 0]}
  g: {complement: a, translate: [1/10, 0, 0]}
  r: {union: [b, c, d, e, f, g]}
)");
  CHECK(instances_of(u, 0) == 3);
}

TEST_CASE("operands come before their users and every root is found", "[tree][unfold]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  r: {difference: [u, b]}
  u: {union: [a, b]}
  a: {points: [[0, 0, 0]]}
  b: {points: [[1, 0, 0]], translate: [1, 0, 0]}
result: r
)",
                               "t.yaml");
  const Unfolding u = unfold(tree, {tree.result, tree.find("b"), tree.find("u")});
  CHECK(u.instances.size() == 4);
  REQUIRE(u.roots.size() == 3);
  CHECK(u.instances[u.roots[1]].node == tree.find("b"));
  for (const InstanceId id : IdRange<InstanceId>(u.instances.size())) {
    for (const InstanceId operand : u.instances[id].operands) CHECK(operand < id);
  }
}

TEST_CASE("a chain of 10,000 names and a diamond ladder are no trouble", "[tree][unfold]") {
  std::string chain = "  n0: {points: [[0, 0, 0]]}\n";
  for (int i = 1; i < 10000; ++i) {
    chain += "  n" + std::to_string(i) + ": {complement: n" + std::to_string(i - 1) + ", translate: [1, 0, 0]}\n";
  }
  const Unfolding u = unfold_text(chain + "  r: {complement: n9999}\n");
  CHECK(u.instances.size() == 10001);
  CHECK(u.instances[InstanceId(0)].transform->apply({0, 0, 0}) == RationalPoint{9999, 0, 0});

  std::string ladder = "  n0: {points: [[0, 0, 0]]}\n";
  for (int i = 1; i < 200; ++i) {
    const std::string last = "n" + std::to_string(i - 1);
    ladder += "  n" + std::to_string(i) + ": {union: [" + last + ", " + last + "]}\n";
  }
  CHECK(unfold_text(ladder + "  r: {complement: n199}\n").instances.size() == 201);
}

TEST_CASE("too many instances are an error, not the end of memory", "[tree][unfold]") {
  std::string text = "  n0: {points: [[0, 0, 0]]}\n";
  for (int i = 1; i < 40; ++i) {
    const std::string last = "n" + std::to_string(i - 1);
    text += "  n" + std::to_string(i) + ": {union: [" + last + ", {simplify: " + last + ", translate: [" +
            std::to_string(1L << i) + ", 0, 0]}]}\n";
  }
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + text + "result: n39\n", "t.yaml");
  CHECK_THROWS_WITH(unfold(tree, {tree.result}, 10'000), Catch::Contains("more than 10000 instances"));
}

}  // namespace
}  // namespace cnrg
