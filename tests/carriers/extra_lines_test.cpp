// Further lines of leaves: they are borders of facets, what is closed stays so, parameters are those of the
// surface, and whoever shares the surface has them, too. CNRG_SEEDS and CNRG_FIRST_SEED as for cubical pairs.
#include <cmath>
#include <numbers>

#include "csg/carriers/common_lines.h"
#include "csg/carriers/surface_numbers.h"
#include "csg/curves/surface_placed.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/leaves/parameters.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "csg/tree/unfold.h"
#include "tests/carriers/rows.h"
#include "tests/leaves/soup_checks.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using test::closed;
using test::volume;

struct Kind {
  std::string leaf;
  std::vector<std::uint32_t> patches;  // with parameters
  bool solid = true, convex = true;
  std::array<bool, 2> periodic{false, false};
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"sphere: {center: [1, 2, 3], radius: 2, segments: 14}", {0}, true, true, {true, false}},
      {"cylinder: {from: [1, 2, 3], to: [2, 4, 5], radius: 1.5, segments: 11}", {2}, true, true, {true, false}},
      {"cylinder: {from: [1, 2, 3], to: [1, 2, 5], radius: 1.5, segments: 11}", {2}, true, true, {true, false}},
      {"cone: {from: [0, 0, 0], to: [1, 2, 2], radius: 2, top: 0.5, segments: 13}",
       {2},
       true,
       true,
       {true, false}},
      {"cone: {from: [0, 0, 0], to: [0, 0, 2], radius: 2, segments: 9}", {2}, true, true, {true, false}},
      {"torus: {center: [1, 0, 0], axis: [1, 1, 2], radius: 3, tube: 1, segments: 17, rings: 10}",
       {0},
       true,
       false,
       {true, true}},
      {"revolve: {profile: [[0, -2], {bezier: [[2, -2]], weights: [1, 1, 2]}, [2, 0], [1, 3], [0, 3]], segments: "
       "7}",
       {0, 1},
       true,
       true,
       {false, true}},
      {"revolve: {profile: [[2, 0], {bezier: [[3, 1]]}, [2, 2], [1, 1]], degrees: 100, axis: [1, 2, 3], segments: "
       "9}",
       {2, 3, 4},
       true,
       false},
      {"revolve: {curve: [[2, 0], {bezier: [[3, 1], [1, 2]]}, [2, 3]], chord: 1/20}",
       {0},
       false,
       false,
       {false, true}},
      {"extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[2, 2, 0]], weights: [1, 1, 2]}, [0, 2, 0]], "
       "vector: [0.5, 0, 3], segments: 6}",
       {3},
       true,
       true},
      {"extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[3, 2, 0], [1, 2, 0]]}, [0, 2, 0]], vector: [0, 0, 3],"
       " segments: 5}",
       {3},
       true,
       true},
      {"extrude: {curve: [[0, 0, 0], {bezier: [[3, 2, 0], [1, 4, 0]]}, [0, 3, 0]], vector: [0, 0, 3], chord: "
       "1/30}",
       {0},
       false,
       false},
      {"bezier: {patch: [[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 1, 1], [1, 1, 3], [2, 1, 1]], [[0, 2, 0], "
       "[1, 2, 1], [2, 2, 0]]], segments: 6}",
       {0},
       false,
       false},
      {"bspline: {patch: {points: [[[0, 0, 0], [1, 0, 1], [2, 0, 0], [3, 0, 2]], [[0, 1, 0], [1, 1, 1], [2, "
       "1, 1], [3, 1, 0]]], degree: [2, 1], knots: [[0, 0, 0, 1/3, 1, 1, 1], [0, 0, 1, 1]]}, chord: 1/40}",
       {0},
       false,
       false},
      {"coons: {patch: [[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[2, 0, 0], [3, 1, 0], [2, 2, 1]], [[2, 2, 1], "
       "[0, 2, 0]], [[0, 2, 0], [-1, 1, 0], [0, 0, 0]]], segments: 5}",
       {0},
       false,
       false},
      {"bezier: {patches: [[[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 0], [1, 1, 2], [2, 1, 0]], [[0, 2, "
       "0], [1, 2, 0], [2, 2, 0]]], [[[0, 2, 0], [1, 2, 0], [2, 2, 0]], [[0, 1, 0], [1, 1, -2], [2, 1, 0]], "
       "[[0, 0, 0], [1, 0, 0], [2, 0, 0]]]], fill: winding, chord: 1/30}",
       {0, 1},
       true,
       false}};
  return all;
}

