// The lessons: who solves an exercise is told so, who does not is told why, and what `make` writes hangs together.
//
// Pages are checked without a browser: every address in them is a file that was made, and every anchor in it an
// id. What the lessons print is checked with all other pages (tests/pages).
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;

const fs::path kRoot = CNRG_SOURCES;
const fs::path kLessons = kRoot / "papers" / "lessons";
constexpr int kCount = 14;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Two digits, as folders of lessons and files of wrong answers begin.
std::string digits(int n) { return (n < 10 ? "0" : "") + std::to_string(n); }

fs::path folder_of(int n) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kLessons)) {
    if (entry.path().filename().string().starts_with(digits(n) + "-")) return entry.path();
  }
  FAIL("there is no lesson " << n);
  return {};
}

/// A script of the lessons, which finds the program of this build.
Outcome script(const Workshop& w, const std::string& words) {
  const fs::path programs = fs::path(CNRG_PROGRAM).parent_path();
  return w.shell("PATH='" + programs.string() + "':\"$PATH\" '" + kLessons.string() + "'/" + words +
                 " >.out 2>.err");
}

Outcome check(const Workshop& w, int n, const fs::path& answer) {
  return script(w, "check " + std::to_string(n) + " '" + answer.string() + "'");
}

TEST_CASE("each answer of a lesson passes", "[lessons]") {
  const Workshop w;
  for (int n = 1; n <= kCount; ++n) {
    const Outcome o = check(w, n, folder_of(n) / "answer.yaml");
    INFO(n << ": " << o.out << o.err);
    CHECK(o.status == 0);
    CHECK_THAT(o.out, Contains("right: exercise " + std::to_string(n) + " is solved\n"));
    CHECK(o.err == "");
  }
}

TEST_CASE("an exercise as it is given has holes, and each is told with its line", "[lessons]") {
  const Workshop w;
  for (int n = 1; n <= kCount; ++n) {
    const fs::path exercise = folder_of(n) / "exercise.yaml";
    const Outcome o = check(w, n, exercise);
    INFO(n << ": " << o.out << o.err);
    CHECK(o.status == 1);
    CHECK(o.out == "");
    std::istringstream lines(text_of(exercise));
    std::string line, told;
    for (int i = 1; std::getline(lines, line); ++i) {
      if (line.find("____") != std::string::npos) {
        told += exercise.string() + ":" + std::to_string(i) + ": error: a hole is left to fill: `____`\n";
      }
    }
    CHECK(!told.empty());
    CHECK(o.err == told);
    // The program itself refuses a hole, too, and says where.
    CHECK(w.run("check '" + exercise.string() + "'").status == 2);
    CHECK_THAT(w.read(".err"), StartsWith(exercise.string() + ":") && Contains("____"));
  }
}

/// What the check of a wrong answer has to say, by lesson.
const std::map<int, std::string> kReasons{
    {1, "in both: a face of area 0.5 about (3/2, 7/4, 3/2): in component 2 `a & b` of A"},
    {2,
     "only in A: a face of area 1/2 sqrt(5) about (3/2, 3/4, 1/2)\n"
     "only in B: a face of area sqrt(2) about (1/2, 3/2, 1/2)\n"},
    {3,
     "in both: a face of area 2 about (7/2, 2, 1): in region 1 `block` of A, an entity of B\n"
     "in both: an edge of length 2 about (2, 2, 3): in region 1 `block` of A, an entity of B\n"},
    {4, "only in A: a face of area 4 about (1, 1, 2)\n"},
    {5, "in both: a region of volume 4 about (9/2, 1, 1): in region 3 `marl` of A, in region 2 `clay` of B\n"},
    {6, "in both: a face of area 4 about (2, 2, 7/2): in region 2 `block` of A, an entity of B\n"},
    {7, "only in B: 6 faces of area 24 in all about (4, 2, 2)\n"},
    {8, "only in B: an edge of length 1 about (4, 2, 7/2)\n"},
    {9, "only in A: a face of area sqrt(107) about (0, -2, 1/3)\n"},
    {10, "only in A: all 2 together: volume 1\n"},
    {11, "in both: a region of volume 0.000000333333333333 (1/3000000) about (1/2, 1/2, 833333/2500000)"},
    {12, "in both: an edge of length 1 about (1, 2, 5/2): an entity of A, in region 1 `block` of B\n"},
    {13, "only in B: 4 faces of area 6 in all about (4, 2, 1/2)\n"},
    {14, "about (0, 17/8, 0)\n"}};

