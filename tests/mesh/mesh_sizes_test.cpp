// The sizes that results ask for, each against what a reader of the tree would say.
#include "csg/mesh/mesh_sizes.h"

#include <cmath>

#include "csg/evaluate/evaluate.h"
#include "csg/mesh/region_locator.h"
#include "csg/result/result_data.h"
#include "csg/result/snap.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "tests/catch.h"
#include "tests/mesh/result_of.h"

using namespace cnrg;

namespace {

/// The sizes of a tree's result.
struct Sized {
  Result result;
  FlatComplex flat;
  RoundedPoints points;
  RegionLocator regions;
  MeshSizes sizes;

  Sized(const Result& of, const SizeOptions& options)
      : result(of),
        flat(flatten(result.data().view())),
        points(round_points(result.data().view(), flat)),
        regions(flat, points),
        sizes(mesh_sizes(result.data().view(), flat, points, options)) {}
  double at(const SizeField::Vector& p) const { return sizes.at(p, regions.at(p)); }
};

Sized sized(const std::string& nodes, const SizeOptions& options = {}, Refining refining = Refining::chosen) {
  return {result_of(nodes, refining), options};
}

constexpr const char* kSquareTunnel = R"(
  rock:   {box: {min: [0, 0, 0], max: [40, 40, 40]}, size: 8}
  tunnel: {box: {min: [18, -1, 18], max: [22, 41, 22]}, size: 1/2}
  model:  {difference: [rock, tunnel]}
)";

}  // namespace

TEST_CASE("nobody asks for a size: there is no field", "[size]") {
  const std::string plain = "  model: {box: {min: [0, 0, 0], max: [1, 2, 3]}}\n";
  CHECK(sized(plain).sizes.empty());
  CHECK(sized(plain).at({0.5, 0.5, 0.5}) == kInfinity);
  const Sized all = sized(plain, {0.25});
  CHECK(all.at({0.5, 0.5, 0.5}) == 0.25);
  CHECK(all.at({9, 9, 9}) == 0.25);
}

TEST_CASE("a size of a leaf is that of its faces wherever they are, and of regions that lie in it", "[size]") {
  for (const Refining refining : {Refining::together, Refining::apart}) {
    const Sized s = sized(kSquareTunnel, {}, refining);
    CHECK(s.at({18, 20, 20}) == Approx(0.5));            // a wall of the tunnel
    CHECK(s.at({13, 20, 20}) == Approx(0.5 + 0.3 * 5));  // 5 away from it
    CHECK(s.at({1, 20, 20}) == Approx(0.5 + 0.3 * 17));  // on its way up to 8
    CHECK(s.at({39, 39, 39}) == Approx(0.5 + 0.3 * std::sqrt(2 * 17.0 * 17)).margin(0.01));
  }
  // Far from all that is short the region's own length holds.
  const Sized wide = sized(R"(
  rock:   {box: {min: [0, 0, 0], max: [400, 400, 400]}, size: 8}
  tunnel: {box: {min: [18, -1, 18], max: [22, 401, 22]}, size: 1/2}
  model:  {difference: [rock, tunnel]}
)");
  CHECK(wide.at({200, 200, 200}) == 8);
  CHECK(wide.at({900, 200, 200}) > 100);  // outside nothing was said
}

TEST_CASE("a size of an operator is that of the leaves below that have none", "[size]") {
  const std::string parts = R"(
  fine:  {box: {min: [0, 0, 0], max: [100, 100, 100]}, size: 2}
  plain: {box: {min: [200, 0, 0], max: [300, 100, 100]}}
  both:  {union: [fine, plain], size: 5}
)";
  const Sized s = sized(parts + "  model: {unify: both}\n");
  CHECK(s.at({50, 50, 50}) == 2);
  CHECK(s.at({250, 50, 50}) == 5);
  // A node with two users: the shorter one of what it hears from them.
  const Sized twice = sized(R"(
  a: {box: {min: [0, 0, 0], max: [100, 100, 100]}}
  b: {union: [a, {box: {min: [200, 0, 0], max: [300, 100, 100]}}], size: 7}
  c: {union: [a, {box: {min: [400, 0, 0], max: [500, 100, 100]}}], size: 3}
  model: {union: [b, c]}
)");
  CHECK(twice.at({50, 50, 50}) == 3);
  CHECK(twice.at({250, 50, 50}) == 7);
  CHECK(twice.at({450, 50, 50}) == 3);
}

