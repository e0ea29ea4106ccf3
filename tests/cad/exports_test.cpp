// Results written as CAD models and read back by OpenCASCADE: valid, with the cells of the result on its surfaces.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Surface.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gp_Pln.hxx>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/result/result_data.h"
#include "tests/cad/models.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using namespace cad;
using Catch::Contains;
constexpr double kHalfTurn = std::numbers::pi;

/// A tree in a folder that goes afterwards.
class Scene {
 public:
  explicit Scene(const std::string& nodes, AskedProof proof = AskedProof::none) {
    std::string pattern = (std::filesystem::temp_directory_path() / "cnrg_exports_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    std::ofstream(file("t.yaml")) << "cnrg: 1\n" << nodes << "\nresult: model\n";
    EvaluateOptions options;
    options.proof = proof;
    evaluation_ = std::make_unique<Evaluation>(evaluate(read_tree(file("t.yaml")), options));
  }
  ~Scene() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  Result result() const { return evaluation_->result("model"); }
  std::vector<std::string> write(const std::string& name) const {
    return cnrg::write(file(name), result()).notices;
  }
  TopoDS_Shape brep() {
    notices = write("m.brep");
    TopoDS_Shape shape;
    REQUIRE(BRepTools::Read(shape, file("m.brep").c_str(), BRep_Builder()));
    return shape;
  }
  TopoDS_Shape step() {
    notices = write("m.step");
    STEPControl_Reader reader;
    REQUIRE(reader.ReadFile(file("m.step").c_str()) == IFSelect_RetDone);
    reader.TransferRoots();
    return reader.OneShape();
  }
  std::vector<std::string> notices;

 private:
  std::string folder_;
  std::unique_ptr<Evaluation> evaluation_;
};

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return static_cast<std::size_t>(found.Extent());
}

bool valid(const TopoDS_Shape& shape) { return BRepCheck_Analyzer(shape).IsValid(); }

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.Mass();
}

std::vector<double> solid_volumes(const TopoDS_Shape& shape) {
  std::vector<double> result;
  for (TopExp_Explorer part(shape, TopAbs_SOLID); part.More(); part.Next())
    result.push_back(volume(part.Current()));
  std::sort(result.begin(), result.end());
  return result;
}

/// Names of the surfaces of faces.
std::multiset<std::string> surfaces(const TopoDS_Shape& shape) {
  std::multiset<std::string> result;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i)
    result.insert(BRep_Tool::Surface(TopoDS::Face(faces(i)))->DynamicType()->Name());
  return result;
}

