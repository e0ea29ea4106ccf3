// The tree file's reader: what it makes of good files, number by number.
#include <string>

#include "csg/leaves/mesh_data.h"
#include "csg/tree/sizes.h"
#include "csg/tree/tree.h"
#include "csg/tree/unfold.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

const char* const kModel = R"(cnrg: 1
materials: {rock: {color: "#998877"}, air: {}}
nodes:
  ground:  {box: {min: [0, 0, 0], max: [100, 100, 60]}, material: rock}
  fault:   {polygon: [[20, 0, 0], [60, 0, 60], [60, 100, 60], [20, 100, 0]]}
  bolt:    {polyline: [[50, 50, 30], [50, 50, "121/3"]]}
  tunnel:  {cylinder: {from: [50, -5, 30], to: [50, 105, 30], radius: 6, segments: 48}, dominance: 2}
  part:    {mesh: {file: part.off, fill: winding}, rotate: {axis: [0, 0, 1], degrees: 90}, translate: [1, 2, 3]}
  split:   {union: [ground, fault], dominance: right}
  model:   {difference: [split, tunnel, part, bolt]}
  solid:   {regularize: model}
result: solid
)";

const Node& node(const Tree& tree, const std::string& name) { return tree.nodes[tree.find(name)]; }

template <class T>
const T& shape(const Tree& tree, const char* name) {
  return std::get<T>(*node(tree, name).shape);
}

/// A tree with one node `a`, given by the inside of its braces.
Tree single(const std::string& inside) {
  return parse_tree("cnrg: 1\nmaterials: {rock: {}}\nnodes: {a: {" + inside + "}}\nresult: a\n", "t.yaml");
}

TEST_CASE("a tree with every kind of node reads as it is written", "[tree]") {
  const Tree tree = parse_tree(kModel, "models/mine.yaml");
  REQUIRE(tree.nodes.size() == 8);
  CHECK(reading_warnings(tree, {tree.result}).empty());
  CHECK(tree.nodes[tree.result].name == "solid");
  REQUIRE(tree.materials.size() == 2);
  CHECK(tree.materials[0].name == "rock");
  CHECK(tree.materials[0].color == "#998877");
  CHECK(tree.materials[1].name == "air");

  const auto& ground = shape<BoxShape>(tree, "ground");
  CHECK(ground.max == RationalPoint{100, 100, 60});
  CHECK(node(tree, "ground").material == "rock");
  CHECK(node(tree, "ground").at == Position{4, 3});
  CHECK(node(tree, "ground").operator_at == Position{4, 13});
  CHECK(shape<PolygonShape>(tree, "fault").outer.size() == 4);
  CHECK(shape<PolylineShape>(tree, "bolt").points[1][2] == Rational(121, 3));
  CHECK(shape<CylinderShape>(tree, "tunnel").segments == 48);
  CHECK(*node(tree, "tunnel").dominance == 2);
  CHECK(shape<MeshShape>(tree, "part").file == "models/part.off");
  CHECK(shape<MeshShape>(tree, "part").fill == Fill::winding);
  CHECK(node(tree, "split").op == Operator::unite);
  CHECK(node(tree, "split").dominant == DominantOperand::right);
  CHECK(tree.operands(tree.find("model")) ==
        std::vector<NodeId>{tree.find("split"), tree.find("tunnel"), tree.find("part"), tree.find("bolt")});
}

TEST_CASE("JSON is read too", "[tree]") {
  const Tree tree = parse_tree(
      R"({"cnrg": 1, "nodes": {"a": {"box": {"min": [0,0,0], "max": [1, 1, 0.5]}}, "b": {"complement": "a"}},
          "result": "b"})",
      "t.json");
  CHECK(shape<BoxShape>(tree, "a").max[2] == Rational(1, 2));
}

