// Names that would clear a terminal, turn a line around or forge one: every command and every file with them.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "csg/text/escape.h"
#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

const std::vector<std::string> kHostile = {"esc\x1b[2J",
                                           "end\nt.yaml:1:1: error: forged\n$EndPhysicalNames\nf 1 2 3\n",
                                           "\r\nv 1 2 3\r\n",
                                           "rlo\xe2\x80\xae",
                                           "nel\xc2\x85",
                                           "csi\xc2\x9b"
                                           "31m",
                                           "line\xe2\x80\xa8\xe2\x80\xa9",
                                           std::string("nul\0z", 5),
                                           "quotes\" '<&>]]> -- &#27; \\",
                                           "tab\tbell\a\x7f"};

/// A tree with these names in every place that has one.
std::string tree_of_names() {
  nlohmann::ordered_json tree{{"cnrg", 1}};
  nlohmann::ordered_json operands = nlohmann::json::array();
  for (std::size_t i = 0; i < kHostile.size(); ++i) {
    const std::string& name = kHostile[i];
    const int x = static_cast<int>(2 * i);
    tree["materials"]["m" + name] = nlohmann::json::object();
    tree["nodes"][name] = {{"box", {{"min", {x, 0, 0}}, {"max", {x + 1, 1, 1}}}},
                           {"material", i == 0 ? "graded" + name : "m" + name},
                           {"name", "r" + name}};
    operands.push_back(name);
  }
  tree["materials"]["graded" + kHostile[0]] = {
      {"linear",
       {{"from", {0, 0, 0}}, {"to", {1, 0, 0}}, {"stops", {{0, "m" + kHostile[0]}, {1, "m" + kHostile[1]}}}}}};
  tree["nodes"]["side" + kHostile[1]] = {
      {"cylinder", {{"from", {30, 0, 0}}, {"to", {30, 0, 1}}, {"radius", 1}, {"segments", 4}}}};
  tree["nodes"]["wire" + kHostile[1]] = {{"polyline", {{-1, 0, 0}, {-1, 0, 1}}}};
  tree["nodes"]["sheet" + kHostile[1]] = {{"polygon", {{-3, 0, 0}, {-2, 0, 0}, {-2, 1, 0}}}};
  tree["nodes"]["tip" + kHostile[1]] = {{"points", {{-4, 0, 0}}}};
  tree["nodes"]["unused" + kHostile[1]] = {{"points", {{-4, 0, 0}}}};
  operands.push_back("side" + kHostile[1]);
  tree["nodes"]["solids" + kHostile[1]] = {{"union", operands}};
  tree["nodes"]["all" + kHostile[1]] = {
      {"union", {"solids" + kHostile[1], "wire" + kHostile[1], "sheet" + kHostile[1], "tip" + kHostile[1]}}};
  tree["result"] = "all" + kHostile[1];
  return tree.dump();
}

/// Lines of text of UTF-8 without a hostile character.
void check_harmless(const std::string& text, const std::string& where) {
  INFO(where);
  for (std::size_t i = 0; i < text.size();) {
    const Character c = first_character(std::string_view(text).substr(i));
    const bool kept = c.code == '\n' || c.code == '\t';
    if (!c.valid || (is_hostile(c.code) && !kept)) FAIL("at byte " << i << ": " << shown(text.substr(i, 20)));
    i += c.length;
  }
  for (const char* forged : {"t.yaml:1:1: error: forged", "$EndPhysicalNames\nf", "f 1 2 3", "v 1 2 3"}) {
    if (text.starts_with(forged) || text.find(std::string("\n") + forged + "\n") != std::string::npos)
      FAIL("a forged line: " << forged);
  }
}

/// An argument for the shell.
std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

