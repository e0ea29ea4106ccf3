// Curved leaves that have a surface in common: at any fineness, under any transform, in any order of the leaves
// the counts are those of the true solids.
#include "csg/carriers/common_lines.h"

#include "csg/evaluate/prepared_leaves.h"
#include "tests/carriers/rows.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

TEST_CASE("a shaft in its bore leaves no void, whatever their segments") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> segments(3, 40);
  for (int i = 0; i < 12; ++i) {
    const int n = i == 0 ? 32 : segments(random), m = i == 0 ? 24 : segments(random);
    INFO(n << " and " << m << " segments");
    const std::string bore = "from: [0, 0, -1], to: [0, 0, 5], radius: 1, segments: " + number(n),
                      shaft = "from: [0, 0, 4], to: [0, 0, 0], radius: 1, segments: " + number(m);
    const Evaluation both =
        evaluated("  block: {box: {min: [-2, -2, 0], max: [2, 2, 4]}}\n  bore: {cylinder: {" + bore +
                  "}}\n  shaft: {cylinder: {" + shaft +
                  "}}\n  plate: {difference: [block, bore]}\n  model: {union: [plate, shaft], dominance: left}\n");
    // The box, and the cylinder's side with its two rims, which part top and bottom.
    CHECK(both.rows.back().cells == Cells{8, 14, 9, 2});
    CHECK(both.rows.back().volume() == Rational(64));
  }
}

TEST_CASE("a ball less the same ball, turned about any axis, is nothing") {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> degrees(1, 359), segments(3, 24);
  for (int i = 0; i < 12; ++i) {
    const std::string turn = direction(random);
    const int angle = degrees(random);
    INFO(turn << " by " << angle);
    const Evaluation both = evaluated(
        "  ball: {sphere: {center: [1, 2, 3], radius: 2.5, segments: " + number(segments(random)) +
        "}}\n"
        "  turned: {sphere: {center: [1, 2, 3], radius: 2.5, segments: " +
        number(segments(random)) + ", rings: 5}, rotate: {axis: " + turn + ", degrees: " + number(angle) +
        ", center: [1, 2, 3]}}\n"
        "  rest: {difference: [ball, turned]}\n  other: {difference: [turned, ball]}\n"
        "  model: {union: [rest, other]}\n");
    CHECK(both.rows.back().raw_cells == Cells{0, 0, 0, 0});
  }
}

TEST_CASE("an ellipsoid less the same one is nothing, however it was turned before it was stretched") {
  const NodeRow rest =
      row("  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 9}, scale: [1, 2, 3]}\n"
          "  b: {sphere: {center: [0, 0, 0], radius: 0.5, segments: 12},\n"
          "      rotate: {axis: [1, 2, 2], degrees: 77}, scale: [2, 4, 6]}\n"
          "  model: {difference: [a, b]}\n");
  CHECK(rest.raw_cells == Cells{0, 0, 0, 0});
}

TEST_CASE("tubes in tubes about an oblique axis share their walls") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 6; ++i) {
    const std::string end = placed(random) + "}\n",
                      there = "cylinder: {from: [0.1, 0, 0], to: [3.1, 4, 12], radius: ",
                      back = "cylinder: {from: [3.1, 4, 12], to: [0.1, 0, 0], radius: ";
    const NodeRow both =
        row("  o1: {" + there + "2, segments: 20}" + end + "  b1: {" + there + "1, segments: 17}" + end +
            "  o2: {" + back + "1, segments: 12}" + end + "  b2: {" + back + "0.5, segments: 24}" + end +
            "  t1: {difference: [o1, b1]}\n  t2: {difference: [o2, b2]}\n  model: {union: [t1, t2], dominance: "
            "left}\n");
    // Three cylinders, two rings at each end; six circles.
    CHECK(both.cells == Cells{0, 6, 7, 2});
  }
}

TEST_CASE("cylinders of one radius that overlap in length have one side") {
  const NodeRow both =
      row("  a: {cylinder: {from: [0, 0, 0], to: [1, 2, 2], radius: 1, segments: 9}}\n"
          "  b: {cylinder: {from: [3, 6, 6], to: [0.5, 1, 1], radius: 1, segments: 14}}\n"
          "  model: {unify: {union: [a, b]}}\n");
  CHECK(both.cells == Cells{0, 2, 3, 1});
}

