// From shapes to facets: OpenCASCADE's mesher (BRepMesh), and who shares which point.
//
// BRepMesh cuts each edge once, and the facets of every face at it end in these points; but each face has its own
// copy of them, in its own coordinates. So points are not compared: those inside of an edge are numbered along the
// edge, its ends are those of its vertices, and the polygon that a face keeps on the edge says which of its nodes
// they are. A seam has two such polygons, an edge without length (a pole) one that is a single point in space.
//
// BRepMesh estimates how far its facets are from the faces. Here it is measured, at the corners' middle and the
// sides' middles in parameters, as the distance of the point of the face from the facet's plane; and in the middle
// of the segments of edges. What is above the chord is meshed again with a smaller one.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Polygon3D.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <gp_Pnt.hxx>
#include <numbers>
#include <set>

#include "csg/curves/boundary_curves.h"
#include "csg/imports/cad_occt.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"

namespace cnrg::occt {
namespace {

using Index = std::uint32_t;
constexpr int kAttempts = 6;

class Tessellator {
 public:
  Tessellator(const CadShape& shape, const CadFile& file)
      : shape_(shape), file_(file), fineness_(shape.name(), shape.tessellation) {
    TopExp::MapShapes(file.shape, TopAbs_SOLID, solids_);
    TopExp::MapShapes(file.shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(file.shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(file.shape, TopAbs_VERTEX, vertices_);
    TopExp::MapShapesAndUniqueAncestors(file.shape, TopAbs_EDGE, TopAbs_FACE, faces_at_);
    TopExp::MapShapesAndUniqueAncestors(file.shape, TopAbs_VERTEX, TopAbs_EDGE, edges_at_);
  }

  CadModel run() {
    mesh();
    add_vertices();
    model_.edges.resize(static_cast<std::size_t>(edges_.Extent()));
    for (int f = 1; f <= faces_.Extent(); ++f) add_face(f);
    for (int e = 1; e <= edges_.Extent(); ++e) {
      complete_edge(e);
      model_.edges[static_cast<std::size_t>(e) - 1].curve = curve_of(TopoDS::Edge(edges_(e)));
    }
    mark_seams();
    add_solids();
    model_.notices = file_.notices;
    return std::move(model_);
  }

 private:
  static std::string face_name(int f) { return "face " + std::to_string(f - 1); }
  static std::string edge_name(int e) { return "edge " + std::to_string(e - 1); }
  TopoDS_Face face(int f) const { return TopoDS::Face(faces_(f).Oriented(TopAbs_FORWARD)); }

  // --- fineness

  void mesh() {
    Bnd_Box box;
    BRepBndLib::Add(file_.shape, box, false);
    const double extent = box.IsVoid() ? 1 : std::sqrt(box.SquareExtent());
    if (!std::isfinite(extent) || box.IsOpen()) {
      throw InputError(cad_subject(shape_) + "it is unbounded: cut it where it was made");
    }
    if (fineness_.by_chord() && fineness_.chord() < Precision::Confusion()) {
      throw InputError(cad_subject(shape_) +
                       "the chord is below 1e-7, where OpenCASCADE's mesher ends: give a larger one");
    }
    IMeshTools_Parameters parameters;
    parameters.Angle = fineness_.by_chord() ? std::numbers::pi / 4 : 2 * std::numbers::pi / fineness_.segments();
    parameters.Deflection = fineness_.by_chord() ? fineness_.chord() : std::max(extent, 1e-6);
    // Without a chord angles alone decide: by default small edges would be left out, by the deflection.
    if (!fineness_.by_chord()) parameters.MinSize = Precision::Confusion();
    for (int attempt = 1;; ++attempt) {
      BRepTools::Clean(file_.shape);
      BRepMesh_IncrementalMesh mesher(file_.shape, parameters);
      if (!fineness_.by_chord()) return;
      worst_ = 0;
      for (int f = 1; f <= faces_.Extent(); ++f) measure_face(f);
      for (int e = 1; e <= edges_.Extent(); ++e) measure_edge(e);
      if (worst_ <= fineness_.chord()) return;
      if (attempt == kAttempts) {
        throw InputError(cad_subject(shape_) + "facets of " + worst_at_ + " stay up to " + std::to_string(worst_) +
                         " away from it, more than the chord: give a larger chord, or repair the part where it "
                         "was made");
      }
      parameters.Deflection *= std::max(0.1, 0.9 * fineness_.chord() / worst_);
      parameters.Deflection = std::max(parameters.Deflection, Precision::Confusion());
    }
  }

  void note_distance(double distance, const std::string& at) {
    if (!(distance > worst_)) return;
    worst_ = distance;
    worst_at_ = at;
  }

  void measure_face(int f) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face(f), location);
    if (mesh.IsNull() || !mesh->HasUVNodes()) return;  // add_face tells
    const BRepAdaptor_Surface surface(face(f), false);
    if (surface.GetType() == GeomAbs_Plane) return;
    fineness_.check_facets(mesh->NbTriangles());
    const std::set<int> poles = pole_nodes(face(f), mesh, location);
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
      int n[3];
      mesh->Triangle(t).Get(n[0], n[1], n[2]);
      gp_Pnt p[3];
      gp_XY uv[3];
      for (int k = 0; k < 3; ++k) {
        p[k] = mesh->Node(n[k]).Transformed(location);
        uv[k] = mesh->UVNode(n[k]).XY();
      }
      for (int k = 0; k < 3; ++k) {
        if (!poles.contains(n[k])) continue;
        const gp_XY middle = (uv[(k + 1) % 3] + uv[(k + 2) % 3]) / 2;
        if (free_parameter(surface, uv[k]) == 0) uv[k].SetX(middle.X());
        else uv[k].SetY(middle.Y());
      }
      gp_Vec normal = gp_Vec(p[0], p[1]).Crossed(gp_Vec(p[0], p[2]));
      if (normal.Magnitude() == 0) continue;
      normal.Normalize();
      const gp_XY at[] = {(uv[0] + uv[1] + uv[2]) / 3, (uv[0] + uv[1]) / 2, (uv[1] + uv[2]) / 2,
                          (uv[2] + uv[0]) / 2};
      for (const gp_XY& x : at) {
        note_distance(std::abs(gp_Vec(p[0], surface.Value(x.X(), x.Y())).Dot(normal)), face_name(f));
      }
    }
  }

