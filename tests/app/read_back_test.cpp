// Files of ours read back as meshes: volumes of regions stay, but for what 32-bit numbers lose.
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

const char* const kModel = R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 2, 3]}}
  b: {tetrahedron: [[5, 0, 0], [7, 0, 0], [5, 3, 0], [5, 0, 1/2]]}
  u: {aggregate: [{unify: a}, {unify: b}]}
  g: {union: [a, b]}
  wall: {union: [a, {box: {min: [1, 0, 0], max: [2, 2, 3]}}], dominance: left}
result: g
)";

TEST_CASE(".msh, .glb and .3mf of solids are read back as trees of one leaf", "[app][inputs]") {
  const Workshop w;
  w.write("t.yaml", kModel);
  REQUIRE(w.run("eval t.yaml -o t.msh -o t.glb -o t.3mf -o t.vtu --quiet").status == 0);
  REQUIRE(w.run("mesh t.yaml -o filled.msh --max-volume 0.5 --quiet").status == 0);
  for (const std::string file : {"t.msh", "t.glb", "t.3mf", "t.vtu", "filled.msh"}) {
    const Outcome o = w.run("eval " + file);
    INFO(file << "\n" << o.err << o.out);
    REQUIRE(o.status == 0);
    CHECK(o.err.empty());
    const auto words = row(o.out, file.substr(0, file.find('.')));
    REQUIRE(words.size() >= 10);
    CHECK(words[7] == "2");
    CHECK(words[9] == "6.5");  // of the tetrahedra up to the rounding of points on a slanted face
    CHECK((words.size() == 10 || file == "filled.msh"));
  }
  // A wall between regions: all cavities are regions.
  REQUIRE(w.run("eval t.yaml --node wall -o w.msh --quiet").status == 0);
  w.write("w.yaml", "cnrg: 1\nnodes: {w: {mesh: {file: w.msh, fill: cells}}}\nresult: w\n");
  const Outcome cells = w.run("eval w.yaml");
  INFO(cells.err);
  const auto words = row(cells.out, "w");
  REQUIRE(words.size() == 10);
  CHECK(words[7] == "2");
  CHECK(words.back() == "12");
}

}  // namespace
}  // namespace cnrg
