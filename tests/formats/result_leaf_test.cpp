// Results read back: the same complex, the same file; and every broken file named with its place.
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>

#include "csg/leaves/leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/operators/cnrg.h"
#include "csg/text/file.h"
#include "csg/transfer/leaf_value.h"
#include "csg/tree/tree.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"
#include "tests/scenes/scene.h"

using namespace cnrg;
using namespace cnrg::test;
using Json = nlohmann::json;

namespace {

/// A result file without what tells where it came from; also without `more` of each cell.
Json comparable(const std::string& path, const std::vector<std::string>& more = {}) {
  Json json = Json::parse(text_of(path));
  json.erase("leaves");
  for (auto& component : json["components"]) component.erase("leaves");
  for (const char* kind : {"regions", "faces", "edges", "vertices"}) {
    for (auto& cell : json[kind]) {
      cell.erase("origin");
      for (const std::string& key : more) cell.erase(key);
    }
  }
  return json;
}

/// Of the first leaf of the soup.
NodeValue value_of(const Case& c, const PreparedLeaf& prepared) {
  REQUIRE(prepared.stored() != nullptr);
  const CellMap map(*c.complex, {part_of(LeafId(0), *prepared.stored(), c.vertex_of)});
  return leaf_value(*c.complex, LeafId(0), c.leaves[0], *prepared.stored(), map, prepared.regions(),
                    std::identity());
}

Case read_back(const std::string& path, const Transform& transform = {}) {
  const auto leaf = prepare_result({path});
  Soup soup;
  leaf->add_to(soup, transform);
  Case c(soup);
  REQUIRE(validate(*c.complex) == "");
  c.show(value_of(c, *leaf));
  return c;
}

/// Read and written, a result is the same but for where it came from; then it stays the same file.
void check_round_trip(const Case& c) {
  const ScratchFolder dir;
  write(dir / "a.json", c.view());
  Case again = read_back(dir / "a.json");
  again.materials = c.materials;
  write(dir / "b.json", again.view());
  const bool same = comparable(dir / "a.json") == comparable(dir / "b.json");
  CHECK(same);
  Case third = read_back(dir / "b.json");
  third.materials = c.materials;
  write(dir / "c.json", third.view());
  const bool same_again = text_of(dir / "b.json") == text_of(dir / "c.json");
  CHECK(same_again);
  Transform mirror;
  mirror.linear[0][0] = -1;
  mirror.offset = {Rational(1, 3), 0, 0};
  Case mirrored = read_back(dir / "a.json", mirror);
  mirrored.materials = c.materials;
  write(dir / "m.json", mirrored.view());
  Case back = read_back(dir / "m.json", mirror);
  back.materials = c.materials;
  write(dir / "n.json", back.view());
  const bool same_after_mirrors = comparable(dir / "a.json") == comparable(dir / "n.json");
  CHECK(same_after_mirrors);
  write(dir / "x.vtu", c.view());
}

}  // namespace

TEST_CASE("round trip: faces with holes, a slit, a bridge and touching loops") {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const auto ring = [&](std::vector<RationalPoint> points) {
    std::vector<PointId> loop;
    for (const auto& p : points) loop.push_back(soup.add_point(p));
    return loop;
  };
  const std::vector<std::vector<PointId>> loops{
      ring({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}),
      ring({{2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}}),
      ring({{4, 4, 0}, {5, 6, 0}, {6, 5, 0}}),
  };
  soup.add_face(leaf, loops, 0, 0);
  const auto wire = [&](const RationalPoint& a, const RationalPoint& b, std::uint32_t number) {
    soup.add_wire(leaf, soup.add_point(a), soup.add_point(b), number);
  };
  wire({0, 0, 0}, {2, 2, 0}, 0);  // a bridge
  wire({7, 7, 0}, {8, 7, 0}, 1);  // a slit
  wire({8, 7, 0}, {8, 8, 2}, 1);
  soup.add_isolated(leaf, soup.add_point(RationalPoint{1, 8, 0}));
  Case c(soup);
  check_round_trip(c);
}

