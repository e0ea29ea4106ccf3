// Names, materials and properties of sheets, wires and points in files: groups by name and material in every
// dimension, data arrays, and all of it back from `.json`.
#include <map>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
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

/// The words of the lines of a text that begin with `first`, without it.
std::vector<std::string> lines_after(const std::string& text, const std::string& first) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(first)) out.push_back(line.substr(first.size()));
  }
  return out;
}

TEST_CASE("what lies in its component for what is said of it is written, or refused with what helps",
          "[formats][attributes]") {
  const std::string kParts = R"(cnrg: 1
materials: {steel: {}}
nodes:
  block: {box: {min: [0, 0, 0], max: [6, 6, 6]}}
  other: {box: {min: [6, 0, 0], max: [8, 6, 6]}}
  fault: {polygon: [[1, 1, 1], [5, 1, 1], [5, 5, 5], [1, 5, 5]], attributes: {aperture: 1}}
  bolt:  {polyline: [[3, 3, 4], [3, 3, 5]], material: steel}
  spot:  {points: [[1, 1, 5]], name: spot}
  all:   {union: [fault, bolt, spot, block, other], dominance: left}
  model: {unify: all}
  solid: {regularize: {select: {of: model, dimension: 3}}, each: true}
)";
  const auto made = [&](const std::string& node) {
    return evaluate(parse_tree(kParts + "result: " + node + "\n", "t.yaml"), {}).result();
  };
  const Result model = made("model"), solid = made("solid");
  CHECK(model.volume(1) == Rational(288));
  const ScratchFolder dir;
  write(dir / "m.obj", model);
  const std::string obj = text_of(dir / "m.obj");
  const auto groups = lines_after(obj, "g face");
  CHECK(std::count_if(groups.begin(), groups.end(), [](const auto& g) { return g.ends_with(" model model"); }) ==
        1);
  CHECK(lines_after(obj, "l ").size() == 1);
  CHECK(lines_after(obj, "p ").size() == 1);
  write(dir / "m.glb", model);
  const std::string glb = text_of(dir / "m.glb");
  for (const std::string name : {"face of fault", "wire of bolt", "spot"}) {
    CHECK(glb.find("\"name\":\"" + name + "\"") != std::string::npos);
  }
  for (const std::string file : {"m.off", "m.stl", "m.ply", "m.3mf"}) {
    CAPTURE(file);
    std::string message;
    try {
      write(dir / file, model);
    } catch (const InputError& error) {
      message = error.what();
    }
    CHECK(message.find("1 face inside of a region, 1 wire, 1 isolated point;") != std::string::npos);
    CHECK(message.find("`regularize` with `each: true` to a `select` of `dimension: 3`") != std::string::npos);
    CHECK_NOTHROW(write(dir / file, solid));
  }
  // The cells of the refinement that say nothing are no shapes, also where they are kept.
  EvaluateOptions raw;
  raw.raw = true;
  const Result cut = evaluate(parse_tree(kParts + "  plain: {unify: {sum: [block, {box: {min: [5, 5, 5], max: [9, "
                                                  "9, 9]}}]}}\nresult: plain\n",
                                         "t.yaml"),
                              raw)
                         .result();
  CHECK_NOTHROW(write(dir / "raw.off", cut));
}

TEST_CASE("a group has all regions of a name, and each dimension its own", "[formats][attributes]") {
  // A name that is given to two layers and the horizon between them.
  const std::string nodes = R"(cnrg: 1
materials: {clay: {}, sand: {}}
nodes:
  block:   {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  horizon: {polygon: [[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]]}
  low:     {below: horizon, within: block, material: clay}
  high:    {above: horizon, within: block, material: sand}
  layers:  {union: [low, high], dominance: left}
  dig:     {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  round:   {intersection: [layers, dig], dominance: left, name: round 1, attributes: {excavated: stage 1}MORE}
  rest:    {difference: [layers, dig]}
  model:   {union: [round, rest], dominance: left}
)";
  const auto evaluated = [&](const std::string& more, const std::string& node) {
    std::string text = nodes + "result: " + node + "\n";
    text.replace(text.find("MORE"), 4, more);
    return evaluate(parse_tree(text, "t.yaml"), {}).result();
  };
  Result result = evaluated("", "model");
  const auto regions = groups(result, 3), faces = groups(result, 2);
  CHECK(regions.at("round 1").size() == 2);
  CHECK(regions.at("block").size() == 2);
  CHECK(regions.at("round 1") == regions.at("excavated stage 1"));
  CHECK(regions.count("round 1 3") + regions.count("round 1 4") == 2);
  const ResultArrays arrays = result_arrays(result);
  const std::vector<double> areas = Measures(result, arrays).areas();
  CHECK(sum_at(areas, faces.at("round 1")) == 4);
  CHECK(faces.at("wall round 1 | round 1") == faces.at("round 1"));
  CHECK(sum_at(areas, faces.at("wall block | round 1")) == 24);
  CHECK(sum_at(areas, faces.at("wall block | block")) == 12);
  CHECK(sum_at(areas, faces.at("boundary of block")) == 96);

  const ScratchFolder dir;
  SnapReport report;
  const TetrahedralMesh made = snapped_tetrahedra(result, {}, report);
  const auto deck = [&](const std::string& file) {
    write(dir / file, result, made.mesh);
    return text_of(dir / file);
  };
  const std::string inp = deck("a.inp");
  CHECK_THAT(inp, Catch::Contains("*ELSET, ELSET=round_1\n") && Catch::Contains("*ELSET, ELSET=round_1_3\n") &&
                      Catch::Contains("NAME=round_1_faces\n") && !Catch::Contains("TYPE=S3") &&
                      !Catch::Contains("ELSET=round_1_faces\n"));
  CHECK_THAT(deck("a.msh"), Catch::Contains("2 1 \"round 1 (faces)\"\n") && Catch::Contains("3 6 \"round 1\"\n"));
  CHECK_THAT(deck("a.bdf"), !Catch::Contains("CTRIA3") && Catch::Contains(": elements of round 1\n") &&
                                Catch::Contains(": points of round 1 (faces)\n"));

  // Of this wall more is said than of the regions beside it.
  Result lined = evaluated(
      "}\n  liner:   {select: {of: round, dimension: 2, from: horizon}, name: liner}\n"
      "  lining:  {union: [liner, round], dominance: left",
      "lining");
  const TetrahedralMesh shell = snapped_tetrahedra(lined, {}, report);
  write(dir / "b.inp", lined, shell.mesh);
  CHECK_THAT(text_of(dir / "b.inp"),
             Catch::Contains("*ELEMENT, TYPE=S3\n") && Catch::Contains("*ELSET, ELSET=liner\n"));
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
