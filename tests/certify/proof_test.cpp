// Certificates of trees whose topology is known, and of contacts and near contacts.
#include <random>

#include "csg/certify/certificate.h"
#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using Cells = std::array<std::size_t, 4>;

struct Asked {
  Tree tree;
  Evaluation evaluation;
  /// `leaves`: lines of a map of nodes; `result`: an operation with them.
  Asked(const std::string& leaves, const std::string& result, AskedProof proof = AskedProof::to_the_end,
        int finer = 1, const std::string& parameters = "")
      : tree(parse_tree("cnrg: 1\n" + parameters + "nodes:\n" + leaves + "  r: " + result + "\nresult: r\n",
                        "t.yaml")) {
    make_finer(tree, finer);
    EvaluateOptions options;
    options.proof = proof;
    evaluation = evaluate(tree, options);
  }
  const Certificate& certificate() const { return *evaluation.certificate; }
  bool certified() const { return certificate().places.empty() && certificate().unknown.empty(); }
  Cells cells() const { return evaluation.rows.back().cells; }
  void certifies(const Cells& right) const {
    CHECK(certified());
    CHECK(cells() == right);
  }
};

struct Known {
  const char* what;
  std::string leaves, result;
  Cells cells;
};

constexpr std::array<const char*, 2> kTurned{"{", "{rotate: {axis: [3, -1, 2], degrees: 23}, "};

// The rod touches the ball and crosses it in one point: Viviani's curve.
const std::string kViviani =
    "  a: {cylinder: {from: [1, 0, -3], to: [1, 0, 3], radius: 1}}\n"
    "  b: {sphere: {center: [0, 0, 0], radius: 2}}\n";

// Of each a certificate with other counts was given once, or none with the right ones.
std::vector<Known> near_contacts() {
  const std::string bore = "  b: {cylinder: {from: [0, 0, -1], to: [0, 0, 5], radius: 1}}\n";
  const std::string ball = "  a: {sphere: {center: [0, 0, 0], radius: 1}}\n";
  return {
      {"a ball less itself",
       ball + "  b: {sphere: {center: [0, 0, 0], radius: 1}}\n",
       "{difference: [a, b]}",
       {0, 0, 0, 0}},
      {"balls a millionth apart",
       ball + "  b: {sphere: {center: [2.000001, 0, 0], radius: 1}}\n",
       "{intersection: [a, b]}",
       {0, 0, 0, 0}},
      {"balls that overlap by a millionth",
       ball + "  b: {sphere: {center: [1.999999, 0, 0], radius: 1}}\n",
       "{intersection: [a, b]}",
       {0, 1, 2, 1}},
      {"a bore that breaks through a wall",
       "  a: {box: {min: [-2, -3, 0], max: [2, 0.998, 4]}}\n" + bore,
       "{difference: [a, b]}",
       {12, 18, 8, 1}},
      {"a pin wholly inside of a bore",
       "  a: {box: {min: [0.2, 0.2, 0], max: [0.4, 0.9, 4]}}\n" + bore,
       "{difference: [a, b]}",
       {0, 0, 0, 0}},
      {"equal pipes, three, which touch and cross by twos",
       "  a: {cylinder: {from: [-3, 0, 0], to: [3, 0, 0], radius: 1, segments: 9}}\n"
       "  b: {cylinder: {from: [-1, -2, -1], to: [1, 2, 1], radius: 1, segments: 14}}\n"
       "  c: {cylinder: {from: [-1, 2, 2], to: [1, -2, -2], radius: 1, segments: 11}}\n",
       "{union: [a, b, c]}",
       {8, 18, 12, 1}},
      {"a pipe that touches a wider one from inside, and crosses it",
       "  a: {cylinder: {from: [-2, 0, 0], to: [2, 0, 0], radius: 1}, scale: [1, 2, 1/3]}\n"
       "  b: {cylinder: {from: [-1, -2, 0.5], to: [1, 2, 0.5], radius: 1/2, segments: 7}, scale: [1, 2, 1/3]}\n",
       "{union: [a, b]}",
       {1, 6, 7, 1}},
      {"vaults that cross at one height",
       "  a: {extrude: {profile: [[-1, -1, 0], [1, -1, 0], [1, 0, 0], {bezier: [[1, 3/4, 0]], weights: "
       "[5, 4, 5]}, [7/25, 24/25, 0], {bezier: [[0, 25/24, 0]], weights: [25, 24, 25]}, [-7/25, 24/25, 0], "
       "{bezier: [[-1, 3/4, 0]], weights: [5, 4, 5]}, [-1, 0, 0]], vector: [0, 0, 4]}}\n"
       "  b: {simplify: a, rotate: {axis: [0, 1, 0], degrees: 90}, translate: [-2, 0, 2]}\n",
       "{union: [a, b]}",
       {37, 64, 29, 1}},
      {"a wire in the plane of a cap",
       "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 8}}\n"
       "  b: {polyline: [[291/325, 97/260, 1], [2, 3, 1]]}\n",
       "{sum: [a, b]}",
       {3, 4, 3, 1}},
      {"a circle that is cut out of a plane which is there again",
       ball + "  b: {polygon: [[-2, -2, 0.3], [2, -2, 0.3], [2, 2, 0.3], [-2, 2, 0.3]]}\n",
       "{sum: [{subtract: [b, a]}, b]}",
       {4, 5, 2, 0}},
      {"corners of a box that is cut out of a cylinder's side",
       "  a: {revolve: {curve: [[1, -1], [1, 1]]}}\n  b: {box: {min: [0, -0.5, -0.5], max: [2, 0.5, 0.5]}}\n",
       "{sum: [{subtract: [a, b]}, a]}",
       {4, 6, 2, 0}},
      {"a piece of a cylinder's side that is cut out of a box which is there again",
       "  a: {revolve: {curve: [[1, -1], [1, 1]]}}\n  b: {box: {min: [0, -0.5, -0.5], max: [2, 0.5, 0.5]}}\n"
       "  c: {box: {min: [-4, -4, -4], max: [4, 4, 4]}}\n",
       "{sum: [{subtract: [c, {product: [a, b]}]}, c]}",
       {12, 16, 7, 1}},
      {"half of a sphere, not about the origin, and a cone that is apart",
       "  a: {revolve: {curve: [[1, 1], {bezier: [[1, 2]], weights: [1, 1, 2]}, [0, 2]], segments: 8}}\n"
       "  b: {polygon: [[-3, -3, 3/2], [3, -3, 3/2], [3, 3, 3/2], [-3, 3, 3/2]]}\n"
       "  c: {cone: {from: [0, 0, 3], to: [0, 0, 4], radius: 1, segments: 10}}\n",
       "{sum: [{sum: [a, b]}, c]}",
       {4, 7, 6, 1}},
      {"a side of a patch that crosses a plane at a small angle",
       "  a: {bezier: {patch: [[[461/84, -115/84, 1055/336], [475/84, -59/84, 1111/336], [1355/252, "
       "-121/252, 2717/1008]], [[1481/252, -373/252, 2843/1008], [1523/252, -205/252, 3011/1008], [1453/252, "
       "-149/252, 2395/1008]], [[1607/252, -373/252, 2717/1008], [1649/252, -205/252, 2885/1008], [1579/252, "
       "-149/252, 2269/1008]]], segments: 5}}\n"
       "  b: {halfspace: {point: [94481/16884, -21295/16884, 224795/67536], normal: [-4/9, -4/9, -7/9]}}\n",
       "{intersection: [a, b]}",
       {4, 4, 2, 0}},
      {"a point of Viviani's curve that is cut off",
       kViviani + "  c: {halfspace: {point: [3/2, 0, 0], normal: [1, 0, 0]}}\n",
       "{union: [{intersection: [a, c]}, b]}",
       {8, 12, 7, 1}},
      {"the same, outside of a ball",
       kViviani + "  c: {sphere: {center: [1/3, 0, 3], radius: 1}}\n",
       "{union: [{intersection: [b, c]}, a]}",
       {0, 2, 3, 1}},
      {"a line of two planes just inside of a ball",
       ball + "  b: {box: {min: [0.6, 0.79975, -3], max: [3, 3, 3]}}\n",
       "{intersection: [a, b]}",
       {2, 3, 3, 1}},
      {"a line of two planes just outside of a ball",
       ball + "  b: {box: {min: [0.6, 0.80025, -3], max: [3, 3, 3]}}\n",
       "{intersection: [a, b]}",
       {0, 0, 0, 0}},
  };
}

