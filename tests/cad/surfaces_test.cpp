// Surfaces and curves that a CAD file names, compared with the numbers that its shapes were made of.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>

#include "csg/imports/cad_model.h"
#include "tests/cad/models.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using namespace cad;
using Surface = CadSurface::Kind;
using Curve = CadCurve::Kind;
using Point = std::array<double, 3>;

/// The model of a shape that is written to a file and read back.
CadModel model_of(const TopoDS_Shape& shape, CadShape::Format format = CadShape::Format::brep) {
  std::string folder = (std::filesystem::temp_directory_path() / "cnrg_surfaces_XXXXXX").string();
  REQUIRE(mkdtemp(folder.data()) != nullptr);
  CadShape leaf;
  leaf.format = format;
  leaf.file = folder + "/part";
  if (format == CadShape::Format::brep) write_brep(shape, leaf.file);
  else write_step(shape, leaf.file);
  CadModel model = read_cad(leaf);
  std::filesystem::remove_all(folder);
  return model;
}

/// The only surface of that kind.
CadSurface only(const CadModel& model, Surface kind) {
  std::vector<CadSurface> found;
  for (const CadModel::Face& face : model.faces) {
    if (face.surface.kind == kind) found.push_back(face.surface);
  }
  REQUIRE(found.size() == 1);
  return found[0];
}

TopoDS_Shape face_on(const Handle(Geom_Surface) & surface, double u = 1, double v = 1) {
  return BRepBuilderAPI_MakeFace(surface, 0, u, 0, v, 1e-7).Shape();
}

TEST_CASE("surfaces of primitive solids are those that they were made of", "[surfaces]") {
  const gp_Ax2 at({1, 2, 3}, {0, 1, 0}, {0, 0, 1});  // y is z x x = (1, 0, 0)
  const CadAxes axes{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  for (const auto format : {CadShape::Format::brep, CadShape::Format::step}) {
    const CadModel cylinder = model_of(BRepPrimAPI_MakeCylinder(at, 0.1, 3).Shape(), format);
    const CadSurface side = only(cylinder, Surface::cylinder);
    CHECK(side.axes == axes);
    CHECK(side.radius == 0.1);
    CHECK_FALSE(side.turned);
    CHECK(side.name == "Geom_CylindricalSurface");
    CHECK(std::count_if(cylinder.faces.begin(), cylinder.faces.end(), [](const CadModel::Face& face) {
            return face.surface.kind == Surface::plane && face.surface.axes.z == Point{0, 1, 0};
          }) == 2);

    const CadSurface cone = only(model_of(BRepPrimAPI_MakeCone(at, 1, 2, 1).Shape(), format), Surface::cone);
    CHECK(cone.axes == axes);
    CHECK(cone.radius == 1);
    CHECK(cone.half_angle == Approx(std::atan(1)).epsilon(1e-12));

    const CadSurface ball = only(model_of(BRepPrimAPI_MakeSphere(at, 0.7).Shape(), format), Surface::sphere);
    CHECK(ball.axes == axes);
    CHECK(ball.radius == 0.7);

    const CadSurface ring = only(model_of(BRepPrimAPI_MakeTorus(at, 3, 0.3).Shape(), format), Surface::torus);
    CHECK(ring.axes == axes);
    CHECK(ring.radius == 3);
    CHECK(ring.minor_radius == 0.3);
  }
}

TEST_CASE("places of parts are applied to surfaces and curves, and a bore is turned", "[surfaces]") {
  const CadModel model = model_of(moved(bored_box(), 0.5, 0, 1));
  const CadSurface bore = only(model, Surface::cylinder);
  CHECK(bore.turned);
  CHECK(bore.axes.origin == Point{2.5, 2, 0});
  CHECK(bore.axes.z == Point{0, 0, 1});
  std::size_t circles = 0, lines = 0;
  for (const CadModel::Edge& edge : model.edges) {
    const CadCurve& curve = edge.curve;
    CHECK(curve.first == edge.parameters.front());
    CHECK(curve.last == edge.parameters.back());
    if (curve.kind == Curve::circle) {
      ++circles;
      CHECK(curve.radius == 1);
      CHECK(curve.axes.origin[0] == 2.5);
    } else if (curve.kind == Curve::line && !edge.seam) {
      ++lines;
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(curve.axes.origin[k] + curve.first * curve.axes.x[k] == model.points[edge.points.front()][k]);
        CHECK(curve.axes.origin[k] + curve.last * curve.axes.x[k] == model.points[edge.points.back()][k]);
      }
    }
  }
  CHECK(circles == 2);
  CHECK(lines == 12);
}

