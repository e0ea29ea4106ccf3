// Surfaces about several axes of which one touches another from inside: the contact is a line, a point or a
// circle, and beside it the inner one is inside, however fine each of the two is drawn.
#include <algorithm>

#include "tests/carriers/rows.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// Leaves with `#` for `segments: n`, and the cells of their union and of the first one less the others.
struct Nest {
  std::string name;
  std::vector<std::string> leaves;
  Cells all, rest;
  bool within = true;  ///< the others are in the first one
};

const std::vector<Nest> nests{
    {"a pin in a bore, longer than it",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 3, #}",
      "cylinder: {from: [1, 0, -1], to: [1, 0, 4], radius: 2, #}"},
     {2, 6, 7, 1},
     {2, 5, 4, 1},
     false},
    {"a pin at an angle that no even step has",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 7, #}",
      "cylinder: {from: [3, 4, 2], to: [3, 4, 0], radius: 2, #}"},
     {2, 4, 5, 1},
     {2, 5, 4, 1}},
    {"cylinders of nearly one radius",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 100, #}",
      "cylinder: {from: [0.06, 0.08, 0], to: [0.06, 0.08, 2], radius: 99.9, #}"},
     {2, 4, 5, 1},
     {2, 5, 4, 1}},
    {"three cylinders along one line",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 4, #}",
      "cylinder: {from: [1, 0, 0], to: [1, 0, 2], radius: 3, #}",
      "cylinder: {from: [2, 0, 0], to: [2, 0, 2], radius: 2, #}"},
     {2, 6, 7, 1},
     {2, 5, 4, 1}},
    {"two cylinders beside each other in a third one",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 3, #}",
      "cylinder: {from: [2, 0, 0], to: [2, 0, 2], radius: 1, #}",
      "cylinder: {from: [-1, 0, 0], to: [-1, 0, 2], radius: 2, #}"},
     {6, 12, 9, 1},
     {6, 15, 10, 2}},
    {"a ball in a tube and between its ends",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 3, #}", "sphere: {center: [1, 0, 2], radius: 2, #}"},
     {0, 2, 3, 1},
     {3, 2, 4, 1}},
    {"a ball that nearly fills a tube",
     {"cylinder: {from: [0, 0, -4], to: [0, 0, 4], radius: 3, #}",
      "sphere: {center: [0.06, 0.08, 1], radius: 2.9, #}"},
     {0, 2, 3, 1},
     {1, 2, 4, 1}},
    {"two balls in a tube that touch each other",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 3, #}", "sphere: {center: [0, 2, 2], radius: 1, #}",
      "sphere: {center: [0, 0, 2], radius: 1, #}"},
     {0, 2, 3, 1},
     {2, 2, 5, 1}},
    {"a ball in a tube in a tube",
     {"cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 3, #}",
      "cylinder: {from: [1, 0, 0], to: [1, 0, 4], radius: 2, #}", "sphere: {center: [1, 1, 2], radius: 1, #}"},
     {2, 4, 5, 1},
     {2, 5, 4, 1}},
    {"a ball in a ball",
     {"sphere: {center: [0, 0, 0], radius: 5, #}", "sphere: {center: [1, 2, 2], radius: 2, #}"},
     {0, 0, 1, 1},
     {1, 0, 2, 1}},
    {"two balls in a ball, about two axes",
     {"sphere: {center: [0, 0, 0], radius: 4, #}", "sphere: {center: [3, 0, 0], radius: 1, #}",
      "sphere: {center: [0, 2.5, 0], radius: 1.5, #}"},
     {0, 0, 1, 1},
     {2, 0, 3, 1}},
    {"a ball in a ball in a ball, about two axes",
     {"sphere: {center: [0, 0, 0], radius: 4, #}", "sphere: {center: [1, 0, 0], radius: 3, #}",
      "sphere: {center: [1, 2, 0], radius: 1, #}"},
     {0, 0, 1, 1},
     {1, 0, 2, 1}},
    {"a ball in a ball above it",
     {"sphere: {center: [0, 0, 0], radius: 4, #}", "sphere: {center: [0, 0, 1], radius: 3, #}"},
     {0, 0, 1, 1},
     {1, 0, 2, 1}},
    {"a ring in a tube",
     {"cylinder: {from: [0, 0, -2], to: [0, 0, 4], radius: 3, #}",
      "torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 2, tube: 1, #}"},
     {0, 2, 3, 1},
     {0, 3, 5, 1}},
    {"a ring in a ring",
     {"torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 4, tube: 2, #}",
      "torus: {center: [0, 0, 0], axis: [0, 0, -1], radius: 5, tube: 1, #}"},
     {0, 0, 1, 1},
     {0, 1, 2, 1}},
};