TEST_CASE("hostile names reach neither a terminal nor a file", "[app][names]") {
  const Workshop w;
  w.write("t.yaml", tree_of_names());
  const std::string solids = " --node " + quoted("solids" + kHostile[1]);
  std::vector<std::string> commands{"check t.yaml",
                                    "eval t.yaml --trace --topology",
                                    "eval t.yaml --parameters -o n.json -o n.vtu",
                                    "eval t.yaml -o a.msh -o a.mesh -o a.obj -o a.poly -o a.smesh -o a.dot "
                                    "-o a.regions.dot -o a.stl",
                                    "eval t.yaml -o a.msh -o a.mesh -o a.obj -o a.poly -o a.smesh -o a.dot "
                                    "-o a.regions.dot",
                                    "eval t.yaml -o s.stl -o s.off -o s.ply" + solids,
                                    "mesh t.yaml -o m.msh -o m.mesh -o m.vtu" + solids,
                                    "explain t.yaml --cell r0",
                                    "explain t.yaml --point 1/2,1/2,1/2",
                                    "explain t.yaml --point 31,0,1/2",
                                    "locate t.yaml --parameters --material",
                                    "tables"};
  for (const std::string& name : kHostile) {
    if (name.find('\0') != std::string::npos) continue;
    const std::string word = quoted(name);
    commands.insert(
        commands.end(),
        {"eval t.yaml --node " + word, "eval " + word, "check " + word, word, "eval t.yaml -o " + word,
         "eval t.yaml -o " + quoted(name + ".vtu") + " -o " + quoted(name + ".vtu"), "mesh t.yaml -o " + word,
         "explain t.yaml --cell " + word, "explain t.yaml --point " + word, "eval t.yaml --threads " + word,
         "eval t.yaml " + quoted("--" + name), "eval t.yaml -o " + quoted("gone/" + name + ".vtu")});
  }
  for (const std::string& command : commands) {
    const Outcome o = w.run(command, "1/2 1/2 1/2\n31 0 1/2\n1/2 1/2 0\n");
    check_harmless(o.out, "stdout of " + shown(command));
    check_harmless(o.err, "stderr of " + shown(command));
    CHECK(o.status != 1);
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(w.path("."))) {
    const std::string name = entry.path().filename().string();
    if (name[0] == '.' || name == "t.yaml") continue;
    check_harmless(w.read(name), "file " + shown(name));
    ++files;
  }
  CHECK(files >= 15);
  // What is exact comes back as it was; all else is shown.
  const auto json = nlohmann::json::parse(w.read("n.json"));
  CHECK(json.at("node") == "all" + kHostile[1]);
  CHECK_THAT(w.run("eval t.yaml").out, Contains("\nesc\\x1b[2J  ") && Contains("\nrlo\\u202e  "));
  w.write("back.yaml", "cnrg: 1\nnodes: {r: {cnrg: n.json}}\nresult: r\n");
  REQUIRE(w.run("eval back.yaml --quiet -o back.json").status == 0);
  const auto back = nlohmann::json::parse(w.read("back.json"));
  REQUIRE(back.at("components").size() == json.at("components").size());
  for (std::size_t i = 0; i < back.at("components").size(); ++i) {
    for (const char* key : {"name", "material"}) CHECK(back["components"][i][key] == json["components"][i][key]);
  }
}

TEST_CASE("the program prints by one door", "[app][names]") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator("csg")) {
    const std::filesystem::path& path = entry.path();
    const std::string name = path.filename().string();
    if (path.extension() != ".cpp" || path.parent_path().filename() == "examples") continue;
    if (name == "output.cpp" || name == "progress_bar.cpp") continue;
    std::ifstream stream(path);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    INFO(path);
    for (const char* door : {"std::cerr", " puts(", "std::puts", "std::printf", "perror"})
      CHECK_THAT(text, !Contains(door));
    // Standard output is `Output`'s; OpenCASCADE is kept from it.
    if (path.parent_path().filename() != "app" && name != "cad_occt_read.cpp")
      CHECK_THAT(text, !Contains("std::cout"));
  }
}

TEST_CASE("hostile words of files that a leaf reads are shown", "[app][names]") {
  const Workshop w;
  const std::string word = "x\x1b[2J\xc2\x9b\xe2\x80\xae\xff";
  w.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 " + word + " 0\n3 0 1 2\n");
  w.write("a.obj", "v 0 0 0\nf " + word + " 2 3\n");
  w.write("a.stl", "solid " + word + "\nfacet normal 0 0 1\nouter " + word + "\n");
  w.write("a.ply", "ply\nformat ascii 1.0\n" + word + "\nend_header\n");
  w.write("a.asc", "ncols 2\nnrows 2\n" + word + " 1\n");
  w.write("a.json", "{\"format\": \"cnrg result\", \"" + word);
  w.write("b.json", R"({"format": "\u001b[2J\u202e", "version": 1})");
  const std::string odd = "odd\n\x1b\xe2\x80\xae.off";
  w.write(odd, "OFF\nx\n");
  for (const std::string leaf :
       {"mesh: {file: a.off}", "mesh: {file: a.obj}", "mesh: {file: a.stl}", "mesh: {file: a.ply}",
        "heightfield: {file: a.asc}", "cnrg: a.json", "cnrg: b.json", "step: {file: a.ply}",
        "mesh: {file: \"odd\\n\\e\\u202e.off\"}", "mesh: {file: \"gone\\n\\e\\u202e.off\"}"}) {
    w.write("t.yaml", "cnrg: 1\nnodes: {a: {" + leaf + "}}\nresult: a\n");
    const Outcome o = w.run("check t.yaml");
    INFO(leaf);
    CHECK(o.status != 0);
    CHECK(o.status != 1);
    CHECK(errors_in(o.err) == 1);
    check_harmless(o.err, leaf);
  }
}

TEST_CASE("a tree that is no UTF-8 is told at its byte", "[app][names]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes: {caf\xe9: {points: [[0, 0, 0]]}}\nresult: caf\xe9\n");
  const Outcome o = w.run("eval t.yaml");
  CHECK(o.status == 2);
  CHECK(o.err ==
        "t.yaml:2:12: error: the byte \\xe9 is no UTF-8; save the file as UTF-8\n"
        "  2 | nodes: {caf\\xe9: {points: [[0, 0, 0]]}}\n    |            ^\n");
}

}  // namespace
}  // namespace cnrg
