// Models whose faces are meant to coincide and differ by what doubles make of them: welded, they have the
// vertices, edges, faces and solids of OpenCASCADE's own fragments, which work with a tolerance throughout.
#include <BRepAlgoAPI_Common.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "tests/cad/models.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using namespace cad;
using Catch::Contains;
using Cells = std::array<std::size_t, 4>;

Cells cells_of(const TopoDS_Shape& shape) {
  Cells cells;
  constexpr TopAbs_ShapeEnum kinds[] = {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID};
  for (std::size_t k = 0; k < 4; ++k) {
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(shape, kinds[k], found);
    cells[k] = static_cast<std::size_t>(found.Extent());
  }
  return cells;
}

TopoDS_Shape turned(const TopoDS_Shape& shape, double angle) {
  gp_Trsf by;
  by.SetRotation(gp_Ax1({0.3, 0.2, 0.1}, {1, 2, 3}), angle);
  return shape.Moved(TopLoc_Location(by));
}

/// A model in a file that goes afterwards.
class File {
 public:
  explicit File(const TopoDS_Shape& shape) {
    std::string pattern = (std::filesystem::temp_directory_path() / "cnrg_cad_weld_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write_step(shape, folder_ + "/part.step");
  }
  ~File() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  Evaluation evaluate(const std::string& tree) const {
    EvaluateOptions options;
    options.validate = true;
    return cnrg::evaluate(parse_tree("cnrg: 1\n" + tree + "\n", folder_ + "/t.yaml"), options);
  }
  Evaluation leaf(const std::string& options) const {
    return evaluate("nodes: {part: {step: {file: part.step" + options + "}}}\nresult: part");
  }

 private:
  std::string folder_;
};

TEST_CASE("solids that are turned in doubles have the walls of OpenCASCADE's fragments", "[weld]") {
  const char* const seeds = std::getenv("CNRG_SEEDS");
  const std::uint64_t count = seeds != nullptr ? std::strtoull(seeds, nullptr, 10) : 10;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    std::vector<TopoDS_Shape> boxes;
    for (int i = 0; i < 5; ++i) {
      const double x = below(4), y = below(4), z = below(4);
      const double a = 1 + below(3), b = 1 + below(3), c = 1 + below(3);
      boxes.push_back(turned(box({x * 0.7, y * 0.7, z * 0.7}, {(x + a) * 0.7, (y + b) * 0.7, (z + c) * 0.7}),
                             0.1 + 0.3 * static_cast<double>(seed)));
    }
    const Evaluation welded = File(compound(boxes)).leaf(", fill: winding, weld: 1e-6");
    CHECK(welded.rows[0].cells == cells_of(glued(boxes)));
  }
}

TEST_CASE("solids of one file that are leaves of their own are welded by the tree", "[weld]") {
  const TopoDS_Shape floor = box({-2, -2, -1}, {2, 2, 0});
  const TopoDS_Shape pillar = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 1e-9}, {0, 0, 1}), 1, 1).Shape();
  const File file(compound({turned(floor, 0.4), turned(pillar, 0.4)}));
  const std::string leaves =
      "nodes:\n  floor: {step: {file: part.step, solids: [1]}}\n"
      "  pillar: {step: {file: part.step, solids: [2]}}\n"
      "  foot: {intersection: [floor, pillar]}\nresult: foot";
  CHECK(file.evaluate(leaves).rows.back().cells == Cells{0, 0, 0, 0});
  const Evaluation welded = file.evaluate("weld: 1e-7\n" + leaves);
  CHECK(welded.rows.back().cells == Cells{1, 1, 1, 0});
  REQUIRE(welded.diagnostics.size() == 1);
  CHECK_THAT(welded.diagnostics[0].message,
             Contains("weld 0.0000001: moved ") && Contains("1 plane and 0 points"));
}

TEST_CASE("a bolt in its hole has one face with it where their facets are the same", "[weld]") {
  const TopoDS_Shape bolt = BRepPrimAPI_MakeCylinder(gp_Ax2({2, 2, 0.5}, {0, 0, 1}), 1, 1).Shape();
  const Evaluation evaluation = File(compound({bored_box(), bolt})).leaf(", weld: 1e-9");
  // Six sides of the box, the bore below, beside and above the bolt, its ends.
  CHECK(evaluation.rows[0].cells[2] == 11);
  CHECK(evaluation.rows[0].regions == 2);
}