TEST_CASE("near contacts are certified with the counts of the true surfaces, at any fineness and turned",
          "[certify]") {
  for (const Known& known : near_contacts()) {
    INFO(known.what);
    Asked(known.leaves, known.result, AskedProof::within_budget).certifies(known.cells);
    for (const int finer : {1, 2}) {
      for (const char* turned : kTurned) {
        INFO("finer " << finer << ", " << turned);
        Asked(known.leaves, turned + known.result.substr(1), AskedProof::to_the_end, finer).certifies(known.cells);
      }
    }
  }
}

TEST_CASE("what dies elsewhere in the tree changes no counts and no certificate", "[certify]") {
  const auto [first, last] = scenes::seeds(2);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    std::mt19937_64 random(seed);
    for (const Known& known : near_contacts()) {
      const auto number = [&] { return std::to_string(int(random() % 4001) - 2000) + "/1009"; };
      const std::string ball = "{sphere: {center: [" + number() + ", " + number() + ", " + number() +
                               "], radius: " + std::to_string(500 + random() % 1500) + "/1009}}";
      INFO(known.what << ", seed " << seed << ", " << ball);
      const std::string leaves = known.leaves + "  w: {box: {min: [-9, -9, -9], max: [9, 9, 9]}}\n";
      const Cells alone = Asked(leaves, "{sum: [" + known.result + ", {subtract: [w, w]}]}").cells();
      Asked(leaves + "  z: " + ball + "\n", "{sum: [" + known.result + ", {subtract: [z, w]}]}").certifies(alone);
    }
  }
  // What touches in the plane of the cut does not die.
  const std::string half = "  c: {halfspace: {point: [2, 0, 0], normal: [1, 0, 0]}}\n";
  CHECK_FALSE(Asked(kViviani + half, "{intersection: [{union: [a, b]}, c]}").certified());
  CHECK_FALSE(Asked(kViviani + half, "{union: [{intersection: [a, c]}, b]}").certified());
}

