// csg/FORMATS.md against the program: what one of them has the other one has, too.
//
// Keys are those that the program lists when it meets one that it does not know. Everything that is written is
// looked at in files of one small scene with curves, grades, planes and open sets, and of the trees of papers/.
#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/pages/tables.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;
using Words = std::set<std::string>;

const Page& formats() {
  static const Page page = read_page(root() / "csg" / "FORMATS.md");
  return page;
}

/// A scene with everything that files may say.
constexpr const char* kScene = R"(cnrg: 1
materials:
  steel: {color: "#667788"}
  ceramic: {}
  graded: {linear: {from: [0, 0, 0], to: [0, 0, 4], stops: [[0, steel], [1, skin]]}}
  skin: {distance: {to: floor, stops: [[0, steel], [5, ceramic]]}}
nodes:
  bar: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 8}, material: graded}
  head: {box: {min: [-2, -2, 4], max: [2, 2, 6]}, material: skin, dominance: 1}
  floor: {polygon: {outer: [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], holes: [[[5, 5, 0], [6, 5, 0], [5, 6, 0]]]}, name: slab, attributes: {thickness: 1/2, kind: paved}}
  wire: {polyline: [[-9, -9, 0], [-9, -9, 5]], material: skin}
  dot: {points: [[7, 0, 0], [8, 8, 8]], material: steel}
  tip: {box: {min: [0, 0, 5], max: [3, 3, 8]}, material: ceramic}
  model: {union: [floor, wire, dot, bar, {union: [head, tip], blend: linear}]}
  plane: {plane: {point: [0, 0, 2], normal: [0, 1, 3]}}
  open: {subtract: [{interior: model}, plane]}
  endless: {sum: [plane, {complement: model}]}
  curved: {aggregate: [{boundary: {sphere: {center: [0, 0, 9], radius: 1, segments: 8}}, name: shell, attributes: {thickness: 1/2, kind: paved}}, bar]}
result: model
)";

/// The words that a list in a source file has between two marks.
Words words_in_source(const std::string& file, const std::string& begin, const std::string& entry) {
  const std::string text = text_of(root() / file);
  const std::size_t from = text.find(begin);
  REQUIRE(from != std::string::npos);
  const std::string list = text.substr(from, text.find(";\n", from) - from);
  const std::regex pattern(entry);
  Words words;
  for (std::sregex_iterator i(list.begin(), list.end(), pattern), end; i != end; ++i) words.insert(i->str(1));
  return words;
}

/// The keys that the program knows where a tree has `@` in place of a key and its value.
Words known_keys(const Workshop& w, std::string tree) {
  const std::string nobody = "qqqqqqqqqqqqqqqqqqqqqqqq: 1";
  tree.replace(tree.find('@'), 1, nobody);
  w.write("probe.yaml", tree);
  const std::string said = w.run("check probe.yaml").err, mark = "; known are: ";
  INFO(tree << said);
  const std::size_t at = said.find(mark);
  REQUIRE(at != std::string::npos);
  static const std::regex word("[a-z]+( [a-z]+)*");
  const std::string list = said.substr(at + mark.size());
  Words keys;
  for (std::sregex_iterator i(list.begin(), list.end(), word), end; i != end; ++i) keys.insert(i->str());
  return keys;
}

std::string node(const std::string& leaf) { return "{cnrg: 1, nodes: {a: {" + leaf + "}}, result: a}"; }

/// Keys by the name in the first column, which rows below it leave out.
std::map<std::string, Words> keys_of(const std::string& title) {
  std::map<std::string, Words> keys;
  for (const PageTable& table : tables_of(formats())) {
    if (table.head.size() < 2 || table.head[0] != title || table.head[1] != "key") continue;
    std::string owner;
    for (const std::vector<std::string>& row : table.rows) {
      if (!row[0].empty()) owner = title == "leaf" ? quoted_words(row[0]).at(0) : row[0];
      for (const std::string& key : quoted_words(row[1])) CHECK(keys[owner].insert(key).second);
      keys[owner];
    }
  }
  return keys;
}