TEST_CASE("radii that differ by 1e-12 are two cylinders, and a notice says so", "[weld]") {
  const auto bolt = [](double radius) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2({2, 2, 0.5}, {0, 0, 1}), radius, 1).Shape();
  };
  const File file(compound({bored_box(), bolt(1 - 1e-12)}));
  const Evaluation apart = file.leaf("");
  CHECK(apart.rows[0].cells[2] == 7 + 3);
  REQUIRE(apart.diagnostics.size() == 1);
  CHECK_THAT(apart.diagnostics[0].message, Contains("1 pair of faces of different solids nearly coincide") &&
                                               Contains("on cylinders that are 1.0e-12 apart") &&
                                               Contains("to join them, give `weld`"));
  CHECK(file.leaf(", weld: 1e-9").rows[0].cells[2] == 11);
  CHECK(File(compound({bored_box(), bolt(0.9)})).leaf("").diagnostics.empty());
  CHECK(File(compound({bored_box(), bolt(1)})).leaf("").diagnostics.empty());
}

TEST_CASE("a bolt that was turned and is off in its last digits fills its hole", "[weld]") {
  // Other corners of circles than in the block, another radius, another axis.
  const auto bolt = [](double off, double turn) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2({2 + off, 2, 0.5}, {off, 0, 1}, {std::cos(turn), std::sin(turn), 0}),
                                    1 + off, 1)
        .Shape();
  };
  for (const double off : {0.0, 1e-15, -1e-15, 3e-12}) {
    for (const double turn : {0.0, 0.3, 2.0}) {
      const File file(compound({bored_box(), bolt(off, turn)}));
      for (const char* options : {", weld: 1e-9", ", weld: 1e-9, segments: 24", ", weld: 1e-9, chord: 0.02",
                                  ", weld: 1e-9, fill: winding"}) {
        CAPTURE(off, turn, options);
        const Evaluation evaluation = file.leaf(options);
        CHECK(evaluation.rows[0].cells[2] == 11);
        CHECK(evaluation.rows[0].regions == 2);
      }
    }
  }
}

TEST_CASE("a lens that is off in its last digits fits its seat", "[weld]") {
  const auto ball = [](double off) {
    return BRepPrimAPI_MakeSphere(gp_Ax2({off, -off, off}, {0, 0, 1}, {1, 0, 0}), 2.5 + off).Shape();
  };
  const auto cells = [&](double off, const char* options) {
    const TopoDS_Shape half = box({-3, -3, 0}, {3, 3, 3}), block = box({-4, -4, 1}, {4, 4, 4});
    const TopoDS_Shape lens = BRepAlgoAPI_Common(ball(off), half).Shape();
    return File(compound({lens, cut(block, ball(0))})).leaf(options).rows[0].cells;
  };
  const Cells exact = cells(0, "");
  CHECK(cells(1e-15, ", weld: 1e-9") == exact);
  CHECK(cells(2e-12, ", weld: 1e-9, segments: 20") == exact);
  CHECK(cells(1e-8, ", weld: 1e-6, segments: 20") == exact);
}

TEST_CASE("a tree welds the round faces of a file with those of other leaves", "[weld]") {
  const auto tree = [](double off, const std::string& weld) {
    const TopoDS_Shape shaft =
        BRepPrimAPI_MakeCylinder(gp_Ax2({2 + off, 2, 0.5}, {off, 0, 1}, {0.6, 0.8, 0}), 1 - off, 1).Shape();
    const File file(compound({bored_box(), shaft}));
    char radius[40];
    std::snprintf(radius, sizeof radius, "%.17g", 1 + off);
    const std::string block = weld + "nodes:\n  block: {step: {file: part.step, solids: [1], segments: 20}}\n";
    const Evaluation two =
        file.evaluate(block + "  shaft: {step: {file: part.step, solids: [2], segments: 16}}\n" +
                      "  both: {union: [block, shaft], dominance: left}\nresult: both");
    const Evaluation own =
        file.evaluate(block + "  bolt: {cylinder: {from: [2, 2, 0], to: [2, 2, 3], radius: " + radius +
                      ", segments: 24}}\n  both: {union: [block, bolt], dominance: left}\nresult: both");
    std::size_t uncertain = 0;
    for (const Evaluation* e : {&two, &own}) {
      for (const Diagnostic& d : e->diagnostics)
        uncertain += d.message.find("these facets do not tell") != std::string::npos;
    }
    CHECK(uncertain == 0);
    return std::array{two.rows.back().cells, own.rows.back().cells};
  };
  const auto exact = tree(0, "");
  CHECK(exact[0][3] == 2);
  CHECK(exact[1][3] == 2);
  CHECK(tree(1e-12, "weld: 1e-9\n") == exact);
  CHECK(tree(-1e-12, "weld: 1e-9\n") == exact);
  CHECK(tree(1e-8, "weld: 1e-6\n") == exact);
  CHECK(tree(1e-12, "") != exact);
}

TEST_CASE("a solid as thin as the length is refused by the names of its faces", "[weld]") {
  CHECK_THROWS_WITH(File(box({0, 0, 0}, {1, 1, 1e-4})).leaf(", weld: 0.001"),
                    Contains("step: '") && Contains("weld: face ") && Contains("would vanish"));
}

}  // namespace
}  // namespace cnrg