TEST_CASE("numbers are exact", "[tree]") {
  const Tree tree = single(
      "points: [[0.1, \"121/3\", 1.5e-3], [-.5, 1e20, 7/14], "
      "[0.1234567890123456789012345678901234567890, 9007199254740993, -0]]");
  const auto& points = shape<PointsShape>(tree, "a").points;
  CHECK(points[0][0] == Rational(1, 10));
  CHECK(points[0][1] == Rational(121, 3));
  CHECK(points[0][2] == Rational(3, 2000));
  CHECK(points[1][0] == Rational(-1, 2));
  CHECK(points[1][1] == Rational("100000000000000000000"));
  CHECK(points[1][2] == Rational(1, 2));
  Rational long_one("1234567890123456789012345678901234567890/10000000000000000000000000000000000000000");
  long_one.canonicalize();
  CHECK(points[2][0] == long_one);
  CHECK(points[2][1] == Rational("9007199254740993"));
  CHECK(points[2][2] == 0);
}

TEST_CASE("transforms multiply in the order in which they are written", "[tree]") {
  const char* box = "box: {min: [0, 0, 0], max: [1, 1, 1]}, ";
  const auto image = [&](const std::string& transforms) {
    return node(single(box + transforms), "a").transform->apply({1, 2, 3});
  };
  CHECK(image("translate: [10, 0, 0], scale: 2") == RationalPoint{22, 4, 6});
  CHECK(image("scale: 2, translate: [10, 0, 0]") == RationalPoint{12, 4, 6});
  CHECK(image("scale: [1, -1, 1/3]") == RationalPoint{1, -2, 1});
  CHECK(image("rotate: {axis: [0, 0, 1], degrees: 90}") == RationalPoint{-2, 1, 3});
  CHECK(image("rotate: {axis: [0, 0, 1], degrees: 180, center: [1, 0, 0]}") == RationalPoint{1, -2, 3});
  CHECK(image("mirror: {normal: [1, 0, 0]}") == RationalPoint{-1, 2, 3});
  CHECK(image("mirror: {normal: [0, 0, 5], point: [0, 0, 1]}") == RationalPoint{1, 2, -1});
  CHECK(image("matrix: [[1, 1/2, 0, 7], [0, -2, 0, 1], [0, 0, 3, 0]]") == RationalPoint{9, -3, 9});
  CHECK(image("mirror: {normal: [1, 1, 0]}") == RationalPoint{-2, -1, 3});
  CHECK_FALSE(node(single("points: [[0, 0, 0]]"), "a").transform.has_value());
}

