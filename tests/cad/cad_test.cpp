// STEP and BREP files as leaves: the cells of the complex are those of the CAD model, whose numbers are counted by
// hand here; volumes are exact where faces are planar.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <iterator>
#include <numbers>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "tests/cad/models.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using namespace cad;
using Catch::Contains;
using Catch::StartsWith;
using Cells = std::array<std::size_t, 4>;
constexpr double kPi = std::numbers::pi;

/// A folder with files of parts, where trees that use them are.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "cnrg_cad_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }
  std::string read(const std::string& name) const {
    std::ifstream stream(file(name));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// The row of the result; `nodes` are further lines of the tree, whose last node is the result.
  NodeRow row(const std::string& nodes, const std::string& result = "part") const {
    return evaluate(nodes, result).rows.back();
  }
  Evaluation evaluate(const std::string& nodes, const std::string& result = "part") const {
    EvaluateOptions options;
    options.validate = true;
    return cnrg::evaluate(parse_tree("cnrg: 1\nnodes:\n" + nodes + "\nresult: " + result, file("t.yaml")),
                          options);
  }

 private:
  std::filesystem::path folder_;
};

/// A BREP file of a compound in a compound, and so on.
std::string nested_compounds(int count) {
  std::string text = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\n";
  for (const char* const none :
       {"Locations", "Curve2ds", "Curves", "Polygon3D", "PolygonOnTriangulations", "Surfaces", "Triangulations"}) {
    text += none + std::string(" 0\n");
  }
  text += "\nTShapes " + std::to_string(count) + "\nCo\n\n1100000\n*\n\n";
  // A shape has the numbers of those before it, counted from the last.
  for (int last = count; last > 1; --last) text += "Co\n\n1100000\n+" + std::to_string(last) + " 0 *\n\n";
  return text + "\n+1 0 \n0\n";
}

/// A model in both formats.
class CadPart : public Folder {
 public:
  explicit CadPart(const TopoDS_Shape& shape) {
    write_brep(shape, file("part.brep"));
    write_step(shape, file("part.step"));
  }
  /// The row of a leaf, whose cells must be the same in both formats.
  NodeRow leaf(const std::string& options) const {
    const NodeRow brep = row("  part: {brep: {file: part.brep" + options + "}}");
    const NodeRow step = row("  part: {step: {file: part.step" + options + "}}");
    CHECK(brep.cells == step.cells);
    return step;
  }
};

TEST_CASE("a box with a bore has the faces, edges and vertices of the model", "[cad]") {
  const CadPart part(bored_box());
  const double exact = 32 - 2 * kPi;
  for (const double chord : {0.2, 0.01}) {
    const NodeRow row = part.leaf(", chord: " + std::to_string(chord));
    CHECK(row.cells == Cells{10, 14, 7, 1});
    // Facets are inside of the bore's cylinder: there is less hole.
    const double more = to_double(*row.volume()) - exact;
    CHECK(more > 0);
    CHECK(more <= chord * 2 * kPi * 2);
  }
  CHECK(part.leaf(", segments: 4, seams: true").cells == Cells{10, 15, 7, 1});
  CHECK(part.leaf("").cells == Cells{10, 14, 7, 1});
}

TEST_CASE("seams and poles are no cells unless they are asked for", "[cad]") {
  struct Case {
    TopoDS_Shape shape;
    Cells cells, with_seams;
    double volume, area;
  };
  const Case cases[] = {
      {BRepPrimAPI_MakeSphere(2).Shape(), {0, 0, 1, 1}, {2, 1, 1, 1}, 32 * kPi / 3, 16 * kPi},
      {BRepPrimAPI_MakeTorus(3, 1).Shape(), {0, 0, 1, 1}, {1, 2, 1, 1}, 6 * kPi * kPi, 12 * kPi * kPi},
      {BRepPrimAPI_MakeCylinder(1, 3).Shape(), {2, 2, 3, 1}, {2, 3, 3, 1}, 3 * kPi, 6 * kPi},
      {BRepPrimAPI_MakeCone(2, 0, 3).Shape(), {1, 1, 2, 1}, {2, 2, 2, 1}, 4 * kPi, 2 * kPi * std::sqrt(13.0)},
      {BRepPrimAPI_MakeCone(2, 1, 3).Shape(), {2, 2, 3, 1}, {2, 3, 3, 1}, 7 * kPi, 3 * kPi * std::sqrt(10.0)}};
  for (const Case& c : cases) {
    const CadPart part(c.shape);
    CHECK(part.leaf(", seams: true").cells == c.with_seams);
    std::vector<double> off;
    for (const double chord : {0.4, 0.01}) {
      const NodeRow row = part.leaf(", chord: " + std::to_string(chord));
      CHECK(row.cells == c.cells);
      off.push_back(std::abs(c.volume - to_double(*row.volume())));
      CHECK(off.back() <= chord * c.area);
    }
    CHECK(off[1] < off[0] / 3);
  }
}

