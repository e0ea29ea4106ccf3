// Mixtures of mixtures and blends through files: kept exactly, read back as the same function, compared as one.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Json = nlohmann::json;

const std::string kHead = R"(cnrg: 1
materials:
  steel: {dominance: 3}
  ceramic: {}
  rubber: {}
  inner: {distance: {to: skin, stops: [[0, steel], [2, rubber]]}}
  outer: {linear: {from: [0, 0, 0], to: [4, 0, 0], stops: [[0, inner], [1, {ceramic: 1/2, inner: 1/2}]]}}
nodes:
  skin: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  a: {simplify: skin, material: outer}
  b: {box: {min: [2, 1, 1], max: [8, 7, 6]}, material: ceramic}
  c: {box: {min: [1, 2, 2], max: [3, 6, 5]}, material: steel}
)";
const std::string kBlend = kHead + "  r: {union: [a, b, c], blend: linear}\nresult: r\n";
const char* const kPoints = "5/2 3 7/2\n3 2 2\n3/2 3 3\n1/2 1 1\n7 6 5\n";

TEST_CASE("nested gradients and blends are read back as the same function", "[app][blend]") {
  const Workshop w;
  w.write("t.yaml", kBlend);
  w.write("back.yaml", "cnrg: 1\nnodes: {r: {cnrg: a.json}}\nresult: r\n");
  w.write("again.yaml", "cnrg: 1\nnodes: {r: {cnrg: b.json}}\nresult: r\n");
  REQUIRE(w.run("eval t.yaml --quiet -o a.json").status == 0);
  const Outcome back = w.run("eval back.yaml --quiet -o b.json");
  INFO(back.err);
  REQUIRE(back.status == 0);
  REQUIRE(w.run("eval again.yaml --quiet -o c.json").status == 0);
  CHECK(w.read("b.json") == w.read("c.json"));
  const Json a = Json::parse(w.read("a.json")), b = Json::parse(w.read("b.json"));
  CHECK(a["grades"] == b["grades"]);
  CHECK(a["components"].size() == 7);
  const auto materials = [&](const std::string& tree) {
    const std::string out = w.run("locate " + tree + " --material", kPoints).out;
    std::string fields;
    for (std::size_t at = 0; (at = out.find("\tmaterial: ", at)) != std::string::npos; ++at) {
      fields += out.substr(at, out.find('\n', at) - at);
    }
    return fields;
  };
  CHECK_THAT(materials("t.yaml"), Contains("ceramic") && Contains("rubber") && Contains("steel"));
  CHECK(materials("t.yaml") == materials("back.yaml"));
  const Outcome same = w.run("compare t.yaml back.yaml --ignore names");
  INFO(same.out << same.err);
  CHECK(same.status == 0);
}

TEST_CASE("the order of two operands does not matter to a blend, nor do names of inner gradients",
          "[app][blend]") {
  const Workshop w;
  const std::string ab = kHead + "  r: {union: [a, b], blend: linear}\nresult: r\n";
  w.write("ab.yaml", ab);
  w.write("ba.yaml", kHead + "  r: {union: [b, a], blend: linear}\nresult: r\n");
  std::string renamed = ab;
  for (std::size_t at; (at = renamed.find("inner")) != std::string::npos;) renamed.replace(at, 5, "other");
  w.write("renamed.yaml", renamed);
  std::string changed = ab;
  changed.replace(changed.find("[2, rubber]"), 11, "[3, rubber]");
  w.write("changed.yaml", changed);
  const auto same = [&](const std::string& other) { return w.run("compare ab.yaml " + other).status; };
  CHECK(same("ba.yaml") == 0);
  CHECK(same("renamed.yaml") == 0);
  CHECK(same("changed.yaml") == 4);
  w.write("plain.yaml", kHead + "  r: {union: [a, b], dominance: left}\nresult: r\n");
  CHECK(same("plain.yaml") == 4);
}

