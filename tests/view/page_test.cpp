// The data of a page against what the library and the exact .json say.
#include "csg/view/page.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "csg/certify/certificate.h"
#include "csg/explain/explain.h"
#include "csg/explain/fates.h"
#include "csg/formats/formats.h"
#include "csg/operators/node_value.h"
#include "csg/result/palette.h"
#include "csg/result/result_data.h"
#include "csg/text/number.h"
#include "csg/tree/dag.h"
#include "csg/view/packed.h"
#include "tests/catch.h"
#include "tests/view/inflated.h"

using namespace cnrg;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// The numbers of a packed column.
std::vector<std::uint32_t> numbers(const Json& column) {
  const std::string text = column.get<std::string>();
  const std::size_t size = static_cast<std::size_t>(text[0] - '0');
  const std::string bytes = bytes_of(text.substr(2));
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i + size <= bytes.size(); i += size) {
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < size; ++k) {
      number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) << (8 * k);
    }
    const std::uint32_t step = number & 1 ? ~(number >> 1) : number >> 1;
    out.push_back((out.empty() ? 0 : out.back()) + step);
  }
  return out;
}

/// Lists of lists from two columns.
std::vector<std::vector<std::uint32_t>> lists(const Json& json, const std::string& name) {
  const std::vector<std::uint32_t> all = numbers(json[name]);
  std::vector<std::vector<std::uint32_t>> out;
  std::size_t at = 0;
  for (const std::uint32_t count : numbers(json[name + "_counts"])) {
    out.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(at),
                     all.begin() + static_cast<std::ptrdiff_t>(at + count));
    at += count;
  }
  CHECK(at == all.size());
  return out;
}

struct Scene {
  Tree tree;
  Evaluation evaluation;
  Json data;

  explicit Scene(const std::string& text, const PageLimits& limits = {}) : tree(parse_tree(text, "t.yaml")) {
    EvaluateOptions options;
    options.keep_all = true;
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) options.nodes.push_back(id);
    evaluation = evaluate(tree, options);
    raw = page_data(tree, evaluation, limits);
    data = Json::parse(raw);
  }
  std::string raw;

  const Json& node(const std::string& name) const {
    for (const Json& n : data["nodes"]) {
      if (n["name"] == name) return n;
    }
    throw std::runtime_error("no node " + name);
  }
};

/// A block with an inner wall, a sheet through it, a wire and a point, open sets and a tunnel.
const char* const kMixed = R"(cnrg: 1
materials: {rock: {color: "#998877"}, steel: {}}
nodes:
  ground: {box: {min: [0, 0, 0], max: [9, 9, 6]}, material: rock, name: ground, attributes: {n: 1/2}}
  fault:  {polygon: [[2, -1, -1], [7, -1, 7], [7, 10, 7], [2, 10, -1]]}
  bolt:   {polyline: [[6, 5, 3], [6, 5, "29/6"]], material: steel, attributes: {diameter: 25, kind: "<b>"}}
  mark:   {points: [[1, 1, 1]]}
  tunnel: {cylinder: {from: [6, -1, 3], to: [6, 10, 3], radius: 1, segments: 12}}
  split:  {union: [bolt, mark, fault, ground], dominance: left}
  model:  {difference: [split, tunnel]}
  inner:  {interior: model}
  skin:   {boundary: inner}
result: model
)";

}  // namespace

TEST_CASE("numbers are packed in as few bytes as the largest needs", "[view]") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(packed(std::vector<std::uint32_t>{}) == "1:");
  CHECK(packed(std::vector<std::uint32_t>{1, 128}) == "1:Av4=");
  CHECK(packed(std::vector<std::uint32_t>{1, 129}) == "2:AgAAAQ==");
  CHECK(packed(std::vector<std::uint32_t>{32768}) == "4:AAABAA==");
  CHECK(packed(std::vector<std::uint32_t>{1000, 1001, 1000}) == "2:0AcCAAEA");
  const std::vector<std::uint32_t> odd{0xffffffff, 0, 0x80000000, 1, 0x7fffffff, 0xffffffff, 5};
  CHECK(numbers(packed(odd)) == odd);
  CHECK(packed(std::vector<float>{1.0f}) == "f:AACAPw==");
  CHECK(packed(std::vector<double>{-2.0}) == "d:AAAAAAAAAMA=");
}

