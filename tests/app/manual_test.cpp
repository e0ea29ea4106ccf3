// What is made of the table of options: the manual page, and what bash completes.
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Words = std::vector<std::string>;

const char* const kCommands[] = {"eval",    "check",  "locate", "explain", "view",       "mesh",
                                 "compare", "tables", "schema", "manual",  "completion", "help"};

std::string plain(std::string text) {
  for (const auto& [from, to] : {std::pair("\\fB", ""), std::pair("\\fI", ""), std::pair("\\fR", ""),
                                 std::pair("\\&", ""), std::pair("\\-", "-"), std::pair("\\e", "\\")}) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;)
      text.replace(at, std::string(from).size(), to);
  }
  return text;
}

/// Options that the help of a command names.
std::set<std::string> options_in(const std::string& help) {
  static const std::regex option("^  (-[a-zA-Z-]+)(?:,(--[a-z-]+))?");
  std::set<std::string> out;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, option)) continue;
    for (std::size_t i = 1; i < match.size(); ++i) {
      if (match[i].matched) out.insert(match.str(i));
    }
  }
  return out;
}

TEST_CASE("the manual page has every command and every option", "[app][manual]") {
  const Workshop w;
  const std::string page = plain(w.run("manual").out);
  const auto section = [&](const std::string& command) {
    const std::size_t begin = page.find("\n.SS cnrg " + command + "\n");
    REQUIRE(begin != std::string::npos);
    return page.substr(begin, page.find("\n.S", begin + 1) - begin);
  };
  CHECK_THAT(page, Contains("--version") && Contains(".SH EXIT STATUS"));
  CHECK_THAT(page, !Contains("__complete"));
  for (const std::string command : kCommands) {
    const std::string text = section(command);
    for (const std::string& option : options_in(w.run(command + " --help").out)) {
      INFO(command << " " << option);
      if (option != "-h" && option != "--help")
        CHECK_THAT(text, Contains("\n" + option) || Contains(", " + option));
    }
  }
}

TEST_CASE("the manual page is one that man can show", "[app][manual]") {
  const Workshop w;
  w.write("cnrg.1", w.run("manual").out);
  // It has no date, so that the same sources give the same page on any day.
  CHECK(w.shell("mandoc -T lint -W warning cnrg.1 >.out 2>.err").out ==
        "mandoc: cnrg.1:1:12: WARNING: missing date, using \"\": TH\n");
  const Outcome o = w.shell("groff -man -ww -T utf8 -P -cbou cnrg.1 >.out 2>.err");
  CHECK(o.status == 0);
  CHECK(o.err.empty());
  CHECK_THAT(o.out, Contains("EXIT STATUS"));
}

TEST_CASE("the model of the manual page can be evaluated", "[app][manual]") {
  const Workshop w;
  const std::string page = plain(w.run("manual").out);
  const std::size_t begin = page.find("cnrg: 1\n");
  w.write("model.yaml", page.substr(begin, page.find(".fi\n", begin) - begin));
  CHECK(w.run("eval model.yaml --quiet -o model.vtu").status == 0);
}

/// What bash offers for these words, of which the last one is not finished.
Words completed(const Workshop& w, const Words& words) {
  std::string line = "PATH=\"$PWD/models/bin:$PATH\"; source ./completion; COMP_WORDS=(";
  for (const std::string& word : words) line += "'" + word + "' ";
  w.write("ask", line +
                     "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_cnrg cnrg \"${COMP_WORDS[COMP_CWORD]}\" "
                     "\"${COMP_WORDS[COMP_CWORD-1]}\"\nprintf '%s\\n' \"${COMPREPLY[@]}\" | sort\n");
  const Outcome o = w.shell("bash --norc ./ask >.out 2>.err");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK(o.err.empty());
  Words out;
  std::istringstream lines(o.out);
  for (std::string word; std::getline(lines, word);) {
    if (!word.empty()) out.push_back(word);
  }
  return out;
}

