// Names, materials and properties of sheets, wires and points in files: groups by name and material in every
// dimension, data arrays, and all of it back from `.json`.
#include <map>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/mesh/cell_groups.h"
#include "csg/result/arrays.h"
#include "csg/result/flat.h"
#include "csg/result/measures.h"
#include "csg/result/result_data.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

const std::string kModel = R"(cnrg: 1
materials: {rock: {}, steel: {}, shotcrete: {}}
nodes:
  block:  {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock, attributes: {density: 2.7}}
  fault:  {polygon: [[2, -1, -1], [2, 5, -1], [2, 5, 5], [2, -1, 5]], name: fault, attributes: {aperture: 1/1000, kind: normal}}
  first:  {polyline: [[1, 1, 1], [1, 1, 6]]}
  second: {polyline: [[1, 3, 1], [3, 3, 1]]}
  bolts:  {union: [first, second], name: bolts, material: steel, attributes: {diameter: 25, section: "25"}}
  shell:  {polygon: [[0, 0, 4], [4, 0, 4], [4, 4, 4], [0, 4, 4]], material: shotcrete, attributes: {thickness: 0.1}}
  tip:    {points: [[3, 1, 1]], name: tip}
  model:  {union: [{intersection: [fault, block]}, bolts, shell, tip, block], dominance: left}
  one:    {unify: model}
)";

Result result_of(const std::string& node, const std::string& more = "") {
  return evaluate(parse_tree(kModel + more + "result: " + node + "\n", "t.yaml"), {}).result();
}

std::map<std::string, std::vector<std::int32_t>> groups(const Result& result, std::size_t dimension) {
  std::map<std::string, std::vector<std::int32_t>> out;
  const auto all = cell_groups(result);
  for (const CellGroup& group : all[dimension]) out[group.name] = group.cells;
  return out;
}

double sum_at(const std::vector<double>& sizes, const std::vector<std::int32_t>& cells) {
  double total = 0;
  for (const std::int32_t cell : cells) total += sizes[static_cast<std::size_t>(cell)];
  return total;
}

TEST_CASE("groups by name, material and texts in every dimension", "[formats][attributes]") {
  for (const std::string node : {"model", "one"}) {
    INFO(node);
    const Result result = result_of(node);
    const ResultArrays arrays = result_arrays(result);
    const Measures measures(result, arrays);
    const std::vector<double> lengths = measures.lengths(), areas = measures.areas();
    const auto wires = groups(result, 1), faces = groups(result, 2), points = groups(result, 0);
    CHECK(sum_at(lengths, wires.at("bolts")) == 7);
    CHECK(wires.at("material steel") == wires.at("bolts"));
    CHECK(wires.at("section 25") == wires.at("bolts"));
    CHECK(sum_at(areas, faces.at("fault")) == 16);
    CHECK(faces.at("kind normal") == faces.at("fault"));
    CHECK(sum_at(areas, faces.at("material shotcrete")) == 16);
    CHECK(faces.count("material steel") == 0);
    CHECK(points.at("tip").size() == 1);
    if (node == "model") CHECK(faces.at("wall block 1 | block 2") == faces.at("fault"));
  }
}

TEST_CASE("what is said of cells comes back from .json, and stays when a result is snapped",
          "[formats][attributes]") {
  const ScratchFolder dir;
  for (const std::string node : {"model", "one", "bolts", "shell"}) {
    INFO(node);
    const Result result = result_of(node);
    const auto said = [](const Result& r) {
      const ResultView view = r.data().view();
      const FlatComplex flat = flatten(view);
      std::vector<std::string> out;
      const auto see = [&](const auto& cells) {
        for (const auto& cell : cells) {
          std::string text;
          if (const Attributes* a = cell.origin.said) {
            text = a->name.text() + "|" + a->material.name();
            for (const auto& [key, value] : a->properties) {
              text += "|" + key + (value.index() == 0 ? "=" : ":") + to_text(value);
            }
          }
          out.push_back(text);
        }
      };
      see(flat.vertices), see(flat.edges), see(flat.faces);
      return out;
    };
    const std::string file = dir / (node + ".json");
    write(file, result);
    const Result again = read_result(file);
    CHECK(said(again) == said(result));
    CHECK(again.cells().faces.size() == result.cells().faces.size());
    std::set<std::string> distinct;
    for (const std::string& text : said(result)) distinct.insert(text);
    CHECK(distinct.size() > 1);
    CHECK(said(snap(result)) == said(result));  // all is on doubles

    // A box so near that rounding alone would break the result: snapping draws it all anew.
    const std::string near =
        "  near: {box: {min: [\"400000000000000000001/100000000000000000000\", 0, 0], max: [6, 4, 4]}}\n"
        "  both: {aggregate: [" +
        node + ", {unify: near}]}\n";
    const Result exact = result_of("both", near);
    SnapReport report;
    const Result snapped = snap(exact, &report);
    if (node != "bolts") CHECK(report.moved > 0);
    std::multiset<std::string> before, after;
    for (const std::string& text : said(exact)) {
      if (!text.empty()) before.insert(text);
    }
    for (const std::string& text : said(snapped)) {
      if (!text.empty()) after.insert(text);
    }
    CHECK(before == after);
    CHECK(before.size() >= (node == "shell" ? 1u : 2u));
  }
}

TEST_CASE("a node says of a result read back what its file does not say", "[formats][attributes]") {
  const ScratchFolder dir;
  const std::string file = dir / ("bolts.json");
  write(file, result_of("bolts"));
  const std::string head = "cnrg: 1\nmaterials: {steel: {}, gold: {}}\nnodes:\n  r: {cnrg: " + file +
                           ", material: gold, attributes: {diameter: 3, coated: yes}";
  const auto group = [&](const std::string& more) {
    const Result r = evaluate(parse_tree(head + "}\n" + more, "t.yaml"), {}).result();
    const FlatComplex flat = flatten(r.data().view());
    const Attributes* said = flat.edges.at(0).origin.said;
    REQUIRE(said != nullptr);
    return said->material.name() + " " + to_text(said->properties.at("diameter")) + " " +
           to_text(said->properties.at("coated"));
  };
  CHECK(group("result: r\n") == "steel 25 yes");
  CHECK(group("  s: {simplify: r, material: gold, attributes: {diameter: 1/2}}\nresult: s\n") == "gold 1/2 yes");
}

TEST_CASE("properties are arrays of .vtu and data of .msh", "[formats][attributes]") {
  const ScratchFolder dir;
  const Result result = result_of("model");
  write(dir / ("m.vtu"), result);
  write(dir / ("m.msh"), result);
  const std::string vtu = text_of(dir / ("m.vtu")), msh = text_of(dir / ("m.msh"));
  for (const char* name : {"\"diameter\"", "\"thickness\"", "\"section\"", "\"name\"", "\"section 25\"",
                           "\"name bolts\"", "\"kind normal\"", "\"density\""}) {
    INFO(name);
    CHECK(vtu.find("Name=" + std::string(name)) != std::string::npos);
  }
  for (const char* name : {"aperture", "density", "diameter", "thickness"}) {
    INFO(name);
    const std::size_t at = msh.find("$ElementData\n1\n\"" + std::string(name) + "\"\n");
    REQUIRE(at != std::string::npos);
    const std::string data = msh.substr(at, msh.find("$EndElementData", at) - at);
    CHECK(data.find(" nan\n") != std::string::npos);
  }
  CHECK(msh.find(" 0.001\n") != std::string::npos);
}

}  // namespace