TEST_CASE("round trip: curved patches, cut by others") {
  Soup soup;
  add_drum(soup, 12, -4, 4);
  add_box(soup, {-9, -9, 0}, {9, 9, 2});
  Case c(soup, {{{"drum", "", {}}}, {{"slab", "", {}}}});
  check_round_trip(c);
  for (const Dominance d : {Dominance::left, Dominance::right, Dominance::equal}) {
    c.show(c.unite(d));
    check_round_trip(c);
  }
  c.show(boolean_operation(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[0], c.leaves[1]).group);
  check_round_trip(c);
}

TEST_CASE("round trip: a flat face whose rim is a curve") {
  Soup soup;
  add_drum(soup, 12, -4, 4);
  const LeafId sheet = soup.add_leaf(Fill::none);
  const std::vector<std::vector<PointId>> square{{soup.add_point(-90, -90, 0), soup.add_point(90, -90, 0),
                                                  soup.add_point(90, 90, 0), soup.add_point(-90, 90, 0)}};
  soup.add_face(sheet, square, 0, 0);
  Case c(soup, {{{"drum", "", {}}}});
  c.show(boolean_operation(*c.complex, BooleanOp::intersect, Dominance::equal, c.leaves[1], c.leaves[0]).group);
  CHECK(active_counts(c.simplified) == std::array<std::size_t, 4>{0, 1, 1, 0});
  check_round_trip(c);
  c.show(boolean_operation(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[1], c.leaves[0]).group);
  CHECK(active_counts(c.simplified) == std::array<std::size_t, 4>{4, 5, 1, 0});
  check_round_trip(c);
}

TEST_CASE("round trip: what a curved component leaves open, or bounds as another") {
  Soup soup;
  add_box(soup, {-9, -9, -9}, {9, 9, 9});
  add_drum(soup, 12, -4, 4);
  Case c(soup);
  const Components box = components_of(*c.complex, c.leaves[0]), drum = components_of(*c.complex, c.leaves[1]);
  c.show(subtract(*c.complex, box, drum).value);
  check_round_trip(c);
  c.show(subtract(*c.complex, drum, box).value);
  check_round_trip(c);
  const Components open = topological_operation(*c.complex, Topological::interior, drum).value;
  c.show(subtract(*c.complex, box, open).value);
  check_round_trip(c);
  c.show(sum(*c.complex, box, open).value);
  check_round_trip(c);
}

TEST_CASE("round trip: a curved face that meets itself in an edge") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  s: {bezier: {patch: [[[0, 1, 2], [2, 2, 0]], [[1, 2, 0], [1, 2, 0]], [[1, 0, 0], [2, 2, 2]]], segments: 2}}
result: s
)",
                               "t.yaml");
  Soup soup;
  prepare(*tree.nodes[tree.result].shape)->add_to(soup, {});
  Case c(soup);
  check_round_trip(c);
}

TEST_CASE("a leaf of a result mirrors and moves exactly") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 2, 3});
  Case c(soup);
  const ScratchFolder dir;
  write(dir / "a.json", c.view());
  const auto leaf = prepare_result({dir / "a.json"});
  Soup mirrored;
  Transform mirror;
  mirror.linear[0][0] = -1;
  mirror.offset = {Rational(1, 3), 0, 0};
  leaf->add_to(mirrored, mirror);
  Case again(mirrored);
  REQUIRE(again.group.regions.size() == 1);
  write(dir / "b.json", again.view());
  const Json json = Json::parse(text_of(dir / "b.json"));
  CHECK(json["points"][0] == Json{"-2/3", "0", "0"});
  CHECK(json["regions"].size() == 2);
  CHECK(json["regions"][0]["volume"] != json["regions"][1]["volume"]);
}