TEST_CASE("surfaces about one axis are told apart however near they are", "[certify]") {
  const std::string body = "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 10}}\n";
  for (const char* const near : {"1/10", "1/1000", "1/100000"}) {
    const std::vector<Known> all{
        {"a longer cylinder inside",
         body + "  b: {cylinder: {from: [0, 0, -1], to: [0, 0, 3], radius: '${1 - n}', segments: 14}}\n",
         "{difference: [a, b]}",
         {0, 4, 4, 1}},
        {"a ball that is a little wider",
         body + "  b: {sphere: {center: [0, 0, 1], radius: '${1 + n}', segments: 8, rings: 6}}\n",
         "{difference: [b, a]}",
         {0, 4, 6, 3}},
        {"a cone and the same one, moved",
         "  a: {cone: {from: [0, 0, 0], to: [0, 0, 2], radius: 1}}\n"
         "  b: {cone: {from: [0, 0, '${-n}'], to: [0, 0, '${2 - n}'], radius: 1, segments: 12}}\n",
         "{difference: [a, b]}",
         {0, 2, 3, 1}},
        {"a ball and the same one, moved",
         "  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 8, rings: 8}}\n"
         "  b: {sphere: {center: ['${2 * n / 3}', '${n / 3}', '${2 * n / 3}'], radius: 1, segments: 8, rings: "
         "8}}\n",
         "{difference: [a, b]}",
         {0, 1, 2, 1}},
    };
    for (const Known& known : all) {
      for (const char* turned : kTurned) {
        INFO(known.what << ", " << near << ", " << turned);
        const std::string n = std::string("parameters: {n: ") + near + "}\n";
        Asked(known.leaves, turned + known.result.substr(1), AskedProof::to_the_end, 1, n).certifies(known.cells);
      }
    }
  }
}

TEST_CASE("a cone in a cone is told apart whatever the segments of both", "[certify]") {
  for (const int segments : {4, 5, 7}) {
    INFO(segments << " segments");
    // Of b only what is below the base of a is left: two disks and the side.
    Asked(
        "  a: {cone: {from: [0, 0, 0], to: [33/40, 0, 11/10], radius: 1/2, segments: 24}}\n"
        "  b: {cone: {from: [-3/100, 0, -1/25], to: [819/1000, 0, 273/250], radius: 1/2, segments: " +
            std::to_string(segments) + "}}\n",
        "{difference: [b, a]}")
        .certifies({0, 2, 3, 1});
  }
}

TEST_CASE("balls nearly in one place are told apart far from the origin, too", "[certify]") {
  for (const auto& [far, near] : {std::pair("1000", "1/10000"), {"10000", "1/1000"}, {"0", "1/1000000"}}) {
    INFO(near << " at " << far);
    const auto ball = [&, x = std::string(far)](const std::string& z) {
      return "{sphere: {center: [" + x + ", 0, " + z + "], radius: 1, segments: 16, rings: 8}}\n";
    };
    Asked("  a: " + ball("0") + "  b: " + ball(near), "{difference: [a, b]}").certifies({0, 1, 2, 1});
  }
}

/// Whether a leaf is, of which all is given but the fineness.
bool certified(const std::string& leaf, int segments, const std::string& moved = "") {
  return Asked("  p: {" + leaf + ", segments: " + std::to_string(segments) + "}}\n", "{simplify: p" + moved + "}")
      .certified();
}

TEST_CASE("a patch that meets itself is not certified, at any fineness", "[certify]") {
  const auto patch = [](const std::string& x1, const std::string& x2) {
    return "bezier: {patch: [[[0, 0, 0], [0, 0, 1]], [[" + x1 + ", 1, 0], [" + x1 + ", 1, 1]], [[" + x2 +
           ", 1, 0], [" + x2 + ", 1, 1]], [[1, 0, 0], [1, 0, 1]]]";
  };
  const std::string turned = "revolve: {curve: [[2, 0], {bezier: [[3.1, 1], [1.9, 1]]}, [3, 0]]",
                    up = ", translate: [0, 0, 1]";
  for (const int segments : {3, 4, 7, 16}) {
    INFO(segments << " segments");
    CHECK(certified(patch("0.95", "0.05"), segments, up));
    for (const std::string& loop : {patch("1.1", "-0.1"), turned}) CHECK_FALSE(certified(loop, segments, up));
  }
}