TEST_CASE("bash completes commands, options, files, nodes and choices", "[app][manual]") {
  const Workshop w;
  w.write("completion", w.run("completion").out);
  std::filesystem::create_directories(w.path("models/bin"));
  std::filesystem::create_symlink(CNRG_PROGRAM, w.path("models/bin/cnrg"));
  w.write("slope.yaml",
          "cnrg: 1\nnodes:\n  rock: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  ore: {points: [[0, 0, 0]]}\n"
          "  'ore body': {union: [rock, {points: [[2, 2, 2]]}]}\nresult: 'ore body'\n");
  w.write("my model.json", w.read("slope.yaml"));
  w.write("notes.txt", "");

  CHECK(completed(w, {"cnrg", "e"}) == Words{"eval", "explain"});
  Words all(std::begin(kCommands), std::end(kCommands));
  for (const char* option : {"-h", "--help", "--version"}) all.push_back(option);
  Words offered = completed(w, {"cnrg", ""});
  std::sort(all.begin(), all.end());
  std::sort(offered.begin(), offered.end());
  CHECK(offered == all);
  for (const std::string command : kCommands) {
    const std::set<std::string> known = options_in(w.run(command + " --help").out);
    const Words found = completed(w, {"cnrg", command, "-"});
    CHECK(std::set<std::string>(found.begin(), found.end()) == known);
  }
  CHECK(completed(w, {"cnrg", "eval", "--th"}) == Words{"--threads"});
  CHECK(completed(w, {"cnrg", "completion", ""}) == Words{"bash", "fish", "zsh"});
  CHECK(completed(w, {"cnrg", "help", "c"}) == Words{"check", "compare", "completion"});

  CHECK(completed(w, {"cnrg", "eval", ""}) == Words{"models", "my model.json", "slope.yaml"});
  CHECK(completed(w, {"cnrg", "eval", "s"}) == Words{"slope.yaml"});
  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", "-o", "n"}) == Words{"notes.txt"});
  CHECK(completed(w, {"cnrg", "eval", "--inside", ""}) == Words{"models"});
  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", ""}).empty());

  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", "--node", ""}) == Words{"ore", "ore\\ body", "rock"});
  CHECK(completed(w, {"cnrg", "eval", "--finer", "2", "slope.yaml", "--node", "r"}) == Words{"rock"});
  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", "--node", "="}).size() == 3);
  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", "--node", "=", "ore\\ "}) == Words{"ore\\ body"});
  CHECK(completed(w, {"cnrg", "locate", "my\\ model.json", "--node", "ro"}) == Words{"rock"});
  CHECK(completed(w, {"cnrg", "compare", "notes.txt", "slope.yaml", "--node-b", "ro"}) == Words{"rock"});
  CHECK(completed(w, {"cnrg", "compare", "notes.txt", "slope.yaml", "--node-a", "ro"}).empty());
  CHECK(completed(w, {"cnrg", "eval", "-", "--node", ""}).empty());

  CHECK(completed(w, {"cnrg", "compare", "a", "b", "--ignore", ""}) ==
        Words{"attributes", "components", "features", "materials", "names"});
  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", "--color-by", "s"}) == Words{"source"});
  CHECK(completed(w, {"cnrg", "eval", "slope.yaml", "--threads", ""}).empty());
}

TEST_CASE("what is completed is never run", "[app][manual]") {
  const Workshop w;
  w.write("completion", w.run("completion").out);
  std::filesystem::create_directories(w.path("models/bin"));
  std::filesystem::create_symlink(CNRG_PROGRAM, w.path("models/bin/cnrg"));
  w.write("t.yaml", "cnrg: 1\nnodes: {\"$(touch ran)\": {points: [[0, 0, 0]]}}\nresult: \"$(touch ran)\"\n");
  CHECK(completed(w, {"cnrg", "eval", "t.yaml", "--node", ""}) == Words{"\\$\\(touch\\ ran\\)"});
  completed(w, {"cnrg", "eval", "$(touch ran)", "--node", ""});
  completed(w, {"cnrg", "eval", "`touch ran`"});
  CHECK_FALSE(std::filesystem::exists(w.path("ran")));
}

}  // namespace
}  // namespace cnrg
