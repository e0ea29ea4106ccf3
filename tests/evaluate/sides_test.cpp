// Which side of a surface a piece is on, against the planes of surfaces that are known, and in every way in which
// a value comes about.
#include <map>
#include <set>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/mesh/cell_groups.h"
#include "csg/result/cell_tags.h"
#include "csg/result/result_data.h"
#include "csg/topology/selectables.h"
#include "csg/tree/selector.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

Evaluation run_tree(const std::string& text, const std::vector<std::string>& nodes = {},
                    Refining refining = Refining::chosen) {
  const Tree tree = parse_tree(text, "t.yaml");
  EvaluateOptions options;
  options.validate = true;
  options.refining = refining;
  for (const std::string& node : nodes) options.nodes.push_back(tree.find(node));
  return evaluate(tree, options);
}

/// `front of f` by component; `*` behind those that tell it from others of its name.
using SideWords = std::vector<std::set<std::string>>;
SideWords sides_of(const Result& result) {
  SideWords out;
  for (const auto& of : named_sides(result.data().view())) {
    auto& words = out.emplace_back();
    for (const NamedSide& side : of) words.insert(side.key() + (" " + side.surface) + (side.tells ? "*" : ""));
  }
  return out;
}

std::string point_text(const RationalPoint& p) {
  return "[\"" + to_string(p[0]) + "\", \"" + to_string(p[1]) + "\", \"" + to_string(p[2]) + "\"]";
}

/// A surface through the block [0, 6]^3, which is larger than that, and where its front looks.
struct Cut {
  std::string node;
  RationalPoint normal;
  Rational offset;
};

/// The front is the side from which the loop runs counter-clockwise, where it was drawn: a mirror takes it along.
Cut random_cut(scenes::Random& random) {
  const auto number = [&](int low, int high) { return Rational(random.between(low, high)); };
  RationalPoint u, v, normal;
  do {
    u = {number(-2, 2), number(-2, 2), number(-2, 2)}, v = {number(-2, 2), number(-2, 2), number(-2, 2)};
    normal = cross(u, v);
  } while (normal == RationalPoint{0, 0, 0});
  const RationalPoint p{number(1, 5), number(1, 5), number(1, 5)};
  const bool mirrored = random.one_in(3);
  std::vector<std::string> corners;
  for (const auto& [a, b] : {std::pair(-40, -40), std::pair(40, -40), std::pair(40, 40), std::pair(-40, 40)}) {
    RationalPoint q;
    for (std::size_t k = 0; k < 3; ++k) q[k] = p[k] + a * u[k] + b * v[k];
    if (mirrored) q[0] = -q[0];
    corners.push_back(point_text(q));
  }
  Cut cut{"", normal, dot(normal, p)};
  const std::string list = "[" + corners[0] + ", " + corners[1] + ", " + corners[2] + ", " + corners[3] + "]";
  switch (random.below(3)) {
    case 0: cut.node = "{polygon: " + list; break;
    case 1: cut.node = "{mesh: {points: " + list + ", faces: [[0, 1, 2], [2, 3, 0]], fill: none}"; break;
    default: {
      RationalPoint way = Rational(80) * v;
      if (mirrored) way[0] = -way[0];
      cut.node = "{extrude: {curve: [" + corners[0] + ", " + corners[1] + "], vector: " + point_text(way) + "}";
    }
  }
  if (mirrored) {
    cut.node += ", mirror: {normal: [1, 0, 0]}";
    cut.normal = Rational(-1) * cut.normal, cut.offset = -cut.offset;
  }
  cut.node += "}";
  return cut;
}

/// The corners of a region.
std::vector<RationalPoint> corners_of(const Result& result, const FlatComplex& flat,
                                      const FlatComplex::Region& region) {
  std::set<FlatComplex::Index> points;
  for (const auto& shell : region.shells)
    for (const auto side : shell)
      for (const auto& loop : flat.faces[side / 2].loops) points.insert(loop.begin(), loop.end());
  std::vector<RationalPoint> out;
  for (const auto point : points) out.push_back(result.complex().points.rational(flat.points[point]));
  return out;
}

bool has_a_facet(const std::vector<RationalPoint>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const RationalPoint n = cross(corners[1] - corners[0], corners[i] - corners[0]);
    if (n != RationalPoint{0, 0, 0}) return true;
  }
  return false;
}

