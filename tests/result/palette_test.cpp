// Which color a cell gets, and that it is the same whatever else is in the picture.
#include "csg/result/palette.h"

#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/result/result_data.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

struct Colored {
  Tree tree;
  Evaluation evaluation;
  Result result;
  ResultView view;
  FlatComplex flat;
  CellColors colors;

  explicit Colored(const std::string& text, const std::string& node = {})
      : tree(parse_tree(text, "t.yaml")),
        evaluation(evaluate(tree, options(tree))),
        result(evaluation.result(node.empty() ? tree.result : id(tree, node))),
        view(result.data().view()),
        flat(flatten(view)),
        colors(view, flat) {}

  static NodeId id(const Tree& tree, const std::string& name) {
    for (const NodeId n : IdRange<NodeId>(tree.nodes.size())) {
      if (tree.nodes[n].name == name) return n;
    }
    throw std::runtime_error("no node " + name);
  }
  static EvaluateOptions options(const Tree& tree) {
    EvaluateOptions out;
    out.keep_all = true;
    for (const NodeId n : IdRange<NodeId>(tree.nodes.size())) out.nodes.push_back(n);
    return out;
  }
  /// Meaning and color of all active regions.
  std::vector<std::string> regions(ColorBy by) const {
    std::vector<std::string> out;
    for (FlatComplex::Index r = 0; r < flat.regions.size(); ++r) {
      if (flat.regions[r].component == 0) continue;
      const CellColor c = colors.of(by, 3, r);
      out.push_back(c.text + " " + hex(c.color));
    }
    return out;
  }
};

const std::string kNodes =
    "cnrg: 1\nmaterials: {rock: {color: \"#998877\"}, clay: {}}\nnodes:\n"
    "  a: {box: {min: [0, 0, 0], max: [2, 1, 1]}, material: clay}\n"
    "  b: {box: {min: [1, 0, 0], max: [3, 1, 1]}, material: rock, name: core}\n"
    "  c: {box: {min: [5, 0, 0], max: [6, 1, 1]}}\n"
    "  s: {polygon: [[8, 0, 0], [9, 0, 0], [9, 1, 0]]}\n"
    "  w: {polyline: [[8, 5, 0], [9, 5, 0]]}\n"
    "  ab: {sum: [a, b]}\n"
    "  all: {sum: [ab, c, s, w]}\n";

}  // namespace

TEST_CASE("a color is written as it is read", "[palette]") {
  for (const char* text : {"#000000", "#ffffff", "#56b4e9", "#0a0b0c"}) CHECK(hex(rgb(text)) == text);
  CHECK(hex(rgb("#ABCDEF")) == "#abcdef");
  CHECK(hex(mix(rgb("#000000"), rgb("#ffffff"), 0.2)) == "#333333");
  for (const char* text : {"", "#12345", "#1234567", "123456#", "#12345g", "#+1+1+1"}) CHECK_THROWS(rgb(text));
}

TEST_CASE("all colors of the palette are different, and they come again", "[palette]") {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < kPaletteSize; ++i) {
    seen.insert(hex(palette_color(i)));
    CHECK(palette_color(i) == palette_color(i + kPaletteSize));
  }
  CHECK(seen.size() == kPaletteSize);
  CHECK(hex(palette_color(0)) == "#7bc5ee");
  CHECK(hex(palette_color(7)) == "#b3ddf5");
  CHECK(hex(palette_color(14)) == "#4787ae");
}

TEST_CASE("regions are colored by material, component, rank and leaves", "[palette]") {
  const Colored all(kNodes + "result: all\n");
  CHECK(default_colors(all.view) == ColorBy::material);
  const auto color = [](std::size_t i) { return hex(palette_color(i)); };
  CHECK(all.regions(ColorBy::material) == std::vector<std::string>{"clay " + color(1), "clay " + color(1),
                                                                   "rock #998877",
                                                                   "no material " + hex(no_color())});
  CHECK(all.regions(ColorBy::source) ==
        std::vector<std::string>{"a " + color(0), "a + b " + color(5), "b " + color(1), "c " + color(2)});
  const std::vector<std::string> ranks = all.regions(ColorBy::region);
  CHECK(ranks.size() == 4);
  for (std::size_t i = 0; i < ranks.size(); ++i) CHECK(ranks[i].ends_with(color(i)));
  CHECK(hex(all.colors.of(ColorBy::region, 2, 0).color) == hex(sheet_color()));
}