std::string nest_tree(const Nest& nest, std::mt19937_64& random, const std::string& at) {
  std::uniform_int_distribution<int> segments(4, 30);
  std::vector<std::string> lines;
  std::string names, others;
  for (std::size_t i = 0; i < nest.leaves.size(); ++i) {
    const std::string name = "n" + number(static_cast<long>(i));
    std::string leaf = nest.leaves[i];
    leaf.replace(leaf.find('#'), 1, "segments: " + number(segments(random)));
    lines.push_back("  " + name + ": {" + leaf + at + "}\n");
    names += (i > 0 ? ", " : "") + name;
    if (i > 0) others += ", " + name;
  }
  std::shuffle(lines.begin(), lines.end(), random);
  std::string text;
  for (const std::string& line : lines) text += line;
  return text + "  all: {union: [" + names + "]}\n  rest: {difference: [n0" + others +
         "]}\n  model: {union: [all, rest]}\n";
}

const NodeRow& row_of(const Evaluation& evaluation, const std::string& name) {
  return *std::find_if(evaluation.rows.begin(), evaluation.rows.end(),
                       [&](const NodeRow& row) { return row.name == name; });
}

Rational volume_of_nest(const Evaluation& evaluation, const std::string& name) {
  return row_of(evaluation, name).volume().value();
}

TEST_CASE("what touches from inside is inside, and touches where it does, at any fineness and place") {
  std::mt19937_64 random(11);
  for (const Nest& nest : nests) {
    for (int i = 0; i < 6; ++i) {
      static const std::array<std::string, 6> more{
          "", "", ", scale: 0.3", ", mirror: {normal: [1, 2, 0]}", ", scale: [2, 1, 0.7]", ", scale: [1, 3, 1]"};
      const std::string at = i == 0 ? "" : placed(random) + more[static_cast<std::size_t>(i)];
      const std::string nodes = nest_tree(nest, random, at);
      INFO(nest.name << "\n" << nodes);
      const Evaluation found = evaluated(nodes);
      CHECK(row_of(found, "all").cells == nest.all);
      CHECK(row_of(found, "rest").cells == nest.rest);
      if (nest.within) CHECK(volume_of_nest(found, "all") == volume_of_nest(found, "n0"));
    }
  }
}

TEST_CASE("what is stretched touches where it did before") {
  std::mt19937_64 random(12);
  std::uniform_int_distribution<int> segments(5, 30);
  for (const std::string stretch : {"", ", scale: [2, 1, 1]", ", scale: [1, 3, 0.5]"}) {
    for (int i = 0; i < 4; ++i) {
      const std::string at = (i == 0 ? "" : placed(random)) + stretch, end = number(segments(random)) + "}";
      INFO(at);
      const NodeRow touching =
          row("  floor: {box: {min: [-9, -9, -1], max: [9, 9, 0]}" + at +
              "}\n  one: {sphere: {center: [0, 0, 2], radius: 2, segments: " + end + at +
              "}\n  other: {sphere: {center: [2, 3, 8], radius: 5, segments: " + end + at +
              "}\n  log: {cylinder: {from: [-8, -3, 2], to: [8, -3, 2], radius: 1, segments: " + end + at +
              "}\n  model: {union: [floor, one, other, log], dominance: left}\n");
      CHECK(touching.regions == 4);
      CHECK(touching.cells[0] == 11);  // three contacts, eight corners
    }
  }
}