std::vector<LeafInstance> instances_of(const Tree& tree) {
  return PreparedLeaves(tree, unfold(tree, {tree.result})).instances();
}
Tree parsed(const std::string& nodes) {
  return parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: model\n", "t.yaml");
}

double some_place(std::mt19937_64& random) { return std::uniform_real_distribution<double>(0.01, 0.99)(random); }

/// Random lines, a few of them next to each other; of a net between its knots, which are 0 and 1.
ExtraLines random_lines(const std::vector<std::uint32_t>& patches, std::mt19937_64& random) {
  ExtraLines lines;
  for (const std::uint32_t patch : patches) {
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t count = random() % 4;
      for (std::size_t k = 0; k < count; ++k) {
        const double at = some_place(random);
        lines.of[patch][d].push_back(from_double(at));
        if (random() % 2 == 0) lines.of[patch][d].push_back(from_double(at + std::ldexp(1.0, -12)));
      }
    }
  }
  return lines;
}

/// The greatest distance between corners of cells and their places on the surface.
double off_surface(const LeafInstance& instance) {
  const auto parameters = instance.leaf->parameters()();
  const auto surfaces = instance.leaf->surfaces()();
  Soup soup;
  instance.leaf->add_to(soup, instance.transform);
  REQUIRE(parameters->facet_count() == soup.face_count());
  double worst = 0;
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    const PlacedSurface surface(surfaces, soup.face(f).patch, instance.transform);
    for (const auto& cell : parameters->cells(f.index())) {
      REQUIRE(is_cell(cell));
      if (surface.flat()) continue;
      for (const PatchCorner& corner : cell) {
        const RationalPoint p = instance.transform->apply(corner.point);
        const auto q = surface.at(to_double(corner.at[0]), to_double(corner.at[1])).point;
        for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, std::abs(to_double(p[k]) - q[k]));
      }
    }
  }
  return worst;
}

using ParameterBox = std::array<std::array<double, 2>, 2>;

/// Around the facets of a patch, by u and v.
std::vector<ParameterBox> boxes_of(const LeafInstance& instance, std::uint32_t patch) {
  Soup soup;
  instance.leaf->add_to(soup, instance.transform);
  const auto parameters = instance.leaf->parameters()();
  std::vector<ParameterBox> result;
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).patch != patch) continue;
    for (const auto& cell : parameters->cells(f.index())) {
      ParameterBox& box = result.emplace_back();
      for (std::size_t k = 0; k < 2; ++k) {
        const auto [low, high] = std::ranges::minmax(cell, {}, [&](const PatchCorner& c) { return c.at[k]; });
        box[k] = {to_double(low.at[k]), to_double(high.at[k])};
      }
    }
  }
  return result;
}

/// No facet of the patch goes across the line, and some end there.
void check_border(const std::vector<ParameterBox>& boxes, std::size_t d, double at, bool periodic) {
  bool ends = false;
  for (const auto& box : boxes) {
    for (const double shift : {0.0, -1.0, 1.0}) {
      if (shift != 0 && !periodic) continue;
      const double low = box[d][0] + shift, high = box[d][1] + shift;
      REQUIRE(!(low < at - 1e-12 && at + 1e-12 < high));
      ends = ends || std::abs(low - at) <= 1e-12 || std::abs(high - at) <= 1e-12;
    }
  }
  REQUIRE(ends);
}
void check_borders(const LeafInstance& instance, const Kind& kind, const ExtraLines& lines) {
  for (const auto& [patch, values] : lines.of) {
    const auto boxes = boxes_of(instance, patch);
    for (std::size_t d = 0; d < 2; ++d) {
      for (const Rational& at : values[d]) check_border(boxes, d, to_double(at), kind.periodic[d]);
    }
  }
}