TEST_CASE("every leaf has its form", "[tree]") {
  const auto read = [](const std::string& inside) { return *node(single(inside), "a").shape; };
  CHECK(std::get<PrismShape>(read("prism: {base: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], vector: [0, 0, 1], "
                                  "holes: [[[1/8, 1/8, 0], [1/4, 1/8, 0], [1/8, 1/4, 0]]]}"))
            .holes.size() == 1);
  CHECK(std::get<PyramidShape>(read("pyramid: {base: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], apex: [0, 0, 1]}"))
            .apex[2] == 1);
  CHECK(
      std::get<TetrahedronShape>(read("tetrahedron: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 7]]")).points[3][2] ==
      7);
  CHECK(std::get<HullShape>(read("hull: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 7]]")).summands[0][3][2] == 7);
  CHECK(std::get<HullShape>(read("minkowski: [[[0, 0, 0]], [[1, 0, 0], [0, 1, 0]]]")).summands[1].size() == 2);
  CHECK(std::get<PolygonShape>(read("polygon: {outer: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], holes: []}"))
            .outer.size() == 3);
  CHECK(*std::get<PolygonShape>(read("polygon: {outer: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], fit: 1e-5}")).fit ==
        Rational(1, 100000));
  // The strike to the north-east, the dip to the south-east.
  const auto disk = std::get<DiskShape>(read("disk: {center: [0, 0, 0], radii: [2, 1], dip: 90, strike: 45}"));
  CHECK(std::abs(to_double(disk.along[0]) - std::sqrt(0.5)) < 1e-15);
  CHECK(std::abs(to_double(disk.along[1]) - std::sqrt(0.5)) < 1e-15);
  CHECK(std::abs(to_double(disk.normal[0]) - std::sqrt(0.5)) < 1e-15);
  CHECK(std::abs(to_double(disk.normal[1]) + std::sqrt(0.5)) < 1e-15);
  CHECK(dot(disk.along, disk.normal) == 0);
  CHECK(std::get<DiskShape>(read("disk: {center: [0, 0, 0], radii: [2, 1], dip: 0, strike: 90}")).along ==
        RationalPoint{1, 0, 0});
  CHECK(
      std::get<PolylineShape>(read("polyline: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], closed: true}")).closed);
  CHECK(std::get<PointsShape>(read("points: [[0, 0, 0]]")).points.size() == 1);
  CHECK(std::get<PlaneShape>(read("plane: {point: [0, 0, 1], normal: [0, 0, 1]}")).point[2] == 1);
  CHECK(std::get<HalfspaceShape>(read("halfspace: {point: [0, 0, 1], normal: [0, 0, 2]}")).normal[2] == 2);
  const auto sphere =
      std::get<SphereShape>(read("sphere: {center: [0, 0, 0], radius: 1/2, segments: 8, rings: 4}"));
  CHECK(sphere.radius == Rational(1, 2));
  CHECK(sphere.segments == 8);
  CHECK(sphere.rings == 4);
  CHECK(std::get<CylinderShape>(read("cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 2}")).segments == 32);
  CHECK(std::get<ConeShape>(read("cone: {from: [0, 0, 0], to: [0, 0, 1], radius: 2, top: 1}")).top == 1);
  CHECK(std::get<TorusShape>(read("torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 4, tube: 1}")).rings == 16);
  const auto field = std::get<HeightfieldShape>(
      read("heightfield: {origin: [1, 2], spacing: [1/2, 1/4], heights: [[0, 1], [2, 3]], base: -1}"));
  CHECK(field.origin_y == 2);
  CHECK(field.spacing_y == Rational(1, 4));
  CHECK(field.heights[1][0] == 2);
  CHECK(*field.base == -1);
  CHECK(std::get<HeightfieldShape>(read("heightfield: {file: grid.asc}")).file == "grid.asc");
  const auto data = std::get<MeshShape>(
      read("mesh: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1/3]], faces: [[0, 2, 1], [0, 1, 3]]}"));
  REQUIRE(data.data != nullptr);
  CHECK(data.file.empty());
  CHECK(data.data->xyz.size() == 12);
  CHECK(data.data->corners == std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3});
  CHECK(data.data->offsets == std::vector<std::uint32_t>{0, 3, 6});
  REQUIRE(data.data->exact.size() == 1);
  CHECK(data.data->exact[0].second[2] == Rational(1, 3));
  const auto mesh = std::get<MeshShape>(read("mesh: {file: sub/part.stl, fill: cells, coordinates: decimal}"));
  CHECK(mesh.fill == Fill::cells);
  CHECK(mesh.decimal);
  CHECK(std::get<ResultShape>(read("cnrg: out.json")).file == "out.json");
}

TEST_CASE("a group leaf keeps sides, names and positions", "[tree]") {
  const Tree tree = parse_tree(R"(cnrg: 1
materials: {rock: {}}
nodes:
  layers:
    group:
      vertices: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], ["1/2", "1/2", 1]]
      faces:
        - {loops: [[0, 3, 2, 1]], sides: [0, 1]}
        - {loops: [[0, 1, 4]], sides: [0, 1]}
      edges: [[0, 4]]
      points: [2]
      regions: {1: {material: rock, name: lower}}
result: layers
)",
                               "t.yaml");
  const auto& group = shape<GroupShape>(tree, "layers");
  REQUIRE(group.faces.size() == 2);
  CHECK(group.faces[0].loops[0] == std::vector<std::uint32_t>{0, 3, 2, 1});
  CHECK(group.faces[1].sides == std::array<std::uint32_t, 2>{0, 1});
  CHECK(group.faces[1].line == 9);
  CHECK(group.faces[1].column == 11);
  CHECK(group.edges[0] == std::array<std::uint32_t, 2>{0, 4});
  CHECK(group.points == std::vector<std::uint32_t>{2});
  CHECK(group.regions.at(1).name == "lower");
  CHECK(group.regions.at(1).material == "rock");
}

