// Results read back: the same complex, the same file; and every broken file named with its place.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "cases.h"
#include "csg/operators/cnrg.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/result_leaf.h"
#include "csg/output/file.h"
#include "kernel/base/error.h"

using namespace cnrg;
using namespace cnrg::test;
using Json = nlohmann::json;

namespace {

/// A result file without what tells where it came from, components numbered as they come. Borders between two
/// faces of a leaf are features of it, so reading back may add features: left out unless `features`.
Json comparable(const std::string& path, bool features = false) {
  Json json = Json::parse(text_of(path));
  json.erase("leaves");
  std::vector<int> number(json["components"].size() + 2, -1);
  number[0] = 0;
  int next = 1;
  const auto renumber = [&](Json& cell) {
    int& n = number.at(cell["component"].get<std::size_t>());
    if (n < 0) n = next++;
    cell["component"] = n;
    cell.erase("leaves");
    cell.erase("sources");
    if (!features) cell.erase("feature");
  };
  for (auto& cell : json["regions"]) renumber(cell);
  for (const char* kind : {"faces", "edges", "vertices"}) {
    for (auto& cell : json[kind]) renumber(cell);
  }
  json.erase("components");
  return json;
}

Case read_back(const std::string& path) {
  const auto leaf = prepare_result({path});
  Soup soup;
  leaf->add_to(soup, {});
  Names names(1);
  for (const LeafRegion& region : leaf->regions()) names[0].push_back({region.name, region.material, {}});
  Case c(soup, names);
  REQUIRE(validate(*c.complex) == "");
  return c;
}

void check_round_trip(Case& c) {
  const Scratch dir;
  write(dir / "a.json", c.view());
  Case again = read_back(dir / "a.json");
  again.materials = c.materials;
  write(dir / "b.json", again.view());
  const bool same = comparable(dir / "a.json") == comparable(dir / "b.json");
  CHECK(same);
  Case third = read_back(dir / "b.json");
  third.materials = c.materials;
  write(dir / "c.json", third.view());
  const bool same_again = comparable(dir / "b.json", true) == comparable(dir / "c.json", true);
  CHECK(same_again);
  for (const std::string name : {"x.vtu", "x.obj"}) {  // the same geometry in other formats as well
    write(dir / name, c.view());
    write(dir / ("y" + name), again.view());
  }
  CHECK(text_of(dir / "x.obj") == text_of(dir / "yx.obj"));
}

}  // namespace

TEST_CASE("round trip: a box") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, Rational(2, 3), Rational(1, 7)});
  Case c(soup, {{{"stone", "rock", {}}}});
  c.materials = {{"rock", "#123456"}};
  check_round_trip(c);
}

TEST_CASE("round trip: walls, sheets in and out, wires, points, a cavity") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {6, 6, 6});
  add_box(soup, {4, 4, 4}, {8, 8, 8});
  add_sheet(soup, {{1, -1, -1}, {1, 7, -1}, {1, 7, 7}, {1, -1, 7}});
  add_sheet(soup, {{2, 2, 2}, {3, 2, 2}, {3, 3, 2}});
  add_wire(soup, {2, 1, 1}, {3, 1, 1});
  add_wire(soup, {5, 5, 5}, {9, 9, 10});
  add_point(soup, {2, 5, 5});
  add_point(soup, {0, 3, 3});
  add_point(soup, {0, 0, 5});
  add_wire(soup, {0, 2, 2}, {0, 2, 4});
  Case c(soup, {{{"first", "rock", {}}}, {{"second", "", {}}}});
  c.show(c.unite(Dominance::left));
  check_round_trip(c);
  c.show(apply(*c.complex, BooleanOp::subtract, Dominance::equal, c.group, c.leaves[1]).group);
  check_round_trip(c);
}

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
  c.show(apply(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[0], c.leaves[1]).group);
  check_round_trip(c);
}