Soup faces_of(const LeafInstance& instance) {
  Soup soup;
  instance.leaf->add_to(soup, instance.transform);
  return soup;
}

TEST_CASE("leaves of every kind have the lines that are asked for", "[random]") {
  const auto [first, last] = scenes::seeds(2);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    for (const Kind& kind : kinds()) {
      std::mt19937_64 random(seed);
      for (const std::string place :
           {"", " ", ", mirror: {normal: [1, 2, 3]}", ", scale: [1, 2, 0.7]", ", scale: 100"}) {
        const std::string at = place.empty() ? "" : placed(random) + place;
        CAPTURE(seed, kind.leaf, at);
        const std::vector<LeafInstance> own = instances_of(parsed("  model: {" + kind.leaf + at + "}\n"));
        const ExtraLines lines = random_lines(kind.patches, random);
        if (lines.of.empty()) continue;
        std::set<std::uint32_t> drawn;
        const std::vector<LeafInstance> made = with_common_lines(own, nullptr, nullptr, {}, {{0, lines}}, &drawn);
        REQUIRE(drawn == std::set<std::uint32_t>{0});
        const double size = place == ", scale: 100" ? 100 : 1;
        CHECK(off_surface(own[0]) < 1e-12 * size);
        REQUIRE(off_surface(made[0]) < 1e-12 * size);
        check_borders(made[0], kind, lines);
        const Soup after = faces_of(made[0]);
        CHECK(after.face_count() <= 16 * faces_of(own[0]).face_count());
        if (!kind.solid) continue;
        REQUIRE(closed(after));
        // On the same even lines.
        if (kind.convex)
          REQUIRE(volume(after) >= volume(faces_of(with_common_lines(own, nullptr, nullptr, {}, {{0, {}}})[0])));
      }
    }
  }
}

/// The facets of a leaf, each from its least corner on.
std::set<std::vector<RationalPoint>> facets_of(const LeafInstance& instance) {
  const Soup soup = faces_of(instance);
  std::set<std::vector<RationalPoint>> result;
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    std::vector<RationalPoint> loop = test::loops(soup, f)[0];
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    result.insert(loop);
  }
  return result;
}