/// Of convex pieces: a plane is touched where three corners lie on it, and the center is on one side.
SideWords expected_sides(const Result& result, const std::vector<Cut>& cuts) {
  const FlatComplex flat = flatten(result.data().view());
  SideWords out(result.component_count());
  std::map<std::string, std::size_t> counts;
  std::size_t pieces = 0;
  for (const auto& region : flat.regions) {
    if (region.component == 0) continue;
    ++pieces;
    const std::vector<RationalPoint> corners = corners_of(result, flat, region);
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      std::vector<RationalPoint> on;
      Rational sum = 0;
      for (const RationalPoint& p : corners) {
        const Rational above = dot(cuts[k].normal, p) - cuts[k].offset;
        if (above == 0) on.push_back(p);
        sum += above;
      }
      if (!has_a_facet(on)) continue;
      const std::string side = (sgn(sum) > 0 ? "front of c" : "behind c") + std::to_string(k);
      out[region.component - 1].insert(side), ++counts[side];
    }
  }
  for (auto& sides : out) {
    std::set<std::string> told;
    for (const std::string& side : sides) told.insert(counts.at(side) == pieces ? side : side + "*");
    sides = told;
  }
  return out;
}

std::string block_cut_by(const std::vector<Cut>& cuts, const std::string& more = "") {
  std::string text = "cnrg: 1\nnodes:\n", list;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    text += "  c" + std::to_string(k) + ": " + cuts[k].node + "\n";
    list += "c" + std::to_string(k) + ", ";
  }
  return text + "  ground: {box: {min: [0, 0, 0], max: [6, 6, 6]}}\n  split: {union: [" + list +
         "ground], dominance: left}\n" + more + "result: split\n";
}

TEST_CASE("a piece is where its center is of the planes that it touches", "[sides][random]") {
  const auto [first, last] = scenes::seeds(40);
  std::size_t pieces = 0, mirrored = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    scenes::Random random(seed + 1);
    std::vector<Cut> cuts;
    for (int k = random.between(1, 3); k > 0; --k) cuts.push_back(random_cut(random));
    std::string more;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      for (const char* key : {"front of", "behind"})
        more += "  " + std::string(key, 5) + std::to_string(k) + ": {select: {of: split, " + key + ": c" +
                std::to_string(k) + "}}\n";
      mirrored += cuts[k].node.find("mirror") != std::string::npos;
    }
    const std::string text = block_cut_by(cuts, more);
    INFO("seed " << seed << "\n" << text);
    const Result split = run_tree(text).result();
    const SideWords expected = expected_sides(split, cuts);
    REQUIRE(sides_of(split) == expected);
    pieces += expected.size();

    // The same refined apart, on doubles, and as picked.
    const std::string ball = "  far: {box: {min: [5, 5, 5], max: [9, 9, 9]}}\n  all: {sum: [split, far]}\n";
    CHECK(sides_of(run_tree(block_cut_by(cuts, ball), {"all", "split"}, Refining::apart).result("split")) ==
          expected);
    SnapReport report;
    const Result snapped = snap(split, &report);
    if (report.lost_regions.empty() && report.parted_regions.empty()) CHECK(sides_of(snapped) == expected);
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      for (const char* key : {"front of", "behind"}) {
        const std::string word = std::string(key) + " c" + std::to_string(k);
        Rational volume = 0;
        std::vector<std::int32_t> numbers;
        for (Component i = 1; i <= expected.size(); ++i)
          if (expected[i - 1].contains(word) || expected[i - 1].contains(word + "*")) volume += *split.volume(i);
        const std::string node = std::string(key, 5) + std::to_string(k);
        const Result picked = run_tree(text, {node}).result(node);
        Rational found = 0;
        for (Component i = 1; i <= picked.component_count(); ++i) found += picked.volume(i).value_or(0);
        CHECK(found == volume);
      }
    }
  }
  CHECK(pieces > 2 * (last - first));
  CHECK((mirrored > 0 || last - first < 10));
}