  /// Nodes of a face that are on its edges without length.
  static std::set<int> pole_nodes(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh,
                                  const TopLoc_Location& location) {
    std::set<int> nodes;
    for (TopExp_Explorer part(face, TopAbs_EDGE); part.More(); part.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(part.Current());
      if (!BRep_Tool::Degenerated(edge)) continue;
      const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
      for (int i = 1; !polygon.IsNull() && i <= polygon->NbNodes(); ++i) nodes.insert(polygon->Node(i));
    }
    return nodes;
  }

  /// The parameter that may have any value at a pole: 0 for u, 1 for v.
  static std::uint8_t free_parameter(const BRepAdaptor_Surface& surface, const gp_XY& uv) {
    gp_Pnt p;
    gp_Vec along_u, along_v;
    surface.D1(uv.X(), uv.Y(), p, along_u, along_v);
    return along_u.SquareMagnitude() < along_v.SquareMagnitude() ? 0 : 1;
  }

  void measure_edge(int e) {
    const TopoDS_Edge edge = TopoDS::Edge(edges_(e));
    TopLoc_Location location;
    const Handle(Poly_Polygon3D) polygon = BRep_Tool::Polygon3D(edge, location);
    Handle(Poly_PolygonOnTriangulation) on_face;
    Handle(Poly_Triangulation) mesh;
    if (polygon.IsNull()) BRep_Tool::PolygonOnTriangulation(edge, on_face, mesh, location);
    if (polygon.IsNull() ? on_face.IsNull() || !on_face->HasParameters() : !polygon->HasParameters()) return;
    if (BRep_Tool::Degenerated(edge)) return;
    const BRepAdaptor_Curve curve(edge);
    const int count = polygon.IsNull() ? on_face->NbNodes() : polygon->NbNodes();
    const auto point = [&](int i) {
      return (polygon.IsNull() ? mesh->Node(on_face->Node(i)) : polygon->Nodes()(i)).Transformed(location);
    };
    const auto parameter = [&](int i) {
      return polygon.IsNull() ? on_face->Parameter(i) : polygon->Parameters()(i);
    };
    for (int i = 1; i < count; ++i) {
      const gp_Pnt a = point(i), b = point(i + 1);
      const double length = a.Distance(b);
      const gp_Vec off(a, curve.Value((parameter(i) + parameter(i + 1)) / 2));
      note_distance(length == 0 ? off.Magnitude() : off.Crossed(gp_Vec(a, b)).Magnitude() / length, edge_name(e));
    }
  }

  // --- points

  Index add_point(const gp_Pnt& p) {
    model_.points.push_back({p.X(), p.Y(), p.Z()});
    return static_cast<Index>(model_.points.size() - 1);
  }

  void add_vertices() {
    for (int v = 1; v <= vertices_.Extent(); ++v) {
      model_.vertices.push_back({add_point(BRep_Tool::Pnt(TopoDS::Vertex(vertices_(v)))), false});
    }
  }