/// Leaves that touch others, or share a surface with them: all have lines.
const std::vector<std::string>& scenes_of_several() {
  static const std::vector<std::string> all{
      // A ball on a plane; balls side by side; one in the other.
      "  a: {sphere: {center: [0, 0, 2], radius: 2, segments: 14}, rotate: {axis: [1, 2, 3], degrees: 77, center: "
      "[0, 0, 2]}}\n"
      "  b: {box: {min: [-3, -3, -1], max: [3, 3, 0]}}\n",
      "  a: {sphere: {center: [0, 0, 2], radius: 2, segments: 14}, rotate: {axis: [1, 0, 0], degrees: 180, "
      "center: [0, 0, 2]}}\n"
      "  b: {box: {min: [-3, -3, -1], max: [3, 3, 0]}}\n",
      "  a: {sphere: {center: [0, 0, 2], radius: 2, segments: 14}}\n"
      "  b: {sphere: {center: [0, 3, 6], radius: 3, segments: 9}}\n",
      "  a: {sphere: {center: [0, 0, 2], radius: 4, segments: 14}}\n"
      "  b: {sphere: {center: [0, 0, 3], radius: 3, segments: 9}}\n",
      // The same ball twice, finer and turned.
      "  a: {sphere: {center: [0, 0, 2], radius: 4, segments: 14}}\n"
      "  b: {sphere: {center: [0, 0, 2], radius: 4, segments: 9}, rotate: {axis: [1, 2, 3], degrees: 77, center: "
      "[0, 0, 2]}}\n",
      // On an axis, and on two.
      "  a: {sphere: {center: [0, 0, 2], radius: 2, segments: 14}}\n"
      "  b: {cylinder: {from: [0, 0, -3], to: [0, 0, 2], radius: 2, segments: 9}}\n",
      "  a: {sphere: {center: [1, 2, 2], radius: 2, segments: 14}}\n"
      "  b: {cylinder: {from: [0, 0, 0], to: [2, 4, 4], radius: 1.5, segments: 9}}\n",
      "  a: {sphere: {center: [0, 0, 2], radius: 2, segments: 14}}\n"
      "  b: {cylinder: {from: [0, 0, -3], to: [0, 0, 2], radius: 1, segments: 9}}\n"
      "  c: {cylinder: {from: [-3, 0, 2], to: [3, 0, 2], radius: 1, segments: 11}}\n",
      // A shaft in a bore, stretched; an arc of an extrusion around it.
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 3], radius: 1, segments: 14}}\n"
      "  b: {cylinder: {from: [0, 0, 1], to: [0, 0, 2], radius: 1, segments: 9}, scale: [1, 1, 2]}\n",
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 3], radius: 1, segments: 14}}\n"
      "  b: {extrude: {profile: [[0, 0, -1], [1, 0, -1], {bezier: [[1, 1, -1]], weights: [1, 1, 2]}, [0, 1, "
      "-1]], vector: [0, 0, 2], segments: 4}}\n",
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 3], radius: 1, segments: 14}}\n"
      "  b: {extrude: {profile: [[0, 0, -1], {bezier: [[0.5, 0.4, -1], [0.7, 0.3, -1]]}, [1, 0, -1], "
      "{bezier: [[1, 1, -1]], weights: [1, 1, 2]}, [0, 1, -1]], vector: [0, 0, 2], chord: 1/20}}\n",
      // A bend and a pipe; a ball that fills a torus; a rod that touches a bore from inside; half balls on a
      // shaft.
      "  a: {revolve: {profile: [[4, 0], {bezier: [[4, 1]], weights: [1, 1, 2]}, [3, 1], {bezier: [[2, 1]], "
      "weights: [1, 1, 2]}, [2, 0], {bezier: [[2, -1]], weights: [1, 1, 2]}, [3, -1], {bezier: [[4, -1]], "
      "weights: [1, 1, 2]}], degrees: 90, segments: 7}}\n"
      "  b: {cylinder: {from: [3, 0, 0], to: [3, -5, 0], radius: 1, segments: 10}}\n",
      "  a: {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1, segments: 15, rings: 8}}\n"
      "  b: {sphere: {center: [0, -3, 0], radius: 1, segments: 10}}\n",
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 5], radius: 2, segments: 10}}\n"
      "  b: {cylinder: {from: [1, 0, 1], to: [1, 0, 4], radius: 1, segments: 11}}\n",
      "  a: {revolve: {profile: [[0, -2], {bezier: [[2, -2]], weights: [1, 1, 2]}, [2, 0], [0, 0]], segments: "
      "5}}\n"
      "  b: {revolve: {profile: [[0, 0], [2, 0], {bezier: [[2, 2]], weights: [1, 1, 2]}, [0, 2]], segments: 7}}\n",
      // Sheets, walls of extrusions, and a sheet on the rim of one.
      "  a: {bezier: {patch: [[[0,0,0],[1,0,0],[2,0,1]],[[0,1,0],[1,1,0],[2,1,1]],[[0,2,1],[1,2,1],[2,2,2]]], "
      "segments: 5}}\n"
      "  b: {bezier: {patch: [[[1/2,1/2,1/8],[1/2,5/6,5/24],[1/2,7/6,3/8],[1/2,3/2,5/8]],[[1,1/2,1/4],[1,5/6,1/3],"
      "[1,7/6,1/2],[1,3/2,3/4]],[[3/2,1/2,5/8],[3/2,5/6,17/24],[3/2,7/6,7/8],[3/2,3/2,9/8]]], chord: 1/40}}\n",
      "  a: {extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[3, 2, 0], [1, 2, 0]]}, [0, 2, 0]], vector: "
      "[0, 0, 3], segments: 5}}\n"
      "  b: {extrude: {profile: [[0, 0, 1], [2, 0, 1], {bezier: [[3, 2, 1], [1, 2, 1]]}, [0, 2, 1]], vector: "
      "[0, 0, 4], segments: 7}}\n",
      "  a: {extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[3, 2, 0], [1, 2, 0]]}, [0, 2, 0]], vector: "
      "[0, 0, 3], chord: 1/30}}\n"
      "  b: {bezier: {patch: [[[2, 0, 3], [3, 2, 3], [1, 2, 3], [0, 2, 3]], [[4, 0, 4], [4, 3, 3], [3, 4, "
      "3], [0, 4, 4]]], segments: 3}}\n",
  };
  return all;
}