TEST_CASE("a group without bounds is read back, a plane is not") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup, {{{"rock", "granite", {}}}});
  c.show(complement(*c.complex, c.group));
  check_round_trip(c);
  const auto halfspace = prepare(Shape(HalfspaceShape{{0, 0, 0}, {0, 0, 1}}));
  Case half(make_soup({{halfspace}}));
  const ScratchFolder dir;
  for (const Topological op : {Topological::interior, Topological::closure}) {
    half.show(topological_operation(*half.complex, op, components_of(*half.complex, half.leaves[0])).value);
    write(dir / "half.json", half.view());
    using Catch::Contains;
    CHECK_THROWS_WITH(prepare_result({dir / "half.json"}), Contains("no bounds") && Contains("product"));
  }
}

namespace {

/// The scene's leaves and a box, the values of which it makes the most, by seed.
void check_random_scene(std::uint64_t seed, scenes::Position position) {
  CAPTURE(seed, int(position));
  const Rational size = position == scenes::Position::general ? 16 : 4;
  const RationalPoint low{Rational(1, 2), Rational(3, 2), Rational(1, 2)}, high{size, size, size};
  Soup soup = scenes::make_soup(scenes::random_leaves(seed, 2, position));
  add_box(soup, low, high);
  Names names(3);
  for (auto& regions : names) {
    for (int i = 0; i < 3; ++i) regions.push_back({"r" + std::to_string(&regions - names.data()), "rock", {}});
  }
  Case c(soup, names);
  c.leaves[0].dominance = 1;
  const Components a = components_of(*c.complex, c.leaves[0]), b = components_of(*c.complex, c.leaves[1]);
  const Components box = components_of(*c.complex, c.leaves[2]);
  scenes::Random random(seed);
  const Complex& complex = *c.complex;
  Components value;
  switch (seed % 8) {
    case 0: value = sum(complex, a, b).value; break;
    case 1: value = product(complex, a, b).value; break;
    case 2: value = subtract(complex, a, b).value; break;
    case 3: value = topological_operation(complex, Topological::interior, sum(complex, a, b).value).value; break;
    case 4:
      value = topological_operation(complex, Topological::closure, subtract(complex, b, a).value).value;
      break;
    case 5:
      value = topological_operation(complex, Topological::boundary, subtract(complex, b, a).value).value;
      break;
    case 6: value = complement(complex, sum(complex, a, b).value).value; break;
    default:
      value = topological_operation_of_each(complex, Topological::regularize, sum(complex, a, b).value).value;
      break;
  }
  c.show(value);
  check_round_trip(c);
  c.show(boolean_operation(complex, BooleanOp::unite, Dominance(random.below(3)), c.leaves[0], c.leaves[1]).group);
  check_round_trip(c);
  c.show(boolean_operation(complex, BooleanOp::subtract, Dominance::equal, c.leaves[0], c.leaves[1]).group);
  check_round_trip(c);

  // Where another leaf cuts its cells the value is the same, and operators give the same.
  const ScratchFolder dir;
  c.show(value);
  write(dir / "a.json", c.view());
  const auto leaf = prepare_result({dir / "a.json"});
  Soup second;
  leaf->add_to(second, {});
  add_box(second, low, high);
  Case cut(second, {{}, names[2]});
  cut.show(value_of(cut, *leaf));
  write(dir / "b.json", cut.view());
  const bool same = comparable(dir / "a.json") == comparable(dir / "b.json");
  CHECK(same);
  c.show(sum(complex, value, box).value);
  cut.show(sum(*cut.complex, cut.value.components(), components_of(*cut.complex, cut.leaves[1])).value);
  write(dir / "a.json", c.view());
  write(dir / "b.json", cut.view());
  // Patches and features are those of the leaves; which diagonal halves a rectangle depends on roundings.
  const std::vector<std::string> of_leaves{"patch", "feature", "triangles"};
  const bool same_sum = comparable(dir / "a.json", of_leaves) == comparable(dir / "b.json", of_leaves);
  CHECK(same_sum);
}

}  // namespace