TEST_CASE("round solids are one face on their surface", "[exports]") {
  const auto [leaf, kind, exact] = GENERATE(
      std::tuple("sphere: {center: [1, 2, 3], radius: 2, segments: 12}", "Geom_SphericalSurface",
                 32 * kHalfTurn / 3),
      std::tuple("torus: {center: [1, 0, 0], axis: [1, 1, 0], radius: 3, tube: 1}", "Geom_ToroidalSurface",
                 6 * kHalfTurn * kHalfTurn),
      std::tuple("cylinder: {from: [0, 0, 0], to: [1, 2, 2], radius: 1, segments: 7}", "Geom_CylindricalSurface",
                 3 * kHalfTurn),
      std::tuple("cone: {from: [0, 0, 0], to: [0, 0, 3], radius: 1, segments: 9}", "Geom_ConicalSurface",
                 kHalfTurn),
      std::tuple("cone: {from: [0, 0, 0], to: [0, 0, 3], radius: 1, top: 2, segments: 9}", "Geom_ConicalSurface",
                 7 * kHalfTurn),
      std::tuple("revolve: {profile: [[1, 0], [2, 0], {bezier: [[3, 1]]}, [2, 2], [1, 2]], segments: 12}",
                 "Geom_SurfaceOfRevolution", 0.0),
      std::tuple("extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[3, 1, 0]]}, [2, 2, 0], [0, 2, 0]], vector: "
                 "[0, 0, 3]}",
                 "Geom_SurfaceOfLinearExtrusion", 3 * (4 + 2.0 / 3)),
      std::tuple("extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[3, 1, 0]]}, [2, 2, 0], [0, 2, 0]], vector: "
                 "[0, 0, 3], "
                 "scale: 1/2}",
                 "Geom_BSplineSurface", (4 + 2.0 / 3) * 7 / 4),
      std::tuple("sphere: {center: [1, 2, 3], radius: 2, segments: 12}, scale: [1, 2, 3]", "Geom_BSplineSurface",
                 64 * kHalfTurn),
      std::tuple("cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 8}, scale: [1, 2, 1]",
                 "Geom_BSplineSurface", 4 * kHalfTurn),
      std::tuple("sphere: {center: [1, 2, 3], radius: 2, segments: 12}, scale: [-2, 2, 2]",
                 "Geom_SphericalSurface", 256 * kHalfTurn / 3),
      std::tuple("torus: {center: [1, 0, 0], axis: [1, 1, 0], radius: 3, tube: 1}, mirror: {normal: [1, 0, 0]}",
                 "Geom_ToroidalSurface", 6 * kHalfTurn * kHalfTurn));
  CAPTURE(leaf);
  Scene scene("nodes: {model: {" + std::string(leaf) + "}}");
  for (const bool step : {false, true}) {
    CAPTURE(step);
    const TopoDS_Shape shape = step ? scene.step() : scene.brep();
    CHECK(valid(shape));
    CHECK(count(shape, TopAbs_FACE) == scene.result().cells().faces.size());
    CHECK(surfaces(shape).count(kind) == 1);
    REQUIRE(solid_volumes(shape).size() == 1);
    if (exact > 0) CHECK(solid_volumes(shape)[0] == Approx(exact).epsilon(1e-6));
    for (const std::string& notice : scene.notices) CHECK_THAT(notice, !Contains("facet"));
  }
}

TEST_CASE("a seam takes a vertex and an edge, all else is as in the result", "[exports]") {
  Scene scene(
      "nodes:\n  block: {box: {min: [0, 0, 0], max: [4, 4, 2]}}\n"
      "  bore: {cylinder: {from: [2, 2, 0], to: [2, 2, 2], radius: 1, segments: 16}}\n"
      "  model: {difference: [block, bore]}");
  const TopoDS_Shape shape = scene.brep();
  CHECK(valid(shape));
  CHECK(count(shape, TopAbs_FACE) == 7);
  CHECK(count(shape, TopAbs_EDGE) == 14 + 1);
  CHECK(count(shape, TopAbs_VERTEX) == 8 + 2);
  CHECK(volume(shape) == Approx(32 - 2 * kHalfTurn).epsilon(1e-12));
}

TEST_CASE("regions share the faces between them, and a wall has two solids", "[exports]") {
  Scene scene(
      "nodes:\n  a: {sphere: {center: [0, 0, 0], radius: 2, segments: 24}}\n"
      "  b: {box: {min: [0, -3, -3], max: [3, 3, 3]}}\n"
      "  model: {union: [a, b], dominance: left}");
  const TopoDS_Shape shape = scene.brep();
  CHECK(valid(shape));
  CHECK(count(shape, TopAbs_SOLID) == 2);
  CHECK(count(shape, TopAbs_FACE) == scene.result().cells().faces.size());
  TopTools_IndexedDataMapOfShapeListOfShape solids;
  TopExp::MapShapesAndAncestors(shape, TopAbs_FACE, TopAbs_SOLID, solids);
  int walls = 0;
  for (int i = 1; i <= solids.Extent(); ++i) walls += solids(i).Extent() == 2;
  CHECK(walls == 1);
  const std::vector<double> found = solid_volumes(shape);
  CHECK(found[0] == Approx(32 * kHalfTurn / 3).epsilon(1e-9));
  CHECK(found[1] == Approx(108 - 16 * kHalfTurn / 3).epsilon(1e-9));
}