TEST_CASE("tables of a page are read", "[pages]") {
  const Page page{{},
                  {"# A", "| x | y |", "|---|---|", "| `a` `b` | c \\| d |", "| | e |", "", "| z |", "|---|"},
                  {"a"},
                  {},
                  {}};
  const std::vector<PageTable> tables = tables_of(page);
  REQUIRE(tables.size() == 2);
  CHECK(tables[0].anchor == "a");
  CHECK(tables[0].head == std::vector<std::string>{"x", "y"});
  REQUIRE(tables[0].rows.size() == 2);
  CHECK(tables[0].rows[0] == std::vector<std::string>{"`a` `b`", "c | d"});
  CHECK(tables[0].rows[1] == std::vector<std::string>{"", "e"});
  CHECK(first_words(page, "x") == Words{"a", "b"});
  CHECK(tables[1].rows.empty());
}

TEST_CASE("csg/FORMATS.md has the leaves that the reader has, each with its keys", "[pages][formats]") {
  const Workshop w;
  const std::map<std::string, Words> leaves = keys_of("leaf");
  Words names;
  for (const auto& [leaf, keys] : leaves) {
    INFO(leaf);
    names.insert(leaf);
    if (!keys.empty()) CHECK(keys == known_keys(w, node(leaf + ": {@}")));
  }
  CHECK(names == words_in_source("csg/tree/read_leaf.cpp", "kReaders{{", "\\{\"([a-z]+)\", read_"));
}

TEST_CASE("csg/FORMATS.md has the keys of every part of a leaf and an attribute", "[pages][formats]") {
  const Workshop w;
  const std::string triangle = "vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
  const auto material = [](const std::string& text) { return "{cnrg: 1, materials: {m: {" + text + "}}}"; };
  const std::map<std::string, std::string> probes{
      {"simplify", node("simplify: {of: a, @}")},
      {"select", node("select: {of: a, @}")},
      {"rotate", node("points: [[0, 0, 0]], rotate: {@}")},
      {"mirror", node("points: [[0, 0, 0]], mirror: {@}")},
      {"profile", node("extrude: {profile: {@}}")},
      {"curve of a line", node("extrude: {profile: [[0, 0, 0], {@}, [1, 0, 0]]}")},
      {"Bézier patch or curve", node("bezier: {patch: {@}}")},
      {"B-spline patch or curve", node("bspline: {curve: {@}}")},
      {"face of a group", node("group: {" + triangle + ", faces: [{@}]}")},
      {"region of a group", node("group: {" + triangle + ", regions: {1: {@}}}")},
      {"material", material("@")},
      {"linear", material("linear: {@}")},
      {"distance", material("distance: {@}")},
  };
  const std::map<std::string, Words> parts = keys_of("part");
  for (const auto& [part, keys] : parts) {
    INFO(part);
    REQUIRE(probes.contains(part));
    CHECK(keys == known_keys(w, probes.at(part)));
  }
  CHECK(parts.size() == probes.size());
  CHECK(first_words(formats(), "key of the file") == known_keys(w, "{@}"));
}

TEST_CASE("csg/FORMATS.md has the operators and attributes that the reader has", "[pages][formats]") {
  CHECK(first_words(formats(), "operator") ==
        words_in_source("csg/tree/operator_names.h", "kOperators{{", "\\{\"([a-z]+)\", Operator::"));
  Words attributes = words_in_source("csg/tree/operator_names.h", "kAttributes{", "\"([a-z]+)\"");
  attributes.insert({"regularize", "simplify"});  // which are operators, too
  CHECK(first_words(formats(), "attribute") == attributes);
}

TEST_CASE("csg/FORMATS.md has the extensions that the program writes and reads", "[pages][formats]") {
  const Workshop w;
  w.write("t.yaml", kScene);
  const auto listed = [](const std::string& text, const std::string& mark) {
    static const std::regex extension("(\\.[a-z0-9]+)+");
    REQUIRE(text.find(mark) != std::string::npos);
    const std::string list = text.substr(text.find(mark) + mark.size());
    Words words;
    for (std::sregex_iterator i(list.begin(), list.end(), extension), end; i != end; ++i) words.insert(i->str());
    return words;
  };
  CHECK(first_words(formats(), "extension") == listed(w.run("eval t.yaml -o t.nobody").err, "use one of"));
  w.write("mesh.yaml", node("mesh: {file: t.nobody}"));
  CHECK(first_words(formats(), "file") == listed(w.run("check mesh.yaml").err, "with the extension"));
}

