// Words that people type from habit: short options, help of a command, rows as JSON; and what zsh and fish offer.
#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Lines = std::set<std::string>;

const char* const kTree =
    "cnrg: 1\nnodes:\n  rock: {box: {min: [0, 0, 0], max: [1, 1, 1/3]}}\n  ball: {sphere: {center: [9, 9, 9], "
    "radius: "
    "1}}\n  \"it's $(touch ran)\": {union: [rock, ball]}\n  far: {complement: rock}\nresult: \"it's $(touch "
    "ran)\"\n";

Lines lines_of(const std::string& text) {
  Lines out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out.insert(line.substr(0, line.find_first_of("\t/")));
  return out;
}

TEST_CASE("-q is --quiet and --output is -o", "[app][words]") {
  const Workshop w;
  w.write("t.yaml", kTree);
  for (const char* command : {"eval t.yaml -o a.json", "mesh t.yaml -o a.msh", "view t.yaml -o a.html"}) {
    const std::string words = command, name = words.substr(words.rfind(' ') + 1);
    CHECK(w.run(words + " --quiet").status == 0);
    const std::string file = w.read(name);
    std::filesystem::remove(w.path(name));
    std::string other = words;
    other.replace(other.find("-o"), 2, "--output");
    const Outcome o = w.run(other + " -q");
    CHECK(o.status == 0);
    CHECK(o.out.empty());
    CHECK(w.read(name) == file);
  }
  CHECK(w.run("compare t.yaml t.yaml -q").out.empty());
  CHECK(w.run("eval t.yaml -o b.vtu --output=c.vtu -q").status == 0);
  CHECK(w.read("b.vtu") == w.read("c.vtu"));
}

TEST_CASE("help of a command is what --help says, in lines of 80 characters", "[app][words]") {
  const Workshop w;
  CHECK(w.run("help").out == w.run("--help").out);
  for (const char* command :
       {"eval", "check", "locate", "explain", "view", "mesh", "compare", "completion", "help"}) {
    const Outcome o = w.run(std::string("help ") + command);
    CHECK(o.status == 0);
    CHECK(o.out == w.run(std::string(command) + " --help").out);
    std::istringstream lines(o.out);
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      CHECK((line.size() <= 80 || line.find(' ', line.find_first_not_of(' ')) == std::string::npos));
    }
  }
  CHECK_THAT(w.run("help mesh").out, Contains("\n  -q,--quiet                  No table and no notices\n"));
  CHECK_THAT(w.run("help eval").out, Contains("\n                              .json .vtu .msh .msh2 .mesh"));
  const Outcome o = w.run("help evla");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, StartsWith("cnrg: error: ") && Contains("evla") && Contains("eval"));
}

TEST_CASE("rows are JSON if they are asked for so", "[app][words]") {
  const Workshop w;
  w.write("t.yaml", kTree);
  const Outcome o = w.run("eval t.yaml --json --node far");
  CHECK(o.status == 0);
  w.write("rows.json", o.out);
  w.write("read.py",
          "import json\nfrom fractions import Fraction\nrows = json.load(open('rows.json'))\n"
          "by = {row['node']: row for row in rows['rows']}\n"
          "assert set(rows['seconds']) == {'leaves', 'refinement', 'crossings', 'results'}, rows\n"
          "assert by['rock']['volume'] == '1/3' and by['rock']['within'] == 0 and by['rock']['vertices'] == 8\n"
          "ball = by['ball']\nassert 4.18879 - ball['within'] < float(Fraction(ball['volume'])) < 4.18880, ball\n"
          "assert Fraction(by[\"it's $(touch ran)\"]['volume']) == Fraction(ball['volume']) + Fraction(1, 3)\n"
          "assert by['far']['volume'] is None and 'within' not in by['far'] and by['far']['components'] == 1\n"
          "assert by['far']['faces'] == 0 and by['rock']['faces'] == 6 and by['rock']['3-cells'] == 1, by\n"
          "assert 'components' not in by['rock'] and by['rock']['operator'] == 'box'\n");
  const Outcome read = w.shell("python3 read.py >.out 2>.err");
  INFO(read.err);
  CHECK(read.status == 0);
  const Outcome quiet = w.run("eval t.yaml -q --json");
  CHECK((quiet.err.find("notice") == std::string::npos && quiet.out.starts_with("{") &&
         quiet.out.find("\"rock\"") != std::string::npos));
  for (const char* other : {"--trace", "--topology", "--list"})
    CHECK_THAT(w.run(std::string("eval t.yaml --json ") + other).err, Contains("excludes --json"));
}

/// A folder with the tree, and the program on PATH.
void prepare(const Workshop& w) {
  w.write("t.yaml", kTree);
  std::filesystem::create_directories(w.path("bin"));
  std::filesystem::create_symlink(CNRG_PROGRAM, w.path("bin/cnrg"));
  w.write("_cnrg", w.run("completion zsh").out);
  w.write("cnrg.fish", w.run("completion fish").out);
}

Lines offered_by_zsh(const Workshop& w, const std::string& line) {
  w.write("line", line);
  return lines_of(w.shell("PATH=\"$PWD/bin:$PATH\" timeout 60 zsh -f '" CNRG_SOURCES
                          "/tests/app/complete.zsh' \"$PWD\" "
                          "\"$(cat line)\" >.out 2>.err")
                      .out);
}

Lines offered_by_fish(const Workshop& w, const std::string& line) {
  w.write("ask.fish", "source cnrg.fish\nread -z line < line\ncomplete -C $line\n");
  w.write("line", line);
  return lines_of(w.shell("PATH=\"$PWD/bin:$PATH\" HOME=\"$PWD\" fish -N ask.fish >.out 2>.err").out);
}

TEST_CASE("zsh and fish offer commands, options, choices, files and nodes", "[app][words]") {
  const Workshop w;
  prepare(w);
  for (const auto offered : {offered_by_zsh, offered_by_fish}) {
    CHECK(offered(w, "cnrg e") == Lines{"eval", "explain"});
    CHECK(offered(w, "cnrg eval t.yaml --no") == Lines{"--no-certify", "--no-snap", "--node"});
    CHECK(offered(w, "cnrg eval t.yaml --node ") == Lines{"ball", "far", "it's $(touch ran)", "rock"});
    CHECK(offered(w, "cnrg eval t.yaml --refine ") == Lines{"apart", "together"});
    CHECK(offered(w, "cnrg eval t") == Lines{"t.yaml"});
    CHECK(offered(w, "cnrg eval t.yaml -o t") == Lines{"t.yaml"});
    CHECK(offered(w, "cnrg eval t.yaml --inside ") == Lines{"bin"});
    CHECK(offered(w, "cnrg completion ") == Lines{"bash", "fish", "zsh"});
    CHECK(offered(w, "cnrg help lo") == Lines{"locate"});
    CHECK(offered(w, "cnrg eval '$(touch ran)' --node ").empty());
  }
  CHECK_FALSE(std::filesystem::exists(w.path("ran")));
}

}  // namespace
}  // namespace cnrg