constexpr const char* kSlab = R"(cnrg: 1
nodes:
  west:   {polygon: [[2, -1, -1], [2, 9, -1], [2, 9, 9], [2, -1, 9]]}
  east:   {polygon: [[4, -1, -1], [4, 9, -1], [4, 9, 9], [4, -1, 9]]}
  crack:  {polygon: [[1, 1, 1], [1, 2, 1], [1, 2, 2], [1, 1, 2]]}
  both:   {union: [west, east]}
  ground: {box: {min: [0, 0, 0], max: [6, 6, 6]}}
  split:  {union: [both, crack, ground], dominance: left}
  open:   {interior: split}
  halved: {subtract: [ground, both]}
  first:  {select: {of: split, dimension: 3, region: ground, behind: west}}
  middle: {select: {of: split, dimension: 3, front of: west, behind: [east]}}
  wall:   {select: {of: split, dimension: 2, front of: west, between: [ground, ground]}}
  last:   {select: {of: split, dimension: 3, front of: both}}
  neither: {select: {of: split, dimension: 3, behind: crack}}
  turned: {simplify: split, mirror: {normal: [1, 0, 0]}, rotate: {axis: [0, 0, 1], degrees: 37}}
  again:  {select: {of: turned, dimension: 3, behind: west}}
result: split
)";

Rational picked_volume(const Evaluation& e, const std::string& node) {
  const Result result = e.result(node);
  Rational sum = 0;
  for (Component i = 1; i <= result.component_count(); ++i) sum += result.volume(i).value_or(0);
  return sum;
}

TEST_CASE("pieces between two faults are told by their sides", "[sides]") {
  const std::vector<std::string> nodes{"split",   "first",  "middle", "wall", "last",
                                       "neither", "turned", "again",  "open", "halved"};
  const Evaluation e = run_tree(kSlab, nodes);
  CHECK(sides_of(e.result("split")) ==
        SideWords{{"behind west*"}, {"front of west*", "behind east*"}, {"front of east*"}, {}});
  CHECK(picked_volume(e, "first") == 72);
  CHECK(picked_volume(e, "middle") == 72);
  CHECK(picked_volume(e, "last") == 72);  // the middle has a front and a back of the two
  CHECK(picked_volume(e, "neither") == 0);
  CHECK(picked_volume(e, "again") == 72);
  CHECK(e.result("wall").cells().faces.size() == 2);
  // A node that is moved as a whole has its pieces where they were.
  std::set<std::string> turned;
  for (const auto& sides : sides_of(e.result("turned")))
    for (const std::string& side : sides) turned.insert(side);
  CHECK(turned == std::set<std::string>{"behind west*", "front of west*", "behind east*", "front of east*"});
  // Of an open set walls between pieces are left, but not what was taken away.
  CHECK(sides_of(e.result("open"))[1] == std::set<std::string>{"front of west*", "behind east*"});
  for (const auto& sides : sides_of(e.result("halved"))) CHECK(sides.empty());
}

TEST_CASE("what can be listed of sides, groups of a mesh and rows of the list", "[sides]") {
  const Result split = run_tree(kSlab).result();
  std::map<std::string, std::vector<std::int32_t>> groups;
  const auto all = cell_groups(split);
  for (const CellGroup& group : all[3]) groups[group.name] = group.cells;
  CHECK(groups.size() == 4 + 4);
  CHECK(groups.at("ground front of west") == groups.at("ground 2"));
  CHECK(groups.at("ground behind east") == groups.at("ground 2"));
  CHECK(groups.at("ground behind west") == groups.at("ground 1"));
  CHECK(groups.at("ground front of east") == groups.at("ground 3"));
  std::map<std::string, std::size_t> rows;
  for (const Selectable& s : selectables(split))
    if (s.key == "front of" || s.key == "behind") rows[s.key + " " + s.value] = s.cells[3];
  CHECK(rows == std::map<std::string, std::size_t>{
                    {"behind east", 1}, {"behind west", 1}, {"front of east", 1}, {"front of west", 1}});
}