std::string with_model(const std::string& scene, const std::string& operation, const std::string& at = "") {
  const std::string operands = scene.find("  c:") == std::string::npos ? "[a, b]" : "[a, b, c]";
  return scene + "  model: {" + operation + ": " + operands + at + "}\n";
}

/// Lines of each curved leaf.
ExtraOfInstances lines_of(const std::vector<LeafInstance>& leaves, std::mt19937_64& random) {
  ExtraOfInstances lines;
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    if (!leaves[i].leaf->surfaces()) continue;
    const std::uint32_t patch = leaves[i].leaf->surfaces()()->patches().begin()->first;
    lines[i] = random_lines({patch}, random);
    if (lines[i].of.empty()) lines[i].of[patch][1].push_back(Rational(1, 3));
  }
  return lines;
}

/// Of an operation on drawn leaves, one after the other.
Cells cells_of(const std::vector<LeafInstance>& drawn, BooleanOp operation) {
  const auto complex = build_complex(make_soup(drawn, {}, surface_numbers(drawn)));
  const std::vector<Group> leaves = leaf_groups(*complex);
  Group value = leaves[0];
  for (std::size_t i = 1; i < leaves.size(); ++i)
    value = boolean_operation(*complex, operation, Dominance::equal, value, leaves[i]).group;
  return simplified_counts(*complex, selection_of(*complex, value), value.features);
}