TEST_CASE("meshes have the fractions of all that is mixed", "[app][blend]") {
  const Workshop w;
  w.write("t.yaml", kBlend);
  REQUIRE(w.run("eval t.yaml --quiet -o t.vtu").status == 0);
  for (const char* name : {"ceramic", "rubber", "steel"}) {
    CHECK_THAT(w.read("t.vtu"), Contains("fraction of " + std::string(name)));
  }
  CHECK_THAT(w.read("t.vtu"), !Contains("fraction of inner") && !Contains("fraction of outer"));
  REQUIRE(w.run("mesh t.yaml --quiet -o t.msh").status == 0);
  CHECK_THAT(w.read("t.msh"), Contains("fraction of rubber") && !Contains("fraction of inner"));
}

TEST_CASE("the dominance of a material is kept with the result", "[app][blend]") {
  const Workshop w;
  w.write("t.yaml", kHead + "  r: {union: [b, c]}\nresult: r\n");
  REQUIRE(w.run("eval t.yaml --quiet -o a.json").status == 0);
  CHECK_THAT(w.read("a.json"), Contains(R"({"name":"steel","color":"","dominance":"3"})"));
  CHECK_THAT(w.read("a.json"), Contains(R"({"name":"ceramic","color":""})"));
  w.write("back.yaml",
          "cnrg: 1\nmaterials: {rock: {}}\nnodes:\n  old: {cnrg: a.json}\n"
          "  more: {box: {min: [0, 0, 0], max: [9, 9, 9]}, material: rock}\n"
          "  r: {intersection: [more, old]}\nresult: r\n");
  CHECK_THAT(w.run("explain back.yaml --point 2,3,3").out,
             Contains("their dominance here is 3 in A and 0 in B: A > B"));
}

TEST_CASE("files with grades that cannot be are refused", "[app][blend][errors]") {
  const Workshop w;
  w.write("t.yaml", kBlend);
  w.write("back.yaml", "cnrg: 1\nnodes: {r: {cnrg: a.json}}\nresult: r\n");
  REQUIRE(w.run("eval t.yaml --quiet -o a.json").status == 0);
  const std::string written = w.read("a.json");
  const auto refused = [&](auto change) {
    nlohmann::ordered_json file = nlohmann::ordered_json::parse(written);
    change(file);
    w.write("a.json", file.dump());
    const Outcome o = w.run("check back.yaml");
    CHECK(o.status == 2);
    return o.err;
  };
  const Json grades = Json::parse(written)["grades"];
  std::size_t blend = 0, nested = 0;
  for (std::size_t i = 0; i < grades.size(); ++i) {
    if (grades[i].contains("blend") && grades[i]["blend"][0].contains("grade")) blend = i;
    if (grades[i].contains("nested")) nested = i;
  }
  REQUIRE(grades[blend].contains("blend"));
  REQUIRE(grades[nested].contains("nested"));
  CHECK_THAT(refused([&](auto& f) { f["grades"][blend]["blend"].erase(1); }), Contains("two materials blend"));
  CHECK_THAT(refused([&](auto& f) { f["grades"][blend]["blend"][0]["grade"] = blend; }),
             Contains("/blend/0/grade"));
  CHECK_THAT(refused([&](auto& f) { f["grades"][blend]["blend"][0]["material"] = "rubber"; }),
             Contains("this grade is of another material"));
  CHECK_THAT(refused([&](auto& f) { f["grades"][nested]["nested"][0]["material"] = "rubber"; }),
             Contains("rubber"));
  CHECK_THAT(refused([&](auto& f) {
               f["grades"][nested]["nested"][0]["stops"][0]["mixture"] = {{"inner", "1"}};
             }),
             Contains("a graded material is made of itself"));
  CHECK_THAT(refused([&](auto& f) {
               for (auto& m : f["materials"]) m["dominance"] = "0";
             }),
             Contains("no member of results is called 'dominance' here"));
}

}  // namespace
}  // namespace cnrg