  /// The vertex at an end of an edge, as a number of the model.
  Index end(int e, bool last) const {
    const TopoDS_Edge edge = TopoDS::Edge(edges_(e).Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex vertex = last ? TopExp::LastVertex(edge) : TopExp::FirstVertex(edge);
    const int v = vertex.IsNull() ? 0 : vertices_.FindIndex(vertex);
    if (v == 0) {
      throw InputError(cad_subject(shape_) + edge_name(e) +
                       " has no vertex at its end: repair it where it was made");
    }
    return model_.vertices[static_cast<std::size_t>(v) - 1].point;
  }

  /// Points of an edge, made when it is first met: `count` in all, `point(i)` inside, `parameter(i)` everywhere.
  template <class Point, class Parameter>
  void take_edge(int e, int count, Point point, Parameter parameter) {
    CadModel::Edge& edge = model_.edges[static_cast<std::size_t>(e) - 1];
    for (int i = 1; i <= count; ++i) {
      edge.points.push_back(i == 1 ? end(e, false) : i == count ? end(e, true) : add_point(point(i)));
      edge.parameters.push_back(parameter(i));
    }
  }

  void add_face(int f) {
    CadModel::Face& result = model_.faces.emplace_back();
    result.surface = surface_of(TopoDS::Face(faces_(f)));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face(f), location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0 || !mesh->HasUVNodes()) {
      throw InputError(cad_subject(shape_) + "OpenCASCADE cannot mesh " + face_name(f) +
                       ": give another `chord` or "
                       "`segments`, or repair the face where it was made");
    }
    std::vector<Index> number(static_cast<std::size_t>(mesh->NbNodes()) + 1, kNone);
    const auto point = [&](int node) { return mesh->Node(node).Transformed(location); };
    const bool reversed = faces_(f).Orientation() == TopAbs_REVERSED;
    for (TopExp_Explorer part(face(f), TopAbs_EDGE); part.More(); part.Next()) {
      add_border(f, TopoDS::Edge(part.Current()), mesh, location, number, reversed);
    }
    for (TopExp_Explorer part(face(f), TopAbs_VERTEX, TopAbs_EDGE); part.More(); part.Next()) {
      const TopoDS_Vertex vertex = TopoDS::Vertex(part.Current());
      const gp_Pnt at = BRep_Tool::Pnt(vertex);
      int nearest = 1;
      for (int n = 2; n <= mesh->NbNodes(); ++n) {
        if (point(n).SquareDistance(at) < point(nearest).SquareDistance(at)) nearest = n;
      }
      if (point(nearest).Distance(at) > BRep_Tool::Tolerance(vertex)) continue;
      number[static_cast<std::size_t>(nearest)] =
          model_.vertices[static_cast<std::size_t>(vertices_.FindIndex(vertex)) - 1].point;
    }
    const BRepAdaptor_Surface surface(face(f), false);
    const std::set<int> poles = pole_nodes(face(f), mesh, location);
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
      int n[3];
      mesh->Triangle(t).Get(n[0], n[1], n[2]);
      if (reversed) std::swap(n[1], n[2]);
      auto& corners = result.triangles.emplace_back();
      CadModel::Place& place = result.places.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        Index& p = number[static_cast<std::size_t>(n[k])];
        if (p == kNone) p = add_point(point(n[k]));
        corners[k] = p;
        const gp_XY uv = mesh->UVNode(n[k]).XY();
        place.at[k] = {uv.X(), uv.Y()};
        if (!poles.contains(n[k])) continue;
        place.pole = static_cast<std::uint8_t>(k);
        place.free = free_parameter(surface, uv);
      }
    }
  }

  /// The nodes of a face on one of its edges get the numbers of the edge's points.
  void add_border(int f, const TopoDS_Edge& part, const Handle(Poly_Triangulation) & mesh,
                  const TopLoc_Location& location, std::vector<Index>& number, bool reversed) {
    const int e = edges_.FindIndex(part);
    const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(part, mesh, location);
    if (polygon.IsNull()) {
      throw InputError(cad_subject(shape_) + "OpenCASCADE cannot mesh " + face_name(f) + " along " + edge_name(e) +
                       ": give another `chord` or `segments`, or repair the face where it was made");
    }
    const int count = polygon->NbNodes();
    CadModel::Edge& edge = model_.edges[static_cast<std::size_t>(e) - 1];
    if (BRep_Tool::Degenerated(part)) {
      edge.points = {end(e, false)};
      edge.parameters = {0};
      for (int i = 1; i <= count; ++i) number[static_cast<std::size_t>(polygon->Node(i))] = edge.points[0];
      return;
    }
    if (edge.points.empty()) {
      take_edge(
          e, count, [&](int i) { return mesh->Node(polygon->Node(i)).Transformed(location); },
          [&](int i) { return polygon->HasParameters() ? polygon->Parameter(i) : i - 1.0; });
    }
    if (edge.points.size() != static_cast<std::size_t>(count)) {
      throw InputError(cad_subject(shape_) + edge_name(e) + " is cut into " +
                       std::to_string(edge.points.size() - 1) + " segments and, for " + face_name(f) + ", into " +
                       std::to_string(count - 1) + ": repair the edge where it was made");
    }
    for (int i = 1; i <= count; ++i) {
      number[static_cast<std::size_t>(polygon->Node(i))] = edge.points[static_cast<std::size_t>(i) - 1];
    }
    auto& border = model_.faces.back().border;
    const TopAbs_Orientation way = part.Orientation();
    if (way == TopAbs_FORWARD || way == TopAbs_REVERSED) {
      border.emplace_back(static_cast<Index>(e) - 1, (way == TopAbs_FORWARD) != reversed);
    } else {
      border.emplace_back(static_cast<Index>(e) - 1, true);
      border.emplace_back(static_cast<Index>(e) - 1, false);
    }
  }

  /// Edges of no face.
  void complete_edge(int e) {
    if (!model_.edges[static_cast<std::size_t>(e) - 1].points.empty()) return;
    TopLoc_Location location;
    const Handle(Poly_Polygon3D) polygon = BRep_Tool::Polygon3D(TopoDS::Edge(edges_(e)), location);
    if (polygon.IsNull()) {
      throw InputError(cad_subject(shape_) + "OpenCASCADE cannot cut " + edge_name(e) +
                       " into segments: repair it where it was made");
    }
    take_edge(
        e, polygon->NbNodes(), [&](int i) { return polygon->Nodes()(i).Transformed(location); },
        [&](int i) { return polygon->HasParameters() ? polygon->Parameters()(i) : i - 1.0; });
  }

  // --- what belongs together

  void mark_seams() {
    const auto is_seam = [&](const TopoDS_Shape& shape) {
      const TopoDS_Edge edge = TopoDS::Edge(shape);
      if (BRep_Tool::Degenerated(edge)) return true;
      const int i = faces_at_.FindIndex(edge);
      return i > 0 && faces_at_(i).Extent() == 1 && BRep_Tool::IsClosed(edge, TopoDS::Face(faces_at_(i).First()));
    };
    for (int e = 1; e <= edges_.Extent(); ++e)
      model_.edges[static_cast<std::size_t>(e) - 1].seam = is_seam(edges_(e));
    for (int v = 1; v <= vertices_.Extent(); ++v) {
      const int i = edges_at_.FindIndex(vertices_(v));
      bool seam = i > 0 && !edges_at_(i).IsEmpty();
      if (seam) {
        for (const TopoDS_Shape& edge : edges_at_(i)) seam = seam && is_seam(edge);
      }
      model_.vertices[static_cast<std::size_t>(v) - 1].seam = seam;
    }
  }

  void add_solids() {
    model_.solids.resize(static_cast<std::size_t>(solids_.Extent()));
    for (const auto& [solid, name] : file_.solids) {
      const int s = solids_.FindIndex(solid);
      if (s > 0) model_.solids[static_cast<std::size_t>(s) - 1] = name;
    }
    for (int s = 1; s <= solids_.Extent(); ++s) {
      for (TopExp_Explorer part(solids_(s), TopAbs_FACE); part.More(); part.Next()) {
        const TopAbs_Orientation way = part.Current().Orientation();
        if (way != TopAbs_FORWARD && way != TopAbs_REVERSED) continue;
        const int f = faces_.FindIndex(part.Current());
        CadModel::Face& face = model_.faces[static_cast<std::size_t>(f) - 1];
        const bool outward = (way == TopAbs_REVERSED) == (faces_(f).Orientation() == TopAbs_REVERSED);
        (outward ? face.behind : face.before).push_back(static_cast<Index>(s) - 1);
      }
    }
    for (TopExp_Explorer part(file_.shape, TopAbs_FACE, TopAbs_SOLID); part.More(); part.Next()) {
      model_.faces[static_cast<std::size_t>(faces_.FindIndex(part.Current())) - 1].outside = true;
    }
  }

  const CadShape& shape_;
  const CadFile& file_;
  Fineness fineness_;
  TopTools_IndexedMapOfShape solids_, faces_, edges_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_at_, edges_at_;
  CadModel model_;
  double worst_ = 0;
  std::string worst_at_;
};

}  // namespace

CadModel tessellate(const CadShape& shape, const CadFile& file) { return Tessellator(shape, file).run(); }

}  // namespace cnrg::occt
