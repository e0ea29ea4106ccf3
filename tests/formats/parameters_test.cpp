// Parameters in files: .json keeps them through reading back, .vtu shows them, and neither without being asked.
#include "csg/leaves/parameters.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "csg/formats/result_file.h"
#include "csg/leaves/leaf.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"
#include "tests/formats/vtu_reader.h"

using namespace cnrg;
using namespace cnrg::test;
using Json = nlohmann::json;

namespace {

// A pierced ball, a cone through a sheet, flat patches: one affine, one whose net is not uniform, a disc swept.
const char* const kPatchTree = R"(cnrg: 1
nodes:
  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: 12}}
  pin: {cylinder: {from: [0, 0, -2], to: [0.25, 0, 2], radius: 1/2, segments: 7}}
  cone: {cone: {from: [3, 0, 0], to: [3, 0, 1], radius: 1, top: 1/3, segments: 6}}
  sheet: {bezier: {patch: [[[2, -1, 0], [3, -1, 1], [4, -1, 1]], [[2, 1, 1], [3, 1, 0], [4, 1, 1/2]]], segments: 4}}
  even: {bezier: {patch: [[[6, 0, 0], [7, 0, 0]], [[6, 1, 0], [7, 1, 0]]], segments: 4}}
  uneven: {bezier: {patch: [[[6, 2, 0], [7, 2, 0], [9, 2, 0]], [[6, 3, 0], [7, 3, 0], [9, 3, 0]]], segments: 4}}
  disc: {revolve: {profile: [[0, 0], [1, 0], [1, 1], [0, 1]], center: [12, 0, 0], segments: 6}}
  drilled: {difference: [ball, pin]}
  hat: {union: [cone, sheet], dominance: right}
  all: {union: [drilled, hat, even, uneven, disc, {box: {min: [-4, 0, 0], max: [-3, 1, 1]}}]}
result: all
)";

std::string file_of(const std::string& text, const std::string& name, bool parameters, const ScratchFolder& dir) {
  const Tree tree = parse_tree(text, dir / "t.yaml");
  write(dir / name, evaluate(tree).result(), {.parameters = parameters});
  return text_of(dir / name);
}

/// Points, faces and their patches and cells; not what tells leaves apart and how regions are numbered.
Json parts_with_patches(const std::string& text) {
  const Json json = Json::parse(text);
  Json result{{"points", json["points"]}, {"cells", json["cells"]}, {"patches", json["patches"]}};
  for (auto& patch : result["patches"]) patch.erase("leaf");
  for (const auto& face : json["faces"]) {
    Json one;
    for (const char* key : {"loops", "facets", "patch", "cells"}) one[key] = face.value(key, Json());
    result["faces"].push_back(one);
  }
  return result;
}

}  // namespace

TEST_CASE("a result without curved leaves has the same file with parameters") {
  const ScratchFolder dir;
  const std::string boxes = "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nresult: a\n";
  CHECK(file_of(boxes, "a.json", true, dir) == file_of(boxes, "b.json", false, dir));
  // What is not asked for is not there.
  const std::string without = file_of(kPatchTree, "c.json", false, dir);
  CHECK(without.find("cells") == std::string::npos);
  Json json = Json::parse(file_of(kPatchTree, "d.json", true, dir));
  for (const char* key : {"patches", "cells"}) json.erase(key);
  for (auto& face : json["faces"]) face.erase("cells");
  CHECK((json == Json::parse(without)));
}