TEST_CASE("csg/FORMATS.md names options that there are", "[pages][formats]") {
  const Workshop w;
  std::string help;
  for (const std::string command : {"eval", "check", "locate", "explain", "view", "mesh", "compare", "tables"}) {
    help += w.run(command + " --help").out;
  }
  help += w.run("--help").out;
  static const std::regex option("--[a-z][a-z-]*");
  std::size_t options = 0;
  for (const std::string& line : formats().lines) {
    for (std::sregex_iterator i(line.begin(), line.end(), option), end; i != end; ++i) {
      INFO(line);
      ++options;
      CHECK(help.find(i->str()) != std::string::npos);
    }
  }
  CHECK(options > 20);
}

TEST_CASE("csg/FORMATS.md has the columns of rows and the arrays of .vtu", "[pages][formats]") {
  const Workshop w;
  w.write("t.yaml", kScene);
  const Outcome o = w.run("eval t.yaml --node curved -o t.vtu --parameters");
  INFO(o.err);
  REQUIRE(o.status == 0);
  std::string columns;
  for (const PageTable& table : tables_of(formats())) {
    if (table.head[0] != "column") continue;
    for (const auto& row : table.rows) {
      for (const std::string& word : quoted_words(row[0])) columns += (columns.empty() ? "" : " ") + word;
    }
  }
  CHECK(std::regex_replace(o.out.substr(0, o.out.find('\n')), std::regex(" +"), " ") == columns);

  Words arrays;
  const std::string vtu = w.read("t.vtu");
  static const std::regex name("DataArray type=\"[A-Za-z0-9]+\" Name=\"([^\"]+)\"");
  static const std::regex named("^(region|material|source_leaf|name) .*|^(patch) .*: .*");
  for (std::sregex_iterator i(vtu.begin(), vtu.end(), name), end; i != end; ++i) {
    const bool patch = i->str(1).starts_with("patch ");
    arrays.insert(std::regex_replace(i->str(1), named, patch ? "$2 LEAF: PATCH" : "$1 NAME"));
  }
  for (const std::string cells : {"Points", "connectivity", "offsets", "types"}) CHECK(arrays.erase(cells) == 1);
  CHECK(arrays.erase("thickness") + arrays.erase("kind") + arrays.erase("kind paved") == 3);
  arrays.insert("KEY TEXT");
  CHECK(arrays.erase("fraction of steel") + arrays.erase("fraction of ceramic") == 2);
  arrays.insert("fraction of NAME");
  CHECK(first_words(formats(), "array") == arrays);
}

/// The members that the tables under `.json` list for an owner (the first column or the one before `member`), in
/// their order.
std::vector<std::string> listed_members(const std::string& title, const std::string& owner) {
  std::vector<std::string> members;
  for (const PageTable& table : tables_of(formats())) {
    if (table.anchor != "json" || table.head[0] != title) continue;
    std::string of;
    for (const auto& row : table.rows) {
      if (title == "of" && !row[0].empty()) of = row[0];
      if (of != owner) continue;
      const std::vector<std::string> words = quoted_words(row[title == "of" ? 1 : 0]);
      members.insert(members.end(), words.begin(), words.end());
    }
  }
  return members;
}

/// Members of an object, in their order, are some of those that are listed; adds them to `seen`.
void check_members(const OrderedJson& object, const std::vector<std::string>& listed, Words& seen) {
  std::size_t next = 0;
  for (const auto& [key, value] : object.items()) {
    INFO(key << " in " << object.dump().substr(0, 200));
    const auto place = std::find(listed.begin(), listed.end(), key);
    REQUIRE(place != listed.end());
    CHECK(static_cast<std::size_t>(place - listed.begin()) >= next);
    next = static_cast<std::size_t>(place - listed.begin());
    seen.insert(key);
  }
}