TEST_CASE("a pin that ends in a ball meets it in one circle") {
  for (const int segments : {5, 16, 21}) {
    const std::string ball =
        "  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: " + number(segments) + "}}\n";
    // The pin comes out below; its rim above lies on the ball, the cap inside.
    CHECK(row(ball + "  pin: {cylinder: {from: [0, 0, -3], to: [0, 0, 0.8], radius: 0.6, segments: 20}}\n"
                     "  model: {unify: {union: [pin, ball]}}\n")
              .cells == Cells{0, 2, 3, 1});
    // The cap of the ball is in the pin, whose disc is the wall between the two.
    CHECK(row(ball + "  pin: {cylinder: {from: [0, 0, 0.8], to: [0, 0, 3], radius: 0.6, segments: 20}}\n"
                     "  model: {union: [pin, ball], dominance: left}\n")
              .cells == Cells{0, 2, 4, 2});
  }
}

TEST_CASE("a ball in a pipe of its radius touches it along a circle") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 6; ++i) {
    const std::string end = "}" + placed(random) + "}\n";
    const NodeRow air =
        row("  pipe: {cylinder: {from: [0, 0, -3], to: [0, 0, 3], radius: 1, segments: " + number(5 + i) + end +
            "  ball: {sphere: {center: [0, 0, 0.3], radius: 1, segments: 15" + end +
            "  model: {difference: [pipe, ball]}\n");
    CHECK(air.cells == Cells{0, 3, 6, 2});
  }
}

TEST_CASE("a cone sits in its countersink without a gap") {
  const NodeRow both =
      row("  plate: {box: {min: [-5, -5, -3], max: [5, 5, 0]}}\n"
          "  sink: {cone: {from: [0, 0, -2], to: [0, 0, 0], radius: 1, top: 3, segments: 20}}\n"
          "  head: {cone: {from: [0, 0, 1], to: [0, 0, -1], radius: 4, top: 2, segments: 13}}\n"
          "  bored: {difference: [plate, sink]}\n"
          "  model: {union: [bored, head], dominance: left}\n");
  CHECK(both.cells == Cells{8, 16, 12, 2});
}

TEST_CASE("a torus is its two halves, and its arcs are those of a revolved profile") {
  const std::string halves =
      "  whole: {torus: {center: [1, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1, segments: 9, rings: 7}}\n"
      "  east: {revolve: {profile: [[4, 0], {bezier: [[4, 1]], weights: [1, 1, 2]}, [3, 1],\n"
      "    {bezier: [[2, 1]], weights: [1, 1, 2]}, [2, 0], {bezier: [[2, -1]], weights: [1, 1, 2]}, [3, -1],\n"
      "    {bezier: [[4, -1]], weights: [1, 1, 2]}], degrees: 180, segments: 11}, translate: [1, 0, 0]}\n"
      "  west: {torus: {center: [-1, 0, 0], axis: [0, 0, -1], radius: 3, tube: 1, segments: 12},\n"
      "    rotate: {axis: [0, 0, 1], degrees: 25, center: [-1, 0, 0]}, translate: [2, 0, 0]}\n";
  CHECK(row(halves + "  model: {difference: [east, whole]}\n").raw_cells == Cells{0, 0, 0, 0});
  CHECK(row(halves + "  model: {difference: [west, whole]}\n").raw_cells == Cells{0, 0, 0, 0});
  CHECK(row(halves + "  a: {difference: [west, east]}\n  b: {difference: [whole, east]}\n"
                     "  c: {union: [a, east], dominance: left}\n  model: {difference: [whole, c]}\n")
            .raw_cells == Cells{0, 0, 0, 0});
}

TEST_CASE("a ball equals the revolved half circle") {
  const NodeRow rest =
      row("  ball: {sphere: {center: [0, 0, 0], radius: 5, segments: 9}}\n"
          "  turned: {revolve: {profile: [[0, -5], {bezier: [[5, -5]], weights: [1, 1, 2]}, [5, 0],\n"
          "    {bezier: [[5, 5]], weights: [1, 1, 2]}, [0, 5]], segments: 10}}\n"
          "  a: {difference: [ball, turned]}\n  b: {difference: [turned, ball]}\n  model: {union: [a, b]}\n");
  CHECK(rest.raw_cells == Cells{0, 0, 0, 0});
}

