// A tree with a CAD leaf where the library is built without OpenCASCADE: this program has the reader of such a
// build in the place of the library's own.

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/imports/cad_model.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

TEST_CASE("without OpenCASCADE a CAD leaf is one error that names the option", "[cad]") {
  CHECK(cad_library().empty());
  for (const std::string kind : {"step", "brep"}) {
    const Tree tree = parse_tree(
        "cnrg: 1\nnodes:\n  part: {" + kind + ": {file: part." + kind + "}}\nresult: part\n", "folder/model.yaml");
    for (const bool all : {false, true}) {
      CHECK_THROWS_WITH(
          all ? static_cast<void>(evaluate(tree)) : static_cast<void>(check(tree)),
          "folder/model.yaml:3:10: error: " + kind +
              ": this cnrg is built without OpenCASCADE, which reads 'folder/part." + kind +
              "': install libocct-data-exchange-dev and build cnrg with -DCNRG_OPENCASCADE=ON, or give "
              "the part as a mesh file");
    }
  }
}

TEST_CASE("the form of a CAD leaf is checked without OpenCASCADE, too", "[cad]") {
  const auto read = [](const std::string& leaf) {
    return parse_tree("cnrg: 1\nnodes:\n  part: {" + leaf + "}\nresult: part\n", "model.yaml");
  };
  CHECK_THROWS_WITH(read("step: {file: a.step, chord: 1, segments: 8}"),
                    Catch::StartsWith("model.yaml:3:41: error: this leaf has `chord` and `segments`"));
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

TEST_CASE("without OpenCASCADE a CAD file is refused before any work", "[cad]") {
  for (const std::string name : {"model.step", "model.stp", "model.brep"}) {
    CHECK_THROWS_WITH(check_file_name(name),
                      name +
                          ": this cnrg is built without OpenCASCADE, which writes CAD models: install "
                          "libocct-data-exchange-dev and build cnrg with -DCNRG_OPENCASCADE=ON, or write .msh or "
                          ".json");
  }
}

}  // namespace
}  // namespace cnrg