TEST_CASE("patches of one leaf are asked whether they meet beside their common side", "[certify]") {
  // The line of the first patch is crossed by the curve of the second one, or not; nearer and nearer to the
  // corner.
  const auto asked = [](const std::string& height, int segments) {
    const std::string fine = ", segments: " + std::to_string(segments) + "}";
    const std::string turned = "matrix: [[3/5, -4/5, 0, 1], [4/5, 3/5, 0, 0], [0, 0, 1, 2]]}";
    return std::array{Asked("  p: {extrude: {curve: [[1, 0, 0], [0, 0, 0], {bezier: [[1, " + height +
                                ", 0]]}, [1, 1, 0]], vector: [0, 0, 1]" + fine + "}\n",
                            "{simplify: p, " + turned),
                      Asked("  p: {bezier: {patches: [[[[1, 0, 0], [1, 0, 1]], [[1/2, 0, 0], [1/2, 0, 1]], "
                            "[[0, 0, 0], [0, 0, 1]]], [[[0, 0, 0], [0, 0, 1]], [[1, " +
                                height + ", 0], [1, " + height + ", 1]], [[1, 1, 0], [1, 1, 1]]]]" + fine + "}\n",
                            "{simplify: p, " + turned)};
  };
  for (const int segments : {1, 2, 5}) {
    for (const char* height : {"-1/2", "-1/10", "-1/1000", "1/1000", "1/10"}) {
      INFO(segments << " segments, " << height);
      for (const Asked& one : asked(height, segments)) {
        // Where they cross their borders do: of two curves that is not proven.
        CHECK(one.certified() == (height[0] != '-'));
        if (one.certified()) CHECK(one.cells() == Cells{6, 7, 2, 0});
      }
    }
    for (const Asked& one : asked("0", segments)) CHECK_FALSE(one.certified());  // tangent there
  }
}

TEST_CASE("a closed patch is asked whether it meets itself where it closes, and a wire", "[certify]") {
  const auto with = [](const std::string& before, const std::string& after) {
    return [=](const std::string& points) { return before + points + after; };
  };
  // Curves from the origin to it or [1, 0, 0], with a loop or without one; from a point over them.
  const auto closed = with("bezier: {patch: [[[0, 0, 0], [0, 0, 1]], ", ", [[0, 0, 0], [0, 0, 1]]]");
  const auto wire = with("bezier: {curve: [[0, 0, 0], ", ", [1, 0, 0]]");
  const std::string top = "[[0, 0, 1], [0, 0, 1], [0, 0, 1]";
  const auto tent = with("bezier: {patch: [" + top + ", [0, 0, 1]], [[0, 0, 0], ", ", [1, 0, 0]]]");
  const auto cone = with("extrude: {curve: [[0, 0, 0], {bezier: [", "]}, [1, 0, 0]], vector: [0, 0, 1], scale: 0");
  const auto two =
      with("bezier: {patches: [[" + top + "], [[1, 0, 0], [1, 1, 0.1], [0, 1, 0]]], [" + top + "], ", "]]");
  const std::string open = "[[2, -1, 0], [2, -1, 1]], [[2, 2, 0], [2, 2, 1]], [[-1, 1, 0], [-1, 1, 1]]",
                    loop = "[[4, -1, 0], [4, -1, 1]], [[-2, 2, 0], [-2, 2, 1]], [[1, -1, 0], [1, -1, 1]]";
  CHECK_FALSE(certified(tent("[6, 1, 0], [-3, 1, 0]"), 1));  // the loop is within one cell
  CHECK_FALSE(certified(cone("[6, 1, 0], [-3, 1, 0]"), 1));
  CHECK(certified(cone("[0.8, 1, 0], [0.2, 1, 0]"), 16));
  for (const int segments : {6, 16}) {
    INFO(segments << " segments");
    CHECK(certified(tent("[0.95, 1, 0], [0.05, 1, 0]"), segments));
    CHECK_FALSE(certified(tent("[1.1, 1, 0], [-0.1, 1, 0]"), segments));
    CHECK(certified(two("[[0, 1, 0], [-1, 1, 0.1], [-1, 0, 0]]"), segments));
    CHECK_FALSE(certified(two("[[0, 1, 0], [1.2, 0.9, 0], [0.9, 0.1, 0]]"), segments));
    CHECK(certified(closed(open), segments));
    CHECK_FALSE(certified(closed(loop), segments));
    CHECK(certified(wire("[1, 2, 0], [2, 0, 1]"), segments));
    CHECK(certified(wire("[3, 1, 0], [-2, 1, 1]"), 2 * segments));
    CHECK_FALSE(certified(wire("[3, 1, 0], [-2, 1, 0]"), segments));
  }
}

