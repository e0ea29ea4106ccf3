// Verdicts on results that are made by hand, right and wrong in each way.
#include "bench/sweep/judge.h"

#include <algorithm>

#include "tests/catch.h"
#include "tests/sweep/models.h"

namespace cnrg::bench {
namespace {

constexpr double kDouble = 1e-12;  // what a system in doubles states
const Rational kTiny("1/1000000000000000");

const Model kCube = box({0, 0, 0}, {2, 2, 2});
/// Along an edge of the cube.
const Model kAtEdge = box({2, 2, 0}, {4, 4, 2});

TEST_CASE("the exact point set is the same, however its faces are cut") {
  const Problem problem = problem_of(kCube, Operation::unite, box({1, 0, 0}, {3, 2, 2}));
  const Judgement whole = judge(problem, box({0, 0, 0}, {3, 2, 2}), 0);
  CHECK(whole.verdict == Verdict::same);
  CHECK(whole.message.empty());
  CHECK(whole.facts->volume == "12");
  CHECK(whole.facts->vertices == 8);
  CHECK(whole.facts->edges == 12);
  CHECK(whole.facts->faces == 6);
  CHECK(whole.facts->shells == 1);
  CHECK(whole.facts->genus == 0);
  CHECK(whole.truth.volume == "12");
  // Two boxes with a common wall are the same set, but each corner of the wall is there twice.
  const Judgement halves = judge(problem, together(box({0, 0, 0}, {1, 2, 2}), box({1, 0, 0}, {3, 2, 2})), 0);
  CHECK(halves.verdict == Verdict::same);
  CHECK(halves.duplicates == 4);
  CHECK(judge(problem, box({0, 0, 0}, {3, 2, 2}), kDouble).verdict == Verdict::same);
}

TEST_CASE("too much and too little are wrong, with their part of the volume") {
  const Problem problem = problem_of(kCube, Operation::unite, box({1, 0, 0}, {3, 2, 2}));
  for (const double rounding : {0.0, kDouble}) {
    CAPTURE(rounding);
    const Judgement less = judge(problem, box({0, 0, 0}, {2, 2, 2}), rounding);
    CHECK(less.verdict == Verdict::wrong);
    CHECK(less.missing == Approx(1.0 / 3));
    CHECK(less.excess == 0);
    CHECK(less.stage == "volume");
    CHECK_FALSE(less.message.empty());
    const Judgement more = judge(problem, box({0, 0, 0}, {4, 2, 2}), rounding);
    CHECK(more.verdict == Verdict::wrong);
    CHECK(more.excess == Approx(1.0 / 3));
    CHECK(judge(problem, {}, rounding).verdict == Verdict::wrong);
  }
  // What is wrong by a hair is wrong for an exact system only.
  const Model hair = box({0, 0, 0}, {3 + kTiny, 2, 2});
  CHECK(judge(problem, hair, 0).verdict == Verdict::wrong);
  CHECK(judge(problem, hair, kDouble).verdict == Verdict::same);
}

TEST_CASE("a surface that is not closed or crosses itself inside out is no result") {
  const Problem problem = problem_of(kCube, Operation::unite, box({1, 0, 0}, {3, 2, 2}));
  Model open = box({0, 0, 0}, {3, 2, 2});
  open.faces.pop_back();
  const Judgement j = judge(problem, open, 0);
  CHECK(j.verdict == Verdict::wrong);
  CHECK(j.stage == "surface");
  CHECK(j.message.find("bounds no solid") != std::string::npos);
  CHECK_FALSE(j.facts.has_value());
  CHECK(j.truth.volume == "12");
}

TEST_CASE("faces that wind around the solid twice or inwards are no result") {
  const Problem problem = problem_of(kCube, Operation::unite, box({1, 0, 0}, {3, 2, 2}));
  const Model right = box({0, 0, 0}, {3, 2, 2});
  Model inside_out = right;
  for (Model::Face& face : inside_out.faces) std::reverse(face.loops[0].begin(), face.loops[0].end());
  for (const double rounding : {0.0, kDouble}) {
    CAPTURE(rounding);
    CHECK(judge(problem, inside_out, rounding).stage == "surface");
    CHECK(judge(problem, together(right, right), rounding).stage == "surface");
    CHECK(judge(problem, together(kCube, box({1, 0, 0}, {3, 2, 2})), rounding).stage == "surface");  // not united
    CHECK(judge(problem, together(right, box({1, 1, 1}, {2, Rational("3/2"), 2})), rounding).stage == "surface");
  }
}

TEST_CASE("a spike and a point at infinity are no rounding") {
  const Problem problem = problem_of(kCube, Operation::unite, box({1, 0, 0}, {3, 2, 2}));
  Model spike = box({0, 0, 0}, {3, 2, 2});
  const Rational far = 100, thin("1/1000000000000000000000000");
  spike = together(spike, box({far, 0, 0}, {far + thin, thin, thin}));
  CHECK(judge(problem, spike, kDouble).verdict == Verdict::wrong);
  Model huge = box({0, 0, 0}, {3, 2, 2});
  huge.points[7] = {from_double(1e308), from_double(1e308), from_double(1e308)};
  const Model triangles = model_of([&] {
    TriangleMesh mesh = rounded_mesh(huge);
    mesh.polygons.clear();
    return mesh;
  }());
  CHECK(judge(problem, triangles, kDouble).verdict == Verdict::wrong);
}

TEST_CASE("edges that overlap in part at a contact are two") {
  // Along a part of the edge, so that no vertices coincide.
  const Model other = box({2, 2, Rational("1/2")}, {3, 3, 1});
  const Problem problem = problem_of(kCube, Operation::unite, other);
  const Judgement j = judge(problem, together(kCube, other), 0);
  CHECK(j.duplicates == 0);
  CHECK(j.verdict == Verdict::contact_duplicated);
}

TEST_CASE("a contact that is kept in part is lost") {
  const Model edge = box({2, 2, 0}, {3, 3, 2}), corner = box({-1, -1, 2}, {0, 0, 3});
  Problem problem = problem_of(kCube, Operation::unite, edge);
  problem.operands.push_back(corner);
  problem.steps.push_back(Operation::unite);
  const Model kept = welded(together(kCube, corner));
  CHECK(judge(problem, welded(together(kept, edge)), kDouble).verdict == Verdict::same);
  CHECK(judge(problem, together(kept, moved(edge, {kTiny, 0, 0})), kDouble).verdict == Verdict::contact_lost);
}

TEST_CASE("where comparing takes too long, a volume that is far off is wrong") {
  const Problem problem = problem_of(kCube, Operation::unite, box({1, 0, 0}, {3, 2, 2}));
  CHECK(judge_by_volume(problem, box({0, 0, 0}, {3, 2, 2}), 0).verdict == Verdict::unjudged);
  const Judgement j = judge_by_volume(problem, kCube, kDouble);
  CHECK(j.verdict == Verdict::wrong);
  CHECK(j.stage == "volume");
  CHECK(j.missing == Approx(1.0 / 3));
}

TEST_CASE("a non-manifold contact is there once, twice, or lost") {
  const Problem problem = problem_of(kCube, Operation::unite, kAtEdge);
  const Judgement twice = judge(problem, together(kCube, kAtEdge), 0);
  CHECK(twice.verdict == Verdict::contact_duplicated);
  CHECK(twice.duplicates == 2);
  CHECK(twice.truth.non_manifold_edges == 1);
  CHECK(twice.truth.shells == 2);
  CHECK(twice.truth.edges == 23);
  CHECK(judge(problem, welded(together(kCube, kAtEdge)), 0).verdict == Verdict::same);
  CHECK(judge(problem, welded(together(kCube, kAtEdge)), kDouble).verdict == Verdict::same);
  CHECK(judge(problem, together(kCube, kAtEdge), kDouble).verdict == Verdict::contact_duplicated);
  const Model apart = together(kCube, moved(kAtEdge, {kTiny, 0, 0}));
  CHECK(judge(problem, apart, kDouble).verdict == Verdict::contact_lost);
  CHECK(judge(problem, apart, 0).verdict == Verdict::wrong);
}

TEST_CASE("a contact at a vertex") {
  const Model other = box({2, 2, 2}, {3, 3, 3});
  const Problem problem = problem_of(kCube, Operation::unite, other);
  const Judgement j = judge(problem, welded(together(kCube, other)), 0);
  CHECK(j.verdict == Verdict::same);
  CHECK(j.truth.non_manifold_edges == 0);
  CHECK(j.truth.non_manifold_vertices == 1);
  CHECK(j.truth.shells == 2);
  CHECK(judge(problem, together(kCube, other), 0).verdict == Verdict::contact_duplicated);
}

TEST_CASE("what the operation makes of lower dimension may be lost by regularization") {
  const Problem problem = problem_of(kCube, Operation::intersect, box({2, 1, 1}, {4, 3, 3}));
  const Model wall = sheet({{2, 1, 1}, {2, 2, 1}, {2, 2, 2}, {2, 1, 2}});
  const Judgement empty = judge(problem, {}, 0);
  CHECK(empty.verdict == Verdict::same_regularized);
  CHECK(empty.truth.dangling_faces == 1);
  CHECK(judge(problem, wall, 0).verdict == Verdict::same);
  CHECK(judge(problem, {}, kDouble).verdict == Verdict::same_regularized);
  CHECK(judge(problem, wall, kDouble).verdict == Verdict::same);
  // A wall where there is none.
  CHECK(judge(problem, sheet({{2, 1, 1}, {2, 3, 1}, {2, 3, 2}, {2, 1, 2}}), 0).verdict == Verdict::wrong);
  CHECK(judge(problem, sheet({{2, 1, 1}, {2, 3, 1}, {2, 3, 2}, {2, 1, 2}}), kDouble).verdict == Verdict::wrong);
}

TEST_CASE("surfaces and wires of operands may be lost") {
  const Model fault = sheet({{1, 3, -1}, {1, 3, 3}, {1, 5, 3}, {1, 5, -1}});
  const Problem problem = problem_of(kCube, Operation::unite, fault);
  for (const double rounding : {0.0, kDouble}) {
    CAPTURE(rounding);
    const Judgement lost = judge(problem, kCube, rounding);
    CHECK(lost.verdict == Verdict::dangling_lost);
    CHECK(lost.truth.dangling_faces == 1);
    CHECK(judge(problem, together(kCube, fault), rounding).verdict == Verdict::same);
  }
  const Model bolt = wire({1, 1, 1}, {1, 1, 5});
  const Problem bolted = problem_of(kCube, Operation::unite, bolt);
  for (const double rounding : {0.0, kDouble}) {
    const Judgement lost = judge(bolted, kCube, rounding);
    CHECK(lost.verdict == Verdict::dangling_lost);
    CHECK(lost.truth.dangling_edges == 1);
    CHECK(lost.truth.dangling_vertices == 0);
    CHECK(judge(bolted, together(kCube, bolt), rounding).verdict == Verdict::same);
  }
}

TEST_CASE("shells and genus of the exact result") {
  // A frame: a plate with a square hole through it.
  const Problem frame = problem_of(box({0, 0, 0}, {3, 3, 1}), Operation::subtract, box({1, 1, -1}, {2, 2, 2}));
  const Facts facts = exact_facts(frame);
  CHECK(facts.volume == "8");
  CHECK(facts.genus == 1);
  CHECK(facts.shells == 1);
  CHECK(facts.faces == 10);
  // A cavity is a shell of its own.
  const Facts hollow =
      exact_facts(problem_of(box({0, 0, 0}, {3, 3, 3}), Operation::subtract, box({1, 1, 1}, {2, 2, 2})));
  CHECK(hollow.shells == 2);
  CHECK(hollow.genus == 0);
  CHECK(hollow.regions == 1);
}

TEST_CASE("a rounded result of the right volume and another topology is right within its rounding") {
  const Model low = box({1, 0, 0}, {3, 1, 1});
  const Problem problem = problem_of(kCube, Operation::unite, low);
  Model right = kCube;  // an L, by what the exact result is known to be
  right.points = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
                  {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {3, 0, 1}, {3, 1, 1}, {2, 1, 1}, {2, 0, 1}};
  right.faces.clear();
  for (const auto& loop : std::vector<std::vector<std::uint32_t>>{{0, 5, 4, 3, 2, 1},
                                                                  {6, 7, 8, 9},
                                                                  {0, 6, 9, 5},
                                                                  {5, 9, 8, 4},
                                                                  {0, 1, 10, 13, 7, 6},
                                                                  {1, 2, 11, 10},
                                                                  {2, 3, 12, 11},
                                                                  {10, 11, 12, 13},
                                                                  {3, 4, 8, 7, 13, 12}})
    right.faces.push_back({{loop}, true});
  CHECK(judge(problem, right, 0).verdict == Verdict::same);
  const Rational x("5/2");
  const Judgement j =
      judge(problem, together(right, box({x, x - 1, x - 1}, {x + kTiny, x - 1 + kTiny, x - 1 + kTiny})), kDouble);
  CHECK(j.verdict == Verdict::within_rounding);
  CHECK_THAT(j.message, Catch::Contains("2 shells of genus 0 instead of 1 of 0") &&
                            Catch::Contains("thinner than the rounding"));
  CHECK_FALSE(is_failure(j.verdict));
}

TEST_CASE("a sliver where solids only touch is within the rounding") {
  const Problem problem = problem_of(kCube, Operation::intersect, kAtEdge);
  const Model sliver = box({2 - kTiny, 2 - kTiny, 0}, {2, 2, 2});
  CHECK(judge(problem, sliver, 0).verdict == Verdict::wrong);
  CHECK(judge(problem, sliver, kDouble).verdict == Verdict::within_rounding);
  CHECK(judge(problem, box({Rational(3, 2), 1, 0}, {2, 2, 2}), kDouble).verdict == Verdict::wrong);
}

TEST_CASE("models are written and read") {
  Model model = together(kCube, sheet({{Rational("1/3"), 0, 0}, {1, 0, 0}, {0, 0, 7}}));
  model.wires.push_back({0, 9});
  model.isolated.push_back(3);
  std::stringstream text;
  write_model(text, model);
  const Model again = read_model(text);
  CHECK(again.points == model.points);
  CHECK(again.wires == model.wires);
  CHECK(again.isolated == model.isolated);
  REQUIRE(again.faces.size() == model.faces.size());
  for (std::size_t i = 0; i < again.faces.size(); ++i) {
    CHECK(again.faces[i].loops == model.faces[i].loops);
    CHECK(again.faces[i].solid == model.faces[i].solid);
  }
  std::stringstream broken("model 1 0 0 0\n1 2 x\n");
  CHECK_THROWS_WITH(read_model(broken), Catch::Contains("line 2"));
}

}  // namespace
}  // namespace cnrg::bench