TEST_CASE("leaves that touch have their lines together and meet as they do without", "[random]") {
  const auto [first, last] = scenes::seeds(1);
  for (const std::string& scene : scenes_of_several()) {
    for (std::uint64_t seed = first; seed < last; ++seed) {
      std::mt19937_64 random(seed);
      for (const BooleanOp operation : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract}) {
        std::string at;
        if (scene.find("scale") == std::string::npos) {  // what is stretched and turned shares nothing
          if (random() % 2 == 0) at = placed(random);
          if (random() % 2 == 0) at += ", scale: [1, 2, 0.7]";
        }
        CAPTURE(scene, seed, int(operation), at);
        const Tree tree = parsed(with_model(scene, "union", at));
        const std::vector<LeafInstance> own = instances_of(tree);
        ExtraOfInstances lines = lines_of(own, random);
        std::set<std::uint32_t> drawn;
        const std::vector<LeafInstance> made = with_common_lines(own, nullptr, nullptr, {}, lines, &drawn);
        REQUIRE(drawn.size() == lines.size());
        REQUIRE(cells_of(made, operation) == cells_of(with_common_lines(own), operation));
        // The order of leaves and lines is none.
        ExtraOfInstances turned;
        for (auto& [i, of] : lines) {
          for (auto& [patch, values] : of.of) {
            for (auto& list : values) std::shuffle(list.begin(), list.end(), random);
          }
          turned[static_cast<std::uint32_t>(own.size() - 1 - i)] = of;
        }
        const std::vector<LeafInstance> others =
            with_common_lines({own.rbegin(), own.rend()}, nullptr, nullptr, {}, turned);
        for (std::size_t i = 0; i < made.size(); ++i) {
          CAPTURE(i);
          REQUIRE((facets_of(others[own.size() - 1 - i]) == facets_of(made[i])));
          REQUIRE(closed(faces_of(made[i])) == closed(faces_of(own[i])));
          if (!made[i].leaf->surfaces()) continue;
          REQUIRE(off_surface(made[i]) < 1e-12);
          const auto& of = lines.at(static_cast<std::uint32_t>(i));
          // A ball about several axes has points in their place.
          if (scene.find("  c:") != std::string::npos && i == 0) continue;
          const bool round =
              scene.find("extrude") == std::string::npos && scene.find("bezier: {patch") == std::string::npos;
          check_borders(made[i], {"", {}, true, true, {round, round}}, of);
        }
      }
    }
  }
}

TEST_CASE("lines next to where balls nearly touch tell how they do, and cost what they add") {
  // Centres 2 - 2e-6 apart, along [2, 3, 6] / 7.
  const std::string scene =
      "  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 24}}\n"
      "  b: {sphere: {center: [2, 0, 0], radius: 1, segments: 24}, translate: [-10000007/7000000, "
      "5999994/7000000, 11999988/7000000]}\n";
  const Tree tree = parsed(with_model(scene, "union"));
  const std::vector<LeafInstance> own = instances_of(tree);
  CHECK(cells_of(own, BooleanOp::unite) == Cells{0, 0, 2, 2});
  const double u = std::atan2(3, 2) / (2 * std::numbers::pi), v = std::asin(6.0 / 7) / std::numbers::pi;
  ExtraOfInstances of_instances;
  for (std::uint32_t i = 0; i < 2; ++i) {
    ExtraLines& of = of_instances[i];
    const std::array<double, 2> at = i == 0 ? std::array{u, 0.5 + v} : std::array{u + 0.5, 0.5 - v};
    for (int k = 0; k < 9; ++k) {
      for (const int sign : {-1, 1}) {
        const double step = sign * std::ldexp(1.0, -k) / 24;
        of.of[0][0].push_back(from_double(at[0] + step));
        of.of[0][1].push_back(from_double(at[1] + step));
      }
    }
  }
  const std::vector<LeafInstance> made = with_common_lines(own, nullptr, nullptr, {}, of_instances);
  CHECK(cells_of(made, BooleanOp::unite) == Cells{0, 1, 2, 1});
  // The same lines, or others that do, are found.
  CHECK(evaluate(tree).rows.back().cells == Cells{0, 1, 2, 1});
  for (std::size_t i = 0; i < 2; ++i) {
    const auto cells = [](const LeafInstance& instance) {
      std::set<ParameterBox> boxes;
      for (const ParameterBox& box : boxes_of(instance, 0)) boxes.insert(box);
      return boxes.size();
    };
    CHECK(cells(own[i]) == 24 * 12);
    CHECK(cells(made[i]) <= (24 + 18) * (12 + 18));
  }
}