TEST_CASE("json: every facet of a curved patch has its cells, and they are kept when the file is read back") {
  const ScratchFolder dir;
  const std::string text = file_of(kPatchTree, "a.json", true, dir);
  const Json json = Json::parse(text);
  std::map<std::size_t, std::string> names;
  for (const auto& patch : json["patches"]) names[patch["patch"]] = patch["name"];
  std::multiset<std::string> known;
  for (const auto& [patch, name] : names) known.insert(name);
  CHECK(known == std::multiset<std::string>{"sphere", "cylinder side", "cone side", "bezier patch", "bezier patch",
                                            "bezier patch", "revolve segment 1", "revolve segment 2",
                                            "revolve segment 3"});
  const auto point = [&](const Json& p) {
    RationalPoint q;
    for (std::size_t k = 0; k < 3; ++k) q[k] = *parse_rational(p[k].get<std::string>());
    return q;
  };
  std::size_t curved = 0;
  for (const auto& face : json["faces"]) {
    REQUIRE(names.count(face["patch"]) == face.count("cells"));
    if (!face.contains("cells")) continue;
    const bool flat = !face.contains("facets");
    REQUIRE(face["cells"].size() == (flat ? 1 : face["facets"].size()));
    for (std::size_t i = 0; i < face["cells"].size(); ++i) {
      const Json& facet = flat ? face : face["facets"][i];
      for (const auto& corner : facet["loops"][0]) {
        std::size_t holding = 0;
        for (const auto& number : face["cells"][i]) {
          std::vector<PatchCorner> cell;
          for (const auto& c : json["cells"][number.get<std::size_t>()]) {
            cell.push_back(
                {point(c), {*parse_rational(c[3].get<std::string>()), *parse_rational(c[4].get<std::string>())}});
          }
          REQUIRE(is_cell(cell));
          CHECK(dot(cross(cell[1].point - cell[0].point, cell[2].point - cell[0].point),
                    point(json["points"][corner.get<std::size_t>()]) - cell[0].point) == 0);
          holding += holds(cell, point(json["points"][corner.get<std::size_t>()]));
        }
        CHECK(holding >= 1);
        ++curved;
      }
    }
  }
  CHECK(curved > 300);

  const std::string again = "cnrg: 1\nnodes:\n  r: {cnrg: " + (dir / "a.json") + "}\nresult: r\n";
  CHECK((parts_with_patches(file_of(again, "b.json", true, dir)) == parts_with_patches(text)));
  CHECK(file_of(again, "c.json", false, dir).find("cells") == std::string::npos);

  // Cut once more, the same points have the same parameters.
  const auto places = [&](const std::string& leaf, const std::vector<LeafId>& leaves, std::size_t& found) {
    const Tree tree = parse_tree(leaf, dir / "t.yaml");
    const Evaluation evaluation = evaluate(tree);
    std::map<RationalPoint, std::map<std::string, std::set<Parameters>>> result;
    const Complex& complex = *evaluation.complex;
    for (const VertexId v : complex.vertices) {
      const RationalPoint p = complex.points.rational(v);
      for (const PatchPoint& at : evaluation.parameters->on_patches({0, v, {}, {}, {}}, p, leaves)) {
        result[p][evaluation.parameters->patch_name(at.leaf, at.patch)].insert(at.at);
        ++found;
      }
    }
    return result;
  };
  const std::string knife =
      "  knife: {box: {min: [0, 0, 0], max: [9, 9, 0.3]}}\n  cut: {difference: [r, knife]}\nresult: cut\n";
  std::string first = kPatchTree;
  first = first.substr(0, first.find("result:"));
  std::size_t before = 0, after = 0;
  const auto old = places(first + "  r: {simplify: all}\n" + knife, {LeafId(0), LeafId(1)}, before);
  const auto now = places(again.substr(0, again.find("result:")) + knife, {LeafId(0)}, after);
  CHECK(before > 100);
  std::size_t compared = 0;
  for (const auto& [p, at] : now) {
    if (!old.count(p)) continue;
    for (const auto& [name, set] : at) {
      if (!old.at(p).count(name)) continue;
      for (const Parameters& x : set) CHECK(old.at(p).at(name).count(x) == 1);
      ++compared;
    }
  }
  CHECK(compared > 100);
}