TEST_CASE("solids that share a face, that touch, that have a cavity", "[cad]") {
  SECTION("shared") {
    const CadPart part(glued({box({0, 0, 0}, {1, 2, 3}), box({1, 0, 0}, {3, 2, 3})}));
    const NodeRow row = part.leaf("");
    CHECK(row.cells == Cells{12, 20, 11, 2});
    CHECK(*row.volume() == 18);
    CHECK(*part.leaf(", fill: winding").volume() == 18);
    CHECK(part.leaf(", fill: cells").cells == Cells{12, 20, 11, 2});
    CHECK(part.leaf(", fill: none").cells == Cells{12, 20, 11, 0});
  }
  SECTION("touching in a part of a face, which the file does not know") {
    const CadPart part(compound({box({0, 0, 0}, {1, 2, 3}), box({1, 0.5, 0.5}, {2, 1.5, 1})}));
    const NodeRow row = part.leaf("");
    CHECK(row.cells == Cells{16, 24, 12, 2});
    CHECK(*row.volume() == Rational(13, 2));
  }
  SECTION("a cavity") {
    const CadPart part(cut(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 3})));
    CHECK(part.leaf("").cells == Cells{16, 24, 12, 1});
    CHECK(*part.leaf("").volume() == 62);
    CHECK(*part.leaf(", fill: winding").volume() == 62);
    CHECK(*part.leaf(", fill: cells").volume() == 64);
  }
  SECTION("a solid in the cavity of another") {
    const TopoDS_Shape inner = box({1, 1, 1}, {2, 2, 3});
    const CadPart part(compound({cut(box({0, 0, 0}, {4, 4, 4}), inner), moved(inner, 0, 0, 0)}));
    const NodeRow row = part.leaf("");
    CHECK(row.regions == 2);
    CHECK(*row.volume() == 64);
  }
  SECTION("overlapping") {
    const CadPart part(compound({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}));
    CHECK_THROWS_WITH(part.row("  part: {brep: {file: part.brep}}"),
                      StartsWith(part.file("t.yaml") + ":3:10: error: solid 1, solid 2 of `part` (line 3): these "
                                                       "solids overlap; "));
    const NodeRow row = part.leaf(", fill: winding");
    CHECK(row.regions == 3);
    CHECK(*row.volume() == 15);
  }
}

TEST_CASE("shells, wires and vertices keep their dimension", "[cad]") {
  SECTION("an open shell") {
    const CadPart part(shell_of(box({0, 0, 0}, {1, 1, 1}), {5}));
    CHECK(part.leaf("").cells == Cells{8, 12, 5, 0});
    CHECK_THROWS_WITH(part.row("  part: {step: {file: part.step, fill: winding}}"),
                      Contains("t.yaml:3:10: error: step: ") &&
                          Contains("its faces together are not closed, along 4 "
                                   "segments, such as (") &&
                          Contains(" of face ") && Contains("fill: none"));
    CHECK_THROWS_WITH(part.row("  part: {brep: {file: part.brep, fill: solids}}"),
                      Contains("there are no solids"));
  }
  SECTION("a closed shell that is no solid") {
    const CadPart part(shell_of(box({0, 0, 0}, {1, 1, 1}), {}));
    CHECK(part.leaf("").cells == Cells{8, 12, 6, 0});
    CHECK(part.leaf(", fill: winding").cells == Cells{8, 12, 6, 1});
    CHECK(part.leaf(", fill: cells").cells == Cells{8, 12, 6, 1});
  }
  SECTION("a solid without a face") {
    const TopoDS_Shape whole = box({0, 0, 0}, {1, 1, 1});
    TopoDS_Solid solid;
    const BRep_Builder builder;
    builder.MakeSolid(solid);
    builder.Add(solid, shell_of(whole, {2}));
    const Folder folder;
    write_brep(solid, folder.file("part.brep"));
    CHECK_THROWS_WITH(folder.row("  part: {brep: {file: part.brep}}"),
                      Contains("solid 1 is not closed, along 4 segments") && Contains("sew its faces"));
    CHECK(folder.row("  part: {brep: {file: part.brep, fill: none}}").cells == Cells{8, 12, 5, 0});
  }
  SECTION("all dimensions in one file") {
    const TopoDS_Shape segment = BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 0), gp_Pnt(6, 1, 0)).Shape();
    const TopoDS_Shape circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({9, 0, 0}, {0, 0, 1}), 1)).Shape();
    const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(5, 5, 5)).Shape();
    const TopoDS_Shape shell = shell_of(box({0, 0, 3}, {1, 1, 4}), {0, 1, 2, 3, 4});
    const Folder folder;
    write_brep(compound({box({0, 0, 0}, {1, 1, 1}), segment, circle, vertex, shell}), folder.file("part.brep"));
    const NodeRow row = folder.row("  part: {brep: {file: part.brep, chord: 1/100}}");
    CHECK(row.cells == Cells{8 + 2 + 1 + 1 + 4, 12 + 1 + 1 + 4, 6 + 1, 1});
    CHECK(*row.volume() == 1);
  }
}