TEST_CASE("of what is left between a pin and its bore the volume is what one has more than the other") {
  for (const int segments : {6, 12, 20}) {
    const Evaluation found = evaluated(
        "  bore: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 3, segments: 20}}\n"
        "  pin: {cylinder: {from: [1, 0, 0], to: [1, 0, 4], radius: 2, segments: " +
        number(segments) + "}}\n  model: {difference: [bore, pin]}\n");
    CHECK(volume_of_nest(found, "model") == volume_of_nest(found, "bore") - volume_of_nest(found, "pin"));
    CHECK(found.rows.back().regions == 1);
  }
}

// The ball has even steps a rounding away from where the tubes touch.
TEST_CASE("contacts have each direction once") {
  const std::string at = ", rotate: {axis: [0, 0, 1], degrees: 234}, translate: [-29.3, 0, 0.7], scale: 0.3}\n";
  const std::string nodes = "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 3, segments: 16}" + at +
                            "  b: {cylinder: {from: [1, 0, 0], to: [1, 0, 4], radius: 2, segments: 23}" + at +
                            "  c: {sphere: {center: [1, 1, 2], radius: 1, segments: 40}" + at +
                            "  model: {difference: [a, b, c]}\n";
  const Evaluation found = evaluated(nodes);
  CHECK(found.rows.back().cells == Cells{2, 5, 4, 1});
}

TEST_CASE("surfaces that each are inside of the next one, in a circle, are evaluated") {
  // A ring of cylinders of radius 1 and 3 about one axis, joined by a cone, and one of radius 2 between them.
  const std::string nodes =
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 9}}\n"
      "  b: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 3, segments: 12}}\n"
      "  c: {cone: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, top: 3, segments: 8}}\n"
      "  d: {cylinder: {from: [1, 0, 0], to: [1, 0, 2], radius: 2, segments: 10}}\n"
      "  model: {union: [a, b, c, d]}\n";
  const Evaluation found = evaluated(nodes);
  CHECK(volume_of_nest(found, "model") >= volume_of_nest(found, "b"));
}

TEST_CASE("where tubes cross and touch in a point, both have it") {
  std::mt19937_64 random(6031);
  std::uniform_int_distribution<int> segments(7, 45);
  for (int i = 0; i < 8; ++i) {
    const std::string at = i == 0 ? "" : placed(random);
    const auto tube = [&](const std::string& ends, const std::string& radius) {
      return "{cylinder: {" + ends + ", radius: " + radius + ", segments: " + number(segments(random)) + "}" + at +
             "}\n";
    };
    // A saddle: the rim of the first one touches the second one in two poles, where its axis meets the other.
    const std::string saddle = "  n0: " + tube("from: [3, 2, 1], to: [3, 2, 3]", "1") +
                               "  n1: " + tube("from: [3, 1, 3], to: [3, 4, 3]", "1") +
                               "  model: {difference: [n0, n1]}\n";
    INFO(saddle);
    CHECK(row(saddle).cells == Cells{0, 2, 3, 1});
    // The smaller one passes through the wall of the larger one, and touches it in one point from inside.
    const std::string beside = "  n0: " + tube("from: [0, 0, -5], to: [0, 0, 5]", "2") +
                               "  n1: " + tube("from: [-4, 1, 1], to: [4, 1, 0]", "1") +
                               "  model: {union: [n0, n1]}\n";
    CHECK(row(beside).cells == Cells{1, 6, 7, 1});
  }
}

}  // namespace
}  // namespace cnrg