/// The volume of the tetrahedra that Gmsh makes of a CAD model.
double meshed_by_gmsh(const std::string& file) {
  const std::string run = "gmsh -3 -format msh2 -clmax 0.4 '" + file + "' -o '" + file + ".msh' >/dev/null 2>&1";
  REQUIRE(std::system(run.c_str()) == 0);
  std::ifstream mesh(file + ".msh");
  std::string line;
  std::size_t n = 0;
  while (line != "$Nodes") REQUIRE(std::getline(mesh, line));
  mesh >> n;
  std::map<std::size_t, std::array<double, 3>> points;
  for (std::size_t i = 0, number = 0; i < n; ++i) {
    mesh >> number;
    for (double& x : points[number]) mesh >> x;
  }
  while (line != "$Elements") REQUIRE(std::getline(mesh, line));
  mesh >> n;
  double six = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    std::getline(mesh, line);
    std::istringstream fields(line);
    std::vector<std::size_t> all;
    for (std::size_t x = 0; fields >> x;) all.push_back(x);
    if (all.size() < 4 || all[1] != 4) continue;  // number, kind (4: a tetrahedron), tags, points
    std::array<std::array<double, 3>, 3> e;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t d = 0; d < 3; ++d)
        e[k][d] = points.at(all[all.size() - 3 + k])[d] - points.at(all[all.size() - 4])[d];
    }
    six += std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                    e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
  }
  return six / 6;
}

TEST_CASE("Gmsh meshes the files", "[exports]") {
  if (std::system("command -v gmsh >/dev/null 2>&1") != 0) NOT_RUN("gmsh is not installed (Debian: gmsh)");
  // A bored ball with a ring around it, and a box that it goes into.
  const Scene scene(
      "nodes:\n  ball: {sphere: {center: [0, 0, 0], radius: 2}}\n"
      "  bore: {cylinder: {from: [0, 0, -3], to: [0, 0, 3], radius: 1}}\n"
      "  bead: {difference: [ball, bore]}\n  box: {box: {min: [0, -3, -3], max: [3, 3, 3]}}\n"
      "  model: {union: [bead, box], dominance: left}");
  // What the bore leaves of the ball is 4/3 pi (4 - 1)^(3/2), half of it in the box.
  const double bead = 4 * kHalfTurn * std::sqrt(3.0), in_box = bead / 2;
  for (const std::string name : {"m.step", "m.brep"}) {
    INFO(name);
    scene.write(name);
    CHECK(meshed_by_gmsh(scene.file(name)) == Approx(bead + 108 - in_box).epsilon(0.01));
  }
}

TEST_CASE("curves of intersection are splines within the tolerance, which the notice says", "[exports]") {
  Scene scene(
      "nodes:\n  a: {cylinder: {from: [-2, 0, 0], to: [2, 0, 0], radius: 1, segments: 32}}\n"
      "  b: {cylinder: {from: [0, -2, 0], to: [0, 2, 0], radius: 0.75, segments: 32}}\n"
      "  model: {intersection: [a, b]}");
  const TopoDS_Shape shape = scene.brep();
  CHECK(valid(shape));
  // By Simpson's rule: the area of a cross-section is 2 sqrt(1 - z^2) times 2 sqrt(r^2 - z^2).
  double exact = 0;
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps * kHalfTurn - kHalfTurn / 2, z = 0.75 * std::sin(t);  // z = r sin t
    exact += 4 * std::sqrt(1 - z * z) * 0.75 * std::cos(t) * 0.75 * std::cos(t) * kHalfTurn / kSteps;
  }
  CHECK(volume(shape) == Approx(exact).epsilon(1e-6));
  REQUIRE(scene.notices.size() == 1);
  CHECK_THAT(scene.notices[0],
             Contains("3 faces are on their true surfaces; ") || Contains("4 faces are on their true surfaces; "));
  CHECK_THAT(scene.notices[0], Contains("splines (tolerance "));
  CHECK(volume(scene.step()) == Approx(exact).epsilon(1e-6));
}