TEST_CASE("round trip: random values of components and groups") {
  for (std::uint64_t seed = 1; seed <= 48; ++seed) {
    check_random_scene(seed, scenes::Position::degenerate);
    if (seed % 3 == 0) check_random_scene(seed, scenes::Position::general);
    if (seed % 3 == 1) check_random_scene(seed, scenes::Position::tilted);
  }
}

TEST_CASE("broken files are refused with their place") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_point(soup, {3, 3, 3});
  Case c(soup);
  c.show(c.unite());
  const ScratchFolder dir;
  write(dir / "good.json", c.view());
  const std::string good = text_of(dir / "good.json");
  const auto refused = [&](const std::string& text) -> std::string {
    replace_file(dir / "bad.json", text);
    try {
      prepare_result({dir / "bad.json"});
    } catch (const InputError& error) {
      return std::string(error.what()).substr((dir / "bad.json").size());
    }
    return "accepted";
  };
  const auto edited = [&](const std::string& pointer, const Json& value) {
    Json json = Json::parse(good);
    json[Json::json_pointer(pointer)] = value;
    return refused(json.dump());
  };
  const auto erased = [&](const std::string& pointer, const std::string& key) {
    Json json = Json::parse(good);
    json[Json::json_pointer(pointer)].erase(key);
    return refused(json.dump());
  };
  const auto inactive = [&](const std::string& pointer) {
    Json cell = Json::parse(good)[Json::json_pointer(pointer)];
    cell.erase("origin");
    cell["component"] = 0;
    return cell;
  };
  /// Has a line and a column, and then begins so.
  const auto starts = [](const std::string& text, const std::string& head) {
    CAPTURE(text);
    static const std::regex kPlace("^:[0-9]+:[0-9]+(: error: [^]*)$");
    std::smatch match;
    return std::regex_match(text, match, kPlace) && match[1].str().starts_with(head);
  };
  CHECK(refused(good) == "accepted");
  CHECK(refused(good.substr(0, good.size() / 2)).find(": error: this is no JSON") != std::string::npos);
  CHECK(refused("").starts_with(":1:1: error: the file is empty: write the file again with "));
  CHECK(starts(refused("[]"), ": error: "));
  CHECK(starts(edited("/format", "other"), ": error: "));
  CHECK(starts(edited("/version", 2), ": error: /version: "));
  CHECK(starts(edited("/points/3", Json{"1", "2"}), ": error: /points/3: "));
  CHECK(starts(edited("/points/3/1", "1/0"), ": error: /points/3/1: "));
  CHECK(starts(edited("/points/3/1", 0.5), ": error: /points/3/1: "));
  CHECK(starts(edited("/faces/2/loops/0/1", 99), ": error: /faces/2/loops/0/1: point 99 does not exist"));
  CHECK(starts(edited("/faces/2/loops/0/1", -1), ": error: /faces/2/loops/0/1: "));
  CHECK(starts(edited("/faces/2/loops", Json::array()), ": error: /faces/2/loops: "));
  CHECK(starts(edited("/faces/2/regions/0", 9), ": error: /faces/2/regions/0: "));
  CHECK(starts(edited("/faces/2/regions", "x"), ": error: /faces/2/regions: "));
  CHECK(starts(erased("/faces/2", "patch"), ": error: /faces/2: "));
  CHECK(starts(erased("", "dominance"), ": error: "));
  CHECK(starts(erased("", "edges"), ": error: "));
  CHECK(starts(edited("/points/0/0", "1/9"), ": error: /points/1: "));  // no longer sorted
  CHECK(starts(edited("/points/7/0", "10/9"), ": error: /faces/"));     // no longer planar
  CHECK(starts(edited("/vertices/8/point", 7), ": error: /vertices/8: "));
  CHECK(starts(edited("/regions/0/component", 7), ": error: /regions/0/component: component 7 does not exist"));
  CHECK(starts(edited("/edges/4/component", 0), ": error: /faces/"));
  CHECK(starts(edited("/edges/4", inactive("/edges/4")), ": error: /faces/"));  // not closed
  CHECK(starts(edited("/vertices/0", inactive("/vertices/0")), ": error: /edges/"));
  CHECK(starts(edited("/vertices/1/point", 0), ": error: /edges/"));
  CHECK(starts(edited("/edges/0/points", Json{0, 0}), ": error: /edges/0/points/1: "));
  CHECK_THROWS_AS(prepare_result({dir / "none.json"}), FileError);
  CHECK_THROWS_AS(prepare_result({dir.path()}), FileError);
}