/// The Minkowski sum of a box and a ball as a union, all round leaves of different fineness, turned about no axis.
std::string rounded_box(const std::string& at, const std::vector<std::size_t>& order) {
  std::vector<std::string> names, lines;
  const auto add = [&](const std::string& shape) {
    names.push_back("n" + number(static_cast<long>(names.size())));
    lines.push_back("  " + names.back() + ": {" + shape + at + "}\n");
  };
  add("box: {min: [0, 0.5, 0.5], max: [4, 2.5, 1.5]}");
  add("box: {min: [0.5, 0, 0.5], max: [3.5, 3, 1.5]}");
  add("box: {min: [0.5, 0.5, 0], max: [3.5, 2.5, 2]}");
  const std::array<std::array<std::string, 2>, 3> ends{{{"0.5", "3.5"}, {"0.5", "2.5"}, {"0.5", "1.5"}}};
  const auto point = [&](std::size_t i, std::size_t j, std::size_t k) {
    return "[" + ends[0][i] + ", " + ends[1][j] + ", " + ends[2][k] + "]";
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::array<std::size_t, 3> p{};
      p[(axis + 1) % 3] = corner % 2;
      p[(axis + 2) % 3] = corner / 2;
      std::array<std::size_t, 3> q = p;
      q[axis] = 1;
      add("cylinder: {from: " + point(p[0], p[1], p[2]) + ", to: " + point(q[0], q[1], q[2]) +
          ", radius: 0.5, segments: " + number(static_cast<long>(9 + names.size())) + "}");
    }
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    add("sphere: {center: " + point(corner % 2, corner / 2 % 2, corner / 4) +
        ", radius: 0.5, segments: " + number(static_cast<long>(6 + corner)) + "}");
  }
  std::string text, list;
  for (const std::size_t i : order) {
    text += lines[i];
    list += (list.empty() ? "" : ", ") + names[i];
  }
  return text + "  model: {unify: {union: [" + list + "]}}\n";
}

TEST_CASE("a rounded box has 26 faces, in any order of its 23 leaves, turned or not") {
  std::mt19937_64 random(5);
  std::vector<std::size_t> order(23);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const NodeRow straight = row(rounded_box("", order));
  CHECK(straight.cells == Cells{24, 48, 26, 1});
  for (int i = 0; i < 3; ++i) {
    std::shuffle(order.begin(), order.end(), random);
    const NodeRow shuffled = row(rounded_box("", order));
    CHECK(shuffled.cells == straight.cells);
    CHECK(shuffled.volume() == straight.volume());
  }
  CHECK(row(rounded_box(placed(random), order)).cells == straight.cells);
}

TEST_CASE("balls, logs and rings touch a floor in a point, a line and a circle") {
  const std::string floor = "  floor: {box: {min: [-9, -9, -1], max: [9, 9, 0]}}\n";
  const auto on_floor = [&](const std::string& leaf) {
    return row(floor + "  leaf: {" + leaf + "}\n  model: {union: [floor, leaf], dominance: left}\n").cells;
  };
  for (const int n : {5, 6, 13}) {
    INFO(n << " segments");
    CHECK(on_floor("sphere: {center: [0.5, 0.3, 1], radius: 1, segments: " + number(n) +
                   "}, rotate: {axis: [1, 2, 3], degrees: 40, center: [0.5, 0.3, 1]}") == Cells{9, 12, 7, 2});
    CHECK(on_floor("cylinder: {from: [-3, 0.4, 0.7], to: [4, -0.2, 0.7], radius: 0.7, segments: " + number(n) +
                   "}") == Cells{10, 15, 9, 2});
    CHECK(on_floor("torus: {center: [0, 0, 0.5], axis: [0, 0, 1], radius: 2, tube: 0.5, rings: " + number(n) +
                   "}") == Cells{8, 13, 8, 2});
    // Upright, and against an oblique wall.
    CHECK(row("  wall: {prism: {base: [[0, 0, 0], [6, -3, 0], [6, 0, 0]], vector: [0, 0, 9]}}\n"
              "  ball: {sphere: {center: [0, -5, 4], radius: 1, segments: " +
              number(n) + "}}\n  model: {union: [wall, ball]}\n")
              .cells == Cells{6, 9, 6, 2});
  }
}

TEST_CASE("a ball rests in a corner that no grid of it knows") {
  // The plane 2x + 2y + z = 0 has distance 3 from (1, 3, 1).
  const std::string leaves =
      "  below: {prism: {base: [[-20, 10, 20], [20, -30, 20], [30, -10, -40], [-10, 30, -40]],\n"
      "    vector: [-2, -2, -1]}}\n"
      "  ball: {sphere: {center: [1, 3, 1], radius: 3, segments: 11}}\n";
  const NodeRow both = row(leaves + "  model: {union: [below, ball]}\n");
  CHECK(both.cells == Cells{9, 12, 7, 2});
}

