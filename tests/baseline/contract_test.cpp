// What operands may be, what failures say, and what results promise.
#include <algorithm>
#include <set>

#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"

namespace cnrg::bench::baseline_test {
namespace {

using mantyla::Failure;
using mantyla::Stage;

/// The stage and message of the failure; both versions fail alike.
std::pair<Stage, std::string> failure_of(const Model& a, const Model& b, Operation operation = Operation::unite) {
  std::string message;
  Stage stage = Stage::output;
  try {
    mantyla::boolean_exact(a, b, operation);
    FAIL("no failure");
  } catch (const Failure& failure) {
    stage = failure.stage();
    message = failure.what();
  }
  try {
    mantyla::boolean_double(a, b, operation);
    FAIL("no failure in doubles");
  } catch (const Failure& failure) {
    CHECK(failure.stage() == stage);
    CHECK(failure.what() == message);
  }
  return {stage, message};
}

void check_input_failure(const Model& bad, const std::string& part) {
  const Model good = box({0, 0, 0}, {1, 1, 1});
  for (const bool first : {true, false}) {
    const auto [stage, message] = first ? failure_of(bad, good) : failure_of(good, bad);
    CHECK(stage == Stage::input);
    CHECK_THAT(message, Catch::StartsWith(first ? "operand A: " : "operand B: ") && Catch::Contains(part));
  }
}

}  // namespace

TEST_CASE("operands that are no 2-manifold solids are refused") {
  const Model cube = box({0, 0, 0}, {2, 2, 2});
  Model model = cube;
  model.faces.pop_back();
  check_input_failure(model, "open");
  model = cube;
  model.faces[0].solid = false;
  check_input_failure(model, "no closed 2-manifold");
  model = cube;
  model.wires.push_back({0, 6});
  check_input_failure(model, "wires");
  model = cube;
  std::swap(model.faces[0].loops[0][0], model.faces[0].loops[0][1]);
  check_input_failure(model, "turned");
  model = cube;
  model.points[7] = {3, 2, 2};
  check_input_failure(model, "not planar");
  model = cube;
  for (auto& face : model.faces) std::reverse(face.loops[0].begin(), face.loops[0].end());
  check_input_failure(model, "inward");
  model = cube;
  model.faces[0].loops[0].pop_back();
  model.faces[0].loops[0].pop_back();
  check_input_failure(model, "less than three corners");
}

TEST_CASE("a cone of two sheets at one vertex is refused") {
  // Two pyramids tip to tip, the tip one point.
  Model model;
  model.points = {{0, 0, 0},  {1, 1, 1},   {-1, 1, 1},   {-1, -1, 1}, {1, -1, 1},
                  {1, 1, -1}, {-1, 1, -1}, {-1, -1, -1}, {1, -1, -1}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t up = 1 + k, next_up = 1 + (k + 1) % 4, down = 5 + k, next_down = 5 + (k + 1) % 4;
    model.faces.push_back({{{0, next_up, up}}, true});
    model.faces.push_back({{{0, down, next_down}}, true});
  }
  model.faces.push_back({{{1, 2, 3, 4}}, true});
  model.faces.push_back({{{8, 7, 6, 5}}, true});
  check_input_failure(model, "touch");
}

TEST_CASE("nothing is an operand, too") {
  const Model cube = box({0, 0, 0}, {2, 2, 2}), nothing;
  CHECK(volume_of(mantyla::boolean_exact(cube, nothing, Operation::unite)) == 8);
  CHECK(volume_of(mantyla::boolean_exact(nothing, cube, Operation::unite)) == 8);
  CHECK(mantyla::boolean_exact(cube, nothing, Operation::intersect).faces.empty());
  CHECK(volume_of(mantyla::boolean_exact(cube, nothing, Operation::subtract)) == 8);
  CHECK(mantyla::boolean_exact(nothing, cube, Operation::subtract).faces.empty());
  CHECK(mantyla::boolean_double(nothing, nothing, Operation::unite).faces.empty());
}

TEST_CASE("several shells: a cavity and parts apart") {
  const Model hollow =
      mantyla::boolean_exact(box({0, 0, 0}, {6, 6, 6}), box({1, 1, 1}, {5, 5, 5}), Operation::subtract);
  CHECK(counts_of(hollow).shells == 2);
  const Model bits =
      mantyla::boolean_exact(box({2, 2, 2}, {3, 3, 3}), box({7, 0, 0}, {8, 1, 1}), Operation::unite);
  CHECK(counts_of(bits).shells == 2);
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    INFO(to_string(operation));
    const Model answer = mantyla::boolean_exact(hollow, bits, operation);
    CHECK(truth_of(hollow, bits, operation, answer).same_set);
    const Model through = box({-1, 2, 2}, {9, 3, 3});
    const Model drilled = mantyla::boolean_exact(hollow, through, operation);
    CHECK(truth_of(hollow, through, operation, drilled).same_set);
  }
}