TEST_CASE("CAD leaves meet other leaves exactly", "[cad]") {
  const CadPart part(box({0, 0, 0}, {2, 2, 2}));
  const std::string nodes =
      "  part: {step: {file: part.step}}\n  other: {box: {min: [1, 1, 1], max: [3, 3, 3]}}\n"
      "  same: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n  m: ";
  CHECK(*part.row(nodes + "{union: [part, other]}", "m").volume() == 15);
  CHECK(*part.row(nodes + "{difference: [part, other]}", "m").volume() == 7);
  CHECK(*part.row(nodes + "{intersection: [part, other]}", "m").volume() == 1);
  CHECK(part.row(nodes + "{difference: [part, same]}", "m").regions == 0);
  CHECK(part.row(nodes + "{union: [part, same], regularize: true}", "m").cells == Cells{8, 12, 6, 1});
  CHECK(*part.row("  part: {brep: {file: part.brep}, scale: [1, 2, -3], translate: [1/3, 0, 0]}").volume() == 48);

  const CadPart bored(bored_box());
  const NodeRow sliced = bored.row(
      "  part: {step: {file: part.step, chord: 1/50}}\n"
      "  half: {box: {min: [-1, -1, -1], max: [5, 2, 3]}}\n"
      "  m: {intersection: [part, half]}",
      "m");
  CHECK(sliced.regions == 1);
}

TEST_CASE("every facet has the number of its face in the file", "[cad]") {
  const CadPart part(bored_box());
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(bored_box(), TopAbs_FACE, faces);
  CadShape shape;
  shape.format = CadShape::Format::brep;
  shape.file = part.file("part.brep");
  shape.tessellation.chord = Rational(1, 1000);
  Soup soup;
  prepare(Shape(shape))->add_to(soup, {});
  std::set<std::uint32_t> met;
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    const std::uint32_t number = soup.face(f).leaf_face;
    CHECK(soup.face(f).patch == number);
    met.insert(number);
    REQUIRE(number < static_cast<std::uint32_t>(faces.Extent()));
    for (const PointId p : soup.corners(f)) {
      if (!p.valid()) continue;
      const double* x = soup.xyz(p);
      BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(gp_Pnt(x[0], x[1], x[2])).Shape(),
                                          faces(static_cast<int>(number) + 1));
      CHECK(distance.Value() < 1e-9);
    }
  }
  CHECK(met.size() == static_cast<std::size_t>(faces.Extent()));
  std::set<std::uint32_t> edges;
  for (const Soup::Wire& wire : soup.wires()) edges.insert(wire.leaf_edge);
  CHECK(edges.size() == 14);

  Soup again;
  prepare(Shape(shape))->add_to(again, {});
  REQUIRE(again.point_count() == soup.point_count());
  for (const PointId p : IdRange<PointId>(soup.point_count())) {
    for (int k = 0; k < 3; ++k) CHECK(again.xyz(p)[k] == soup.xyz(p)[k]);
  }
}