TEST_CASE("sheets, wires and points are there beside solids, in a sheet's face and alone", "[exports]") {
  Scene scene(
      "nodes:\n  sheet: {polygon: [[1, 2, 1], [3, 2, 1], [3, 2, 5], [1, 2, 5]]}\n"
      "  wire: {polyline: [[1, 1, 1], [1, 1, 5], [2, 1, 6]]}\n"
      "  curve: {bezier: {curve: [[-1, -1, 0], [0, 3, 1], [-3, -2, 2], [-3, 3, 0]], segments: 12}}\n"
      "  dots: {points: [[2, 2, 2], [9, 9, 9]]}\n"
      "  disc: {bezier: {patch: [[[6, 0, 0], [7, 0, 1], [8, 0, 0]], [[6, 1, 0], [7, 1, 2], [8, 1, 0]], [[6, 2, "
      "0], "
      "[7, 2, 1], [8, 2, 0]]]}}\n"
      "  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}, name: block}\n"
      "  model: {union: [sheet, wire, curve, dots, disc, block], dominance: left}");
  const SimplifiedComplex cells = scene.result().cells();
  for (const bool step : {false, true}) {
    CAPTURE(step);
    const TopoDS_Shape shape = step ? scene.step() : scene.brep();
    CHECK(valid(shape));
    REQUIRE(solid_volumes(shape).size() == 1);
    CHECK(solid_volumes(shape)[0] == Approx(64));
    if (step) continue;
    CHECK(count(shape, TopAbs_FACE) == cells.faces.size());
    CHECK(count(shape, TopAbs_EDGE) == cells.edges.size());
    CHECK(surfaces(shape).count("Geom_BSplineSurface") == 1);
  }
}

TEST_CASE("products have the names of regions, colours those of materials", "[exports]") {
  Scene scene(
      "materials: {steel: {color: \"#336699\"}}\n"
      "nodes:\n  ring: {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1}, name: \"Größe 7\", "
      "material: steel}\n"
      "  pin: {cylinder: {from: [0, 0, -1], to: [0, 0, 1], radius: 1}}\n"
      "  model: {union: [ring, pin]}");
  scene.step();
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  REQUIRE(reader.ReadFile(scene.file("m.step").c_str()) == IFSelect_RetDone);
  REQUIRE(reader.Transfer(document));
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  TDF_LabelSequence labels;
  shapes->GetShapes(labels);
  std::set<std::string> names;
  int painted = 0;
  for (int i = 1; i <= labels.Length(); ++i) {
    Handle(TDataStd_Name) name;
    if (!labels(i).FindAttribute(TDataStd_Name::GetID(), name)) continue;
    std::string utf8(static_cast<std::size_t>(name->Get().LengthOfCString()), '\0');
    Standard_PCharacter at = utf8.data();
    name->Get().ToUTF8CString(at);
    names.insert(utf8.c_str());
    Quantity_Color color;
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(labels(i));
    for (const auto type : {XCAFDoc_ColorGen, XCAFDoc_ColorSurf}) {
      if (!colors->GetColor(shape, type, color)) continue;
      CHECK(color.IsEqual(Quantity_Color(0x33 / 255.0, 0x66 / 255.0, 0x99 / 255.0, Quantity_TOC_sRGB)));
      ++painted;
      break;
    }
  }
  CHECK(names.count("model") == 1);
  CHECK(names.count("Größe 7") == 1);
  CHECK(names.count("pin") == 1);
  CHECK(painted >= 1);
  std::ostringstream text;
  text << std::ifstream(scene.file("m.step")).rdbuf();
  CHECK_THAT(text.str(), Contains("'material: steel'"));
}

TEST_CASE("what bounds no region is called as its leaves or by what is said of it, not as its component",
          "[exports]") {
  Scene scene(
      "materials: {steel: {}}\n"
      "nodes:\n  block: {box: {min: [0, 0, 0], max: [6, 6, 6]}}\n"
      "  fault: {polygon: [[1, 1, 1], [5, 1, 1], [5, 5, 5], [1, 5, 5]], attributes: {aperture: 1}}\n"
      "  bolt:  {polyline: [[3, 3, 4], [3, 3, 5]], material: steel}\n"
      "  line:  {polyline: [[7, 7, 7], [8, 8, 8]]}\n"
      "  spots: {points: [[1, 1, 5]], name: spot}\n"
      "  model: {unify: {union: [fault, bolt, line, spots, block], dominance: left}}");
  scene.step();
  std::ostringstream text;
  text << std::ifstream(scene.file("m.step")).rdbuf();
  for (const std::string product : {"'block','block',''", "'fault','fault',''", "'bolt','bolt','material: steel'",
                                    "'line','line',''", "'spot','spot',''"}) {
    CHECK_THAT(text.str(), Contains("PRODUCT(" + product));
  }
}

