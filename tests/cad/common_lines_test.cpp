// Curved faces of CAD files that lie on one surface with others: of another solid of the file, of another file, of
// a native leaf. Counts are those of the true solids, at any fineness.
#include "csg/carriers/common_lines.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <random>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/imports/cad_model.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/operators/node_value.h"
#include "tests/cad/models.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using namespace cad;
using Catch::Contains;
using Cells = std::array<std::size_t, 4>;

const gp_Dir kUp(0, 0, 1);

TopoDS_Shape cylinder(const gp_Pnt& from, double radius, double height, double turn = 2 * M_PI) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(from, kUp, {1, 0, 0}), radius, height, turn).Shape();
}
TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }
TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Common(a, b).Shape(); }

/// A file with solids, and trees that use it.
class Parts {
 public:
  explicit Parts(const std::vector<TopoDS_Shape>& solids) {
    std::string pattern = (std::filesystem::temp_directory_path() / "cnrg_lines_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write_step(compound(solids), folder_ / "parts.step");
    write_brep(compound(solids), folder_ / "parts.brep");
  }
  ~Parts() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  Tree tree(const std::string& nodes) const {
    return parse_tree("cnrg: 1\nnodes:\n" + nodes + "\nresult: model\n", folder_ / "t.yaml");
  }
  Evaluation evaluated(const std::string& nodes) const {
    EvaluateOptions options;
    options.validate = true;
    return evaluate(tree(nodes), options);
  }
  /// The row of all solids as one leaf.
  NodeRow row(const std::string& options = "") const {
    const Evaluation both = evaluated("  model: {step: {file: parts.step" + options + "}}");
    CHECK(both.diagnostics.empty());
    return both.rows.back();
  }

 private:
  std::filesystem::path folder_;
};

/// A block with a stepped hole, and a bolt in it.
std::vector<TopoDS_Shape> bolt_in_hole(double x, double y, double z) {
  const TopoDS_Shape bolt = fused(cylinder({x, y, z - 2}, 0.8, 3), cylinder({x, y, z + 1}, 1.4, 1));
  const TopoDS_Shape block = cut(box({x - 2, y - 2, z - 1}, {x + 2, y + 2, z + 2}), bolt);
  return {block, bolt};
}

TEST_CASE("a bolt fills its hole, whatever the fineness and wherever it is", "[lines]") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> shift(-40, 40);
  for (int i = 0; i < 4; ++i) {
    std::vector<TopoDS_Shape> parts = bolt_in_hole(shift(random) / 8.0, shift(random) / 8.0, shift(random) / 8.0);
    if (i % 2 == 1) std::swap(parts[0], parts[1]);
    const Parts file(parts);
    for (const char* options : {"", ", segments: 5", ", segments: 23", ", chord: 0.01", ", fill: winding"}) {
      INFO(i << options);
      const NodeRow both = file.row(options);
      // Six faces of the block; the head's top, side and shoulder; the shank in the block, below it, and its end.
      CHECK(both.cells == Cells{13, 17, 12, 2});
    }
  }
}

TEST_CASE("a lens fits its seat", "[lines]") {
  for (const double height : {1.5, 1.0, 0.3}) {
    for (const bool first : {true, false}) {
      const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, kUp), 2.5).Shape();
      const TopoDS_Shape lens = common(ball, box({-3, -3, 0}, {3, 3, 3}));
      const TopoDS_Shape seat = cut(box({-4, -4, height}, {4, 4, 4}), ball);
      const Parts file(first ? std::vector{lens, seat} : std::vector{seat, lens});
      for (const char* options : {"", ", segments: 6", ", segments: 21", ", chord: 0.01", ", fill: winding"}) {
        INFO(height << options);
        // The dome is parted where it comes out of the seat.
        CHECK(file.row(options).cells == Cells{10, 14, 9, 2});
      }
    }
  }
}

TEST_CASE("a ring lies in its groove, a plug in its countersink", "[lines]") {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(gp_Ax2({1, 2, 0}, kUp), 3, 0.7).Shape();
  const TopoDS_Shape grooved = cut(box({-4, -4, -2}, {6, 7, 0}), ring);
  const TopoDS_Shape plug = BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 0}, kUp), 1, 3, 2).Shape();
  const TopoDS_Shape sunk = cut(box({-4, -4, 0.5}, {4, 4, 2}), plug);
  for (const char* options : {"", ", segments: 7", ", chord: 0.02"}) {
    INFO(options);
    CHECK(Parts({ring, grooved}).row(options).cells == Cells{10, 14, 9, 2});
    CHECK(Parts({sunk, plug}).row(options).cells == Cells{11, 15, 10, 2});
  }
}