TEST_CASE("operands are names or inline nodes of any depth", "[tree]") {
  std::string inside = "{points: [[0, 0, 0]]}";
  for (int depth = 0; depth < 100; ++depth) inside = "{union: [" + inside + ", {points: [[1, 0, 0]]}]}";
  const Tree tree = parse_tree("cnrg: 1\nnodes: {a: {complement: " + inside + "}}\nresult: a\n", "t.yaml");
  CHECK(tree.nodes.size() == 202);
  CHECK(tree.nodes[NodeId(1)].name == "a/1");
  CHECK(tree.nodes[NodeId(1)].is_inline);
  CHECK(tree.find("a/1/2") == NodeId(201));
  CHECK(reading_warnings(tree, {tree.result}).empty());
}

TEST_CASE("a YAML alias of an inline node is the same node", "[tree]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {union: [&p {points: [[0, 0, 0]]}, *p]}
  b: {union: [a, *p]}
result: b
)",
                               "t.yaml");
  CHECK(tree.nodes.size() == 3);
  CHECK(tree.operands(tree.find("a")) == std::vector<NodeId>{NodeId(2), NodeId(2)});
  CHECK(tree.operands(tree.find("b")) == std::vector<NodeId>{NodeId(0), NodeId(2)});
}

TEST_CASE("simplify and regularize are operators and attributes", "[tree]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  points: {points: [[0, 0, 0]]}
  plain: {simplify: points}
  forms: {simplify: {of: plain, mode: points}}
  keeps: {simplify: {of: {points: [[0, 0, 0]]}}}
  joins: {simplify: {of: plain, within: 1/8, mode: points}}
  inner: {simplify: {points: [[0, 0, 0]]}}
  side:  {union: [plain, forms, keeps, inner], simplify: points, regularize: true}
  last:  {regularize: side}
result: last
)",
                               "t.yaml");
  CHECK(node(tree, "plain").op == Operator::simplify);
  CHECK_FALSE(node(tree, "plain").forget_features);
  CHECK(tree.operands(tree.find("plain")) == std::vector<NodeId>{tree.find("points")});
  CHECK(node(tree, "forms").forget_features);
  CHECK_FALSE(node(tree, "keeps").forget_features);
  CHECK_FALSE(node(tree, "keeps").within);
  CHECK(node(tree, "joins").within == Rational(1, 8));
  CHECK(node(tree, "joins").forget_features);
  CHECK(tree.operands(tree.find("joins")) == std::vector<NodeId>{tree.find("plain")});
  CHECK(tree.operands_within(tree.find("joins")).empty());
  CHECK(tree.operands_within(tree.find("plain")).size() == 1);
  CHECK(tree.operands(tree.find("inner")).size() == 1);
  CHECK(node(tree, "side").op == Operator::unite);
  CHECK(node(tree, "side").forget_features);
  CHECK(node(tree, "side").regularize);
  CHECK(node(tree, "last").op == Operator::regularize);
}