TEST_CASE("what is said above counts for its result only", "[size]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [100, 100, 100]}}
  b: {box: {min: [200, 0, 0], max: [300, 100, 100]}}
  model: {union: [a, b], size: 4}
  plain: {union: [a, b]}
result: model
)",
                               "t.yaml");
  EvaluateOptions options;
  options.nodes = {tree.find("plain")};
  const Evaluation evaluation = evaluate(tree, options);
  CHECK(Sized(evaluation.result(), {}).at({50, 50, 50}) == 4);
  CHECK(Sized(evaluation.result("plain"), {}).sizes.empty());
}

TEST_CASE("sizes are lengths of the model as it stands", "[size]") {
  const Sized s = sized(R"(
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}, size: 2, scale: 100}
  b: {simplify: a, translate: [500, 0, 0]}
  model: {union: [a, b]}
)");
  CHECK(s.at({50, 50, 50}) == 2);
  CHECK(s.at({550, 50, 50}) == 2);
}

TEST_CASE("a region that lies in a leaf in part is as fine as all of it is to be", "[size]") {
  const auto foot = [](const std::string& plate) {
    return sized("  plate: {box: {min: [0, 0, 0], max: [100, 100, 100]}" + plate +
                 "}\n  foot: {box: {min: [45, 45, 90], max: [55, 55, 110]}, size: 1/10}\n"
                 "  model: {union: [plate, foot]}\n");
  };
  const Sized said = foot(", size: 4");
  REQUIRE(said.flat.regions.size() == 2);
  CHECK(said.at({50, 50, 10}) == 4);
  CHECK(said.at({50, 45.01, 105}) == Approx(0.1).margin(0.01));
  const Sized silent = foot("");
  CHECK(silent.sizes.regions.empty());
  CHECK(silent.at({50, 45.01, 105}) == Approx(0.1).margin(0.01));
  // In an intersection all of it lies in both.
  const Sized common = sized(R"(
  a: {box: {min: [0, 0, 0], max: [100, 100, 100]}, size: 9}
  b: {box: {min: [20, 20, 20], max: [120, 120, 120]}, size: 6}
  model: {intersection: [a, b]}
)");
  CHECK(common.at({60, 60, 60}) == 6);
}

TEST_CASE("sheets, wires and points have the sizes of their leaves", "[size]") {
  const Sized s = sized(R"(
  rock:  {box: {min: [0, 0, 0], max: [100, 100, 100]}}
  fault: {polygon: [[50, 20, 20], [50, 80, 20], [50, 80, 80], [50, 20, 80]], size: 1}
  bolt:  {polyline: [[10, 10, 10], [10, 10, 90]], size: 1/4}
  probe: {points: [[90, 90, 50]], size: 1/8}
  model: {union: [probe, bolt, fault, rock], dominance: left}
)");
  CHECK(s.at({50, 50, 50}) == Approx(1));
  CHECK(s.at({10, 10, 47}) == Approx(0.25));
  CHECK(s.at({10, 12, 47}) == Approx(0.25 + 0.6));
  CHECK(s.at({90, 90, 50}) == Approx(0.125));
  CHECK(s.at({54, 50, 50}) == Approx(1 + 0.3 * 4));
}

TEST_CASE("short edges and small facets ask for themselves", "[size]") {
  // A notch of 1 in a block of 40: beside it as fine as it is.
  const Sized s = sized(R"(
  block: {box: {min: [0, 0, 0], max: [40, 40, 40]}}
  notch: {box: {min: [20, 20, 39], max: [21, 21, 41]}}
  model: {difference: [block, notch]}
)",
                        {10});
  CHECK(s.at({20, 20, 39.5}) == Approx(1));
  CHECK(s.at({20, 20, 35}) == Approx(1 + 0.3 * 4));
  CHECK(s.at({1, 1, 1}) == 10);
  const Sized steeper = sized("  model: {box: {min: [0, 0, 0], max: [40, 40, 1/2]}}\n", {10, 1});
  CHECK(steeper.at({40, 40, 0.25}) == Approx(0.5));
  CHECK(steeper.at({37, 20, 0.25}) == Approx(4 * 20 / 81.0 + 3));  // from a strip that is half as wide
  // Each of 12 sides of a drum is 0.52 wide, and asks for nothing finer; the facets of a ball are about as wide.
  const Sized ball = sized("  model: {sphere: {center: [0, 0, 0], radius: 1, segments: 24}}\n", {1});
  CHECK(ball.at({0, 1, 0}) == Approx(0.26).epsilon(0.1));
  // A sliver asks for a thousandth of the diagonal.
  const Sized sliver = sized(R"(
  block: {box: {min: [0, 0, 0], max: [40, 40, 40]}}
  notch: {box: {min: [20, 20, 39], max: [20.000001, 20.000001, 41]}}
  model: {difference: [block, notch]}
)",
                             {10});
  CHECK(sliver.at({20, 20, 40}) == Approx(0.04 * std::sqrt(3.0)));
}