TEST_CASE("cylinders and rings in a tube have the faces that they share once", "[lines]") {
  const TopoDS_Shape tube = cut(cylinder({0, 0, 0}, 2, 6), cylinder({0, 0, -1}, 1.9, 8));
  const TopoDS_Shape ring = cut(cylinder({0, 0, 3}, 1.7, 1), cylinder({0, 0, 2}, 1, 3));
  const std::vector<TopoDS_Shape> parts{
      tube, cylinder({0, 0, 0}, 1.9, 1), cylinder({0, 0, 1}, 1.9, 2), cylinder({0, 0, 4}, 1.9, 2),
      ring, cylinder({0, 0, 3}, 1, 1)};
  for (const char* options : {"", ", segments: 5", ", segments: 30", ", chord: 0.03", ", fill: winding"}) {
    INFO(options);
    const NodeRow all = Parts(parts).row(options);
    // The tube: side, two ends, bore in four pieces; discs at 0, 1, 6, three faces each at 3 and 4; the middle
    // ring has two sides.
    CHECK(all.cells[2] == 18);
    CHECK(all.cells[3] == 6);
  }
  std::vector<TopoDS_Shape> back(parts.rbegin(), parts.rend());
  CHECK(Parts(back).row().volume() == Parts(parts).row().volume());
}

TEST_CASE("half a cylinder shares half a bore", "[lines]") {
  const TopoDS_Shape tube = cut(cylinder({0, 0, 0}, 2, 6), cylinder({0, 0, -1}, 1.9, 8));
  const Parts file({tube, cylinder({0, 0, 1}, 1.9, 2, M_PI)});
  for (const char* options : {"", ", segments: 7", ", chord: 0.03"}) {
    INFO(options);
    const NodeRow both = file.row(options);
    // The flat side of the half consists of two faces in the file.
    CHECK(both.cells[2] == 9);
    CHECK(both.cells[3] == 2);
  }
}

TEST_CASE("a leaf whose walls are thinner than its chords allow is drawn finer", "[lines]") {
  // The rulings of the wedge's sides in the bore would come out of the tube of five segments.
  const TopoDS_Shape tube = cut(cylinder({0, 0, 0}, 2, 6, M_PI), cylinder({0, 0, -1}, 1.9, 8));
  const Parts file({tube, cylinder({0, 0, 1}, 1.9, 2, 2.0)});
  for (const char* options : {", segments: 5", ", segments: 5, fill: winding", ", segments: 31"}) {
    INFO(options);
    const Evaluation both = file.evaluated("  model: {step: {file: parts.step" + std::string(options) + "}}");
    for (const Diagnostic& notice : both.diagnostics) CHECK_THAT(notice.message, !Contains("is not drawn"));
    // The tube: side, two ends, two flat sides, bore in two pieces; four of the wedge.
    CHECK(both.rows.back().cells[2] == 11);
    CHECK(both.rows.back().cells[3] == 2);
  }
}

TEST_CASE("a shaft from a file fills the bore of native leaves", "[lines]") {
  const Parts file({cylinder({0, 0, 0}, 1, 4)});
  for (const char* turn : {"", ", rotate: {axis: [1, 2, 2], degrees: 77}", ", scale: [1, -1, 1]"}) {
    for (const int segments : {8, 15, 24}) {
      const std::string at = turn + std::string(", translate: [0.1, 0.2, 0.3]}\n");
      INFO(at << segments);
      const Evaluation both = file.evaluated(
          "  block: {box: {min: [-2, -2, 0], max: [2, 2, 4]}" + at +
          "  bore: {cylinder: {from: [0, 0, -1], to: [0, 0, 5], radius: 1, segments: " + std::to_string(segments) +
          "}" + at + "  shaft: {step: {file: parts.step, segments: 10}" + at +
          "  plate: {difference: [block, bore]}\n  model: {union: [plate, shaft], dominance: left}\n");
      CHECK(both.rows.back().cells == Cells{10, 14, 9, 2});
      CHECK(both.rows.back().volume() == Rational(64));
    }
  }
}

