// All that is said of a node follows from its own subtree: other leaves, their order, other roots change nothing.
#include <algorithm>
#include <array>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/geometry/transform.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/operators/node_value.h"
#include "csg/result/result_data.h"
#include "csg/result/result_json.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

/// A node in a tree with others.
struct InContext {
  std::string nodes, result;
};

Result result_in(const InContext& context, const std::string& node) {
  const Tree tree = parse_tree("cnrg: 1\nmaterials: {rock: {}, clay: {}, steel: {dominance: 1}}\nnodes:\n" +
                                   context.nodes + "result: " + context.result + "\n",
                               "t.yaml");
  EvaluateOptions options;
  options.refining = Refining::together;
  options.nodes = {tree.find(node)};
  return evaluate(tree, options).result(node);
}

std::string json_in(const InContext& context, const std::string& node) {
  const Result result = result_in(context, node);
  return result_json(result.data().view(true));
}

/// A random tree `n`, and contexts of it.
class RandomSubtree {
 public:
  explicit RandomSubtree(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 5; ++i) add_leaf("l" + std::to_string(i));
    std::vector<std::string> all = leaves_;
    for (int i = 0; i < 4; ++i) {
      const std::string name = "o" + std::to_string(i);
      nodes_ += "  " + name + ": " + operation(all) + "\n";
      all.push_back(name);
    }
    nodes_ += "  n: {" + std::string(number(2) == 0 ? "unify" : "closure") + ": o3}\n";
  }

  /// The same with one more node, which is the result.
  InContext with(const std::string& name, const std::string& node) const {
    return {nodes_ + "  " + name + ": " + node + "\n", name};
  }

 private:
  std::mt19937_64 random_;
  std::vector<std::string> leaves_;
  std::string nodes_;

  int number(int below) { return static_cast<int>(random_() % static_cast<std::uint64_t>(below)); }
  static std::string point(int x, int y, int z) {
    return "[" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + "]";
  }

  std::string leaf() {
    int low[3], high[3];
    for (int k = 0; k < 3; ++k) low[k] = number(4), high[k] = low[k] + 1 + number(3);
    std::string said;
    if (number(2) == 0) said += std::string(", material: ") + (number(2) == 0 ? "rock" : "clay");
    if (number(3) == 0) said += ", attributes: {k: " + std::to_string(number(3)) + "}";
    if (number(4) == 0) said += ", name: " + std::string(number(2) == 0 ? "this" : "that");
    if (number(4) == 0) {
      return "{polygon: [" + point(low[0], low[1], low[2]) + ", " + point(high[0], low[1], low[2]) + ", " +
             point(high[0], high[1], high[2]) + ", " + point(low[0], high[1], high[2]) + "]" + said + "}";
    }
    return "{box: {min: " + point(low[0], low[1], low[2]) + ", max: " + point(high[0], high[1], high[2]) + "}" +
           said + "}";
  }

  void add_leaf(const std::string& name) {
    nodes_ += "  " + name + ": " + leaf() + "\n";
    leaves_.push_back(name);
  }

  std::string operation(const std::vector<std::string>& from) {
    static const char* const kOperators[] = {"union", "union", "intersection", "difference", "union"};
    std::string text = std::string("{") + kOperators[number(5)] + ": [";
    const int count = 2 + number(3);
    for (int i = 0; i < count; ++i) {
      const std::size_t last = from.size() - 1 - static_cast<std::size_t>(number(3));
      text += (i == 0 ? "" : ", ") + from[i == 0 ? last : static_cast<std::size_t>(number(int(from.size())))];
    }
    return text + "]}";
  }
};

}  // namespace

/// Name and volume of each component, in their order.
std::vector<std::string> components_in(const InContext& context) {
  const Result result = result_in(context, context.result);
  std::vector<std::string> out;
  for (Component i = 1; i <= result.component_count(); ++i) {
    const std::optional<Rational> volume = result.volume(i);
    out.push_back(result.attributes(i).name.text() + " " + (volume ? to_string(*volume) : "unbounded"));
  }
  return out;
}

TEST_CASE("what is picked by number, and the order of components, do not depend on how the node is moved",
          "[subtree]") {
  const std::string moves[] = {"rotate: {axis: [0, 0, 1], degrees: 180}", "rotate: {axis: [1, 0, 0], degrees: 90}",
                               "mirror: {normal: [1, 0, 0]}", "rotate: {axis: [1, 2, 3], degrees: 77}",
                               "scale: [-1, 2, 1/2]"};
  const auto [first, last] = scenes::seeds(60);
  std::size_t several = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("seed " << seed);
    RandomSubtree tree(seed);
    const std::string move = moves[seed % 5];
    for (const std::string node : {"{sum: [o3, o2]}", "{interior: o3}", "{aggregate: [{interior: o3}, l0]}",
                                   "{select: {of: o3, region: 1}}", "{select: {of: o3, region: 2}}"}) {
      const InContext alone = tree.with("w", node),
                      moved = tree.with("w", node + "\n  m: {simplify: w, " + move + "}");
      INFO(moved.nodes << move);
      std::vector<std::string> one, other;
      try {
        one = components_in(alone);
      } catch (const TreeError&) {
        CHECK_THROWS_AS(components_in({moved.nodes, "m"}), TreeError);
        continue;
      }
      other = components_in({moved.nodes, "m"});
      several += one.size() > 2;
      if (node.starts_with("{select")) std::sort(one.begin(), one.end()), std::sort(other.begin(), other.end());
      CHECK(one == other);
    }
  }
  CHECK(several > 20);
}

