// Where plug-ins are missing: this program is made without a place to look for them.
#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/formats/result_file.h"
#include "csg/picture/paint.h"
#include "csg/text/plugin.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::string fault_of(const Plugin& plugin) {
  return std::string("the plug-in for ") + plugin.library + " cannot be opened (cnrg_" + plugin.name +
         ".so: cannot open shared object file: No such file or directory): install or build cnrg again, with it";
}

TEST_CASE("a plug-in that is missing says what to install, and why it is not there", "[plugins]") {
  for (const Plugin* plugin : kPlugins) CHECK(plugin_fault(*plugin) == fault_of(*plugin));
}

TEST_CASE("without OpenCASCADE a CAD leaf is one error", "[plugins]") {
  for (const std::string kind : {"step", "brep"}) {
    const Tree tree = parse_tree(
        "cnrg: 1\nnodes:\n  part: {" + kind + ": {file: part." + kind + "}}\nresult: part\n", "folder/model.yaml");
    for (const bool all : {false, true}) {
      CHECK_THROWS_WITH(all ? static_cast<void>(evaluate(tree)) : static_cast<void>(check(tree)),
                        "folder/model.yaml:3:10: error: " + kind + ": 'folder/part." + kind +
                            "': " + fault_of(kCadPlugin) + ", or give the part as a mesh file");
    }
  }
}

TEST_CASE("the form of a CAD leaf is checked without OpenCASCADE, too", "[plugins]") {
  const auto read = [](const std::string& leaf) {
    return parse_tree("cnrg: 1\nnodes:\n  part: {" + leaf + "}\nresult: part\n", "model.yaml");
  };
  CHECK_THROWS_WITH(read("step: {file: a.step, chord: 1, segments: 8}"),
                    Catch::Equals("model.yaml:3:41: error: step has `chord` and `segments`; remove one of them"));
  CHECK_THROWS_WITH(read("step: {file: a.step, chord: 0}"), Catch::Contains("must be a positive length"));
  CHECK_THROWS_WITH(read("step: {file: a.step, fill: parity}"),
                    Catch::Contains("model.yaml:3:37: error: ") &&
                        Catch::Contains("must be one of solids, winding, cells, none"));
  CHECK_THROWS_WITH(read("step: {file: a.step, unit: mile}"), Catch::Contains("one of um, mm, cm, m, km, in, ft"));
  CHECK_THROWS_WITH(read("brep: {file: a.brep, unit: mm}"), Catch::Contains("unit"));
  CHECK_THROWS_WITH(read("brep: {chord: 1}"), Catch::Contains("file"));
  const Tree tree = read("brep: {file: a.brep, chord: 1/8, fill: solids, seams: true}");
  const auto& shape = std::get<CadShape>(*tree.nodes[tree.result].shape);
  CHECK(shape.format == CadShape::Format::brep);
  CHECK(*shape.tessellation.chord == Rational(1, 8));
  CHECK(shape.fill == Fill::solids);
  CHECK(shape.seams);
}

TEST_CASE("a file that a missing plug-in writes is refused before any work", "[plugins]") {
  for (const std::string name : {"model.step", "model.stp", "model.brep"})
    CHECK_THROWS_WITH(check_file_name(name), name + ": " + fault_of(kCadPlugin) + ", or write .msh or .json");
  for (const std::string name : {"model.h5m", "model.med"}) {
    const std::string words = name + ": " + fault_of(kHdf5Plugin) + ", or write .msh or .vtu";
    CHECK_THROWS_WITH(check_file_name(name), words);
    CHECK_THROWS_WITH(check_mesh_file_name(name), words);
  }
  CHECK_NOTHROW(check_file_name("model.vtu"));
  CHECK_THROWS_WITH(picture_bytes("model.svg", {Panel{}}, {}), fault_of(kPaperPlugin));
}

TEST_CASE("without TetGen our own tetrahedra stand in, and it is said", "[plugins]") {
  const Tree tree =
      parse_tree("cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 2, 3]}}\nresult: a\n", "a.yaml");
  const Result result = evaluate(tree).result("a");
  const TetrahedralMesh mesh = tetrahedra(result, {});
  CHECK_FALSE(mesh.mesh.tetrahedra.empty());
  CHECK(mesh.notice == fault_of(kTetgenPlugin) + "; these are constrained tetrahedra, improved");
  TetrahedraOptions kept;
  kept.keep_boundary = true;
  CHECK(tetrahedra(result, kept).mesh.points.size() == 8);  // no point on the boundary is needed here
}

}  // namespace
}  // namespace cnrg