TEST_CASE("keys of maps under `<<` stand in a map that has them not itself", "[tree][merge]") {
  const Tree tree = parse_tree(R"(cnrg: 1
$schema: tree.schema.json
x-parts:
  - &round {segments: 12, radius: 1}
  - &place {center: [1, 2, 3], <<: {radius: 9, rings: 4}}
nodes:
  a: &a {sphere: {<<: [*round, *place]}, name: first}
  b: {translate: [1, 0, 0], <<: *a, name: second}
  c: {union: [a, b], attributes: {"<<": quoted}}
result: c
)",
                               "t.yaml");
  const auto& a = shape<SphereShape>(tree, "a");
  CHECK(a.radius == 1);
  CHECK(a.rings == 4);
  CHECK(a.segments == 12);
  CHECK(a.center == RationalPoint{1, 2, 3});
  CHECK(shape<SphereShape>(tree, "b").center == a.center);
  CHECK(node(tree, "a").label == "first");
  CHECK(node(tree, "b").label == "second");
  CHECK(node(tree, "c").properties.contains("<<"));
  // At its place: transforms act in order, and parameters name those before.
  const Tree ordered = parse_tree(
      "cnrg: 1\nparameters: {<<: {n: 3}, m: n}\nnodes:\n"
      "  a: {<<: {translate: [1, 0, 0]}, scale: 2, points: [[0, 0, 0]]}\n"
      "  b: {scale: \"${m - 1}\", <<: {translate: [1, 0, 0]}, points: [[0, 0, 0]]}\n"
      "  c: {union: [a, b]}\nresult: c\n",
      "t.yaml");
  CHECK(node(ordered, "a").transform->offset == RationalPoint{2, 0, 0});
  CHECK(node(ordered, "b").transform->offset == RationalPoint{1, 0, 0});
  const auto fault = [](const std::string& inside) {
    try {
      single(inside);
    } catch (const TreeError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(fault("points: [[0, 0, 0]], <<: [1]") ==
        "t.yaml:3:39: error: `<<` must be a map {key: value, ...}, not the text `1`");
  CHECK(fault("points: [[0, 0, 0]], <<: rock") ==
        "t.yaml:3:38: error: `<<` must be a map, or a list of maps, not the text `rock`");
  CHECK(fault("points: [[0, 0, 0]], <<: {size: 1, size: 2}") ==
        "t.yaml:3:48: error: the key `size` is there twice in `<<`; remove or rename one");
  CHECK(fault("points: [[0, 0, 0]], <<: {sise: 1}").starts_with("t.yaml:3:39: error: unknown key `sise`"));
  CHECK_THAT(fault("points: [[0, 0, 0]], attributes: &m {k: 1, <<: *m}"),
             Catch::Contains("error: this map is merged into itself; remove the `<<` that names it"));
}

TEST_CASE("a number is a dominance on every node, a side on Booleans only", "[tree]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {points: [[0, 0, 0]], dominance: 1/2}
  b: {union: [a, a], dominance: equal}
  c: {union: [a, b], dominance: -3}
result: c
)",
                               "t.yaml");
  CHECK(*node(tree, "a").dominance == Rational(1, 2));
  CHECK(node(tree, "b").dominant == DominantOperand::equal);
  CHECK(*node(tree, "c").dominance == -3);
  CHECK_FALSE(node(tree, "c").dominant.has_value());
}

TEST_CASE("sizes are exact numbers of any node", "[tree][size]") {
  const Tree tree = parse_tree(
      "cnrg: 1\nnodes:\n  a: {points: [[0, 0, 0]], size: 1/3}\n  b: {complement: a, size: 0.5}\n"
      "  c: {complement: b}\nresult: c\n",
      "t.yaml");
  CHECK(*node(tree, "a").size == Rational(1, 3));
  CHECK(*node(tree, "b").size == Rational(1, 2));
  CHECK_FALSE(node(tree, "c").size);
}

TEST_CASE("of what is said on the way to a leaf the last counts, of several ways the shortest", "[tree][size]") {
  const auto sizes = [](const std::string& nodes) {
    const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: r\n", "t.yaml");
    const Unfolding unfolding = unfold(tree, {tree.result});
    return leaf_sizes(tree, unfolding.instances, unfolding.roots[0]);
  };
  const std::string leaves = "  a: {points: [[0, 0, 0]]}\n  b: {points: [[1, 0, 0]], size: 9}\n";
  CHECK(sizes(leaves + "  r: {union: [a, a]}\n").empty());
  CHECK(sizes(leaves + "  r: {union: [a, b], size: 2}\n") == std::vector<double>{2, 9});
  CHECK(sizes(leaves + "  r: {union: [a, b]}\n") == std::vector<double>{0, 9});
  CHECK(sizes(leaves + "  m: {union: [a, b], size: 4}\n  r: {union: [m, b], size: 2}\n") ==
        std::vector<double>{4, 9});
  CHECK(sizes(leaves + "  m: {union: [a, b], size: 4}\n  r: {union: [m, a], size: 2}\n") ==
        std::vector<double>{2, 9});
  CHECK(sizes(leaves + "  m: {complement: a, size: 4}\n  r: {union: [a, m]}\n") == std::vector<double>{4});
  // Two instances of one leaf, of which one hears something.
  CHECK(sizes(leaves + "  m: {simplify: a, translate: [5, 0, 0], size: 4}\n  r: {union: [a, m]}\n").size() == 2);
}

}  // namespace
}  // namespace cnrg