TEST_CASE("round trip: a flat face whose rim is a curve") {
  Soup soup;
  add_drum(soup, 12, -4, 4);
  const LeafId sheet = soup.add_leaf(Fill::none);
  const std::vector<std::vector<PointId>> square{
      {soup.add_point(-90, -90, 0), soup.add_point(90, -90, 0), soup.add_point(90, 90, 0), soup.add_point(-90, 90, 0)}};
  soup.add_face(sheet, square, 0, 0);
  Case c(soup, {{{"drum", "", {}}}});
  c.show(apply(*c.complex, BooleanOp::intersect, Dominance::equal, c.leaves[1], c.leaves[0]).group);
  CHECK(active_counts(c.simplified) == std::array<std::size_t, 4>{0, 1, 1, 0});
  check_round_trip(c);
  c.show(apply(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[1], c.leaves[0]).group);
  CHECK(active_counts(c.simplified) == std::array<std::size_t, 4>{4, 5, 1, 0});
  check_round_trip(c);
}

TEST_CASE("round trip: a horizon and a fault part a box") {
  HeightfieldShape horizon;
  horizon.origin_x = horizon.origin_y = -1;
  for (int j = 0; j < 8; ++j) {
    auto& row = horizon.heights.emplace_back();
    for (int i = 0; i < 8; ++i) row.push_back(3 + Rational((i * 5 + j * 3) % 7 - 3, 10));
  }
  const auto leaf = prepare(Shape(horizon));
  Soup soup;
  leaf->add_to(soup, {});
  add_sheet(soup, {{2, -1, -1}, {2, 7, -1}, {4, 7, 8}, {4, -1, 8}});
  add_box(soup, {0, 0, 0}, {5, 5, 6});
  Case c(soup, {{}, {}, {{"rock", "", {}}}});
  const Group surfaces = apply(*c.complex, BooleanOp::unite, Dominance::equal, c.leaves[0], c.leaves[1]).group;
  const Group layers = apply(*c.complex, BooleanOp::unite, Dominance::left, surfaces, c.leaves[2]).group;
  const Group outside = complement(*c.complex, c.leaves[2]);
  c.show(apply(*c.complex, BooleanOp::subtract, Dominance::equal, layers, outside).group);
  CHECK(c.group.regions.size() == 4);
  check_round_trip(c);
}

TEST_CASE("a leaf of a result mirrors and moves exactly") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 2, 3});
  Case c(soup);
  const Scratch dir;
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

TEST_CASE("results that can be no leaf say why") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup);
  const Scratch dir;
  c.show(complement(*c.complex, c.group));
  write(dir / "unbounded.json", c.view());
  using Catch::Contains;
  CHECK_THROWS_WITH(prepare_result({dir / "unbounded.json"}), Contains("/regions/") && Contains("no bounds"));
  c.show(apply(*c.complex, Topological::interior, components_of(*c.complex, c.leaves[0])).value);
  write(dir / "open.json", c.view());
  CHECK_THROWS_WITH(prepare_result({dir / "open.json"}), Contains("/faces/0") && Contains("closure"));
}

TEST_CASE("broken files are refused with their place") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_point(soup, {3, 3, 3});
  Case c(soup);
  c.show(c.unite());
  const Scratch dir;
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
  const auto starts = [](const std::string& text, const std::string& head) {
    CAPTURE(text);
    return text.rfind(head, 0) == 0;
  };
  CHECK(refused(good) == "accepted");
  CHECK(refused(good.substr(0, good.size() / 2)).find(": error: this is no JSON") != std::string::npos);
  CHECK(starts(refused(""), ":1:1: error: "));
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
  CHECK(starts(erased("/faces/2", "entity"), ": error: /faces/2: "));
  CHECK(starts(erased("", "edges"), ": error: "));
  CHECK(starts(edited("/points/0/0", "1/9"), ": error: /faces/"));              // no longer planar
  CHECK(starts(edited("/edges/4/component", 0), ": error: /faces/"));           // not closed
  CHECK(starts(edited("/vertices/0/component", 0), ": error: /edges/"));
  CHECK(starts(edited("/vertices/1/point", 0), ": error: /vertices/1: "));
  CHECK(starts(edited("/edges/0/points", Json{0, 0}), ": error: /edges/0/points/1: "));
  CHECK_THROWS_AS(prepare_result({dir / "none.json"}), InputError);
  CHECK_THROWS_AS(prepare_result({dir.path()}), FileError);
}