TEST_CASE("above is above where a node is described, however it is moved", "[subtree]") {
  const std::string nodes =
      "  horizon: {polygon: [[-9, -9, 1], [9, -9, 1], [9, 9, 2], [-9, 9, 2]]}\n"
      "  box: {box: {min: [0, 0, 0], max: [1, 1, 4]}}\n  n: {above: horizon, within: box}\n";
  const Rational volume(89, 36);  // under the plane z = 1 + (y + 9)/18 are 55/36 of the box
  CHECK(result_in({nodes, "n"}, "n").volume(1) == volume);
  for (const std::string move : {"rotate: {axis: [1, 0, 0], degrees: 180}", "mirror: {normal: [0, 0, 1]}",
                                 "mirror: {normal: [1, 0, 0]}", "rotate: {axis: [3, 1, 2], degrees: 100}"}) {
    INFO(move);
    CHECK(result_in({nodes + "  m: {simplify: n, " + move + "}\n", "m"}, "m").volume(1) == volume);
    CHECK(result_in({nodes + "  m: {simplify: {above: horizon, within: box, " + move + "}}\n", "m"}, "m")
              .volume(1) == volume);
  }
}

TEST_CASE("melted regions have the material of the leaf that comes first below their node", "[subtree]") {
  const std::string nodes = R"(  a:  {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: rock}
  b:  {box: {min: [2, 0, 0], max: [3, 1, 1]}, material: clay}
  ab: {union: [a, b]}
  c:  {box: {min: [1, 0, 0], max: [2, 1, 1]}}
  n:  {union: [ab, c]}
  x:  {box: {min: [9, 0, 0], max: [10, 1, 1]}}
  bx: {union: [b, x]}
  r:  {sum: [bx, n]}
)";
  for (const std::string result : {"n", "r"}) {
    const Result n = result_in({nodes, result}, "n");
    CHECK(n.attributes(1).material.name() == "rock");
    CHECK(n.attributes(1).name == "a");
  }
  CHECK(json_in({nodes, "n"}, "n") == json_in({nodes, "r"}, "n"));
}

