// Results as arrays, sizes and places of their cells, and what is told of them as data, through what is installed:
// once each here, so that builds without Python run it, too; tests/python compares all of it with files and with
// the program.
#include <cnrg.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/catch.h"

using namespace cnrg;
using Json = nlohmann::json;

namespace {

const char* const kSlope = R"(cnrg: 1
nodes:
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}}
  fault:  {polygon: [[20, -5, -5], [70, -5, 65], [70, 105, 65], [20, 105, -5]]}
  bolt:   {polyline: [[60, 50, 30], [60, 50, 48]]}
  tunnel: {cylinder: {from: [60, -5, 30], to: [60, 105, 30], radius: 6, segments: 48}}
  split:  {union: [bolt, {intersection: [fault, ground]}, ground], dominance: left}
  model:  {difference: [split, tunnel]}
result: model
)";

const char* const kHalf = R"(cnrg: 1
nodes:
  low:   {halfspace: {point: [0, 0, 0], normal: [1/3, 0, 1]}}
  wall:  {plane: {point: [0, 0, 0], normal: [1, 1, 0]}}
  model: {union: [wall, {box: {min: [-1, -1, -1], max: [1, 1, 1]}}, low], dominance: left}
result: model
)";

struct Run {
  std::shared_ptr<const Tree> tree;
  Evaluation evaluation;
  Result result;
};

Run run(const char* text, bool keep_all = false) {
  auto tree = std::make_shared<const Tree>(parse_tree(text, "t.yaml"));
  EvaluateOptions options;
  options.keep_all = keep_all;
  Evaluation evaluation = evaluate(*tree, options);
  Result result = evaluation.result();
  return {std::move(tree), std::move(evaluation), std::move(result)};
}

std::size_t at(const std::vector<std::int64_t>& offsets, std::size_t i) {
  return static_cast<std::size_t>(offsets[i]);
}

}  // namespace

TEST_CASE("lists of arrays are as long as they say, and their numbers are those of cells", "[arrays]") {
  for (const char* text : {kSlope, kHalf}) {
    const Run r = run(text);
    const ResultArrays a = result_arrays(r.result);
    CHECK(a.points.size() == 3 * a.ids.size());
    CHECK(a.vertices.component.size() == r.result.cells().vertices.size());
    CHECK(a.edges.component.size() == r.result.cells().edges.size());
    CHECK(a.faces.component.size() == r.result.cells().faces.size());
    CHECK(a.regions.component.size() == r.result.cells().regions.size());
    CHECK(at(a.faces.triangles.offsets, a.faces.triangles.size()) * 3 == a.faces.triangles.values.size());
    CHECK(at(a.faces.loops.offsets, a.faces.loops.size()) == a.faces.loop_points.size());
    CHECK(a.faces.loop_points.size() == a.faces.loop_edges.size());
    CHECK(at(a.faces.facets.offsets, a.faces.facets.size()) == a.faces.facet_loops.size());
    // Each use of an edge by a loop is one of the sides around it.
    CHECK(a.edges.around.values.size() == a.faces.loop_edges.values.size());
    for (std::size_t i = 0; i < a.ids.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(a.points[3 * i + k] == to_double(r.result.complex().points.rational(a.ids[i])[k]));
      }
    }
  }
}

TEST_CASE("sizes are exact where they can be", "[arrays]") {
  const Run r = run(kSlope);
  const ResultArrays a = result_arrays(r.result);
  const Measures measures(r.result, a);
  Rational volume = 0;
  for (std::size_t i = 0; i < a.regions.component.size(); ++i) {
    if (a.regions.component[i] != 0) volume += measures.volume(i).value();
  }
  CHECK(volume == *r.result.volume(1) + *r.result.volume(2));
  for (std::size_t i = 0; i < a.faces.component.size(); ++i) {
    const std::optional<Rational> square = measures.squared_area(i);
    CHECK(square.has_value() == (a.faces.flat[i] != 0));
    if (square) CHECK(measures.area(i) == Approx(std::sqrt(to_double(*square))).epsilon(1e-15));
  }
  const std::vector<double> areas = measures.areas();
  // The fault is the wall: 100 long, 60 of its 70 high, so 300/7 of its 50 wide.
  const Rational width(300, 7);
  const Rational wall = (width * width + 3600) * 10000;
  CHECK(std::count_if(areas.begin(), areas.end(), [&](double x) { return x == to_double(square_root(wall)); }) ==
        1);
  // The boundary of a region has no area vector in all.
  for (std::size_t region = 0; region < a.regions.component.size(); ++region) {
    RationalPoint sum{0, 0, 0};
    for (std::size_t i = 0; i < a.faces.component.size(); ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (a.faces.regions[2 * i + side] != static_cast<std::int32_t>(region)) continue;
        for (std::size_t k = 0; k < 3; ++k) sum[k] += (side == 0 ? -1 : 1) * (*measures.area_vector(i))[k];
      }
    }
    CHECK(sum == RationalPoint{0, 0, 0});
  }

  const Run half = run(kHalf);
  const ResultArrays b = result_arrays(half.result);
  const std::vector<double> unbounded = Measures(half.result, b).areas();
  CHECK(std::count_if(unbounded.begin(), unbounded.end(), [](double x) { return std::isinf(x); }) > 0);
}