TEST_CASE("facets of a CAD leaf know the parameters of their faces", "[cad]") {
  for (const TopoDS_Shape& shape :
       {bored_box(), BRepPrimAPI_MakeSphere(2).Shape(), BRepPrimAPI_MakeCone(2, 0, 3).Shape()}) {
    const Folder folder;
    write_brep(shape, folder.file("part.brep"));
    CadShape part;
    part.format = CadShape::Format::brep;
    part.file = folder.file("part.brep");
    const auto leaf = prepare(Shape(part));
    Soup soup;
    leaf->add_to(soup, {});
    std::filesystem::remove(part.file);  // it is not read again
    REQUIRE(leaf->parameters());
    const auto parameters = leaf->parameters()();
    REQUIRE(parameters->facet_count() == soup.face_count());
    REQUIRE(parameters->wire_count() == soup.wires().size());
    TopTools_IndexedMapOfShape faces, edges;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    std::size_t poles = 0;
    for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
      const int number = static_cast<int>(soup.face(f).patch);
      CHECK(parameters->patch_name(soup.face(f).patch) == "face " + std::to_string(number));
      const BRepAdaptor_Surface surface(TopoDS::Face(faces(number + 1)));
      const auto cells = parameters->cells(f.index());
      CHECK_FALSE(cells.empty());
      for (const auto& cell : cells) {
        if (cell.size() == 4) ++poles;
        for (const PatchCorner& corner : cell) {
          const gp_Pnt p = surface.Value(to_double(corner.at[0]), to_double(corner.at[1]));
          for (int k = 0; k < 3; ++k) CHECK(std::abs(p.Coord(k + 1) - to_double(corner.point[k])) < 1e-9);
        }
      }
    }
    CHECK((poles > 0) == (faces.Extent() < 7));
    for (std::size_t w = 0; w < soup.wires().size(); ++w) {
      const BRepAdaptor_Curve curve(TopoDS::Edge(edges(static_cast<int>(soup.wires()[w].leaf_edge) + 1)));
      const gp_Pnt p = curve.Value(to_double(parameters->wire(w).at[0]));
      const double* x = soup.xyz(soup.wires()[w].a);
      for (int k = 0; k < 3; ++k) CHECK(std::abs(p.Coord(k + 1) - x[k]) < 1e-9);
    }
  }
}

TEST_CASE("products of an assembly are regions of their names, each where it is", "[cad]") {
  const Folder folder;
  write_assembly({{"block", box({0, 0, 0}, {1, 1, 1})}, {"Schraube M8", box({0, 0, 2}, {1, 1, 5})}},
                 {{0, 10}, {20, 30, 40}}, folder.file("part.step"));
  const Evaluation e = folder.evaluate("  part: {step: {file: part.step}}");
  CHECK(*e.rows.back().volume() == 11);
  std::multiset<std::string> names;
  for (const RegionAttributes& region : e.kept[0].group().regions) names.insert(region.name);
  CHECK(names == std::multiset<std::string>{"Schraube M8", "Schraube M8", "Schraube M8", "block", "block"});
}

TEST_CASE("solids of a file by number or name", "[cad]") {
  const Folder folder;
  write_assembly({{"block", box({0, 0, 0}, {1, 1, 1})}, {"bolt", box({0, 0, 0}, {1, 1, 3})}}, {{0, 10}, {0.5}},
                 folder.file("part.step"));
  const auto row = [&](const std::string& solids) {
    return folder.row("  part: {step: {file: part.step, solids: " + solids + "}}");
  };
  CHECK(row("[block]").cells == Cells{16, 24, 12, 2});
  CHECK(*row("[block]").volume() == 2);
  CHECK(row("[bolt]").cells == Cells{8, 12, 6, 1});
  CHECK(*row("[bolt]").volume() == 3);
  CHECK(row("[1]").regions == 1);
  CHECK_THROWS_WITH(row("[nut]"), Contains("there is no solid `nut` in it; it has solid 1 `"));
  // The file's solids overlap; as operands they need not be parted.
  CHECK_THROWS_WITH(folder.row("  part: {step: {file: part.step}}"), Contains("`block`") && Contains("`bolt`"));
  const NodeRow both = folder.row(
      "  blocks: {step: {file: part.step, solids: [block]}}\n"
      "  bolt: {step: {file: part.step, solids: [bolt]}}\n"
      "  both: {union: [bolt, blocks], dominance: left}",
      "both");
  CHECK(both.regions == 3);
  CHECK(*both.volume() == Rational(9, 2));

  const CadPart glue(glued({box({0, 0, 0}, {1, 2, 3}), box({1, 0, 0}, {3, 2, 3})}));
  CHECK(glue.leaf(", solids: [2]").cells == Cells{8, 12, 6, 1});
  CHECK(*glue.leaf(", solids: [2]").volume() + *glue.leaf(", solids: [1]").volume() == 18);
}