TEST_CASE("cylinders and balls side by side touch in lines and points") {
  const NodeRow three =
      row("  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 5], radius: 2, segments: 9}}\n"
          "  b: {cylinder: {from: [3, 4, 1], to: [3, 4, 6], radius: 3, segments: 11}}\n"
          "  ball: {sphere: {center: [-3, 0, 1], radius: 1, segments: 13}}\n"
          "  small: {sphere: {center: [-3, 1.5, 3], radius: 1.5, segments: 7}}\n"
          "  model: {union: [a, b, ball, small], dominance: left}\n");
  // The line of contact ends on a rim of each cylinder; the ball touches one of them and the other ball, which
  // reaches into the first cylinder, between its facets.
  CHECK(three.cells == Cells{4, 6, 9, 4});
}

TEST_CASE("logs that lie across each other touch in a point") {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<int> segments(5, 30);
  for (int i = 0; i < 6; ++i) {
    const std::string at = i == 0 ? "" : placed(random);
    const auto log = [&](const std::string& name, const std::string& ends, const std::string& radius) {
      return "  " + name + ": {cylinder: {" + ends + ", radius: " + radius +
             ", segments: " + number(segments(random)) + "}" + at + "}\n";
    };
    // The third one reaches the first with its rim only.
    const NodeRow three =
        row(log("a", "from: [-4, 0, 1], to: [5, 0, 1]", "1") + log("b", "from: [1, -3, 4], to: [4, 1, 4]", "2") +
            log("c", "from: [-2, 0, 4], to: [-2, 5, 4]", "2") + "  model: {union: [a, b, c], dominance: left}\n");
    CHECK(three.cells == Cells{2, 6, 9, 3});
  }
}

// Scaled by a number that is no double, the contact of torus and ball was found twice, a rounding apart.
TEST_CASE("a ball in the hole of a torus and on the rim of a cone is drawn at once at any scale") {
  const auto scene = [](const std::string& at) {
    return row(
        "  t: {torus: {center: [0, 0, 2], axis: [1, 0, 0], radius: 2.5, tube: 0.5, segments: 16, rings: 12}}\n"
        "  c: {cone: {from: [0, 0, 0], to: [0, 0, -2], radius: 0.5, segments: 12}}\n"
        "  s: {sphere: {center: [0, 0, 2], radius: 2, segments: 12}}\n"
        "  model: {union: [t, c, s]" +
        at + "}\n");
  };
  const NodeRow one = scene("");
  CHECK(one.raw_cells[2] < 2000);
  for (const std::string at : {"scale: 0.1", "scale: 0.37, rotate: {axis: [0, 0, 1], degrees: 71}"}) {
    INFO(at);
    const NodeRow other = scene(", " + at);
    CHECK(other.cells == one.cells);
    CHECK(other.raw_cells[2] < 2000);
  }
}

TEST_CASE("a plane that a leaf has elsewhere is no contact, and a whole model may be moved") {
  const std::string leaves =
      "  s: {sphere: {center: [0, 0, 1], radius: 2, segments: 8}}\n"
      "  c: {cylinder: {from: [1, 0, -1], to: [1, 0, 2], radius: 0.5, segments: 8}}\n";
  const NodeRow one = row(leaves + "  model: {sum: [s, c]}\n");
  const NodeRow other = row(leaves + "  model: {sum: [s, c], mirror: {normal: [1, 1, 3]}}\n");
  CHECK(one.cells == Cells{0, 3, 6, 3});
  CHECK(other.cells == one.cells);
  // Where further lines are needed depends on rounding, and that on the frame.
  const auto as_drawn = [&](const std::string& model) {
    return evaluated(leaves + model, "model", AskedProof::none).rows.back().volume();
  };
  CHECK(as_drawn("  model: {sum: [s, c], mirror: {normal: [1, 1, 3]}}\n") == as_drawn("  model: {sum: [s, c]}\n"));
  const Tree tree =
      parse_tree("cnrg: 1\nnodes:\n" + leaves + "  model: {union: [s, c]}\nresult: model\n", "t.yaml");
  const std::vector<LeafInstance> own = PreparedLeaves(tree, unfold(tree, {tree.result})).instances();
  const std::vector<LeafInstance> common = with_common_lines(own);
  for (std::size_t i = 0; i < own.size(); ++i) CHECK(common[i].leaf == own[i].leaf);
}