TEST_CASE("what a file says and its cells do not is refused at the first cell") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add_wire(soup, {2, 2, 5}, {2, 2, 9});
  add_sheet(soup, {{0, 0, 6}, {1, 0, 6}, {1, 1, 6}, {0, 1, 6}});
  Case c(soup, {{{"stone", "rock", {}}}});
  c.show(c.unite());
  const ScratchFolder dir;
  write(dir / "good.json", c.view());
  const Json good = Json::parse(text_of(dir / "good.json"));
  const auto fault = [&](const std::function<void(Json&)>& change) -> std::string {
    Json json = good;
    change(json);
    replace_file(dir / "bad.json", json.dump(1));
    try {
      prepare_result({dir / "bad.json"});
    } catch (const LeafFileError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto put = [&](const char* pointer, const Json& value) {
    return fault([&](Json& json) { json[Json::json_pointer(pointer)] = value; });
  };
  const std::string place = "bad.json:";
  using Catch::Contains;
  CHECK(fault([](Json&) {}) == "accepted");
  // Regions without faces.
  CHECK_THAT(fault([](Json& json) {
               json["faces"] = Json::array();
               for (auto& edge : json["edges"]) edge["wire"] = true, edge["region"] = 0;
               for (auto& region : json["regions"]) region["shells"] = Json::array();
             }),
             Contains("/components: the result calls itself a group but a component is not one region"));
  CHECK_THAT(put("/faces", Json::array()), Contains("error: "));
  // The ends of the wire are points 8 and 9: through the box, onto a face, through the sheet.
  REQUIRE(good["points"][8] == Json{"2", "2", "5"});
  CHECK_THAT(put("/points/8/2", "-1"), Contains("error: "));
  const auto wire = [&](const char* x, const char* y, const char* z) {
    return fault([&](Json& json) { json["points"][8] = {x, y, z}; });
  };
  CHECK_THAT(
      wire("2", "2", "3"),
      Contains("/edges/") && Contains("another cell meets this one in (2, 2, 4), where the file has no point"));
  CHECK_THAT(wire("2", "2", "4"), Contains("/faces/") && Contains("isolated"));
  // Numbers of things that do not exist.
  CHECK_THAT(put("/vertices/0/origin/0/leaf", 99), Contains("/vertices/0/origin/0/leaf: leaf 99 does not exist"));
  CHECK_THAT(put("/faces/0/regions/0", 99), Contains("/faces/0/regions/0: region 99 does not exist"));
  CHECK_THAT(put("/regions/1/shells/0/0/face", 99),
             Contains("/regions/1/shells/0/0/face: by the cells of the file this is 0"));
  CHECK_THAT(put("/faces/0/triangles/0/1", 99), Contains("/faces/0/triangles/0/1: point 99 does not exist"));
  CHECK_THAT(put("/components/0/material", "gold"), Contains("/components/0/material: `materials` has none"));
  CHECK_THAT(put("/components/0/leaves/0", 7), Contains("/components/0/leaves/0: leaf 7 does not exist"));
  // Things that exist and are others.
  CHECK_THAT(put("/regions/1/volume", "65"), Contains("/regions/1/volume: ") && Contains("64"));
  CHECK_THAT(put("/regions/1/bounded", false), Contains("error: "));
  CHECK_THAT(put("/regions/1/name", "clay"),
             Contains("/regions/1/name: by the cells of the file this is 'stone'"));
  CHECK_THAT(put("/regions/1/shells/0/0/side", "front"),
             Contains("/regions/1/shells/0/0/side: by the cells of the file this is 'back'"));
  CHECK_THAT(put("/faces/0/triangles/0/1", 3), Contains("/faces/0/triangles"));
  CHECK_THAT(put("/faces/0/entity", false), Contains("/faces/0/entity: "));
  CHECK_THAT(put("/faces/0/patch", 5), Contains("/faces/0/patch: by the cells of the file this is 0"));
  CHECK_THAT(put("/edges/0/wire", true), Contains("/edges/0/wire: by the cells of the file this is false"));
  CHECK_THAT(put("/faces/0/colour", 1), Contains("no member of results is called 'colour' here"));
  CHECK_THAT(put("/points/0/0", "0/1"), Contains("error: "));
  CHECK_THAT(put("/points/9/0", "4/2"), Contains("/points/9/0: fractions are in lowest terms; this one is '2'"));
  // The line is that of the value.
  const std::string text = good.dump(1);
  const std::string volume = put("/regions/1/volume", "65");
  const auto at = text.find("\"volume\": \"64\"");
  REQUIRE(at != std::string::npos);
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
  CHECK_THAT(volume, Contains(place + std::to_string(line) + ":14: error: "));
}

TEST_CASE("a region of a file is in one piece") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {5, 0, 0}, {6, 1, 1});
  Case c(soup);
  c.show(unify(*c.complex, components_of(*c.complex, c.unite())).value);
  const ScratchFolder dir;
  write(dir / "two.json", c.view());
  Json json = Json::parse(text_of(dir / "two.json"));
  REQUIRE(json["regions"].size() == 3);
  std::vector<int> number(3), active;
  for (int i = 0; i < 3; ++i) {
    if (json["regions"][i]["component"] == 1) active.push_back(i);
  }
  REQUIRE(active.size() == 2);
  for (int i = 0; i < 3; ++i) number[i] = i == active[1] ? active[0] : i - (i > active[1]);
  json["regions"].erase(active[1]);
  for (auto& face : json["faces"]) {
    for (auto& region : face["regions"]) region = number[region.get<int>()];
  }
  std::ofstream(dir / "one.json") << json.dump();
  CHECK_THROWS_WITH(prepare_result({dir / "one.json"}), Catch::Contains("/faces/") &&
                                                            Catch::Contains("/regions/") &&
                                                            Catch::Contains("by the cells of the file this is 2"));
}

