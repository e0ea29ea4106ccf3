// Sharing: which nodes become how many instances, and under which matrices.
#include "csg/tree/unfold.h"

#include <cstdint>
#include <string>

#include "kernel/exact/rational.h"
#include "tests/catch.h"

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
            std::to_string(std::int64_t{1} << i) + ", 0, 0]}]}\n";
  }
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + text + "result: n39\n", "t.yaml");
  CHECK_THROWS_WITH(unfold(tree, {tree.result}, 10'000), Catch::Contains("more than 10000 instances"));
  // 2^39 points: known before the first is placed.
  CHECK_THROWS_WITH(unfold(tree, {tree.result}), Catch::Contains("more than 1000000 instances, to ") &&
                                                     Catch::Contains(" places, and every node"));
}

TEST_CASE("as many instances as are allowed, and one more", "[tree][unfold][limits]") {
  // 2^k places of n(12 - k), and 2^k of the moved node below each but the last: 2^13 - 1 + 2^12 - 1.
  std::string text = "  n0: {points: [[0, 0, 0]]}\n";
  for (int i = 1; i <= 12; ++i) {
    const std::string last = "n" + std::to_string(i - 1);
    text += "  n" + std::to_string(i) + ": {union: [" + last + ", {simplify: " + last + ", translate: [" +
            std::to_string(std::int64_t{1} << i) + ", 0, 0]}]}\n";
  }
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + text + "result: n12\n", "t.yaml");
  constexpr std::size_t kAll = 8191 + 4095;
  CHECK(unfold(tree, {tree.result}, kAll).instances.size() == kAll);
  CHECK_THROWS_WITH(unfold(tree, {tree.result}, kAll - 1), Catch::Contains("more than 12285 instances"));
}

TEST_CASE("many ways to few places are few instances", "[tree][unfold]") {
  // Each step is the one before and the same moved by 1: 2^60 ways from the top to n0, which stands at 61 places.
  std::string text = "  n0: {points: [[0, 0, 0]]}\n";
  for (int i = 1; i <= 60; ++i) {
    const std::string last = "n" + std::to_string(i - 1);
    text +=
        "  n" + std::to_string(i) + ": {union: [" + last + ", {simplify: " + last + ", translate: [1, 0, 0]}]}\n";
  }
  const Unfolding u = unfold_text(text + "  r: {complement: n60}\n");
  CHECK(instances_of(u, 0) == 61);
  CHECK(u.instances.size() == 1 + 61 * 62 / 2 + 60 * 61 / 2);
}

TEST_CASE("a product of transforms may have long numbers, up to a limit", "[tree][unfold][limits]") {
  const auto scaled = [](unsigned long inner_bits) {
    const std::string outer = Integer(Integer(1) << 50'000).get_str();
    const std::string inner = Integer(Integer(1) << inner_bits).get_str();
    return unfold_text("  a: {points: [[1, 1, 1]]}\n  b: {simplify: a, scale: \"" + inner +
                       "\"}\n  r: {simplify: b, scale: \"" + outer + "\"}\n");
  };
  CHECK(scaled(49'999).instances.size() == 3);  // 2^99,999 has 100,000 bits
  CHECK(unfold_text("  r: {points: [[1, 1, 1]], scale: \"" + Integer(Integer(1) << 150'000).get_str() + "\"}\n")
            .instances.size() == 1);
  CHECK_THROWS_WITH(scaled(50'000),
                    Catch::Contains("t.yaml:4:3: error: the transforms from the result down to `b` "
                                    "have a product with numbers of 100001 bits, and 100000"));
  // What cancels does not count: a thousand scalings by 3 and by 1/3.
  std::string chain = "  n0: {points: [[1, 2, 3]]}\n";
  for (int i = 1; i <= 1000; ++i) {
    chain += "  n" + std::to_string(i) + ": {simplify: n" + std::to_string(i - 1) +
             ", scale: " + (i % 2 == 0 ? "3" : "1/3") + ", translate: [1, 0, 0]}\n";
  }
  CHECK(unfold_text(chain + "  r: {complement: n1000}\n").instances.size() == 1002);
}

TEST_CASE("3,000 nested rotations are refused, not computed", "[tree][unfold][limits]") {
  std::string chain = "  n0: {points: [[1, 2, 3]]}\n";
  for (int i = 1; i <= 3000; ++i) {
    chain += "  n" + std::to_string(i) + ": {simplify: n" + std::to_string(i - 1) + ", rotate: {axis: [" +
             std::to_string(i % 3) + ", 1, 2], degrees: " + std::to_string(i % 89 + 1) + "}}\n";
  }
  CHECK_THROWS_WITH(unfold_text(chain + "  r: {complement: n3000}\n"),
                    Catch::Contains("one rotation in place of many"));
}

}  // namespace
}  // namespace cnrg