TEST_CASE("a wrong answer is told why", "[lessons]") {
  const Workshop w;
  for (int n = 1; n <= kCount; ++n) {
    const fs::path wrong = kRoot / "tests" / "lessons" / "wrong" / (digits(n) + ".yaml");
    const Outcome o = check(w, n, wrong);
    INFO(n << ": " << o.out << o.err);
    CHECK(o.status == 1);
    CHECK_THAT(o.out, Contains("\nnot yet right: "));
    CHECK_THAT(o.out, !Contains("right: exercise"));
    CHECK_THAT(o.out, Contains(kReasons.at(n)));
  }
}

TEST_CASE("a tree with a fault is not yet right, and the fault is told", "[lessons]") {
  const Workshop w;
  w.write("mine.yaml", "cnrg: 1\nnodes:\n  a: {bax: {}}\nresult: a\n");
  const Outcome o = check(w, 1, "mine.yaml");
  CHECK(o.status == 1);
  CHECK_THAT(o.err, StartsWith("mine.yaml:3:7: error: "));
}

TEST_CASE("the check refuses what it cannot check", "[lessons]") {
  const Workshop w;
  for (const char* words : {"check", "check 1", "check 1 a b", "check 0 .", "check 15 .", "check x .",
                            "check 1 none.yaml", "check 1 ."}) {
    const Outcome o = script(w, words);
    INFO(words << ": " << o.err);
    CHECK(o.status == 2);
    CHECK(o.out == "");
    CHECK_THAT(o.err, StartsWith("check: error: "));
  }
  CHECK_THAT(script(w, "check --help").out, Contains("check N ANSWER.yaml"));
}

/// Addresses in a page that was made, and its anchors.
struct Made {
  std::vector<std::string> addresses;
  std::set<std::string> anchors;
  std::vector<std::string> frames;
};

Made read_made(const std::string& text) {
  static const std::regex address("\\b(href|src)=\"([^\"]*)\""), id("\\bid=\"([^\"]*)\"");
  Made made;
  for (std::sregex_iterator m(text.begin(), text.end(), address), end; m != end; ++m) {
    made.addresses.push_back(std::regex_replace(m->str(2), std::regex("&amp;"), "&"));
    if (m->prefix().str().ends_with("<iframe ")) made.frames.push_back(made.addresses.back());
  }
  for (std::sregex_iterator m(text.begin(), text.end(), id), end; m != end; ++m) made.anchors.insert(m->str(1));
  return made;
}

TEST_CASE("the lessons are made, and all links in them lead somewhere", "[lessons]") {
  const Workshop w;
  const Outcome o = script(w, "make --out made");
  INFO(o.err);
  REQUIRE(o.status == 0);
  CHECK_THAT(o.out, Contains("14 lessons; open this file in a browser: made/index.html"));
  std::map<std::string, Made> pages;
  std::set<std::string> views;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(w.path("made"))) {
    if (entry.path().extension() != ".html") continue;
    // What has the name of a tree is a page of `cnrg view`, which has tests of its own.
    if (fs::exists(fs::path(entry.path()).replace_extension(".yaml"))) views.insert(entry.path().string());
    else pages.emplace(entry.path().string(), read_made(text_of(entry.path())));
  }
  CHECK(views.size() == kCount);
  std::size_t links = 0, framed = 0;
  for (const auto& [path, made] : pages) {
    for (const std::string& address : made.addresses) {
      INFO(path << ": " << address);
      CHECK(address.find("://") == std::string::npos);
      const std::size_t mark = address.find('#');
      const std::string file = address.substr(0, mark),
                        part = mark == std::string::npos ? "" : address.substr(mark + 1);
      const fs::path target =
          file.empty() ? fs::path(path) : (fs::path(path).parent_path() / file).lexically_normal();
      CHECK(fs::is_regular_file(target));
      if (pages.contains(target.string()) && !part.empty())
        CHECK(pages.at(target.string()).anchors.contains(part));
      ++links;
    }
    for (const std::string& address : made.frames) {
      INFO(path << ": " << address);
      const fs::path target = fs::path(path).parent_path() / address.substr(0, address.find('#'));
      CHECK(views.contains(target.string()));
      // The view opens with a node that there is.
      std::smatch node;
      REQUIRE(std::regex_search(address, node, std::regex("#node=([a-z_]+)")));
      const std::string tree = fs::path(target).replace_extension(".yaml").string();
      CHECK(w.run("eval '" + tree + "' --quiet --node " + node.str(1)).status == 0);
      ++framed;
    }
  }
  CHECK(links > 200);
  CHECK(framed == 2 * kCount);  // once on the page, once on a slide
}