TEST_CASE("lines go to leaves that share the surface, and to no others") {
  const Tree tree = parsed(
      "  shaft: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 10}}\n"
      "  drill: {cylinder: {from: [0, 0, 1], to: [0, 0, 3], radius: 1, segments: 7}}\n"
      "  tube: {cylinder: {from: [0, 0, 1], to: [0, 0, 3], radius: 2, segments: 9}}\n"
      "  above: {cylinder: {from: [0, 0, 5], to: [0, 0, 6], radius: 1, segments: 9}}\n"
      "  ball: {sphere: {center: [1.5, 0, 2], radius: 1, segments: 8}}\n"
      "  block: {box: {min: [0, 0, 0], max: [3, 3, 3]}}\n"
      "  model: {union: [shaft, drill, tube, above, ball, block]}\n");
  const std::vector<LeafInstance> own = instances_of(tree), without = with_common_lines(own);
  ExtraLines lines;
  lines.of[2] = {std::vector<Rational>{Rational(1, 7), Rational(5, 9)}, {Rational(1, 3)}};
  lines.of[0][0] = {Rational(1, 3)};  // a cap has none
  std::set<std::uint32_t> drawn;
  const std::vector<LeafInstance> made =
      with_common_lines(own, nullptr, nullptr, {}, {{0, lines}, {5, lines}, {9, lines}}, &drawn);
  CHECK(drawn == std::set<std::uint32_t>{0});
  for (const std::size_t i : {0, 1}) {
    for (const Rational& u : lines.of[2][0]) check_border(boxes_of(made[i], 2), 0, to_double(u), true);
  }
  CHECK(faces_of(made[1]).face_count() == faces_of(without[1]).face_count() + 2);
  for (const std::size_t i : {2, 3, 4, 5}) CHECK(made[i].leaf == own[i].leaf);
  // A line that is there already changes nothing.
  ExtraLines known;
  known.of[2][0] = {0, Rational(1, 10), 1};
  const std::vector<LeafInstance> same = with_common_lines(own, nullptr, nullptr, {}, {{0, known}});
  for (const std::size_t i : {0, 1}) CHECK((facets_of(same[i]) == facets_of(without[i])));
}

TEST_CASE("a ball about several axes has a corner where its lines cross") {
  const Tree tree = parsed(
      "  ball: {sphere: {center: [0, 0, 2], radius: 2, segments: 14}}\n"
      "  b: {cylinder: {from: [0, 0, -3], to: [0, 0, 2], radius: 1, segments: 9}}\n"
      "  c: {cylinder: {from: [-3, 0, 2], to: [3, 0, 2], radius: 1, segments: 11}}\n"
      "  model: {union: [ball, b, c]}\n");
  ExtraLines lines;
  lines.of[0] = {std::vector<Rational>{Rational(13, 100), Rational(14, 100)}, {Rational(3, 5)}};
  const LeafInstance made = with_common_lines(instances_of(tree), nullptr, nullptr, {}, {{0, lines}})[0];
  const auto parameters = made.leaf->parameters()();
  std::size_t corners = 0;
  for (std::size_t f = 0; f < parameters->facet_count(); ++f) {
    const auto cells = parameters->cells(f);
    for (const PatchCorner& corner : cells[0]) {
      for (const Rational& u : lines.of[0][0])
        corners +=
            abs(corner.at[0] - u) < from_double(1e-12) && abs(corner.at[1] - Rational(3, 5)) < from_double(1e-12);
    }
  }
  CHECK(corners >= 8);
}

TEST_CASE("parameters of leaves that touch are those of their surfaces") {
  for (const std::string& scene : scenes_of_several()) {
    CAPTURE(scene);
    const std::vector<LeafInstance> made = with_common_lines(instances_of(parsed(with_model(scene, "union"))));
    std::vector<LeafInstance> own = instances_of(parsed(with_model(scene, "union")));
    std::reverse(own.begin(), own.end());
    const std::vector<LeafInstance> others = with_common_lines(own);
    for (std::size_t i = 0; i < made.size(); ++i) {
      CAPTURE(i);
      CHECK((facets_of(made[i]) == facets_of(others[own.size() - 1 - i])));
      if (made[i].leaf->surfaces()) CHECK(off_surface(made[i]) < 1e-12);
    }
  }
}

}  // namespace
}  // namespace cnrg
