// `bench/run same`: two programs that answer alike are found to be the same, times aside; one byte that differs in
// anything that a program says or writes is found. Its trees have every leaf and every operator.
#include <filesystem>
#include <regex>
#include <string>

#include "csg/tree/read_leaf.h"
#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const std::string kCommand = "PYTHONDONTWRITEBYTECODE=1 '" CNRG_SOURCES "/bench/same/same' ";

Outcome same(const Workshop& w, const std::string& programs, const std::string& options) {
  return w.shell(kCommand + programs + " " + options + " --jobs 1 >.out 2>.err");
}

/// A program that answers as ours does, but for what a line of the shell does afterwards in the folder: the
/// streams are in the files $o and $e, the exit status in $s.
void write_liar(const Workshop& w, const std::string& line) {
  w.write("liar", "#!/bin/sh\no=$(mktemp) e=$(mktemp)\n'" CNRG_PROGRAM "' \"$@\" >$o 2>$e\ns=$?\n" + line +
                      "\ncat $o\ncat $e >&2\nrm -f $o $e\nexit $s\n");
  std::filesystem::permissions(w.path("liar"), std::filesystem::perms::owner_all);
}

TEST_CASE("a program is the same as itself, and times do not count", "[same]") {
  const Workshop w;
  write_liar(w, R"(sed -i -E 's/  0\.[0-9]{3}  /  7.654  /; s/; 0\.[0-9]{3} s$/; 7.654 s/' $o)");
  const Outcome o = same(w, "'" CNRG_PROGRAM "' ./liar", "--trees 3 --only random/");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, StartsWith("identical: 3 trees, "));
  CHECK_FALSE(std::filesystem::exists(w.path("out")));
}

TEST_CASE("messages that are meant to change may do so", "[same]") {
  const Workshop w;
  write_liar(w, "sed -i 's/vertices/corners/g' $o");
  const Outcome o = same(w, "'" CNRG_PROGRAM "' ./liar", "--trees 1 --only random/ --reword vertices=corners");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
}

TEST_CASE("one byte that differs is found and kept", "[same]") {
  struct Lie {
    std::string line, found;
  };
  const Lie lies[] = {
      {"[ ! -e result.vtu ] || printf ' ' >>result.vtu", "result.vtu, line"},
      {"[ ! -e result.json ] || sed -i '1,/vertices/s/vertices/Vertices/' result.json", "result.json, line"},
      {"rm -f result.obj", "result.obj, line"},
      {R"([ "$1" != locate ] || sed -i '$s/.$//' $o)", "stdout, line"},
      {R"([ "$1" != explain ] || echo 'notice' >>$e)", "stderr, line"},
      {R"([ "$1" != eval ] || s=1)", "exit status, line 1"},
  };
  for (const Lie& lie : lies) {
    INFO(lie.line);
    const Workshop w;
    write_liar(w, lie.line);
    const Outcome o = same(w, "'" CNRG_PROGRAM "' ./liar", "--trees 1 --only random/ --keep kept");
    INFO(o.out << o.err);
    CHECK(o.status == 1);
    CHECK_THAT(o.out, Contains(lie.found));
    CHECK_THAT(o.out, Contains("different: 1 of 1 trees (seed 1)"));
    const std::filesystem::path kept = w.path("kept/random-0");
    CHECK(std::filesystem::exists(kept / "commands"));
    CHECK((std::filesystem::exists(kept / "t.yaml") || std::filesystem::exists(kept / "t.json")));
    CHECK_FALSE(std::filesystem::is_empty(kept / "base"));
    CHECK_FALSE(std::filesystem::is_empty(kept / "head"));
  }
}

TEST_CASE("random trees are those of their seed and have every leaf, operator and attribute", "[same]") {
  const Workshop w;
  const auto print = [&](const std::string& options) {
    const Outcome o = w.shell(kCommand + "--print " + options + " >.out 2>.err");
    INFO(o.err);
    CHECK(o.status == 0);
    return o.out;
  };
  const std::string trees = print("--only random/ --trees 400");
  for (const std::string_view leaf : leaf_names()) {
    INFO(leaf);
    CHECK(std::regex_search(trees, std::regex("[{\"]" + std::string(leaf) + "\"?: ")));
  }
  for (const std::string word :
       {"union: [",         "intersection: [",  "difference: [", "aggregate: [",    "sum: [",
        "product: [",       "subtract: [",      "unify: ",       "complement: ",    "interior: ",
        "closure: ",        "boundary: ",       "regularize: ",  "simplify: ",      "mode: points",
        "simplify: points", "regularize: true", "each: true",    "dominance: left", "dominance: right",
        "dominance: equal", "dominance: 1",     "material: ",    "name: ",          "translate: ",
        "rotate: ",         "scale: ",          "mirror: ",      "linear: ",        "distance: ",
        "holes: ",          "sides: ",          "regions: ",     "matrix: "}) {
    INFO(word);
    CHECK(trees.find(word) != std::string::npos);
  }
  CHECK(print("--only random/1 --trees 2") == print("--only random/1 --trees 2"));
  CHECK(print("--only random/1 --trees 2") != print("--only random/1 --trees 2 --seed 2"));
}

TEST_CASE("the trees of the repository are found", "[same]") {
  const Workshop w;
  const Outcome o = w.shell(kCommand + "--print --trees 0 >.out 2>.err");
  INFO(o.err);
  CHECK(o.status == 0);
  const std::filesystem::path sources = CNRG_SOURCES;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sources / "papers")) {
    if (entry.path().extension() != ".yaml") continue;
    CHECK_THAT(o.out, Contains("# " + entry.path().lexically_relative(sources).string() + "\n"));
  }
  CHECK_THAT(o.out, Contains("# csg/examples/evaluate_tree.cpp:"));
  CHECK_THAT(o.out, Contains("# tests/evaluate/"));
  CHECK_THAT(o.out, Contains("# tests/tree/errors_test.cpp:"));
}

}  // namespace
}  // namespace cnrg