TEST_CASE("coordinates are in the file's unit unless another one is asked for", "[cad]") {
  const Folder folder;
  const auto volume = [&](const std::string& unit) {
    return *folder.row("  part: {step: {file: part.step" + unit + "}}").volume();
  };
  write_step(box({0, 0, 0}, {1, 2, 0.5}), folder.file("part.step"));
  std::string text = folder.read("part.step");
  const std::string millimetre = "SI_UNIT(.MILLI.,.METRE.)";
  REQUIRE(text.find(millimetre) != std::string::npos);
  CHECK(volume("") == 1);
  CHECK(volume(", unit: mm") == 1);
  CHECK(to_double(volume(", unit: cm")) == Approx(1e-3));
  CHECK(volume(", unit: um") == 1000000000);
  folder.write("part.step", text.replace(text.find(millimetre), millimetre.size(), "SI_UNIT($,.METRE.)"));
  CHECK(volume("") == 1);
  CHECK(volume(", unit: m") == 1);
  CHECK(volume(", unit: mm") == 1000000000);
  CHECK(volume(", unit: cm") == 1000000);
  CHECK(to_double(volume(", unit: km")) == Approx(1e-9));
  CHECK(to_double(volume(", unit: in")) == Approx(std::pow(1 / 0.0254, 3)));
  CHECK(to_double(volume(", unit: ft")) == Approx(std::pow(1 / 0.3048, 3)));
  CHECK(volume("") == 1);  // nothing is left of the others
  for (const auto& [setting, unit] : {std::pair{"CM", "cm"}, {"INCH", "in"}, {"FT", "ft"}, {"KM", "km"}}) {
    INFO(setting);
    write_step(box({0, 0, 0}, {1, 2, 0.5}), folder.file("part.step"), setting);
    CHECK(volume("") == volume(std::string(", unit: ") + unit));
    CHECK(volume("") != volume(", unit: m"));
  }
  write_step(box({0, 0, 0}, {1, 2, 0.5}), folder.file("part.step"), "MI");
  CHECK_THROWS_WITH(volume(""), Contains("its unit of length is ") && Contains("unit: mm"));
}

TEST_CASE("what OpenCASCADE does to its process is one error", "[cad]") {
  const Folder folder;
  const auto tree = [&](const std::string& leaf) {
    return parse_tree("cnrg: 1\nnodes:\n  part: {" + leaf + "}\nresult: part\n", folder.file("t.yaml"));
  };
  // Found by fuzzing; fuzzers and this test share them.
  const auto corpus = [](const std::string& file) {
    return std::filesystem::absolute("tests/campaign/fuzz/corpus/" + file).string();
  };
  const std::string at = folder.file("t.yaml") + ":3:10: error: ";
  const std::string crash = corpus("step/crash"), endless = corpus("brep/endless");
  const auto crashed = [&](const std::string& format, const std::string& file) {
    return at + format + ": '" + file +
           "': OpenCASCADE crashed (signal 11): write the file again, or repair the part where it was made";
  };
#if OCC_VERSION_HEX < 0x070800
  CHECK_THROWS_WITH(check(tree("step: {file: " + crash + "}")), crashed("step", crash));
#else
  CHECK_NOTHROW(check(tree("step: {file: " + crash + "}")));
#endif
  CHECK_THROWS_WITH(check(tree("brep: {file: " + corpus("brep/infinite") + "}")),
                    Contains(at + "brep: '") &&
                        Contains("OpenCASCADE computes no finite numbers for its points: repair the part"));
  // Bounds of the shell are lower than those of the library, and stay.
  const auto checked = [&](const std::string& bound, const std::string& file) {
    folder.write("t.yaml", "cnrg: 1\nnodes:\n  part: {brep: {file: " + file + "}}\nresult: part\n");
    return WEXITSTATUS(std::system(("ulimit " + bound + "; '" CNRG_PROGRAM "' check '" + folder.file("t.yaml") +
                                    "' 2>'" + folder.file("err") + "'")
                                       .c_str()));
  };
  // Every version descends into compounds in compounds by recursion.
  const std::string deep = folder.file("deep.brep");
  folder.write("deep.brep", nested_compounds(10000));
  CHECK(checked("-Ss 512", deep) == 2);
  CHECK_THAT(folder.read("err"), Catch::StartsWith(crashed("brep", deep) + "\n"));
  CHECK(checked("-St 1", endless) == 2);
  CHECK_THAT(
      folder.read("err"),
      Catch::StartsWith(at + "brep: '" + endless +
                        "': OpenCASCADE did not end within 1 s of processor time: write the file again, or "
                        "repair the part where it was made, or give a larger `chord` or fewer `segments`\n"));
}