TEST_CASE("cavities of random faces keep their numbers under random motions beside other leaves", "[subtree]") {
  const auto [first, last] = scenes::seeds(25);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    std::mt19937_64 random(seed);
    const auto number = [&](int below) { return static_cast<int>(random() % static_cast<std::uint64_t>(below)); };
    const auto list = [](const RationalPoint& p) {
      return "[" + to_string(p[0]) + ", " + to_string(p[1]) + ", " + to_string(p[2]) + "]";
    };
    // Tetrahedra that cross each other, two of them with one corner.
    std::string points, faces;
    for (int t = 0; t < 3; ++t) {
      std::array<RationalPoint, 4> p;
      do {
        for (RationalPoint& corner : p) corner = {number(7), number(7), number(7)};
        if (t < 2) p[0] = {0, 0, 0};
      } while (volume6(p[0], p[1], p[2], p[3]) == 0);
      for (const RationalPoint& corner : p) points += (points.empty() ? "" : ", ") + list(corner);
      for (const std::array<int, 3>& f : {std::array{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
        faces += faces.empty() ? "[" : ", [";
        for (int k = 0; k < 3; ++k)
          faces += (k == 0 ? "" : ", ") + std::to_string(4 * t + f[static_cast<std::size_t>(k)]);
        faces += "]";
      }
    }
    const RationalPoint axis{number(5) - 2, number(5) - 2, 1},
        factors{number(2) == 0 ? 1 : -2, 1, number(2) == 0 ? 3 : -1};
    const int degrees = number(360);
    const std::string mesh = "  two: {mesh: {points: [" + points + "], faces: [" + faces + "], fill: cells}";
    const std::string motion =
        ", rotate: {axis: " + list(axis) + ", degrees: " + std::to_string(degrees) + "}, scale: " + list(factors);
    const Transform transform = Transform::scaling(factors) * Transform::rotation(axis, degrees, {0, 0, 0});
    INFO("seed " << seed << "\n" << mesh << motion);
    const Result alone = result_in({mesh + "}\n", "two"}, "two");
    const Result moved = result_in(
        {"  other: {box: {min: [-3, -3, -3], max: [2, 3, 3]}}\n" + mesh + motion + "}\n  r: {sum: [other, two]}\n",
         "r"},
        "two");
    REQUIRE(alone.component_count() == moved.component_count());
    const Locator in_alone(alone.complex()), in_moved(moved.complex());
    const auto name_at = [](const Result& result, const Locator& locator, const RationalPoint& p) {
      const Component c = result.component(result.place(locator.locate(p)));
      return c == 0 ? std::string() : result.attributes(c).name.text();
    };
    for (int i = 0; i < 30; ++i) {
      const RationalPoint p{Rational(1 + 2 * number(20), 7), Rational(1 + 2 * number(20), 7),
                            Rational(1 + 2 * number(20), 7)};
      CHECK(name_at(alone, in_alone, p) == name_at(moved, in_moved, transform.apply(p)));
    }
  }
}

TEST_CASE("names are data: no text in them means anything", "[subtree]") {
  const auto named = [](const std::string& name) {
    return result_in({"  \"" + name +
                          "\": {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n  other: {box: {min: [1, 0, 0], "
                          "max: [3, 2, 2]}}\n  x: {unify: \"" +
                          name + "\"}\n  y: {unify: other}\n  n: {sum: [x, y]}\n",
                      "n"},
                     "n");
  };
  for (const std::string name : {"entities", "rock", "closure", "sand & clay", "a.2", "a & a"}) {
    const Result n = named(name);
    REQUIRE(n.component_count() == 3);
    CHECK(n.attributes(1).name == name);
    CHECK(n.attributes(2).name == name + " & other");
    CHECK(n.attributes(2).name.parts().size() == 2);
    CHECK(n.attributes(3).name == "other");
  }
  // The component of what is no region of a group yields to any name, whatever others are called.
  const Result mixed = result_in(
      {"  b: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n  u: {unify: b}\n  n: {product: [b, u]}\n", "n"}, "n");
  REQUIRE(mixed.component_count() == 2);
  CHECK(mixed.attributes(2).name == "b");
}

TEST_CASE("an exact file keeps the parts of names; one without them is read", "[subtree]") {
  const Result n = result_in({"  b: {box: {min: [0, 0, 0], max: [2, 2, 2]}, name: sand & clay}\n  c: {box: {min: "
                              "[1, 0, 0], max: [3, 2, 2]}}\n"
                              "  two: {mesh: {points: [[9, 0, 0], [9, 1, 0], [9, 0, 1], [8, 0, 0], [5, 0, 0], [5, "
                              "1, 0], [5, 0, 1], [4, 0, 0]], "
                              "faces: [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3], [4, 5, 6], [4, 5, 7], [5, 6, "
                              "7], [6, 4, 7]], fill: cells}}\n"
                              "  u: {unify: c}\n  n: {closure: {interior: {sum: [b, u, two]}}}\n",
                              "n"},
                             "n");
  const std::string text = result_json(n.data().view());
  const std::vector<Attributes> read = prepare_result(text, "n.json")->regions();
  REQUIRE(read.size() == n.component_count());
  std::set<NameOrigin> origins;
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i].name == n.attributes(static_cast<Component>(i + 1)).name);
    for (const NamePart& part : read[i].name.parts()) origins.insert(part.origin);
  }
  CHECK(origins == std::set{NameOrigin::operation, NameOrigin::node, NameOrigin::given});
  const std::string old = std::regex_replace(text, std::regex(R"("called":\[([^\]]*)\],)"), "");
  CHECK(old.find("called") == std::string::npos);
  for (const Attributes& of : prepare_result(old, "n.json")->regions()) {
    REQUIRE(of.name.parts().size() == 1);
    CHECK(of.name.parts()[0].origin == NameOrigin::file);
  }
}

TEST_CASE("what is written inline is called after its user, where that is a part or another form of it",
          "[subtree]") {
  const auto name_of = [](const std::string& node) {
    return result_in({"  n: " + node + "\n", "n"}, "n").attributes(1).name.text();
  };
  const std::string box = "{box: {min: [0, 0, 0], max: [2, 2, 2]}}",
                    rod = "{box: {min: [1, 1, -1], max: [3, 3, 3]}}";
  CHECK(name_of("{unify: " + box + "}") == "n");
  CHECK(name_of("{interior: {closure: " + box + "}}") == "n");
  CHECK(name_of("{difference: [" + box + ", " + rod + "]}") == "n");
  CHECK(name_of("{intersection: [" + box + ", " + rod + "]}") == "n/1");
  CHECK(name_of("{unify: {union: [" + box + ", " + rod + "]}}") == "n/1/1");
  CHECK(name_of("{union: [{difference: [" + box + ", " + rod + "]}, {box: {min: [5, 0, 0], max: [6, 1, 1]}}]}") ==
        "n/1");
}