TEST_CASE("a ball, a ring and a cone from files are those of native leaves", "[lines]") {
  const Parts ball({BRepPrimAPI_MakeSphere(gp_Ax2({1, 2, 3}, {1, 0, 0}), 2).Shape()});
  CHECK(ball.evaluated("  a: {step: {file: parts.step}}\n"
                       "  b: {sphere: {center: [1, 2, 3], radius: 2, segments: 9}}\n"
                       "  c: {difference: [a, b]}\n  d: {difference: [b, a]}\n  model: {union: [c, d]}\n")
            .rows.back()
            .raw_cells == Cells{0, 0, 0, 0});
  const Parts ring({BRepPrimAPI_MakeTorus(gp_Ax2({1, 0, 0}, kUp), 3, 1).Shape()});
  CHECK(ring.evaluated("  a: {step: {file: parts.step}}\n"
                       "  b: {torus: {center: [1, 0, 0], axis: [0, 0, -1], radius: 3, tube: 1, segments: 9}}\n"
                       "  c: {difference: [a, b]}\n  d: {difference: [b, a]}\n  model: {union: [c, d]}\n")
            .rows.back()
            .raw_cells == Cells{0, 0, 0, 0});
  const Parts cone({BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 1}, kUp), 2, 0, 4).Shape()});
  CHECK(cone.evaluated("  a: {step: {file: parts.step}}\n"
                       "  b: {cone: {from: [0, 0, 5], to: [0, 0, 1], radius: 0, top: 2, segments: 9}}\n"
                       "  c: {difference: [a, b]}\n  d: {difference: [b, a]}\n  model: {union: [c, d]}\n")
            .rows.back()
            .raw_cells == Cells{0, 0, 0, 0});
}

TEST_CASE("wedges of round solids lie in the native ones", "[lines]") {
  struct Case {
    TopoDS_Shape shape;
    std::string native;
  };
  const gp_Ax2 at({1, 2, 3}, kUp, {1, 0, 0});
  for (const double turn : {M_PI / 2, 2.0, 5.5}) {
    const Case cases[] = {
        {BRepPrimAPI_MakeCylinder(at, 2, 3, turn).Shape(),
         "cylinder: {from: [1, 2, 3], to: [1, 2, 6], radius: 2, segments: 7}"},
        {BRepPrimAPI_MakeCone(at, 2, 0, 3, turn).Shape(),
         "cone: {from: [1, 2, 3], to: [1, 2, 6], radius: 2, top: 0, segments: 7}"},
        {BRepPrimAPI_MakeSphere(at, 2, turn).Shape(), "sphere: {center: [1, 2, 3], radius: 2, segments: 7}"},
        {BRepPrimAPI_MakeSphere(at, 2, -0.5, 1, turn).Shape(),
         "sphere: {center: [1, 2, 3], radius: 2, segments: 7}"},
        {BRepPrimAPI_MakeTorus(at, 3, 1, turn).Shape(),
         "torus: {center: [1, 2, 3], axis: [0, 0, 1], radius: 3, tube: 1, segments: 7, rings: 5}"}};
    for (const Case& c : cases) {
      INFO(turn << " " << c.native);
      const Parts file({c.shape});
      const Evaluation rest = file.evaluated("  a: {step: {file: parts.step, segments: 11}}\n  b: {" + c.native +
                                             "}\n  model: {difference: [a, b]}\n");
      CHECK(rest.diagnostics.empty());
      CHECK(rest.rows.back().raw_cells == Cells{0, 0, 0, 0});
      const Evaluation seamed = file.evaluated("  a: {step: {file: parts.step, seams: true}}\n  b: {" + c.native +
                                               "}\n  model: {difference: [a, b]}\n");
      CHECK(seamed.rows.back().raw_cells == Cells{0, 0, 0, 0});
    }
  }
}

TEST_CASE("parts that were turned in the file share what they shared before", "[lines]") {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> steps(-64, 64);
  const auto some = [&] { return steps(random) / 64.0; };
  for (int i = 0; i < 6; ++i) {
    gp_Trsf turn;
    const gp_Pnt center(some(), some(), some());
    const gp_Dir axis(some(), some(), some() + 2);
    turn.SetRotation(gp_Ax1(center, axis), 3 * some());
    std::vector<TopoDS_Shape> parts = bolt_in_hole(some(), some(), some());
    for (TopoDS_Shape& part : parts) part = BRepBuilderAPI_Transform(part, turn, true).Shape();
    CHECK(Parts(parts).evaluated("  model: {step: {file: parts.step, fill: winding}}").rows.back().cells ==
          Cells{13, 17, 12, 2});
  }
}