TEST_CASE("files that are none", "[cad]") {
  const CadPart part(bored_box());
  const auto tree = [&](const std::string& leaf) {
    return parse_tree("cnrg: 1\nnodes:\n  part: {" + leaf + "}\nresult: part\n", part.file("t.yaml"));
  };
  const std::string at = part.file("t.yaml") + ":3:10";
  const auto fails = [&](const std::string& leaf, const std::string& words) {
    INFO(leaf);
    CHECK_THROWS_AS(check(tree(leaf)), InputError);
    CHECK_THROWS_WITH(check(tree(leaf)), Contains(words) && Contains(at) && !Contains("\n"));
  };
  for (const std::string leaf : {"step: {file: none.step}", "brep: {file: none.brep}", "step: {file: .}"})
    CHECK_THROWS_AS(check(tree(leaf)), FileError);
  CHECK_THROWS_WITH(check(tree("step: {file: none.step}")),
                    Contains(part.file("t.yaml") + ":3:23: error: there is no file '" + part.file("none.step")));
  part.write("empty.step", "");
  fails("step: {file: empty.step}", "empty.step:1:1: error: the file is empty: write the part again");
  fails("brep: {file: empty.step}", "empty.step:1:1: error: the file is empty: write the part again");
  fails("step: {file: part.brep}", "part.brep:1:1: error: this is no STEP file");
  fails("brep: {file: part.step}", "part.step:1:1: error: this is no BREP file");
  const std::string step = part.read("part.step"), brep = part.read("part.brep");
  for (const double portion : {0.02, 0.3, 0.6, 0.9}) {
    INFO(portion);
    const auto start = [portion](const std::string& text) {
      return text.substr(0, static_cast<std::size_t>(portion * static_cast<double>(text.size())));
    };
    part.write("cut.step", start(step));
    fails("step: {file: cut.step}", "cut.step");
    part.write("cut.brep", start(brep));
    fails("brep: {file: cut.brep}", "cut.brep");
  }
  part.write("bare.step", step.substr(0, step.find("DATA;")) + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  fails("step: {file: bare.step}", "there are no shapes in it");
  fails("step: {file: part.step, chord: 1/1000000000000}", "chord is below 1e-7");
}

TEST_CASE("OpenCASCADE says nothing on its own", "[cad]") {
  const CadPart part(bored_box());
  part.write("t.yaml", "cnrg: 1\nnodes:\n  part: {step: {file: part.step}}\nresult: part\n");
  part.write("u.yaml", "cnrg: 1\nnodes:\n  part: {step: {file: cut.step}}\nresult: part\n");
  const std::string step = part.read("part.step");
  part.write("cut.step", step.substr(0, step.size() / 2));
  const auto said = [&](const std::string& arguments) {
    const std::string command = "'" CNRG_PROGRAM "' " + arguments + " >'" + part.file("said") + "' 2>&1";
    const int status = std::system(command.c_str());
    return std::pair(status, part.read("said"));
  };
  CHECK(said("eval --quiet '" + part.file("t.yaml") + "'") == std::pair(0, std::string()));
  const auto [status, words] = said("eval --quiet '" + part.file("u.yaml") + "'");
  CHECK(status != 0);
  CHECK_THAT(words, StartsWith(part.file("cut.step") + ":1:1: error: "));
  CHECK(std::count(words.begin(), words.end(), '\n') == 1);
}

}  // namespace
}  // namespace cnrg