TEST_CASE("a CAD model that went through a tree has its surfaces", "[exports]") {
  Scene scene(
      "nodes:\n  ball: {sphere: {center: [0, 0, 0], radius: 2, segments: 24}}\n"
      "  hole: {cylinder: {from: [0, 0, -3], to: [0, 0, 3], radius: 1, segments: 24}}\n"
      "  model: {difference: [ball, hole]}");
  const double exact = 4 * kHalfTurn / 3 * std::pow(3, 1.5);
  CHECK(volume(scene.step()) == Approx(exact).epsilon(1e-9));
  for (const std::string form : {"step", "brep"}) {
    if (form == "brep") scene.brep();
    Scene again("nodes:\n  model: {" + form + ": {file: '" + scene.file("m." + form) + "'}}");
    CHECK(solid_volumes(again.brep()).size() == 1);
    const TopoDS_Shape shape = again.brep();
    CHECK(valid(shape));
    CHECK(surfaces(shape) == std::multiset<std::string>{"Geom_CylindricalSurface", "Geom_SphericalSurface"});
    CHECK(volume(shape) == Approx(exact).epsilon(1e-9));
  }
}

TEST_CASE("a face without a surface is written as its facets, by name and with the reason", "[exports]") {
  Scene scene(
      "nodes:\n  twist: {extrude: {profile: [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], vector: [0, 0, 2], "
      "twist: 45, "
      "segments: 8}}\n"
      "  ball: {sphere: {center: [4, 0, 2], radius: 1/2, segments: 24}}\n"
      "  model: {union: [twist, ball]}");
  const TopoDS_Shape shape = scene.brep();
  CHECK(valid(shape));
  CHECK(surfaces(shape).count("Geom_SphericalSurface") == 1);
  REQUIRE(scene.notices.size() == 5);
  CHECK_THAT(scene.notices[1],
             Contains("is written as its ") && Contains("flat facets: ") && Contains("names no surface"));
}

TEST_CASE("what a CAD model cannot hold is refused, and the old file stays", "[exports]") {
  Scene open("nodes:\n  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  model: {interior: box}");
  std::ofstream(open.file("m.step")) << "old";
  CHECK_THROWS_WITH(open.write("m.step"), Contains("STEP holds closed sets only") && Contains("apply `closure`"));
  std::ostringstream text;
  text << std::ifstream(open.file("m.step")).rdbuf();
  CHECK(text.str() == "old");
  Scene unbounded(
      "nodes:\n  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  cut: {halfspace: {point: [0, 0, 0], "
      "normal: [0, 0, 1]}}\n  model: {union: [box, cut]}");
  CHECK_THROWS_WITH(unbounded.write("m.brep"), Contains("BREP cannot hold"));
}

TEST_CASE("the empty result is a file without solids, and files are the same bytes each time", "[exports]") {
  Scene empty("nodes:\n  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  model: {difference: [box, box]}");
  CHECK(count(empty.brep(), TopAbs_SHAPE) <= 1);
  empty.write("m.step");
  Scene scene(
      "nodes:\n  a: {sphere: {center: [0, 0, 0], radius: 1}}\n  b: {cylinder: {from: [0, 0, 0], to: [1, 1, 2], "
      "radius: "
      "1/2}}\n  model: {union: [a, b]}");
  for (const std::string form : {".step", ".brep"}) {
    scene.write("a" + form);
    scene.write("b" + form);
    std::ostringstream a, b;
    a << std::ifstream(scene.file("a" + form)).rdbuf();
    b << std::ifstream(scene.file("b" + form)).rdbuf();
    CHECK(a.str() == b.str());
    CHECK(!a.str().empty());
  }
}