TEST_CASE("a file whose cells are broken is refused with its place") {
  const ScratchFolder dir;
  const Json good = Json::parse(file_of(kPatchTree, "a.json", true, dir));
  const auto fault = [&](const std::function<void(Json&)>& change) -> std::string {
    Json json = good;
    change(json);
    std::ofstream(dir / "b.json") << json.dump();
    try {
      prepare(ResultShape{dir / "b.json"});
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK(fault([](Json&) {}).empty());
  CHECK_THAT(fault([](Json& j) { j["cells"][3].erase(0), j["cells"][3].erase(0); }),
             Contains("/cells/3: a cell has"));
  CHECK_THAT(fault([](Json& j) { j["cells"][3][1] = j["cells"][3][0]; }), Contains("/cells/3: the corners"));
  CHECK_THAT(fault([](Json& j) { j["cells"][0][0].erase(4); }), Contains("/cells/0/0: x, y, z, u and v"));
  CHECK_THAT(fault([](Json& j) { j["cells"][0][0][4] = "half"; }), Contains("/cells/0/0/4: an exact number"));
  CHECK_THAT(fault([](Json& j) {
               for (auto& f : j["faces"]) {
                 if (f.contains("cells")) f["cells"].push_back(Json::array());
               }
             }),
             Contains("/cells: one list for each facet"));
  CHECK_THAT(fault([](Json& j) {
               for (auto& f : j["faces"]) {
                 if (f.contains("cells")) f["cells"][0] = {1000000};
               }
             }),
             Contains("cell 1000000 does not exist"));
}

TEST_CASE("vtu: points of curved patches carry u and v, split where they differ") {
  const ScratchFolder dir;
  const Vtu plain{file_of(kPatchTree, "a.vtu", false, dir)}, with{file_of(kPatchTree, "b.vtu", true, dir)};
  CHECK(plain.text.find("parameters") == std::string::npos);
  CHECK(plain.text.find("\"patch ") == std::string::npos);
  const auto uv = with.array<double>("parameters"), xyz = with.array<double>("Points");
  const auto patch = with.array<std::int32_t>("patch");
  const auto old = plain.array<double>("Points");
  REQUIRE(uv.size() / 2 == xyz.size() / 3);
  REQUIRE(xyz.size() > old.size());
  CHECK(std::equal(old.begin(), old.end(), xyz.begin()));
  auto names = with.names("patch");
  const auto has = [&](const std::string& name) {
    return std::count_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == name; });
  };
  CHECK(names.begin()->first == 1);
  CHECK(has("ball: sphere") == 1);
  CHECK(has("pin: cylinder side") == 1);
  const auto connectivity = with.array<std::int64_t>("connectivity"),
             offsets = with.array<std::int64_t>("offsets");
  const auto types = with.array<std::uint8_t>("types");
  REQUIRE(patch.size() == offsets.size());
  REQUIRE(types == plain.array<std::uint8_t>("types"));
  const auto before = plain.array<std::int64_t>("connectivity");
  const auto source = with.array<std::int32_t>("source_leaf");
  CHECK(source == plain.array<std::int32_t>("source_leaf"));
  std::map<std::string, std::size_t> triangles;
  for (std::size_t c = 0, begin = 0; c < offsets.size(); begin = std::size_t(offsets[c]), ++c) {
    if (patch[c] > 0) ++triangles[names[patch[c]]];
    for (std::size_t k = begin; k < std::size_t(offsets[c]); ++k) {
      const auto p = std::size_t(connectivity[k]), q = std::size_t(before[k]);
      for (std::size_t d = 0; d < 3; ++d) REQUIRE(xyz[3 * p + d] == old[3 * q + d]);
      if (patch[c] == 0) {
        CHECK(p == q);
        CHECK(std::isnan(uv[2 * p]));
        continue;
      }
      CHECK((uv[2 * p] >= 0 && uv[2 * p] <= 1 && uv[2 * p + 1] >= 0 && uv[2 * p + 1] <= 1));
      if (names[patch[c]] == "even: bezier patch") {  // affine, though its facets are one face
        CHECK(uv[2 * p] == xyz[3 * p] - 6);
        CHECK(uv[2 * p + 1] == xyz[3 * p + 1]);
      }
      if (names[patch[c]] == "cone: cone side") CHECK(uv[2 * p + 1] == Approx(xyz[3 * p + 2]));
    }
  }
  CHECK(triangles["even: bezier patch"] == 2);
  CHECK(triangles["cone: cone side"] >= 24);
  CHECK(triangles["disc: revolve segment 2"] == 24);  // the wall, as a face and as the end of a region
  // Not one affine map on their flat faces, whose triangles know no facets.
  CHECK(triangles.count("uneven: bezier patch") == 0);
  CHECK(triangles.count("disc: revolve segment 1") == 0);
}