TEST_CASE("a page has the cells of each node with the numbers of its exact file", "[view]") {
  const Scene scene(kMixed);
  REQUIRE(scene.data["nodes"].size() == scene.tree.nodes.size());
  CHECK(scene.data["nodes"][scene.data["result"].get<std::size_t>()]["name"] == "model");
  for (const Json& node : scene.data["nodes"]) {
    const std::string name = node["name"];
    INFO(name);
    const Result result = scene.evaluation.result(name);
    const Json exact = Json::parse(json_text(result.data().view()).text);
    const Json& cells = node["cells"];
    const auto component = [&](const char* kind) { return numbers(cells[kind]["component"]); };
    for (const char* kind : {"vertices", "edges", "faces", "regions"}) {
      std::vector<std::uint32_t> expected;
      for (const Json& cell : exact[kind]) expected.push_back(cell["component"]);
      CHECK(component(kind) == expected);
    }
    const auto edges = lists(cells["edges"], "points");
    REQUIRE(edges.size() == exact["edges"].size());
    for (std::size_t e = 0; e < edges.size(); ++e) CHECK(Json(edges[e]) == exact["edges"][e]["points"]);
    const auto triangles = lists(cells["faces"], "triangles");
    const auto front = numbers(cells["faces"]["front"]), back = numbers(cells["faces"]["back"]);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const Json& t : exact["faces"][f]["triangles"]) {
        for (const Json& corner : t) corners.push_back(corner);
      }
      CHECK(triangles[f] == corners);
      const auto region = [](std::uint32_t r) { return r == 0 ? Json() : Json(r - 1); };
      CHECK(region(front[f]) == exact["faces"][f]["regions"][0]);
      CHECK(region(back[f]) == exact["faces"][f]["regions"][1]);
    }
    for (std::size_t r = 0; r < exact["regions"].size(); ++r) {
      const Json& volume = cells["regions"]["volume"][r];
      if (exact["regions"][r]["component"] != 0) {
        CHECK((volume.is_null() ? volume : volume[0]) == exact["regions"][r]["volume"]);
      }
    }
  }
}

TEST_CASE("coordinates that no doubles are stand in a page exactly", "[view]") {
  const Scene scene(kMixed);
  const Json& cells = scene.node("bolt")["cells"];
  const std::uint32_t number = numbers(cells["points"])[1];
  bool found = false;
  for (const Json& entry : scene.data["exact"]) {
    if (entry[0] != number) continue;
    found = true;
    CHECK(entry == Json({number, "6", "5", "29/6"}));
  }
  CHECK(found);
}

TEST_CASE("every cell's story in a page is what explain says of it", "[view]") {
  const Scene scene(kMixed);
  std::size_t told = 0;
  for (const Json& node : scene.data["nodes"]) {
    const std::string name = node["name"];
    const NodeId id = scene.tree.find(name);
    const SimplifiedComplex& s = *scene.evaluation.value(id).simplified;
    const auto stories = lists(node["stories"], "lines");
    std::size_t next = 0;
    const std::size_t counts[] = {s.vertices.size(), s.edges.size(), s.faces.size(), s.regions.size()};
    REQUIRE(stories.size() == counts[0] + counts[1] + counts[2] + counts[3]);
    for (int d = 0; d < 4; ++d) {
      for (std::uint32_t i = 0; i < counts[d]; ++i) {
        std::string text;
        for (const std::uint32_t line : stories[next]) text += scene.data["lines"][line].get<std::string>() + "\n";
        ++next;
        if (i % 3 != 0 && d < 3) continue;  // each asks for all of it again
        CHECK(text == explanation_text(scene.tree, scene.evaluation,
                                       explain(scene.tree, scene.evaluation, id, cell_name(d, i))));
        ++told;
      }
    }
  }
  CHECK(told > 60);
}