TEST_CASE("the front of each kind of surface goes along with it", "[sides]") {
  const char* const surfaces[] = {
      "{polygon: [[-1, -1, 1], [7, -1, 1], [7, 7, 1], [-1, 7, 1]]",
      "{plane: {point: [0, 0, 1], normal: [0, 0, 1]}",
      "{heightfield: {origin: [-1, -1], spacing: [4, 4], heights: [[1, 1, 1], [1, 1, 1], [1, 1, 1]]}",
      "{bezier: {patch: [[[-1, -1, 1], [7, -1, 1]], [[-1, 7, 1], [7, 7, 1]]]}",
      "{extrude: {curve: [[-1, -1, 1], [7, -1, 1]], vector: [0, 9, 0]}",
      "{mesh: {points: [[-20, -20, 1], [20, -20, 1], [0, 30, 1]], faces: [[0, 1, 2]], fill: none}"};
  const std::pair<const char*, bool> moves[] = {
      {"", true},
      {", mirror: {normal: [1, 0, 0], point: [3, 0, 0]}", true},
      {", mirror: {normal: [0, 0, 1], point: [0, 0, 1]}", false},
      {", rotate: {axis: [1, 0, 0], degrees: 180, center: [0, 3, 1]}", false}};
  for (const char* const surface : surfaces) {
    for (const auto& [move, upward] : moves) {
      const std::string text = "cnrg: 1\nnodes:\n  f: " + (surface + std::string(move)) +
                               "}\n  g: {box: {min: [0, 1, 0], max: [2, 3, 3]}}\n"
                               "  s: {union: [f, g], dominance: left}\nresult: s\n";
      INFO(text);
      const SideWords sides = sides_of(run_tree(text).result());
      REQUIRE(sides.size() == 3);
      CHECK(sides[0] == std::set<std::string>{upward ? "behind f*" : "front of f*"});  // z < 1
      CHECK(sides[1] == std::set<std::string>{upward ? "front of f*" : "behind f*"});
    }
  }
}

TEST_CASE("solids and walls within a leaf have no sides", "[sides]") {
  // Two cells of one mesh, all called rock, and a box in a corner.
  const char* const text = R"(cnrg: 1
nodes:
  two: {mesh: {points: [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [0, 0, -4]],
        faces: [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2], [0, 2, 4], [0, 4, 1], [1, 4, 2]], fill: cells}, name: rock}
  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}, name: rock}
  all: {union: [two, box], dominance: right}
  far: {box: {min: [0, 0, 3], max: [9, 9, 9]}}
  cut: {difference: [all, far]}
result: cut
)";
  for (const Refining refining : {Refining::together, Refining::apart}) {
    for (const char* node : {"all", "cut"}) {
      const Result result = run_tree(text, {"cut", "all"}, refining).result(node);
      CHECK(result.component_count() == 3 + 1);
      for (const auto& sides : sides_of(result)) CHECK(sides.empty());
      for (const auto& sides : sides_of(snap(result))) CHECK(sides.empty());
    }
  }
}

TEST_CASE("a surface that is no leaf below, and a solid, are refused with a remedy", "[sides][errors]") {
  const std::string tree = std::string(kSlab);
  const auto with = [&](const std::string& criterion) {
    const std::string line = "  again:  {select: {of: turned, dimension: 3, behind: west}}";
    std::string text = tree;
    return text.replace(text.find(line), line.size(), "  again:  {select: {of: ground, " + criterion + "}}");
  };
  CHECK_THROWS_WITH(run_tree(with("front of: west"), {"again"}),
                    Catch::StartsWith("t.yaml:17:43: error: nothing of `ground` is from `west`; name a leaf"));
  CHECK_THROWS_WITH(
      run_tree(with("behind: wset"), {"again"}),
      Catch::StartsWith("t.yaml:17:41: error: there is no node called `wset`; did you mean `west`?"));
  CHECK_THROWS_WITH(run_tree(with("behind: []"), {"again"}), Catch::Contains("is an empty list"));
  CHECK_THROWS_WITH(
      run_tree(with("behind: ground"), {"again"}),
      Catch::StartsWith("t.yaml:17:41: error: `ground` is a solid") && Catch::Contains("`inside: ground`"));
  std::string wire = tree;
  wire.replace(wire.find("polygon: [[1, 1, 1]"), 7, "polyline");
  CHECK_THROWS_WITH(run_tree(wire, {"neither"}),
                    Catch::StartsWith("t.yaml:15:55: error: `crack` has no face, so no front and no back"));
  std::string joined = tree;
  const std::string turned = "simplify: split, mirror";
  joined.replace(joined.find(turned), turned.size(), "simplify: {of: split, within: 0.001}, mirror");
  CHECK_THROWS_WITH(run_tree(joined, {"again"}),
                    Catch::StartsWith("t.yaml:17:55: error: a node that joins lies above `west`"));
  Tree picked = parse_tree(tree, "t.yaml");
  EvaluateOptions options;
  options.result = add_selection(picked, picked.result, "{dimension: 3, behind: ground}", "--select");
  CHECK_THROWS_WITH(evaluate(picked, options), Catch::StartsWith("--select:1:24: error: `ground` is a solid"));
  const Evaluation none = run_tree(with("name: rock").replace(0, 0, ""), {"again", "neither"});
  REQUIRE(none.diagnostics.size() == 2);
}

}  // namespace