TEST_CASE("splines have the net, weights and knots of the file", "[surfaces]") {
  TColgp_Array2OfPnt points(1, 3, 1, 4);
  TColStd_Array2OfReal weights(1, 3, 1, 4);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 4; ++j) {
      points(i, j) = gp_Pnt(i, j, 0.1 * i * j);
      weights(i, j) = i == 2 ? 0.7 : 1;
    }
  }
  TColStd_Array1OfReal u(1, 2), v(1, 3);
  TColStd_Array1OfInteger u_counts(1, 2), v_counts(1, 3);
  u(1) = 0, u(2) = 1, u_counts(1) = u_counts(2) = 3;
  v(1) = 0, v(2) = 0.3, v(3) = 1, v_counts(1) = v_counts(3) = 3, v_counts(2) = 1;
  const CadModel model =
      model_of(face_on(new Geom_BSplineSurface(points, weights, u, v, u_counts, v_counts, 2, 2)));
  const CadSurface net = only(model, Surface::spline);
  CHECK(net.rows == std::array<std::uint32_t, 2>{3, 4});
  CHECK(net.points[1 * 4 + 2] == Point{2, 3, 0.1 * 2 * 3});
  CHECK(net.weights[1 * 4 + 2] == 0.7);
  CHECK(net.weights[2 * 4 + 2] == 1);
  CHECK(net.knots[0] == CadKnots{2, false, {0, 1}, {3, 3}});
  CHECK(net.knots[1] == CadKnots{2, false, {0, 0.3, 1}, {3, 1, 3}});
}

TEST_CASE("surfaces that are swept have their profile; others are named", "[surfaces]") {
  TColgp_Array1OfPnt points(1, 3);
  points(1) = gp_Pnt(2, 0, 0), points(2) = gp_Pnt(3, 0, 1), points(3) = gp_Pnt(2, 0, 2);
  const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(points);
  CadCurve profile;
  profile.kind = Curve::spline;
  profile.last = 1;
  profile.points = {{2, 0, 0}, {3, 0, 1}, {2, 0, 2}};
  profile.knots = {2, false, {0, 1}, {3, 3}};
  profile.name = "Geom_BezierCurve";

  const CadSurface wall =
      only(model_of(face_on(new Geom_SurfaceOfLinearExtrusion(curve, {0, 1, 0}))), Surface::extrusion);
  CHECK(wall.axes.z == Point{0, 1, 0});
  CHECK(wall.profile == profile);

  const Handle(Geom_Surface) vase = new Geom_SurfaceOfRevolution(curve, gp_Ax1({0, 0, 5}, {0, 0, 1}));
  const CadSurface turned = only(model_of(face_on(vase)), Surface::revolution);
  CHECK(turned.axes.origin == Point{0, 0, 5});
  CHECK(turned.axes.z == Point{0, 0, 1});
  CHECK(turned.profile == profile);

  CHECK(only(model_of(face_on(new Geom_OffsetSurface(vase, 0.1))), Surface::other).name == "Geom_OffsetSurface");
}

TEST_CASE("an edge has its ellipse and the range of it", "[surfaces]") {
  const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(gp_Ax2({0, 0, 1}, {0, 0, 1}, {1, 0, 0}), 2, 0.5);
  const CadModel model = model_of(BRepBuilderAPI_MakeEdge(ellipse, 0.25, 1.5).Shape());
  REQUIRE(model.edges.size() == 1);
  const CadCurve& curve = model.edges[0].curve;
  CHECK(curve.kind == Curve::ellipse);
  CHECK(curve.axes == CadAxes{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(curve.radius == 2);
  CHECK(curve.minor_radius == 0.5);
  CHECK(curve.first == 0.25);
  CHECK(curve.last == 1.5);
}

}  // namespace
}  // namespace cnrg