TEST_CASE("pieces of one leaf are asked three at a time, and its curves", "[certify]") {
  // Each with counts of facets that are wrong: what is certified is right, at any fineness.
  struct Own {
    const char* what;
    std::string leaf;
    std::array<std::size_t, 4> cells;
    bool certified = true;  // with 12 segments
  };
  const std::string walls =
      "[[[0, 0, 0], [0.5, 0.25, 0], [1, 0.3, 0]], [[0, 0, 1], [0.5, 0.25, 1], [1, 0.3, 1]]], [[[0, 0, 0], [0.5, "
      "-0.25, 0], [1, -0.3, 0]], [[0, 0, 1], [0.5, -0.25, 1], [1, -0.3, 1]]]";
  const std::string sheet =
      "[[[-1, -1, -0.1], [0, -1, 0.1], [1, -1, -0.1]], [[-1, -0.3, -0.1], [0, 0.34, 0.1], [1, -0.3, -0.1]]]";
  const std::vector<Own> all = {
      {"a wall that passes where two others meet",
       "{bezier: {patches: [" + walls +
           ", [[[0.2, -1, 0], [-0.21, 0, 0], [0.2, 1, 0]], [[0.2, -1, 1], [-0.21, 0, 1], [0.2, 1, 1]]]]}}",
       {10, 11, 3, 0}},
      {"an extruded line that passes its own corner",
       "{extrude: {curve: [[1, 0.3, 0], {bezier: [[0.5, 0.25, 0]]}, [0, 0, 0], {bezier: [[0.5, -0.25, 0]]}, [1, "
       "-0.3, 0], [0.2, -1, 0], {bezier: [[-0.21, 0, 0]]}, [0.2, 1, 0]], vector: [0, 0, 1]}}",
       {10, 13, 4, 0}},
      {"borders of two patches that pass each other",
       "{bezier: {patches: [" + sheet +
           ", [[[0.05, 0.3, -1], [0, -0.3, 0], [-0.1, 0.3, 1]], [[0.05, 1, -1], [0.1, 1, 0], [-0.1, 1, 1]]]]}}",
       {10, 11, 2, 0}},
      {"a wire beside a border",
       "{bezier: {patches: [" + sheet + "], curves: [[[0.1, 0.2, -1], [0, -0.2, 0.1], [-0.1, 0.2, 1]]]}}",
       {7, 6, 1, 0}},
      {"an arc that bulges through a wall",
       "{extrude: {curve: [[0, 0, 0], {bezier: [[1, 4/3, 0]], weights: [1, 3/5, 1]}, [2, 0, 0], [2, 0.4, 0], [0, "
       "0.4, 0]], vector: [0, 0, 1]}}",
       {12, 20, 7, 0},
       false},
      {"arcs of a turned line that cross",
       "{revolve: {curve: [[2, 0], {bezier: [[3, 4/3]], weights: [1, 3/5, 1]}, [4, 0], [4, 0.9], {bezier: [[3, "
       "-13/30]], weights: [1, 3/5, 1]}, [2, 0.9]]}}",
       {0, 6, 7, 0}},
      {"two curves between the same ends",
       "{bezier: {patches: [[[[0, 0, 0], [1, 1, 0.5], [2, 0, 0]], [[0, 1, 2], [1, 2, 2], [2, 1, 2]]], [[[0, 0, "
       "0], [1, -1, -0.5], [2, 0, 0]], [[0, -1, -2], [1, -2, -2], [2, -1, -2]]]]}}",
       {6, 8, 2, 0}},
      {"a flat patch and a curved one between the same ends",
       "{bezier: {patches: [[[[0, 0, 0], [2, 0, 0]], [[0, -2, 0], [2, -2, 0]]], [[[0, 0, 0], [1, -1, 1], [2, 0, "
       "0]], [[0, 0, 2], [1, 0, 2], [2, 0, 2]]]]}}",
       {6, 8, 2, 0},
       false},
      {"two parts of one curve that cross",
       "{bezier: {patches: [[[[0, 0, 0], [1, 1/2, 0], [3/4, 3/4, 0], [1/2, 3/4, 0]], [[0, 0, 1], [1, 1/2, "
       "1], [3/4, 3/4, 1], [1/2, 3/4, 1]]], [[[119/256, 21/64, 0], [37/64, 15/64, 0], [3/4, 1/8, 0], [1, 0, "
       "0]], [[119/256, 21/64, 1], [37/64, 15/64, 1], [3/4, 1/8, 1], [1, 0, 1]]]]}}",
       {10, 13, 4, 0},
       false},
      {"a border that passes through a patch at whose corner it begins",
       "{bezier: {patches: [[[[0, 0, 0], [2, 0, 0], [4, 0, 0.25]], [[0, -3, 0.25], [2, -3, 0], [4, -3, 0]]], "
       "[[[0, 0, 0], [1/3, -1, 2], [4/3, -1, -3], [2, -1, 3]], [[0, 0, 3], [1/3, -1, 5], [4/3, -1, 0], [2, "
       "-1, 6]]]]}}",
       {9, 11, 3, 0}},
      {"a wall that goes on smoothly",
       "{extrude: {profile: [[-1, -1, 0], [0, -1, 0], {bezier: [[1, -1, 0]], weights: [1, 1, 2]}, [1, 0, 0], "
       "[1, 1, 0], [-1, 1, 0]], vector: [0, 0, 1]}}",
       {10, 15, 7, 1}},
      {"a rounded rim",
       "{revolve: {profile: [[0, 0], [2, 0], [2, 1], {bezier: [[2, 2]], weights: [1, 1, 2]}, [1, 2], [0, 2]]}}",
       {0, 3, 4, 1}},
      {"a bend with flat walls",
       "{sweep: {profile: [[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1]], path: [[0, 0, 0], [5, 0, 0], [5, 5, 0]], "
       "radius: 2}}",
       {16, 28, 14, 1}},
      {"a flat patch with curved sides",
       "{bspline: {patch: {points: [[[0, 0, 0], [1, -1, 0], [2, 0, 0], [3, 1, 0]], [[1, 5, 0], [2, 4, 0], [3, 5, "
       "0], [4, 6, 0]]], degree: [2, 1]}}}",
       {4, 4, 1, 0}},
      {"a flat ring with a wall at its inner side",
       "{revolve: {curve: [[1, 1], [1, 0], [2, 0]], axis: [1, 2, 2]}}",
       {0, 3, 2, 0}},
      {"walls in one plane with curved ends",
       "{extrude: {curve: [[0, 0, 0], {bezier: [[1, 1, 0]]}, [2, 0, 0], {bezier: [[3, -1, 0]]}, [5, 0, 0]], "
       "vector: [1/3, 2, 0]}}",
       {6, 7, 2, 0}},
      {"a curve that is extruded to a point",
       "{extrude: {curve: [[0, 0, 0], {bezier: [[1, 0, 1]]}, [2, 0, 0]], vector: [0, 1, 0], scale: 0, center: [1, "
       "0, -1]}}",
       {3, 3, 1, 0}},
      {"a flat patch that is folded",
       "{bezier: {patch: [[[0, 0, 0], [5, 0, 0], [2, 0, 0]], [[0, 2, 0], [5, 2, 0], [2, 2, 0]]]}}",
       {0, 0, 0, 0},
       false},
      {"a wire that returns to the patch at whose corner it begins",
       "{bezier: {patches: [[[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 2, 0], [1, 2, 1], [2, 2, 0]]]], curves: "
       "[[[0, 0, 0], [1, 0.3, 0.975], [2, 1, 0.45]]]}}",
       {6, 6, 1, 0},
       false}};
  for (const Own& own : all) {
    for (const int segments : {1, 3, 4, 6, 12}) {
      INFO(own.what << ", " << segments << " segments");
      std::string leaf = own.leaf;
      leaf.insert(leaf.size() - 2, ", segments: " + std::to_string(segments));
      const Asked asked("  a: " + leaf + "\n", "{simplify: a}");
      if (segments == 12 && own.certified) CHECK(asked.certified());
      if (asked.certified()) CHECK(asked.cells() == own.cells);
    }
  }
}

