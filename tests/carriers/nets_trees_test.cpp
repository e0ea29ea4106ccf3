// Trees whose leaves share surfaces: counts as people count the surfaces, at any fineness; parameters and faults.
#include "csg/evaluate/evaluate.h"
#include "csg/leaves/surface_parameters.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Two patches of z = (x^2 + y^2) / 4, of which the second is the middle of the first: its control points are
/// blossoms, its rows run along the other parameter and are of degree 3; it is turned, and turned back.
const char* const kPatches = R"(
cnrg: 1
nodes:
  whole: {bezier: {patch: [[[0,0,0],[1,0,0],[2,0,1]],[[0,1,0],[1,1,0],[2,1,1]],[[0,2,1],[1,2,1],[2,2,2]]], FIRST}}
  part:
    bezier:
      patch: [[[1/2,1/2,1/8],[1/2,5/6,5/24],[1/2,7/6,3/8],[1/2,3/2,5/8]],
              [[1,1/2,1/4],[1,5/6,1/3],[1,7/6,1/2],[1,3/2,3/4]],
              [[3/2,1/2,5/8],[3/2,5/6,17/24],[3/2,7/6,7/8],[3/2,3/2,9/8]]]
      SECOND
    rotate: {axis: [1, 2, 3], degrees: 10}
  middle: {simplify: part, rotate: {axis: [1, 2, 3], degrees: -10}}
  both: {union: [whole, middle]}
  rest: {difference: [whole, middle]}
  none: {difference: [middle, whole]}
  all: {union: [both, rest, none]}
result: all
)";

}  // namespace

TEST_CASE("a patch and its middle in a tree: two faces, a hole, nothing, at any fineness") {
  for (const char* first : {"segments: 1", "segments: 7", "chord: 1/50"}) {
    for (const char* second : {"segments: 1", "segments: 16", "chord: 1/5"}) {
      CAPTURE(first, second);
      EvaluateOptions options;
      options.validate = true;
      const Evaluation evaluation = evaluate(
          parse_tree(replaced(replaced(kPatches, "FIRST", first), "SECOND", second), "test.yaml"), options);
      std::map<std::string, std::array<std::size_t, 4>> cells;
      for (const NodeRow& row : evaluation.rows) cells[row.name] = row.cells;
      CHECK(cells["whole"] == std::array<std::size_t, 4>{4, 4, 1, 0});
      CHECK(cells["middle"] == std::array<std::size_t, 4>{4, 4, 1, 0});
      CHECK(cells["both"] == std::array<std::size_t, 4>{8, 8, 2, 0});
      CHECK(cells["rest"] == std::array<std::size_t, 4>{8, 8, 1, 0});
      CHECK(cells["none"] == std::array<std::size_t, 4>{0, 0, 0, 0});
      // A vertex of the overlap has its parameters on both patches: x / 2 and y / 2 on one, y and x on the other.
      std::size_t on_both = 0;
      for (const VertexId v : evaluation.complex->vertices) {
        const RationalPoint p = evaluation.complex->points.rational(v);
        const std::vector<LeafId> leaves{LeafId(0), LeafId(1)};
        const auto places = evaluation.parameters->on_patches({0, v, {}, {}, {}}, p, leaves);
        REQUIRE(!places.empty());
        on_both += places.size() == 2 ? 1 : 0;
        for (const PatchPoint& place : places) {
          const bool whole = evaluation.leaf_names[place.leaf.index()] == "whole";
          const Parameters expected =
              whole ? Parameters{p[0] / 2, p[1] / 2} : Parameters{p[1] - Rational(1, 2), p[0] - Rational(1, 2)};
          CHECK(place.at == expected);
        }
      }
      CHECK(on_both >= 4);
    }
  }
}

TEST_CASE("curves that cut each other for ever are refused with the name of a leaf") {
  const char* const text = R"(
cnrg: 1
nodes:
  arch: {bezier: {patch: [[[0,0,0],[1,2,0],[2,0,0]],[[0,0,0],[1/2,1,0],[1,1,0]]]}}
  rim: {bezier: {curve: [[0,0,0],[1,2,0],[2,0,0]]}}
  all: {union: [arch, rim]}
result: all
)";
  CHECK_THROWS_WITH(evaluate(parse_tree(text, "test.yaml")),
                    Catch::StartsWith("test.yaml:") && Catch::Contains("cut that patch there") &&
                        (Catch::Contains("`arch` (line 4)") || Catch::Contains("`rim` (line 5)")));
}