TEST_CASE("files are right where OpenCASCADE's own Booleans are not", "[exports]") {
  const std::string leaves =
      "nodes:\n"
      "  ring:    {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1, segments: 48, rings: 24}}\n"
      "  ball:    {sphere: {center: [3, 0, 0], radius: 1, segments: 24}}\n"
      "  post:    {cylinder: {from: [0, 0, -2], to: [0, 0, 2], radius: 1}}\n"
      "  fin:     {polygon: [[-3, 0, -3], [3, 0, -3], [3, 0, 3], [-3, 0, 3]]}\n"
      "  left:    {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
      "  right:   {box: {min: [1.00000001, 0, 0], max: [2, 1, 1]}}\n";
  SECTION("a ball that fills the tube of a torus is cut out of it") {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(3, 1).Shape();
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(3, 0, 0), 1).Shape();
    CHECK(volume(BRepAlgoAPI_Cut(torus, ball).Shape()) == Approx(6 * kHalfTurn * kHalfTurn));
    Scene scene(leaves + "  model:   {difference: [ring, ball]}");
    for (const bool step : {false, true}) {
      const TopoDS_Shape shape = step ? scene.step() : scene.brep();
      CHECK(valid(shape));
      CHECK(count(shape, TopAbs_SOLID) == 1);
      CHECK(count(shape, TopAbs_SHELL) == 2);
      CHECK(volume(shape) == Approx(6 * kHalfTurn * kHalfTurn - 4 * kHalfTurn / 3));
    }
  }
  SECTION("a sheet parts a solid and goes on outside of it") {
    const TopoDS_Shape post = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -2}, {0, 0, 1}), 1, 4).Shape();
    const TopoDS_Shape fin =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), -3, 3, -3, 3).Shape();
    CHECK(BRepAlgoAPI_Fuse(post, fin).HasErrors());
    Scene scene(leaves + "  model:   {union: [fin, post], dominance: left}");
    const TopoDS_Shape shape = scene.brep();
    CHECK(valid(shape));
    REQUIRE(solid_volumes(shape).size() == 2);
    for (const double v : solid_volumes(shape)) CHECK(v == Approx(2 * kHalfTurn));
    CHECK(count(shape, TopAbs_FACE) == scene.result().cells().faces.size());
    CHECK(valid(scene.step()));
  }
  SECTION("boxes with a gap less than the tolerance are two") {
    const TopoDS_Shape left = box({0, 0, 0}, {1, 1, 1}), right = box({1.00000001, 0, 0}, {2, 1, 1});
    const TopoDS_Shape fused = BRepAlgoAPI_Fuse(left, right).Shape();
    CHECK(count(fused, TopAbs_SOLID) == 1);
    CHECK(count(fused, TopAbs_FACE) == 10);
    Scene scene(leaves + "  model:   {union: [left, right]}");
    for (const bool step : {false, true}) {
      const TopoDS_Shape shape = step ? scene.step() : scene.brep();
      CHECK(valid(shape));
      CHECK(count(shape, TopAbs_SOLID) == 2);
      CHECK(count(shape, TopAbs_FACE) == 12);
    }
  }
}

TEST_CASE("a region that touches itself along an edge is a solid of shells that touch", "[exports]") {
  Scene scene(
      "nodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}\n"
      "  c: {box: {min: [-1, -1, -1], max: [3, 3, 2]}}\n  model: {difference: [c, a, b]}");
  const TopoDS_Shape shape = scene.brep();
  CHECK(valid(shape));
  CHECK(count(shape, TopAbs_SOLID) == 1);
  CHECK(count(shape, TopAbs_SHELL) == 3);
  CHECK(count(shape, TopAbs_EDGE) == 12 + 23);
  CHECK(volume(shape) == Approx(46));
}

TEST_CASE("a bore that breaks through and balls that hardly overlap are valid where that is proven", "[exports]") {
  Scene wall(R"(nodes:
  block: {box: {min: [-4, -4, 0], max: [4, 0.998, 4]}}
  bore: {cylinder: {from: [0, 0, -1], to: [0, 0, 5], radius: 1, segments: 32}, rotate: {axis: [0, 0, 1], degrees: 5.625}}
  model: {difference: [block, bore]})",
             AskedProof::to_the_end);
  const TopoDS_Shape broken = wall.step();
  CHECK(valid(broken));
  const double beyond = std::acos(0.998) - 0.998 * std::sqrt(1 - 0.998 * 0.998);
  CHECK(volume(broken) == Approx(4 * (8 * 4.998 - kHalfTurn + beyond)));
  Scene balls(R"(nodes:
  a: {sphere: {center: [0, 0, 0], radius: 1}, rotate: {axis: [1, 2, 3], degrees: 41}}
  b: {sphere: {center: [1.999, 0, 0], radius: 1}, rotate: {axis: [3, -2, 1], degrees: 17, center: [1.999, 0, 0]}}
  model: {union: [a, b]})",
              AskedProof::to_the_end);
  CHECK(valid(balls.step()));
}

