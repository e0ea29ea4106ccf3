// csg/FORMATS.md against the program: what one of them has the other one has, too.
//
// Keys are those of the tables by which the program reads. Everything that is written is looked at in files of one
// small scene with curves, grades, planes and open sets, and of the trees of papers/.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
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

std::string node(const std::string& leaf) { return "{cnrg: 1, nodes: {a: {" + leaf + "}}, result: a}"; }

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

/// The lines of a text from a mark to the line that ends its block, by the name in the mark.
std::map<std::string, std::string> blocks_of(const std::vector<std::string>& lines) {
  static const std::regex begin("<!-- keys: ([a-z ]+) -->");
  std::map<std::string, std::string> blocks;
  std::string* block = nullptr;
  for (const std::string& line : lines) {
    std::smatch found;
    if (std::regex_match(line, found, begin)) block = &blocks[found.str(1)];
    else if (line == "<!-- /keys -->") block = nullptr;
    else if (block) *block += line + "\n";
  }
  return blocks;
}

// CNRG_WRITE_PAGES=1 writes the tables of the program into the page.
TEST_CASE("csg/FORMATS.md has the tables of keys by which the program reads", "[pages][formats]") {
  const Workshop w;
  std::map<std::string, std::string> tables = blocks_of(lines_of(w.run("schema --tables").out));
  CHECK(tables.erase("hidden") == 1);  // of points [r, z] what others say of points [x, y, z]
  CHECK(tables.size() > 15);
  std::map<std::string, std::string> shown = blocks_of(formats().lines);
  if (std::getenv("CNRG_WRITE_PAGES") != nullptr) {
    std::string text = text_of(formats().path);
    for (const auto& [name, lines] : shown) {
      const std::string mark = "<!-- keys: " + name + " -->\n";
      text.replace(text.find(mark) + mark.size(), lines.size(), tables.at(name));
    }
    std::ofstream(formats().path) << text;
    shown = tables;
  }
  CHECK(shown == tables);
}

TEST_CASE("the tables of keys have the leaves and operators that the reader has", "[pages][formats]") {
  CHECK(first_words(formats(), "leaf") ==
        words_in_source("csg/tree/read_leaf.cpp", "kReaders{{", "\\{\"([a-z]+)\", read_"));
  CHECK(first_words(formats(), "operator") ==
        words_in_source("csg/tree/operator_names.h", "kOperators{{", "\\{\"([a-z]+)\", Operator::"));
}

TEST_CASE("csg/FORMATS.md has the extensions that the program writes and reads", "[pages][formats]") {
  const Workshop w;
  w.write("t.yaml", kScene);
  const auto listed = [](const std::string& text, const std::string& mark) {
    static const std::regex extension("(\\.[a-z0-9]+)+");
    REQUIRE(text.find(mark) != std::string::npos);
    const std::string rest = text.substr(text.find(mark) + mark.size()), list = rest.substr(0, rest.find('\n'));
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

/// The members that the schema of .json has, in its order; of a definition or of the whole.
std::vector<std::string> listed_members(const std::string& definition = {}) {
  static const OrderedJson schema = OrderedJson::parse(text_of(root() / "csg/formats/result.schema.json"));
  const OrderedJson& whole = definition.empty() ? schema : schema.at("definitions").at(definition);
  const OrderedJson& one = whole.contains("items") ? whole.at("items") : whole;
  std::vector<std::string> members;
  for (const auto& [name, value] : one.at("properties").items()) members.push_back(name);
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

TEST_CASE("the schema of .json has its members, in their order", "[pages][formats]") {
  const Workshop w;
  const std::map<std::string, std::vector<std::string>> cells{{"vertices", listed_members("vertex")},
                                                              {"edges", listed_members("edge")},
                                                              {"faces", listed_members("face")},
                                                              {"regions", listed_members("region")}};
  const std::vector<std::string> top = listed_members(), origin = listed_members("origin"),
                                 grade = listed_members("grade");
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