TEST_CASE("halves of cylinders and rings, welded, have the faces that they share once", "[lines]") {
  const auto half = [](double from, double radius, double height) {
    return cylinder({0, 0, from}, radius, height, M_PI);
  };
  const std::vector<TopoDS_Shape> parts{
      cut(half(0, 2, 6), cylinder({0, 0, -1}, 1.9, 8)), half(0, 1.9, 1), half(1, 1.9, 2), half(4, 1.9, 2),
      cut(half(3, 1.7, 1), cylinder({0, 0, 2}, 1, 3)),  half(3, 1, 1)};
  // Where a weld tilts planes so that they hold no ruling, the leaf stays as it is.
  for (const char* options : {"", ", segments: 5", ", segments: 30", ", fill: winding"}) {
    INFO(options);
    const NodeRow all =
        Parts(parts)
            .evaluated("  model: {step: {file: parts.step, weld: 1e-9" + std::string(options) + "}}")
            .rows.back();
    // The tube: side, two ends, bore in four pieces, two flat sides; discs at 0, 1, 6, three faces each at 3 and
    // 4; two flat sides of each other part (for cylinders, both sides of the axis); the middle ring's two round
    // ones.
    CHECK(all.cells[2] == 9 + 9 + 10 + 2);
    CHECK(all.cells[3] == 6);
  }
}

TEST_CASE("solids of one file in leaves of their own share their walls, turned together", "[lines]") {
  const Parts file(bolt_in_hole(0.25, 0, 0));
  for (const char* at : {"", ", rotate: {axis: [3, -1, 2], degrees: 29}, translate: [0.1, 7, -3]"}) {
    const NodeRow both =
        file.evaluated("  block: {step: {file: parts.step, segments: 13, solids: ['1']}" + std::string(at) +
                       "}\n  bolt: {step: {file: parts.step, segments: 20, solids: ['2']}" + at +
                       "}\n  model: {union: [block, bolt], dominance: left}\n")
            .rows.back();
    CHECK(both.cells == Cells{13, 17, 12, 2});
  }
}

TEST_CASE("seams are edges where they are asked for", "[lines]") {
  CHECK(Parts(bolt_in_hole(0, 0, 0)).row(", seams: true").cells == Cells{13, 20, 12, 2});
}

/// The point of the surface, as `CadSurface` says.
RationalPoint surface_point(const CadSurface& surface, double u, double v) {
  double r = surface.radius, z = v;
  if (surface.kind == CadSurface::Kind::cone)
    r += v * std::sin(surface.half_angle), z *= std::cos(surface.half_angle);
  if (surface.kind == CadSurface::Kind::sphere) r *= std::cos(v), z = surface.radius * std::sin(v);
  if (surface.kind == CadSurface::Kind::torus)
    r += surface.minor_radius * std::cos(v), z = surface.minor_radius * std::sin(v);
  const bool plane = surface.kind == CadSurface::Kind::plane;
  const double x = plane ? u : r * std::cos(u), y = plane ? v : r * std::sin(u);
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k) {
    const CadAxes& axes = surface.axes;
    p[k] = from_double(axes.origin[k] + x * axes.x[k] + y * axes.y[k] + (plane ? 0 : z * axes.z[k]));
  }
  return p;
}