TEST_CASE("faces about an edge of a page are in radial order, at growing angles", "[view]") {
  const Scene scene(kMixed);
  const SimplifiedComplex& s = *scene.evaluation.value(scene.tree.find("model")).simplified;
  const Json& radial = scene.node("model")["radial"];
  const auto counts = numbers(radial["counts"]), faces = numbers(radial["faces"]);
  REQUIRE(counts.size() == s.edges.size());
  std::size_t at = 0, fans = 0;
  for (std::size_t e = 0; e < counts.size(); ++e) {
    std::vector<std::uint32_t> expected;
    for (const FaceUse& use : scene.evaluation.complex->edge_uses[s.edges[e].chain.front().edge()]) {
      const SimplifiedComplex::Place place = s.face_place[use.face.index()];
      if (place.dimension == 2) expected.push_back(place.index);
    }
    const std::vector<std::uint32_t> shown(faces.begin() + static_cast<std::ptrdiff_t>(at),
                                           faces.begin() + static_cast<std::ptrdiff_t>(at + counts[e]));
    // Around is around: it may begin at any face.
    REQUIRE(shown.size() == expected.size());
    std::vector<std::uint32_t> turned = expected;
    bool same = shown == turned;
    for (std::size_t k = 0; k < expected.size() && !same; ++k) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      same = shown == turned;
    }
    CHECK(same);
    fans += expected.size() > 2;
    at += counts[e];
  }
  CHECK(fans > 0);
}

TEST_CASE("a page tells Euler-Poincare and Betti numbers, and leaves out the former of what is unbounded",
          "[view]") {
  const Scene scene(
      "cnrg: 1\nnodes:\n  box: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n"
      "  hole: {box: {min: [0.5, 0.5, -1], max: [1.5, 1.5, 3]}}\n  ring: {difference: [box, hole]}\n"
      "  rest: {complement: ring}\nresult: ring\n");
  const Json& euler = scene.node("ring")["euler"];
  CHECK(euler["v"] == 16);
  CHECK(euler["e"] == 24);
  CHECK(euler["f"] == 10);
  CHECK(euler["r"] == 2);
  CHECK(euler["V"] == 1);
  CHECK(euler["Vh"] == 1);
  CHECK(euler["Ch"] == 1);
  CHECK(euler["closed"] == true);
  CHECK(scene.node("ring")["betti"][0] == Json({0, 1, 1, 0, 1, 1, 0}));
  CHECK(!scene.node("rest").contains("euler"));
  CHECK(scene.node("rest")["betti"][0] == Json({0, 1, 1, 1, 1, 1, 1}));
}

TEST_CASE("what became of the operands' entities is told with relation and row", "[view]") {
  const Scene scene(
      "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n  b: {box: {min: [1, 1, 1], max: [3, 3, "
      "3]}}\n"
      "  c: {difference: [a, b]}\n  i: {interior: c}\nresult: i\n");
  const Json& classes = scene.node("c")["classes"];
  std::map<std::string, std::string> rows;
  for (const Json& fate : classes["fates"]) {
    const std::string key = fate["relation"].get<std::string>() + (fate["removed"] ? "-" : "+");
    if (fate["rows"].contains("2")) rows[key] = fate["rows"]["2"][0];
  }
  // Three faces of a lose a corner, three stay whole; of b three corners of faces are the new walls.
  CHECK(rows == std::map<std::string, std::string>{{"AinB-", "difference.face.AinB"},
                                                   {"AoutB+", "difference.face.AoutB"},
                                                   {"BinA+", "difference.face.BinA"},
                                                   {"BoutA-", "difference.face.BoutA"}});
  // The interior has no table: its boundary went.
  const Json& fates = scene.node("i")["classes"]["fates"];
  REQUIRE(fates.size() == 1);
  CHECK(fates.begin().value() == Json({{"removed", true}}));
  CHECK(!scene.node("a").contains("classes"));
}