TEST_CASE("components have the numbers of their file, also beside leaves that cut them") {
  Soup soup;
  add_box(soup, {5, 0, 0}, {6, 1, 1});
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup, {{{"far", "", {}}}, {{"near", "", {}}}});
  c.show(c.unite());
  const ScratchFolder dir;
  write(dir / "a.json", c.view());
  // A file that numbers them in another order than we do.
  Json json = Json::parse(text_of(dir / "a.json"));
  REQUIRE(json["components"][0]["name"] == "near");
  std::swap(json["components"][0], json["components"][1]);
  for (Json& region : json["regions"]) {
    if (const int number = region["component"].get<int>(); number > 0) region["component"] = 3 - number;
  }
  std::ofstream(dir / "a.json") << json.dump();
  const auto leaf = prepare_result({dir / "a.json"});
  Soup second;
  leaf->add_to(second, {});
  add_box(second, {Rational(1, 2), Rational(1, 2), Rational(1, 2)}, {9, 9, 9});
  Case cut(second);
  cut.show(value_of(cut, *leaf));
  CHECK(cut.group.regions.at(0).name == "far");
  CHECK(cut.group.regions.at(1).name == "near");
  write(dir / "b.json", cut.view());
  const bool same = comparable(dir / "a.json") == comparable(dir / "b.json");
  CHECK(same);
  // Operators take such a group as any other.
  const Group all = cut.unite(Dominance::left);
  CHECK(all.regions.size() == 3);
  const Group rest =
      boolean_operation(*cut.complex, BooleanOp::subtract, Dominance::equal, cut.group, cut.leaves[1]).group;
  CHECK(rest.regions.size() == 2);
}
