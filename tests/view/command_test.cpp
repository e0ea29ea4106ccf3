// `cnrg view` as people call it.

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/view/inflated.h"

using namespace cnrg;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {
const char* const kCube = "cnrg: 1\nnodes: {cube: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: cube\n";

/// The program in a folder of its own, with this beside it as the page to fill in; none if it is empty.
std::string program_with(const Workshop& w, const std::string& page) {
  fs::copy_file(CNRG_PROGRAM, w.path("cnrg"), fs::copy_options::overwrite_existing);
  if (!page.empty()) w.write("view.html", page);
  return "./cnrg view ";
}
/// Of a page made with the template below.
std::string data_of(const std::string& page) { return inflated(page.substr(page.rfind('|') + 1)); }
const char* const kPage = "<!--cnrg:title-->|<!--cnrg:stamp-->|<!--cnrg:data-->";
}  // namespace

TEST_CASE("view fills the page that is beside the program", "[view]") {
  const Workshop w;
  w.write("cube.yaml", kCube);
  const std::string view = program_with(w, kPage);
  Outcome o = w.shell(view + "cube.yaml -o out.html >.out 2>.err");
  CHECK(o.status == 0);
  CHECK(o.err == "");
  CHECK_THAT(o.out, Catch::StartsWith("out.html: 1 node, "));
  CHECK_THAT(data_of(w.read("out.html")), Catch::StartsWith("{\"format\":\"cnrg page\",\"version\":1,"));
  // Without a name it has that of the tree; the same tree gives the same bytes.
  o = w.shell(view + "cube.yaml --quiet --threads 1 >.out 2>.err");
  CHECK(o.status == 0);
  CHECK(o.out == "");
  CHECK(w.read("cube.html") == w.read("out.html"));
}

TEST_CASE("view says what is missing", "[view]") {
  const Workshop w;
  w.write("cube.yaml", kCube);
  const std::string view = program_with(w, "");
  const Outcome o = w.shell(view + "cube.yaml -o out.html >.out 2>.err");
  CHECK(o.status == 3);
  CHECK_THAT(o.err, Contains("`cnrg view` has no page to fill in") && Contains("kernel/install-deps"));
  CHECK(!fs::exists(w.path("out.html")));
}

TEST_CASE("view refuses other extensions and the tree itself", "[view]") {
  const Workshop w;
  w.write("cube.yaml", kCube);
  w.write("cube.html", kCube);
  const std::string view = program_with(w, kPage);
  Outcome o = w.shell(view + "cube.yaml -o out.png >.out 2>.err");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("out.png: `cnrg view` writes .html"));
  o = w.shell(view + "cube.html >.out 2>.err");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("would replace the tree itself"));
  CHECK(w.read("cube.html") == kCube);
  o = w.shell(view + "cube.yaml --node cub >.out 2>.err");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("did you mean `cube`"));
  o = w.shell(view + "cube.yaml -o none/out.html >.out 2>.err");
  CHECK(o.status == 3);
  CHECK_THAT(o.err, Contains("there is no folder 'none'"));
}

TEST_CASE("view shows the nodes asked for and what is below them", "[view]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  b: {box: {min: [2, 0, 0], max: [3, 1, "
          "1]}}\n"
          "  c: {closure: b}\n  d: {box: {min: [4, 0, 0], max: [5, 1, 1]}}\nresult: a\n");
  const std::string view = program_with(w, kPage);
  CHECK_THAT(w.shell(view + "t.yaml >.out 2>.err").out, Contains(": 4 nodes, "));
  CHECK_THAT(w.shell(view + "t.yaml --node c >.out 2>.err").out, Contains(": 2 nodes, "));
}

TEST_CASE("view opens the page by xdg-open, and says where there is none", "[view]") {
  const Workshop w;
  w.write("cube.yaml", kCube);
  const std::string view = program_with(w, kPage);
  w.write("xdg-open", "#!/bin/sh\necho noise\necho \"$1\" >opened\n");
  fs::permissions(w.path("xdg-open"), fs::perms::owner_all);
  Outcome o = w.shell("PATH=\"$PWD:$PATH\" " + view + "cube.yaml --open --quiet >.out 2>.err");
  CHECK(o.status == 0);
  CHECK(o.out == "");
  CHECK_THAT(w.read("opened"), Contains("/cube.html"));
  o = w.shell("PATH=/nowhere " + view + "cube.yaml --open --quiet >.out 2>.err");
  CHECK(o.status == 3);
  CHECK_THAT(o.err, Contains("cube.html: was written, but `xdg-open` is not there; open the file in a browser"));
}

TEST_CASE("a watched tree is written again, faults are told and outlived", "[view]") {
  const Workshop w;
  w.write("cube.yaml", kCube);
  const std::string view = program_with(w, kPage);
  const Outcome o = w.shell(
      "{ " + view +
      "cube.yaml --watch --quiet >.out 2>.err & watcher=$!\n"
      "wait_for() { for i in $(seq 100); do grep -q \"$1\" \"$2\" 2>/dev/null && return; sleep 0.1; done; }\n"
      "wait_for cube.yaml cube.html; cp cube.html first.html\n"
      "sleep 0.1; sed 's/result: cube/result: cub/' cube.yaml >next; cat next >cube.yaml\n"
      "wait_for 'did you mean' .err\n"
      "sleep 0.1; sed 's/cube*/cone/g' next >cube.yaml\n"
      "for i in $(seq 100); do cmp -s cube.html first.html || break; sleep 0.1; done\n"
      "kill $watcher; }");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("notice: watched; end with Ctrl-C") && Contains("did you mean `cube`"));
  CHECK_THAT(data_of(w.read("cube.html")), Contains("\"cone\""));
}