TEST_CASE("a page has all rows that a node asked, and of each cell of the result the fates of its pieces",
          "[view]") {
  const Scene scene(kMixed);
  const Json& model = scene.node("model");
  const KeptValue& kept = *std::find_if(scene.evaluation.kept.begin(), scene.evaluation.kept.end(),
                                        [](const KeptValue& k) { return k.name == "model"; });
  const AskedRows asked = asked_rows(scene.tree, scene.evaluation, instance_of(scene.evaluation, kept));
  REQUIRE(model["asked"]["rows"].size() == 15);
  for (const Json& row : model["asked"]["rows"]) {
    const auto at = std::find_if(asked.cells.begin(), asked.cells.end(),
                                 [&](const auto& entry) { return table_rows()[entry.first].id == row[0]; });
    REQUIRE(at != asked.cells.end());
    CHECK(row[1] == table_rows()[at->first].dimension);
    CHECK(row[4] == at->second[0]);
    CHECK(row[5] == at->second[1]);
  }
  CHECK(model["asked"]["steps"] == Json({{1, false, true, "operands"}}));
  CHECK(scene.node("split")["asked"]["steps"].size() == 3);
  CHECK(!scene.node("inner").contains("asked"));
  // What is of the result was kept by some row, and nothing that was removed is among its pieces.
  const FlatComplex flat = flatten(scene.evaluation.result(kept.node).data().view());
  const Json& of = model["classes"]["of"];
  const auto check = [&](const char* kind, const auto& cells) {
    const auto fates = lists(of, kind);
    REQUIRE(fates.size() == cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      CHECK(fates[i].empty() == !cells[i].entity);
      for (const std::uint32_t fate : fates[i]) CHECK(!Fate::of(fate).removed);
    }
  };
  check("v", flat.vertices), check("e", flat.edges), check("f", flat.faces);
  // A face that was kept has on its sides the regions that the face of the result has.
  const std::vector<std::uint32_t> front = numbers(model["classes"]["faces"]["front"]),
                                   back = numbers(model["classes"]["faces"]["back"]);
  std::set<std::set<std::uint32_t>> expected, found;
  for (const auto& f : flat.faces) expected.insert({f.regions[0] + 1, f.regions[1] + 1});
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (!Fate::of(numbers(model["classes"]["faces"]["component"])[i]).removed) found.insert({front[i], back[i]});
  }
  CHECK(found == expected);
}

TEST_CASE("what went is told as explain tells a point of it", "[view]") {
  const Scene scene(
      "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n  b: {box: {min: [1, 1, 1], max: [3, 3, "
      "3]}}\n  c: {difference: [a, b]}\nresult: c\n");
  const Json& classes = scene.node("c")["classes"];
  const auto stories = lists(classes, "lines");
  const NodeId c = scene.tree.result;
  std::size_t told = 0;
  for (std::size_t i = 0; i < stories.size(); ++i) {
    const std::string at = classes["told_at"][i];
    CHECK(at.empty() == stories[i].empty());
    if (at.empty()) continue;
    ++told;
    std::string story;
    for (const std::uint32_t line : stories[i]) story += scene.data["lines"][line].get<std::string>() + "\n";
    RationalPoint p;
    std::istringstream words(at);
    for (Rational& x : p) {
      std::string word;
      std::getline(words, word, ',');
      x = Rational(word);
    }
    CHECK(story == explanation_text(scene.tree, scene.evaluation, explain(scene.tree, scene.evaluation, c, p)));
  }
  CHECK(told > 10);
  CHECK(!Scene("cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}, b: {interior: a}}\nresult: b\n",
               {.removed = 10})
             .node("b")["classes"]
             .contains("told_at"));
}

TEST_CASE("a node says how many instances it has", "[view]") {
  const Scene scene(
      "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  l: {closure: a, translate: [2, 0, 0]}\n"
      "  r: {closure: a, translate: [4, 0, 0]}\n  b: {union: [l, r]}\nresult: b\n");
  CHECK(scene.node("a")["instances"] == 2);
  CHECK(scene.node("b")["instances"] == 1);
}