TEST_CASE("a point has the same cell within the frame and beyond", "[places]") {
  const Run r = run(kHalf);
  const Places places(r.result, r.tree, r.tree->result);
  // Along rays from the middle of the box, where nothing but planes through it is met.
  std::vector<RationalPoint> near, far;
  for (const auto& [x, y, z] :
       {std::array{5, 1, 7}, {5, 1, -7}, {-5, 5, 9}, {-5, 5, -9}, {-9, 2, 3}, {-9, 2, -3}}) {
    near.push_back({Rational(x), Rational(y), Rational(z)});
    far.push_back({Rational(x) * 1000000000, Rational(y) * 1000000000, Rational(z) * 1000000000});
  }
  const auto at_near = places.of(near), at_far = places.of(far);
  for (std::size_t i = 0; i < near.size(); ++i) {
    INFO(i);
    CHECK(at_near[i].dimension == at_far[i].dimension);
    CHECK(at_near[i].index == at_far[i].index);
  }
  const Places alone(r.result);
  CHECK(alone.of(std::vector{RationalPoint{0, 0, Rational(1, 2)}}).front().dimension == 2);
  CHECK_THROWS_WITH(alone.of(far), Catch::Contains("has no tree to evaluate again"));
  const Rational limit(Integer(1) << 1001);
  CHECK_THROWS_WITH(places.of(std::vector{RationalPoint{limit, 0, 0}}), Catch::Contains("2^1000"));
}

TEST_CASE("what is told as data is told as text", "[data]") {
  const Run r = run(kSlope, true);
  const Story told = story(*r.tree, r.evaluation, r.tree->result, RationalPoint{60, 50, 33});
  CHECK_THAT(told.text, Catch::Contains("removed by difference.edge.AinB"));
  const Json facts = Json::parse(told.json);
  CHECK(facts["lives"][0]["steps"].back()["booleans"][0]["row"] == "difference.edge.AinB");
  CHECK(facts["point"] == Json({"60", "50", "33"}));

  const TopologyReport topology = topology_report(r.result);
  CHECK(Json::parse(topology.json)["betti"][0]["z2"] == Json({1, 1, 0}));
  CHECK_THAT(topology.text, Catch::Contains("Betti numbers"));

  const Tree other =
      parse_tree("cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n", "o.yaml");
  const Difference found = difference(*r.tree, r.tree->result, other, other.result);
  CHECK_FALSE(found.same);
  CHECK(Json::parse(found.json)["only_b"].empty());
  CHECK(difference(other, other.result, other, other.result).text.empty());
}

TEST_CASE("tetrahedra and pictures are given as arrays and bytes", "[arrays]") {
  const Run r = run(kSlope, true);
  const TetrahedralResult mesh(r.result);
  const TetrahedraArrays a = mesh.arrays();
  CHECK(a.of[3].points.size() == 4 * a.of[3].cell.size());
  CHECK(a.regions.size() == 2);
  CHECK(a.regions[0].tetrahedra + a.regions[1].tetrahedra == a.of[3].cell.size());
  CHECK(a.groups[3].size() >= 2);
  CHECK_THAT(picture(".svg", r.result, {{"cut", "y=50"}}), Catch::StartsWith("<svg"));
  CHECK_THAT(picture(".svg", *r.tree, r.evaluation, r.tree->result, {{"ghosts", ""}}), Catch::StartsWith("<svg"));
  CHECK(check_picture_options({{"ghosts", ""}}));
  CHECK_THROWS_WITH(check_picture_options({{"color-by", "taste"}}), Catch::StartsWith("color_by: `taste` is not"));
  CHECK_THROWS_WITH(check_picture_options({{"zoom", "2"}}), Catch::Contains("no such option"));
}