TEST_CASE("one surface in two drawings is not certified, nor corners that are rounded or moved", "[certify]") {
  // Equal ellipses; no common lines are known for leaves that are stretched otherwise.
  CHECK_FALSE(
      Asked("  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 6}, scale: [2, 1, 1]}\n"
            "  b: {cylinder: {from: [0, 0, 1/2], to: [0, 0, 3/2], radius: 2, segments: 12}, scale: [1, 1/2, 1]}\n",
            "{sum: [a, b]}")
          .certified());
  // Rounded, the corner is inside of the ball.
  CHECK_FALSE(Asked("  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 10}}\n"
                    "  b: {polyline: [[-2647149443198255/9007199254740992, -8147088261773907/9007199254740992, "
                    "347922205179541/1125899906842624], [-1, -2, 1]]}\n",
                    "{sum: [a, b]}")
                  .certified());
  // The pole meets the wire half way.
  CHECK_FALSE(Asked("  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}\n"
                    "  b: {polyline: [[0, 0, 1.01], [0, 0, 2]]}\n",
                    "{sum: [a, b]}", AskedProof::to_the_end, 1, "weld: 0.03\n")
                  .certified());
  // Two facets that are one.
  Asked(
      "  a: {extrude: {curve: [[0, 0, 0], {bezier: [[1, 0, 0], [0, 1, 0]]}, [0, 0, 0]], vector: [0, 0, 1], "
      "segments: 2}}\n",
      "{simplify: a}")
      .certifies({0, 2, 1, 0});
}

TEST_CASE("what is left is told with its place", "[certify]") {
  const Asked asked(kViviani, "{union: [a, b]}", AskedProof::within_budget);
  REQUIRE(!asked.certificate().places.empty());
  const UncertainPlace& place = asked.certificate().places[0];
  CHECK(place.why == UncertainPlace::Why::near);
  CHECK(place.names == std::vector<std::string>{"`a` (cylinder side)", "`b` (sphere)"});
  CHECK(std::abs(place.at[0] - 2) < 0.1);
  const std::vector<Diagnostic> notices = asked.certificate().notices(asked.tree, 1);
  REQUIRE(notices.size() == 1);
  CHECK_THAT(notices[0].text(),
             Catch::StartsWith("t.yaml:3:7: notice: `a` (cylinder side) and `b` (sphere) near ["));
}