TEST_CASE("a fate is kept in its component", "[view]") {
  for (std::size_t r = 0; r < kRelations; ++r) {
    for (int code = 0; code < 4; ++code) {
      const Fate fate{static_cast<Relation>(r), (code & 2) != 0, (code & 1) != 0, true};
      const Fate back = Fate::of(fate.component());
      CHECK(back.relation == fate.relation);
      CHECK(back.dominant == fate.dominant);
      CHECK(back.removed == fate.removed);
      CHECK(back.table);
    }
  }
  CHECK(!Fate::of(Fate{Relation::common, false, true, false}.component()).table);
}

TEST_CASE("a page has the colors that stills have", "[view]") {
  const Scene scene(kMixed);
  CHECK(scene.data["color_by"] == "material");
  CHECK(scene.data["fixed_colors"]["sheet"] == hex(sheet_color()));
  CHECK(scene.data["fixed_colors"]["relations"]["INTERS"] == hex(relation_color(Relation::common)));
  const auto color = [&](std::uint32_t number) { return scene.data["colors"][number].get<std::string>(); };
  const std::vector<std::uint32_t> sources = numbers(scene.data["source_colors"]);
  for (const KeptValue& kept : scene.evaluation.kept) {
    const Json& node = scene.node(kept.name);
    const Result result = scene.evaluation.result(kept.node);
    const ResultView view = result.data().view();
    const FlatComplex flat = flatten(view);
    const CellColors colors(view, flat);
    const std::array<std::size_t, 4> counts{flat.vertices.size(), flat.edges.size(), flat.faces.size(),
                                            flat.regions.size()};
    const std::array<std::string, 4> names{"vertices", "edges", "faces", "regions"}, kinds{"v", "e", "f", "r"};
    for (std::size_t d = 0; d < 4; ++d) {
      const Json& columns = node["cells"][names[d]];
      const auto component = numbers(columns["component"]), origin = numbers(columns["origin"]);
      const auto by_material = numbers(node["colors"]["material"][kinds[d]]);
      const auto by_component = numbers(node["colors"]["component"]);
      for (FlatComplex::Index i = 0; i < counts[d]; ++i) {
        const auto expect = [&](ColorBy by) { return hex(colors.of(by, static_cast<int>(d), i).color); };
        const std::uint32_t own = columns.contains("said") ? numbers(columns["said"])[i] : 0;
        const Json& said = own == 0 ? Json() : node["said"][own - 1];
        CHECK(color(said.contains("color") ? said["color"].get<std::uint32_t>() : by_material[component[i]]) ==
              expect(ColorBy::material));
        CHECK(color(by_component[component[i]]) == expect(ColorBy::component));
        // In all nodes of a page leaves have the colors that they have in the result.
        if (kept.node == scene.tree.result) CHECK(color(sources[origin[i]]) == expect(ColorBy::source));
        if (d == 3) CHECK(color(numbers(node["colors"]["region"])[i]) == expect(ColorBy::region));
      }
    }
  }
}

TEST_CASE("a page has what is said of cells", "[view]") {
  const Scene scene(kMixed);
  const Json& model = scene.node("model");
  REQUIRE(model["said"].size() == 1);  // of the bolt; of the fault and the mark nothing is said
  CHECK(model["said"][0]["material"] == "steel");
  CHECK(model["said"][0]["attributes"] ==
        Json::array({Json::array({"diameter", "25"}), Json::array({"kind", "<b>"})}));
  const auto wires = numbers(model["cells"]["edges"]["said"]);
  CHECK(std::count(wires.begin(), wires.end(), 1) == 1);
  for (const char* const kind : {"vertices", "faces"}) {
    const auto others = numbers(model["cells"][kind]["said"]);
    CHECK(std::count(others.begin(), others.end(), 0) == static_cast<std::ptrdiff_t>(others.size()));
  }
  CHECK(model["components"][0]["attributes"] == Json::array({Json::array({"n", "1/2"})}));
}