TEST_CASE("what is narrow asks for nothing where it is very thin", "[size]") {
  const auto slab = [](const std::string& top, const SizeOptions& options) {
    return sized(
        "  block: {box: {min: [0, 0, 0], max: [10, 10, 10]}}\n  slab: {box: {min: [0, 0, 3], max: [10, 10, \"" +
            top + "\"]}}\n  bolt: {polyline: [[5, 5, 1], [5, 5, 9]]}\n" +
            "  model: {union: [bolt, slab, block], dominance: left}\n",
        options);
  };
  const Sized thin = slab("3001/1000", {2});
  for (const double x : {0.0, 5.0, 10.0}) CHECK(thin.at({x, 5, 3.0005}) == 2);
  CHECK(thin.at({10, 10, 3.0005}) == 2);
  // One of more than a thousandth of the diagonal asks as ever, unless what is wide alone is to ask.
  CHECK(slab("305/100", {2}).at({10, 5, 3.025}) == Approx(0.1).epsilon(0.01));
  CHECK(slab("305/100", {2, 0.3, false, false, true}).at({10, 5, 3.025}) == 2);
  CHECK(slab("305/100", {2}).at({5, 5, 3.025}) == Approx(0.05));  // the bolt's piece
}

TEST_CASE("sizes survive snapping", "[size]") {
  const Result exact = result_of(R"(
  low:   {box: {min: [0, 0, 0], max: [100, 100, 100]}, size: 3}
  high:  {box: {min: [0, 0, 100.00000000000000001], max: [100, 100, 200]}, size: 5}
  free:  {box: {min: [300, 0, 0], max: [400, 100, 100]}}
  model: {union: [low, high, free]}
)");
  SnapReport report;
  const Result snapped = snap(exact, &report);
  REQUIRE(report.rounds > 0);
  for (const Result& result : {snapped, snap(snapped)}) {
    const Sized s(result, {});
    CHECK(s.at({50, 50, 50}) == 3);
    CHECK(s.at({50, 50, 150}) == 5);
    CHECK(s.at({50, 50, 100}) == Approx(3));
    CHECK(s.at({350, 50, 50}) > 5);
  }
}

TEST_CASE("regions are found by a ray", "[size]") {
  const Sized s = sized(R"(
  shell:  {box: {min: [0, 0, 0], max: [9, 9, 9]}}
  cavity: {box: {min: [1, 1, 1], max: [8, 8, 8]}}
  block:  {box: {min: [3, 3, 3], max: [5, 5, 5]}}
  model:  {union: [{difference: [shell, cavity]}, block]}
)",
                        {1});
  const auto component = [&](double x, double y, double z) {
    const FlatComplex::Index r = s.regions.at({x, y, z});
    REQUIRE(r != FlatComplex::kNone);
    return s.flat.regions[r].component;
  };
  CHECK(component(0.5, 4, 4) != 0);
  CHECK(component(0.5, 4, 4) == component(8.5, 8.5, 8.5));
  CHECK(component(4, 4, 4) != 0);
  CHECK(component(4, 4, 4) != component(0.5, 4, 4));
  CHECK(component(2, 4, 4) == 0);
  CHECK(component(7, 7, 7) == 0);
  CHECK(component(-1, 4, 4) == 0);
  CHECK(component(20, 20, 20) == 0);
  CHECK_FALSE(s.regions.meets_faces({3.5, 3.5, 3.5}, {4.5, 4.5, 4.5}));
  CHECK(s.regions.meets_faces({3.5, 3.5, 3.5}, {5.5, 4.5, 4.5}));
  std::size_t triangles = 0;
  for (const auto& face : s.flat.faces) {
    for (const auto& t : face.triangles) {
      const auto &a = s.points.xyz[t[0]], &b = s.points.xyz[t[1]], &c = s.points.xyz[t[2]];
      const std::size_t place = triangles++;
      if (a[0] != 0 || b[0] != 0 || c[0] != 0) continue;
      const auto shell = s.regions.at({0.5, 4.1, 4.2});
      const SizeField::Vector middle{0, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
      CHECK(s.regions.gap(middle, {1, 0, 0}, shell, place, 100) == Approx(1));
      CHECK(s.regions.gap(middle, {1, 0, 0}, shell, place, 0.5) == 0.5);
      CHECK(s.regions.gap(middle, {1, 0, 0}, shell + 1, place, 100) == 100);
    }
  }
  CHECK(triangles == 36);
}