TEST_CASE("a leaf that touches a plane alone keeps its meridians wherever the model is") {
  const std::string leaves =
      "  s: {sphere: {center: [0.5, 0, 1], radius: 1, segments: 9}, rotate: {axis: [1, 2, 3], degrees: 33,"
      " center: [0.5, 0, 1]}}\n"
      "  b: {box: {min: [-3, -3, -1], max: [3, 3, 0]}}\n"
      "  c: {cylinder: {from: [-2, -3, 1], to: [-2, 2, 1], radius: 1, segments: 9}}\n";
  const NodeRow one = row(leaves + "  model: {union: [s, b, c]}\n");
  const NodeRow other = row(leaves + "  model: {union: [s, b, c], rotate: {axis: [3, -1, 2], degrees: 71}}\n");
  CHECK(one.cells == Cells{11, 16, 10, 3});
  CHECK(other.cells == one.cells);
  CHECK(to_double(*other.volume()) == Approx(to_double(*one.volume())).epsilon(1e-12));
}

TEST_CASE("which lines are common does not depend on the order of the leaves") {
  const std::string a = "  a: {cylinder: {from: [0, 0, 0], to: [1, 2, 2], radius: 1, segments: 9}}\n",
                    b = "  b: {sphere: {center: [0.5, 1, 1], radius: 1.3, segments: 14}}\n",
                    c = "  c: {cone: {from: [2, 4, 4], to: [0, 0, 0], radius: 2, top: 1, segments: 7}}\n",
                    model = "  model: {union: [a, b, c]}\n";
  const NodeRow one = row(a + b + c + model), other = row(c + b + a + model), third = row(b + a + c + model);
  CHECK(one.volume() == other.volume());
  CHECK(one.volume() == third.volume());
  CHECK(one.cells == other.cells);
}

TEST_CASE("leaves that share nothing keep what they were") {
  const Tree tree = parse_tree(
      "cnrg: 1\nnodes:\n"
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 5], radius: 2, segments: 9}}\n"
      "  b: {cylinder: {from: [0, 0, 0], to: [0, 0, 5], radius: 1, segments: 24}}\n"
      "  c: {sphere: {center: [2, 0, 1], radius: 0.9}}\n"
      "  d: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
      "  e: {cylinder: {from: [0, 0, 5], to: [0, 0, 7], radius: 2, segments: 9}}\n"
      "  model: {union: [a, b, c, d, e]}\nresult: model\n",
      "t.yaml");
  const std::vector<LeafInstance> own = PreparedLeaves(tree, unfold(tree, {tree.result})).instances();
  const std::vector<LeafInstance> common = with_common_lines(own);
  REQUIRE(common.size() == own.size());
  for (std::size_t i = 0; i < own.size(); ++i) CHECK(common[i].leaf == own[i].leaf);
}

TEST_CASE("what is stretched along its own axis is round about it still") {
  for (const char* finer : {"7", "16", "31"}) {
    const std::string segments = ", segments: " + std::string(finer);
    const std::string pin = "  pin: {cylinder: {from: [0, 0, 0], to: [0, 0, 3], radius: 1" + segments + "}}\n";
    CHECK(row(pin +
              "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 20}, scale: [1, 1, 3]}\n"
              "  model: {difference: [pin, a]}\n")
              .raw_cells == Cells{0, 0, 0, 0});
    CHECK(row(pin + "  a: {cone: {from: [0, 0, 0], to: [0, 0, 6], radius: 2, top: 1, segments: 20}, "
                    "scale: [1/2, 1/2, 1/4]}\n  model: {difference: [pin, a]}\n")
              .cells == Cells{0, 3, 4, 1});
    // Arcs of extrusions, stretched along their walls, and with all that they touch.
    const std::string wall =
        "extrude: {curve: [[1, 0, -1], {bezier: [[1, 1, -1]], weights: [1, 1, 2]}, [0, 1, -1]], "
        "vector: [0, 0, 2], segments: 4}";
    CHECK(row(pin + "  a: {" + wall + ", scale: [1, 1, 5/2]}\n  model: {union: [pin, a]}\n").cells ==
          Cells{6, 9, 5, 1});
    CHECK(row("  pin: {cylinder: {from: [0, 0, 0], to: [0, 0, 3], radius: 1" + segments +
              "}, scale: [2, 3, 1/2]}\n  a: {" + wall + ", scale: [2, 3, 1/2]}\n  model: {union: [pin, a]}\n")
              .cells == Cells{6, 9, 5, 1});
  }
}

TEST_CASE("axes whose numbers are too far apart for doubles are no fault") {
  CHECK(row("  a: {torus: {center: [0, 0, 0], axis: [1e300, 1, 1e-300], radius: 2, tube: 1}}\n"
            "  b: {sphere: {center: [0, 0, 0], radius: 1}}\n  model: {union: [a, b]}\n")
            .cells[3] >= 1);
}

}  // namespace
}  // namespace cnrg