TEST_CASE("surfaces that cross at a good angle are certified as they are drawn", "[certify]") {
  for (const char* leaves :
       {"  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 2}}\n"
        "  b: {cylinder: {from: [-5, 0.3, 2], to: [5, 0.3, 2], radius: 0.7}}\n",
        "  a: {sphere: {center: [0, 0, 0], radius: 1}}\n"
        "  b: {sphere: {center: [1.5, 0.1, 0.05], radius: 1}}\n",
        "  a: {cylinder: {from: [-4, 0, 0.3], to: [4, 0, 0.3], radius: 1, segments: 31}}\n"
        "  b: {box: {min: [-5, -5, -1], max: [5, 5, 0]}}\n",
        "  a: {bezier: {patch: [[[0, 0, 0], [1, 0, 1]], [[0, 1, 1], [1, 1, 0]]]}}\n"
        "  b: {polyline: [[0.1, 0.2, 0], [0.9, 0.9, 1]]}\n",
        // One surface, drawn alike; a bore with a plug.
        "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 2}}\n"
        "  b: {cylinder: {from: [0, 0, 1], to: [0, 0, 5], radius: 2, segments: 20}}\n",
        // Nothing is curved, or nothing meets.
        "  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  b: {box: {min: [0, 0, 0], max: [2, 2, 1]}}\n",
        "  a: {sphere: {center: [0, 0, 0], radius: 1}}\n  b: {points: [[5, 5, 5]]}\n"}) {
    INFO(leaves);
    CHECK(Asked(leaves, "{union: [a, b]}", AskedProof::within_budget).certified());
  }
}

TEST_CASE("planes and edges through poles of balls and tips of cones are certified", "[certify]") {
  const std::string octant = "  b: {box: {min: [0, 0, 0], max: [3, 3, 3]}}\n";
  const std::string half = "  b: {halfspace: {point: [0, 0, 0], normal: [1, 0, 0]}}\n";
  const std::string cone = "  a: {cone: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: ";
  for (const int segments : {5, 8, 24, 48}) {
    const std::string end = std::to_string(segments) + "}}\n",
                      ball = "  a: {sphere: {center: [0, 0, 0], radius: 1, segments: " + end;
    CAPTURE(segments);
    for (const auto& [what, leaves, result, cells] :
         {Known{"an octant out of a ball", ball + octant, "{difference: [a, b]}", {4, 6, 4, 1}},
          Known{"half a ball", ball + half, "{intersection: [a, b]}", {0, 1, 2, 1}},
          Known{"a wire from pole to pole",
                ball + "  b: {polyline: [[0, 0, -2], [0, 0, 2]]}\n",
                "{union: [a, b]}",
                {4, 3, 1, 1}},
          Known{"a quarter out of a cone", cone + end + octant, "{difference: [a, b]}", {4, 6, 4, 1}},
          Known{"a plane along the axis of a cone", cone + end + half, "{intersection: [a, b]}", {3, 4, 3, 1}}}) {
      INFO(what);
      Asked(leaves, result).certifies(cells);
    }
  }
}

void check_contact(const std::string& leaves, const char* result, AskedProof proof, const Cells& cells) {
  for (const int finer : {1, 2}) {
    INFO(leaves << finer);
    const Asked asked(leaves, result, proof, finer);
    CHECK(asked.certificate().contacts > 0);
    asked.certifies(cells);
  }
}

TEST_CASE("contacts of planes and quadrics are certified where they are drawn", "[certify]") {
  const std::string slab = "  a: {box: {min: [-5, -5, -1], max: [5, 5, 0]}}\n";
  const std::string one = "  a: {sphere: {center: [0, 0, 0], radius: 1}}\n";
  const std::string pipe = "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1}}\n";
  const std::string turned = ", rotate: {axis: [-1, -2, -1], degrees: 156}}\n";
  for (const auto& [leaves, cells] : std::vector<std::pair<std::string, Cells>>{
           {slab + "  b: {cylinder: {from: [-4, 0, 1], to: [4, 0, 1], radius: 1}}\n", {10, 15, 9, 2}},
           {slab + "  b: {sphere: {center: [0.3, 0.2, 1], radius: 1}}\n", {9, 12, 7, 2}},
           {one + "  b: {sphere: {center: [1.2, 1.6, 0], radius: 1}}\n", {1, 0, 2, 2}},
           {pipe + "  b: {cylinder: {from: [2, 0, 1], to: [2, 0, 5], radius: 1}}\n", {2, 5, 6, 2}},
           {pipe + "  b: {cylinder: {from: [2, 0, 1], to: [2, 0, 3], radius: 1}}\n", {2, 5, 6, 2}},
           {pipe + "  b: {cylinder: {from: [2, -3, 2], to: [2, 4, 2], radius: 1}}\n", {1, 4, 6, 2}},
           {pipe + "  b: {sphere: {center: [0, 0, 2], radius: 1}}\n", {0, 2, 3, 1}},
           {"  a: {cone: {from: [0, 0, 0], to: [0, 0, 49/50], radius: 84/25, segments: 9}}\n"
            "  b: {sphere: {center: [7/4, 0, 73/100], radius: 1/4, segments: 24, rings: 4}}\n",
            {1, 1, 3, 2}},
           // A plane along a ruling, whose end is on the rim, in a frame of no simple numbers.
           {"  a: {cone: {from: [0, 0, 0], to: [0, 0, 28/17], radius: 105/34, segments: 16}" + turned +
                "  b: {halfspace: {point: [3360/4913, 0, 6300/4913], normal: [-8/17, 0, -15/17]}" + turned,
            {2, 2, 3, 2}}}) {
    check_contact(leaves, "{union: [a, b]}", AskedProof::within_budget, cells);
  }
}