TEST_CASE("one lesson is made alone, and one that is not there is refused", "[lessons]") {
  const Workshop w;
  const Outcome o = script(w, "make 1 --out made");
  CHECK(o.status == 0);
  CHECK(fs::exists(w.path("made") / folder_of(1).filename() / "index.html"));
  CHECK(!fs::exists(w.path("made") / folder_of(2).filename()));
  const Outcome none = script(w, "make 15 --out made");
  CHECK(none.status == 2);
  CHECK_THAT(none.err, Contains("there is no lesson 15"));
}

TEST_CASE("a lesson of one's own is a folder elsewhere", "[lessons]") {
  const Workshop w;
  const fs::path mine = w.path("mine");
  fs::create_directory(mine);
  std::ofstream(mine / "README.md") << "# Mine\n\n[Look](tree.yaml \"node=a\")\n\nSee [the tree](tree.yaml).\n";
  for (const char* name : {"tree.yaml", "answer.yaml"}) fs::copy_file(folder_of(1) / "cells.yaml", mine / name);
  const Outcome made = script(w, "make mine 2 --out made");
  INFO(made.err);
  CHECK(made.status == 0);
  CHECK_THAT(text_of(w.path("made") / "mine" / "index.html"),
             Contains("<iframe src=\"tree.html#node=a\"") && Contains("href=\"tree.yaml\""));
  CHECK(fs::exists(w.path("made") / "mine" / "tree.html"));
  CHECK(fs::exists(w.path("made") / folder_of(2).filename() / "index.html"));
  CHECK_THAT(script(w, "check mine mine/tree.yaml").out, Contains("right: the exercise of mine is solved\n"));
  CHECK(script(w, "check mine '" + (folder_of(2) / "answer.yaml").string() + "'").status == 1);
}

TEST_CASE("lessons can be read while the program is being built", "[lessons]") {
  const Workshop w;
  const Outcome o =
      w.shell("PATH=/usr/bin:/bin '" + kLessons.string() + "'/make 1 --waiting --out made >.out 2>.err");
  INFO(o.err);
  REQUIRE(o.status == 0);
  const std::string view = text_of(w.path("made") / folder_of(1).filename() / "cells.html");
  CHECK_THAT(view, Contains("cnrg is being built") && Contains("location.reload()"));
}

TEST_CASE("where views cannot be made, pages are, and the reason is told", "[lessons]") {
  const Workshop w;
  w.write("cnrg", "#!/bin/sh\necho 'cnrg: error: no page to fill in' >&2\nexit 3\n");
  fs::permissions(w.path("cnrg"), fs::perms::owner_all);
  const Outcome o = w.shell("PATH=\"$PWD:$PATH\" '" + kLessons.string() + "'/make 1 --out made >.out 2>.err");
  CHECK(o.status == 2);
  CHECK(o.out == "");
  CHECK_THAT(o.err, StartsWith("papers/lessons/make: error: ") &&
                        Contains("cells.yaml: cnrg: error: no page to fill in"));
  CHECK(fs::exists(w.path("made") / folder_of(1).filename() / "slides.html"));
}

TEST_CASE("what a page shows is shown as it stands", "[lessons]") {
  const Workshop w;
  REQUIRE(script(w, "make 1 --out made").status == 0);
  const std::string page = text_of(w.path("made") / folder_of(1).filename() / "index.html");
  CHECK_THAT(page, Contains("3 r2 2 a &amp; b"));
  CHECK_THAT(page, !Contains("a & b"));
  CHECK_THAT(page, Contains("<details>") && Contains("<summary>Answers</summary>"));
}

}  // namespace
}  // namespace cnrg