TEST_CASE("an edge through the middle of a face that it lies on") {
  // Of a small tetrahedron that stands on the centroid of one of the triangles of the cube's first face.
  const Model cube = placed(fanned(box({-1, -1, -1}, {1, 1, 1})), {1, -1, 0, 0}, 1, {0, 0, 0});
  for (const std::uint32_t p : cube.faces[0].loops[0]) CHECK(cube.points[p][2] == 1);
  for (const int x : {-1, 1})
    for (const int y : {-1, 1}) {
      const Model standing =
          placed(tetrahedron(), {1, 0, 0, 0}, Rational(1, 9), {Rational(x, 3), Rational(y, 3), Rational(10, 9)});
      CHECK(volume_of(mantyla::boolean_exact(cube, standing, Operation::unite)) == 8 + Rational(8, 3 * 729));
      CHECK(volume_of(mantyla::boolean_exact(cube, standing, Operation::subtract)) == 8);
      CHECK(mantyla::boolean_exact(cube, standing, Operation::intersect).faces.empty());
    }
}

// The point set of such an operand is no 2-manifold at the contact, although its representation is: the book's
// classifiers see one neighbourhood at a time. They fail only where the other boundary crosses there.
TEST_CASE("a vertex that crosses a boundary where that touches itself") {
  const Model pair =
      mantyla::boolean_exact(box({0, 0, 0}, {2, 2, 2}), box({2, 2, 2}, {4, 4, 4}), Operation::unite);
  CHECK(duplicates_of(pair) == 1);
  const Model across = box({0, 0, 2}, {2, 3, 3});
  const auto [stage, message] = failure_of(pair, across, Operation::unite);
  CHECK(stage == Stage::null_edges);
  CHECK_THAT(message, Catch::Contains("touches itself"));
  const Model clear = box({1, 1, 3}, {3, 3, 5});
  const Model answer = mantyla::boolean_exact(pair, clear, Operation::unite);
  CHECK(truth_of(pair, clear, Operation::unite, answer).same_set);
}

TEST_CASE("an epsilon that swallows the operand is a failure, not a result") {
  const Model small = placed(box({0, 0, 0}, {1, 1, 1}), {1, 0, 0, 0}, Rational(1, 1000), {0, 0, 0});
  const Model large = box({-1, -1, -1}, {1, 1, 1});
  const Model right = mantyla::boolean_double(large, small, Operation::subtract, 1e-10);
  CHECK(to_double(volume_of(right)) == Approx(8 - 1e-9).epsilon(1e-15));
  CHECK_THROWS_AS(mantyla::boolean_double(large, small, Operation::subtract, 0.1), Failure);
}

TEST_CASE("faces of double results are triangles of doubles, those of exact ones planar") {
  const Model a = frame(), b = placed(frame(), {3, 1, 2, 1}, Rational(7, 9), {Rational(1, 3), 0, Rational(1, 5)});
  const Model rounded_answer = mantyla::boolean_double(a, b, Operation::subtract);
  for (const Model::Face& face : rounded_answer.faces) {
    CHECK(face.loops.size() == 1);
    CHECK(face.loops[0].size() == 3);
    CHECK(face.solid);
  }
  for (const RationalPoint& p : rounded_answer.points)
    for (const Rational& x : p) CHECK(is_double(x));
  const Model exact = mantyla::boolean_exact(a, b, Operation::subtract);
  std::size_t rings = 0;
  for (const Model::Face& face : exact.faces) rings += face.loops.size() - 1;
  CHECK(rings == counts_of(exact).rings);
}

TEST_CASE("stages have names") {
  std::set<std::string> names;
  for (int s = 0; s <= static_cast<int>(Stage::output); ++s)
    names.insert(mantyla::to_string(static_cast<Stage>(s)));
  CHECK(names.size() == 7);
  CHECK(names.count("null_edges") == 1);
}

}  // namespace cnrg::bench::baseline_test
