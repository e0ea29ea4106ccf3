// What the program reads: regular files, where they may be, and how large.
#include <algorithm>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const char* const kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string tree_with(const std::string& leaf) { return "cnrg: 1\nnodes:\n  a: {" + leaf + "}\nresult: a\n"; }

/// The column of the file's name in `tree_with(leaf)`.
std::string place_of_file(const std::string& leaf) {
  const std::size_t key = leaf.find("file: ");
  return std::to_string(7 + (key == std::string::npos ? leaf.find(": ") + 2 : key + 6));
}

TEST_CASE("only regular files are read", "[app][inputs]") {
  const Workshop w;
  w.shell("mkfifo pipe.off pipe.json; mkdir folder.off; ln -s /dev/zero zero.off; ln -s /dev/zero zero.asc");
  const auto fails = [&](const std::string& leaf, const std::string& what) {
    w.write("t.yaml", tree_with(leaf));
    const Outcome o = w.run("check t.yaml");
    INFO(leaf);
    CHECK(o.status == 3);
    CHECK_THAT(o.err, StartsWith("t.yaml:3:" + place_of_file(leaf) + ": error: ") && Contains(what));
    CHECK(errors_in(o.err) == 1);
  };
  fails("mesh: {file: pipe.off}", "'pipe.off' cannot be read: it is a pipe, give a regular file");
  fails("mesh: {file: folder.off}", "it is a directory");
  fails("mesh: {file: zero.off}", "it is a device");
  fails("heightfield: {file: zero.asc}", "it is a device");
  fails("cnrg: pipe.json", "it is a pipe");
  fails("cnrg: /dev/zero", "it is a device");
  fails("mesh: {file: none.off}", "there is no file 'none.off': check the path");
  w.write("t.yaml", tree_with("points: [[0, 0, 0]]"));
  for (const std::string tree : {"/dev/zero", "pipe.off", "folder.off", "none.yaml"}) {
    const Outcome o = w.run("eval " + tree);
    INFO(o.err);
    CHECK(o.status == 3);
    CHECK_THAT(o.err, StartsWith(tree + ":1:1: error: ") && Contains(tree));
    CHECK(errors_in(o.err) == 1);
  }
}

TEST_CASE("a number of very many digits is refused early, wherever it stands", "[app][inputs]") {
  const Workshop w;
  const std::string digits(3'000'000, '7');
  w.write("t.yaml", tree_with("points: [[0, 0, " + digits + "]]"));
  Outcome o = w.run("check t.yaml");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, StartsWith("t.yaml:3:23: error: ") && Contains("has 3,000,000 characters"));
  CHECK(o.err.size() < 300);
  w.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 " + digits + " 0\n3 0 1 2\n");
  for (const std::string coordinates : {"double", "decimal"}) {
    w.write("t.yaml", tree_with("mesh: {file: a.off, coordinates: " + coordinates + "}"));
    o = w.run("check t.yaml");
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("a.off:5:1: error: '7777") && Contains("has 3,000,000 characters"));
  }
  // A tree that is too large as a whole; the file has no content on the disk.
  o = w.shell("truncate -s 100000001 large.yaml && ulimit -v 4000000 && '" CNRG_PROGRAM
              "' check large.yaml 2>.err");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("this file has 100,000,001 bytes, and at most 100,000,000 are read"));
}

TEST_CASE("a file larger than the memory of the machine is refused before it is read", "[app][inputs]") {
  const Workshop w;
  for (const std::string leaf :
       {"mesh: {file: a.stl}", "mesh: {file: a.off}", "mesh: {file: a.obj}", "mesh: {file: a.ply}", "cnrg: a.json",
        "heightfield: {file: a.asc}", "step: {file: a.step}", "brep: {file: a.brep}"}) {
    w.write("t.yaml", tree_with(leaf));
    const std::string file = leaf.substr(leaf.find("a."), leaf.find_last_not_of('}') + 1 - leaf.find("a."));
    // It has no content on the disk.
    const Outcome o = w.shell("truncate -s 8T " + file + " && '" CNRG_PROGRAM "' check t.yaml 2>.err");
    if (o.err.find("without OpenCASCADE") != std::string::npos) continue;
    CHECK(o.status == 3);
    CHECK_THAT(o.err, StartsWith("t.yaml:3:" + place_of_file(leaf) + ": error: '" + file +
                                 "' cannot be read: it has 8,796,093,022,208 bytes, more than the memory of this "
                                 "machine; give a smaller file\n"));
  }
}