TEST_CASE("the leaves of a node have their colors whatever else is in the tree", "[palette]") {
  for (const std::string node : {"ab", "c"}) {
    const Colored beside(kNodes + "result: all\n", node), alone(kNodes + "result: " + node + "\n");
    CHECK(beside.regions(ColorBy::source) == alone.regions(ColorBy::source));
    CHECK(default_colors(alone.view) == default_colors(beside.view));
  }
  const Colored c(kNodes + "result: all\n", "c");
  CHECK(default_colors(c.view) == ColorBy::region);
}

TEST_CASE("where nothing has a material, by material is by component", "[palette]") {
  const Colored c(kNodes + "result: all\n", "c");
  CHECK(c.regions(ColorBy::material) == c.regions(ColorBy::component));
}

TEST_CASE("sheets, wires and points have the color of their own material, others that of their kind",
          "[palette]") {
  const std::string text =
      "cnrg: 1\nmaterials: {rock: {color: \"#998877\"}, steel: {}}\nnodes:\n"
      "  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n"
      "  s: {polygon: [[8, 0, 0], [9, 0, 0], [9, 1, 0]], material: rock}\n"
      "  t: {polygon: [[8, 0, 5], [9, 0, 5], [9, 1, 5]]}\n"
      "  w: {polyline: [[1, 1, 1], [1, 1, 3]], material: steel}\n"
      "  p: {points: [[7, 7, 7]], material: steel}\n"
      "  all: {union: [a, s, t, w, p], dominance: right}\nresult: all\n";
  const Colored all(text, "all");
  CHECK(default_colors(all.view) == ColorBy::material);
  const auto count = [&](int dimension, std::size_t size, const std::string& meaning, const Rgb& color) {
    std::size_t out = 0;
    for (FlatComplex::Index i = 0; i < size; ++i) {
      const CellColor c = all.colors.of(ColorBy::material, dimension, i);
      out += c.text == meaning && c.color == color;
    }
    return out;
  };
  CHECK(count(2, all.flat.faces.size(), "rock", rgb("#998877")) == 1);
  CHECK(count(2, all.flat.faces.size(), "", sheet_color()) == 6 + 1);      // walls of the box, and the sheet t
  CHECK(count(1, all.flat.edges.size(), "steel", palette_color(1)) == 2);  // in the box and above it
  CHECK(count(1, all.flat.edges.size(), "", wire_color()) == 12 + 3 + 3);
  CHECK(count(0, all.flat.vertices.size(), "steel", palette_color(1)) == 1);
}

TEST_CASE("the sets of four leaves have colors of their own; copies of a leaf are one", "[palette]") {
  const LeafColors leaves({{"a", 0}, {"b", 1}, {"a", 2}, {"c", 3}, {"d", 4}});
  std::set<std::string> seen;
  const std::vector<std::uint32_t> one_each{0, 1, 3, 4};
  for (unsigned mask = 1; mask < 16; ++mask) {
    std::vector<LeafId> some;
    for (unsigned k = 0; k < 4; ++k) {
      if (mask >> k & 1) some.push_back(LeafId(one_each[k]));
    }
    seen.insert(hex(leaves.of(some).color));
  }
  CHECK(seen.size() == 15);
  const CellColor twice = leaves.of(std::array{LeafId(0), LeafId(2)});
  CHECK(twice.text == "a");
  CHECK(twice.color == leaves.of(std::array{LeafId(2)}).color);
  CHECK(leaves.of({}).text == "no leaf");
  // The order is that of places; what is not below the node counts for nothing.
  const LeafColors turned({{"d", 3}, {"x"}, {"c", 2}, {"b", 1}, {"a", 0}});
  CHECK(turned.of(std::array{LeafId(0), LeafId(3)}).text == "b + d");
  CHECK(turned.of(std::array{LeafId(0), LeafId(3)}).color == leaves.of(std::array{LeafId(1), LeafId(4)}).color);
  // Of very many leaves the last one's power of two is beyond every integer.
  std::vector<LeafInfo> many;
  for (std::uint32_t i = 0; i < 500; ++i) many.push_back({std::to_string(i), i});
  const LeafColors most(many);
  std::set<std::string> pairs;
  for (std::uint32_t i = 0; i < 21; ++i) pairs.insert(hex(most.of(std::array{LeafId(i), LeafId(499)}).color));
  CHECK(pairs.size() > 4);
}