TEST_CASE("random solids are valid, with the faces of the result on their surfaces", "[exports]") {
  const char* const seeds = std::getenv("CNRG_SEEDS");
  const std::uint64_t number = seeds != nullptr ? std::strtoull(seeds, nullptr, 10) : 25;
  std::size_t faces = 0, faceted = 0;
  for (std::uint64_t seed = 1; seed <= number; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    const auto eighths = [&](int from, int to) { return std::to_string(from + below(to - from)) + "/8"; };
    // What is drawn has a name, for compilers differ in which operand comes first.
    const auto point = [&] {
      const std::string z = eighths(-10, 11), y = eighths(-10, 11), x = eighths(-10, 11);
      return "[" + x + ", " + y + ", " + z + "]";
    };
    std::string nodes = "nodes:\n", list;
    const int leaves = 2 + below(2);
    for (int i = 0; i < leaves; ++i) {
      const std::string name(1, static_cast<char>('a' + i));
      nodes += "  " + name + ": {";
      switch (below(4)) {
        case 0: {
          const std::string back = eighths(1, 12), bottom = eighths(-8, 0);
          nodes += "box: {min: [-1/2, -1, " + bottom + "], max: [1, " + back + ", 1]}";
          break;
        }
        case 1: {
          const std::string radius = eighths(6, 14), center = point();
          nodes += "sphere: {center: " + center + ", radius: " + radius + ", segments: 40}";
          break;
        }
        case 2: {
          const std::string radius = eighths(3, 9), y = eighths(-4, 5), from = point();
          nodes += "cylinder: {from: " + from + ", to: [2, " + y + ", 3/2], radius: " + radius + ", segments: 40}";
          break;
        }
        default: {
          const std::string tube = eighths(2, 5), radius = eighths(8, 13), y = std::to_string(below(2)),
                            center = point();
          nodes += "torus: {center: " + center + ", axis: [0, " + y + ", 1], radius: " + radius +
                   ", tube: " + tube + ", segments: 48, rings: 24}";
        }
      }
      nodes += "}\n";
      list += (i > 0 ? ", " : "") + name;
    }
    const bool left = below(2) == 0, united = below(2) == 0;
    nodes += std::string("  model: {") + (united ? "union" : "difference") + ": [" + list +
             "], dominance: " + (left ? "left" : "right") + "}";
    CAPTURE(nodes);
    Scene scene(nodes);
    const Result result = scene.result();
    const TopoDS_Shape shape = scene.brep();
    CHECK(valid(shape));
    std::size_t active = 0;
    for (const auto& region : result.cells().regions) active += region.component != 0;
    CHECK(count(shape, TopAbs_SOLID) == active);
    const std::size_t here = result.cells().faces.size();
    faces += here;
    for (const double v : solid_volumes(shape)) CHECK(v > 0);
    std::size_t of_facets = 0;
    for (const std::string& notice : scene.notices) of_facets += notice.find("flat facet") != std::string::npos;
    faceted += of_facets;
    if (of_facets == 0) CHECK(count(shape, TopAbs_FACE) == here);
    // Facets are inside of convex patches and outside of bores: near, but no more.
    double exact = 0;
    for (Component i = 1; i <= result.component_count(); ++i) exact += to_double(*result.volume(i));
    if (exact > 0.5) CHECK(volume(shape) == Approx(exact).epsilon(0.04));
    if (of_facets == 0) CHECK(std::abs(volume(shape) - exact) <= result.data().volume_bound().value() + 1e-6);
  }
  CHECK(faceted * 50 <= faces);
}

}  // namespace
}  // namespace cnrg