TEST_CASE("YAML that explodes is refused", "[app][inputs]") {
  const Workshop w;
  std::string laughs = "cnrg: 1\nnodes:\n  a: {points: &a0 [[0, 0, 0], [1, 0, 0]]}\n";
  for (int i = 1; i < 30; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    laughs += "  n" + std::to_string(i) + ": {prism: {base: [], vector: [0, 0, 1], holes: &a" + std::to_string(i) +
              " [" + last + ", " + last + ", " + last + "]}}\n";
  }
  w.write("laughs.yaml", laughs + "result: n29\n");
  w.write("deep.yaml", "cnrg: 1\nnodes: " + std::string(200'000, '[') + "\n");
  w.write("maps.yaml", [] {
    std::string text = "cnrg: 1\nnodes: ";
    for (int i = 0; i < 100'000; ++i) text += "{a: ";
    return text + "\n";
  }());
  for (const char* name : {"laughs.yaml", "deep.yaml", "maps.yaml"}) {
    const Outcome o =
        w.shell(std::string("ulimit -v 2000000; '" CNRG_PROGRAM "' check ") + name + " >.out 2>.err");
    INFO(o.err);
    CHECK(o.status == 2);
    CHECK(errors_in(o.err) == (name == std::string("laughs.yaml") ? 50 : 1));  // each node has a fault
  }
}

TEST_CASE("--inside refuses every file outside of the folder", "[app][inputs]") {
  const Workshop w;
  w.shell(
      "mkdir -p in/deep out in2; ln -s ../out/o.off in/link.off; ln -s ../out in/linked; ln -s deep/i.off "
      "in/good.off; "
      "ln -s ../none.off in/dangling.off; ln -s in folder");
  for (const std::string name : {"out/o.off", "in/deep/i.off", "in2/o.off"}) w.write(name, kOff);
  w.write("out/o.asc", "x");
  const std::string absolute = w.path("out/o.off").string();
  const auto run = [&](const std::string& leaf, const std::string& command = "check",
                       const std::string& rest = "") {
    w.write("in/t.yaml", tree_with(leaf));
    return w.run(command + " in/t.yaml --inside folder" + rest);
  };
  for (const std::string leaf :
       {"mesh: {file: ../out/o.off}", "mesh: {file: deep/../../out/o.off}", "mesh: {file: link.off}",
        "mesh: {file: linked/o.off}", "mesh: {file: dangling.off}", "mesh: {file: ../in2/o.off}",
        "mesh: {file: ../out/none.off}", "mesh: {file: /dev/zero.off}", "heightfield: {file: ../out/o.asc}",
        "cnrg: ../out/o.json", "cnrg: /etc/passwd", "step: {file: ../out/o.step}",
        "brep: {file: ../out/o.brep}"}) {
    const Outcome o = run(leaf);
    INFO(leaf << "\n" << o.err);
    if (o.err.find("without OpenCASCADE") != std::string::npos) continue;
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("in/t.yaml:3:" + place_of_file(leaf) + ": error: ") &&
                          Contains("is no file inside of the folder '" + w.path("in").string() + "'"));
    CHECK(errors_in(o.err) == 1);
  }
  CHECK(run("mesh: {file: " + absolute + "}").status == 2);
  for (const std::string leaf : {"mesh: {file: deep/i.off}", "mesh: {file: good.off}",
                                 "mesh: {file: ../in/deep/i.off}", "mesh: {file: ../folder/deep/i.off}"}) {
    const Outcome o = run(leaf);
    INFO(leaf << "\n" << o.err);
    CHECK(o.status == 0);
  }
  CHECK_THAT(run("mesh: {file: none.off}").err, Contains("is no file inside of the folder"));
  for (const std::string command : {"eval", "explain", "locate", "mesh", "check"}) {
    const std::string rest = command == "explain" ? " --point 0,0,0" : command == "mesh" ? " -o m.msh" : "";
    CHECK_THAT(run("mesh: {file: link.off}", command, rest).err, Contains("is no file inside of the folder"));
  }
  const Outcome none = w.run("check in/t.yaml --inside gone");
  CHECK(none.status == 3);
  CHECK(none.err == "cnrg: error: there is no folder 'gone'\n");
  CHECK(w.run("check in/t.yaml").status == 0);  // without the switch: what the user may read
}

TEST_CASE("a link that moves while the tree is read leads nowhere else", "[app][inputs]") {
  const Workshop w;
  w.shell("mkdir in out");
  w.write("in/i.off", kOff);
  w.write("out/o.off", "SECRET\n");
  w.write("in/t.yaml", tree_with("mesh: {file: x.off}"));
  const Outcome o = w.shell(
      "{ ( cd in; while [ ! -e ../stop ]; do ln -sfn i.off x.off; ln -sfn ../out/o.off x.off; done ) & sleep 0.1; "
      "for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do '" CNRG_PROGRAM
      "' check in/t.yaml --inside in >>.out 2>>.err; done; touch stop; wait; }");
  CHECK_THAT(o.err, !Contains("SECRET"));
  CHECK_THAT(o.err, Contains("is no file inside of the folder"));
}

}  // namespace
}  // namespace cnrg