TEST_CASE("leaves that are drawn anew have the parameters of the file's surfaces", "[lines]") {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, kUp), 2.5).Shape();
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(gp_Ax2({1, 2, 0}, kUp), 3, 0.7).Shape();
  const TopoDS_Shape plug = BRepPrimAPI_MakeCone(gp_Ax2({9, 0, 0}, kUp), 0, 3, 2).Shape();
  const std::vector<std::vector<TopoDS_Shape>> scenes{
      bolt_in_hole(0.5, 0, 1),
      {common(ball, box({-3, -3, 0}, {3, 3, 3})), cut(box({-4, -4, 1}, {4, 4, 4}), ball)},
      {ring, cut(box({-4, -4, -2}, {6, 7, 0}), ring)},
      {plug, cut(box({5, -4, 0.5}, {13, 4, 2}), plug)}};
  for (const auto& scene : scenes) {
    const Parts file(scene);
    const Tree tree = file.tree("  model: {step: {file: parts.step}}");
    const CadModel model = read_cad(std::get<CadShape>(*tree.nodes[tree.result].shape));
    const std::vector<LeafInstance> own = PreparedLeaves(tree, unfold(tree, {tree.result})).instances();
    const std::vector<LeafInstance> drawn = with_common_lines(own);
    REQUIRE(drawn[0].leaf != own[0].leaf);
    const auto parameters = drawn[0].leaf->parameters()();
    const Soup& soup = dynamic_cast<const GeometryLeaf&>(*drawn[0].leaf).geometry();
    for (std::size_t i = 0; i < parameters->facet_count(); ++i) {
      const CadSurface& surface = model.faces[soup.face(SourceId(i)).patch].surface;
      for (const auto& cell : parameters->cells(i)) {
        for (const PatchCorner& corner : cell) {
          const RationalPoint p = surface_point(surface, to_double(corner.at[0]), to_double(corner.at[1]));
          for (std::size_t k = 0; k < 3; ++k)
            CHECK(to_double(p[k]) == Approx(to_double(corner.point[k])).margin(1e-12));
        }
      }
    }
    for (std::size_t i = 0; i < parameters->wire_count(); ++i) {
      const LeafParameters::Wire wire = parameters->wire(i);
      CHECK(wire.at[0] < wire.at[1]);
    }
  }
}

TEST_CASE("products keep their names where they share a bore", "[lines]") {
  std::string pattern = (std::filesystem::temp_directory_path() / "cnrg_names_XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(pattern.data());
  const std::vector<TopoDS_Shape> parts = bolt_in_hole(0, 0, 0);
  write_assembly({{"block", parts[0]}, {"M8", parts[1]}}, {{0, 10}, {0, 10}}, folder / "parts.step");
  const Tree tree =
      parse_tree("cnrg: 1\nnodes:\n  model: {step: {file: parts.step}}\nresult: model\n", folder / "t.yaml");
  const Evaluation all = evaluate(tree, {});
  CHECK(all.rows.back().cells == Cells{26, 34, 24, 4});
  std::multiset<std::string> names;
  for (const RegionAttributes& region : all.kept[0].group().regions) names.insert(region.name);
  CHECK(names == std::multiset<std::string>{"M8", "M8", "block", "block"});
  std::filesystem::remove_all(folder);
}

TEST_CASE("what shares nothing, or shares faces in the file, stays as it is", "[lines]") {
  const std::vector<std::vector<TopoDS_Shape>> scenes{
      {fused(cylinder({0, 0, 0}, 1, 2), cylinder({0, 0, 2}, 2, 1))},
      {glued({cylinder({0, 0, 0}, 1, 2), cylinder({0, 0, 2}, 1, 1)})},
      {glued(bolt_in_hole(0, 0, 0))},
      {cylinder({0, 0, 0}, 1, 2), cylinder({0, 0, 3}, 1, 2), cylinder({0, 0, 0}, 2, 1)}};
  for (const auto& scene : scenes) {
    const Parts file(scene);
    const Tree tree = file.tree("  model: {brep: {file: parts.brep}}");
    const std::vector<LeafInstance> own = PreparedLeaves(tree, unfold(tree, {tree.result})).instances();
    CHECK(with_common_lines(own)[0].leaf == own[0].leaf);
  }
}

TEST_CASE("a leaf that cannot be drawn so is named, with the edge that prevents it", "[lines]") {
  std::vector<TopoDS_Shape> parts = bolt_in_hole(0, 0, 0);
  parts[1] = cut(parts[1], BRepPrimAPI_MakeCylinder(gp_Ax2({-3, 0, 0.2}, {1, 0, 0}), 0.3, 6).Shape());
  const Evaluation both = Parts(parts).evaluated("  model: {step: {file: parts.step, fill: winding}}");
  REQUIRE(both.diagnostics.size() == 1);
  CHECK(both.diagnostics[0].level == Diagnostic::Level::notice);
  CHECK_THAT(both.diagnostics[0].message,
             Contains("of `model`") && Contains("is neither a parallel nor a meridian of") && Contains("`weld`"));
}

}  // namespace
}  // namespace cnrg