/// The scene's nodes as `.json`, in files of the workshop.
std::vector<std::string> write_results(const Workshop& w) {
  w.write("t.yaml", kScene);
  std::vector<std::string> files;
  for (const std::string node : {"model", "open", "endless", "curved"}) {
    for (const std::string option : {"", "--raw", "--parameters"}) {
      files.push_back(node + option + ".json");
      const Outcome o = w.run("eval t.yaml --quiet --node " + node + " " + option + " -o " + files.back());
      INFO(o.err);
      REQUIRE(o.status == 0);
    }
  }
  return files;
}

TEST_CASE("csg/FORMATS.md has the members of .json, in their order", "[pages][formats]") {
  const Workshop w;
  const std::map<std::string, std::vector<std::string>> cells{{"vertices", listed_members("of", "vertex")},
                                                              {"edges", listed_members("of", "edge")},
                                                              {"faces", listed_members("of", "face")},
                                                              {"regions", listed_members("of", "region")}};
  const std::vector<std::string> top = listed_members("member", ""),
                                 origin = listed_members("of", "entry of `origin`"),
                                 grade = listed_members("of a grade", "");
  std::map<std::string, Words> seen;
  for (const std::string& file : write_results(w)) {
    const OrderedJson result = OrderedJson::parse(w.read(file));
    check_members(result, top, seen["top"]);
    for (const auto& [list, members] : cells) {
      for (const OrderedJson& cell : result.at(list)) {
        check_members(cell, members, seen[list]);
        for (const OrderedJson& entry : cell.value("origin", OrderedJson::array()))
          check_members(entry, origin, seen["origin"]);
      }
    }
    for (const OrderedJson& one : result.value("grades", OrderedJson::array()))
      check_members(one, grade, seen["grade"]);
  }
  const auto all = [](const std::vector<std::string>& words) { return Words(words.begin(), words.end()); };
  for (const auto& [list, members] : cells) CHECK(seen[list] == all(members));
  CHECK(seen["top"] == all(top));
  CHECK(seen["origin"] == all(origin));
  CHECK(seen["grade"] == all(grade));
}

TEST_CASE("results are as the schema of .json says", "[pages][formats]") {
  const Workshop w;
  std::vector<std::string> files = write_results(w);
  fs::copy(root() / "papers", w.path("papers"), fs::copy_options::recursive);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(w.path("papers"))) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string file = std::to_string(files.size()) + ".json";
    const Outcome o = w.run("eval --quiet '" + entry.path().string() + "' -o " + file);
    // Some read files that papers/run makes.
    if (o.status == 0) files.push_back(file);
  }
  CHECK(files.size() >= 30);
  // A file that is none is told from those that are.
  OrderedJson broken = OrderedJson::parse(w.read(files[0]));
  broken["faces"][0]["regions"] = {0};
  w.write("broken.json", broken.dump());
  w.write("validate.py", R"(import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
for name in sys.argv[2:]:
    for error in validator.iter_errors(json.load(open(name))):
        print(name, "/".join(str(step) for step in error.absolute_path))
        break
)");
  std::string names = "broken.json";
  for (const std::string& file : files) names += " '" + file + "'";
  const Outcome o = w.shell("python3 validate.py '" + (root() / "csg/formats/result.schema.json").string() + "' " +
                            names + " >.out 2>.err");
  INFO(o.err << "needs python3-jsonschema (Debian)");
  CHECK(o.status == 0);
  CHECK(o.out == "broken.json faces/0/regions\n");
}

TEST_CASE("exit statuses are those of csg/FORMATS.md", "[pages][formats]") {
  const Workshop w;
  w.write("t.yaml", kScene);
  CHECK(w.run("check t.yaml").status == 0);
  CHECK(w.run("check").status == 2);
  CHECK(w.run("eval t.yaml --quiet --node endless -o t.off").status == 2);
  CHECK(w.run("eval none.yaml").status == 3);
  CHECK(w.run("eval t.yaml --quiet -o none/t.vtu").status == 3);
}

}  // namespace
}  // namespace cnrg