TEST_CASE("beyond its limits a page says what it leaves out", "[view]") {
  const Scene scene(kMixed, {.stories = 60, .topology = 10, .classes = 10});
  const Json& model = scene.node("model");
  CHECK(!model.contains("stories"));
  CHECK(!model.contains("euler"));
  CHECK(!model.contains("classes"));
  CHECK(model["left_out"] == Json({"topology", "stories", "classes"}));
  CHECK(scene.node("bolt").contains("stories"));
}

TEST_CASE("a page is compressed", "[view]") {
  const std::string text(100000, 'x');
  const std::string page = compressed(text);
  CHECK(page.size() < 1000);
  CHECK(inflated(page) == text);
}

TEST_CASE("nodes that repeat each other cost a page little", "[view]") {
  const auto page = [](int boxes) {
    std::string text = "cnrg: 1\nnodes:\n", before = "b0";
    for (int i = 0; i < boxes; ++i) {
      const std::string n = std::to_string(i);
      text += "  b" + n + ": {box: {min: [\"" + std::to_string(2 * i) + "/3\", 0, 0], max: [\"" +
              std::to_string(2 * i + 3) + "/3\", 1, 1]}}\n";
      if (i > 0) text += "  u" + n + ": {union: [" + before + ", b" + n + "]}\n", before = "u" + n;
    }
    const Scene scene(text + "result: " + before + "\n");
    return std::pair(scene.raw.size(), compressed(scene.raw).size());
  };
  const auto [raw, small] = page(60);
  CHECK(small * 7 < raw);  // and the more nodes, the less
}

TEST_CASE("what a page has no room for is left out of nodes of many cells, not of the result", "[view]") {
  const Scene some(kMixed, {.stories = 1500, .topology = 200, .classes = 100000});
  std::size_t with = 0;
  for (const Json& node : some.data["nodes"]) {
    with += node.contains("stories");
    const std::string left_out = node.contains("left_out") ? node["left_out"].dump() : "";
    CHECK(node.contains("stories") == (left_out.find("stories") == std::string::npos));
  }
  CHECK(some.node("model").contains("stories"));
  CHECK(with > 2);
  CHECK(with < some.evaluation.kept.size());
}

TEST_CASE("no text of a tree is HTML in its page", "[view]") {
  const Scene scene(
      "cnrg: 1\nnodes:\n  \"</script><b>\": {box: {min: [0, 0, 0], max: [1, 1, 1]}, name: \"<!--<script>\"}\n"
      "result: \"</script><b>\"\n");
  CHECK(scene.data["nodes"][0]["name"] == "</script><b>");
  CHECK(scene.data["nodes"][0]["components"][0]["name"] == "<!--<script>");
  const std::string page =
      page_text("<t><!--cnrg:title--></t><!--cnrg:stamp-->|<!--cnrg:data-->", "a<b>&\"c\"", scene.raw, "7");
  CHECK(page == "<t>a&lt;b&gt;&amp;&quot;c&quot;</t>7|" + compressed(scene.raw));
  CHECK(page.find("script") == std::string::npos);
  CHECK_THROWS_WITH(page_text("nothing", "a", "b"), Contains("no place `<!--cnrg:title-->`"));
}

TEST_CASE("a page has the uncertain places of each node, in the words of the notices", "[view]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {cylinder: {from: [1, 0, -3], to: [1, 0, 3], radius: 1}}
  b: {sphere: {center: [0, 0, 0], radius: 2}}
  both: {union: [a, b]}
result: both
)",
                               "t.yaml");
  EvaluateOptions options;
  options.keep_all = true;
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) options.nodes.push_back(id);
  const Evaluation evaluation = evaluate(tree, options);
  const Json data = Json::parse(page_data(tree, evaluation));
  const std::vector<UncertainPlace> places = certificate_of(evaluation).places;
  REQUIRE(!places.empty());
  REQUIRE(data["doubts"].size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(data["doubts"][i]["text"] == places[i].text());
    CHECK(data["doubts"][i]["at"] == places[i].at);
    CHECK(data["doubts"][i]["nodes"] == std::vector<std::size_t>{2});
  }
  CHECK(data["nodes"][0]["within"] == bound_text(evaluation.rows[0].volume_bound()));
}