TEST_CASE("contacts of tori are certified where they are drawn", "[certify]") {
  const std::string slab = "  a: {box: {min: [-4, -4, -1], max: [4, 4, 0]}}\n";
  const std::string ring = "  a: {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1}}\n";
  for (const auto& [leaves, cells] : std::vector<std::pair<std::string, Cells>>{
           {slab + "  b: {torus: {center: [0, 0, 3], axis: [3/5, 4/5, 0], radius: 2, tube: 1, segments: 9}}\n",
            {1, 0, 0, 0}},
           {slab + "  b: {torus: {center: [0, 0, 1], axis: [0, 0, 1], radius: 2, tube: 1}}\n", {0, 1, 0, 0}},
           {"  a: {torus: {center: [2, 4/3, 3], axis: [-12/13, 0, 5/13], radius: 1, tube: 1/3, segments: 6}}\n"
            "  b: {sphere: {center: [14/13, 7/3, 44/13], radius: 2/3, segments: 15, rings: 5}}\n",
            {1, 0, 0, 0}},
           {ring + "  b: {cylinder: {from: [6, -2, 0], to: [6, 4, 0], radius: 2}}\n", {1, 0, 0, 0}},
           {ring + "  b: {torus: {center: [7.5, 0, 0], axis: [0, 0, 1], radius: 3, tube: 0.5}}\n",
            {1, 0, 0, 0}}}) {
    check_contact(leaves, "{intersection: [a, b]}", AskedProof::to_the_end, cells);
  }
}

// A cylinder lies on a floor along a line; whether a ball beside it reaches that line is in the counts.
TEST_CASE("what is near a contact is asked with it", "[certify]") {
  for (const char* const y : {"0.29", "0.2999", "0.299999", "0.3", "0.300001", "0.3001", "0.31"}) {
    for (const int finer : {1, 2}) {
      INFO("y = " << y << ", --finer " << finer);
      const Asked asked(
          "  a: {box: {min: [-3, -3, -1], max: [3, 3, 0]}}\n"
          "  b: {cylinder: {from: [-2, 0, 1], to: [2, 0, 1], radius: 1}}\n"
          "  c: {sphere: {center: [1/7, " +
              std::string(y) + ", 2/5], radius: 1/2}}\n",
          "{sum: [a, b, c]}", AskedProof::to_the_end, finer);
      CHECK(asked.certified() == (std::string(y) != "0.3"));  // there it touches the line
      if (asked.certified()) CHECK(asked.cells() == (y[2] == '2' ? Cells{12, 21, 17, 6} : Cells{10, 17, 14, 5}));
    }
  }
}

// Of each facets have other counts than surfaces, and more of them the same.
TEST_CASE("what lies between facets and surfaces counts: faces, wires, points, what is below a joined node",
          "[certify]") {
  const std::string ball = "  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 24}}\n";
  for (const auto& [leaves, result] : std::vector<std::pair<std::string, std::string>>{
           // A chord of the side lies in the face: facets overlap and surfaces do not.
           {"  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 5, segments: 4}}\n"
            "  b: {polygon: [[10, -5, -1], [-5, 10, -1], [-5, 10, 2], [10, -5, 2]]}\n",
            "{union: [a, b]}"},
           {ball + "  b: {points: [[0.9955, 0.06, 0.06]]}\n", "{intersection: [a, b]}"},
           {ball + "  b: {polyline: [[0.9955, -5, 0.06], [0.9955, 5, 0.06]]}\n", "{union: [a, b]}"},
           {ball + "  b: {extrude: {curve: [[-3, 0.2, -3], [0.977, 0.2, -3], [3, 0.2, -3]], vector: [0, 0, 6]}}\n",
            "{union: [a, b]}"},
           {"  a: {cone: {from: [18, -1, 22], to: [31, 22, 20], radius: 23, top: 1, segments: 6}}\n"
            "  b: {plane: {point: [13, 0, 0], normal: [1, 2, 3]}}\n",
            "{union: [a, b]}"},
           // The end of a wire, straight or curved.
           {ball + "  b: {polyline: [[0.9955, 0.06, 0.06], [3, 0.1, 0.2]]}\n", "{sum: [a, b]}"},
           {ball + "  b: {bezier: {curve: [[0.9955, 0.06, 0.06], [2, 0.1, 0.5], [3, 0.1, 0.2]]}}\n",
            "{sum: [a, b]}"},
           {ball + "  b: {sphere: {center: [1.1994, 1.5992, 0], radius: 1, segments: 24}}\n",
            "{simplify: {of: {union: [a, b]}, within: 0.0001}}"}}) {
    INFO(leaves);
    const Asked asked(leaves, result, AskedProof::within_budget), as_drawn(leaves, result, AskedProof::none);
    CHECK(asked.certified() == !result.starts_with("{simplify"));  // of what is joined facets alone are known
    CHECK(asked.certificate().places.empty());
    CHECK(asked.cells() != as_drawn.cells());
    if (asked.certified()) CHECK(asked.cells() == Asked(leaves, result, AskedProof::none, 16).cells());
  }
  CHECK(Asked(ball + "  b: {polyline: [[-5, 0.1, 0.06], [5, 0.2, 0.06]]}\n", "{union: [a, b]}").certified());
}

}  // namespace
}  // namespace cnrg
