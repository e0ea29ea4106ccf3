// Shapes share vertices and edges as the model does, so nothing is sewn.
#include "bench/peers/occt_arguments.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <map>

#include "bench/cases/face_loops.h"
#include "kernel/base/union_find.h"

namespace cnrg::bench {
namespace {

class ArgumentMaker {
 public:
  explicit ArgumentMaker(const Model& model) : model_(model), vertices_(model.points.size()) {}

  OcctArguments run() {
    add_solids();
    TopTools_ListOfShape sheets, wires, points;
    for (const Model::Face& face : model_.faces)
      if (!face.solid) sheets.Append(face_of(face));
    for (const auto& [a, b] : model_.wires) wires.Append(edge(a, b));
    for (const std::uint32_t p : model_.isolated) points.Append(vertex(p));
    for (const TopTools_ListOfShape* list : {&sheets, &wires, &points}) add_compound(*list);
    for (const TopoDS_Shape& argument : arguments_)
      if (!BRepCheck_Analyzer(argument).IsValid()) throw Refusal("input", "BRepCheck: an operand is not valid");
    return std::move(arguments_);
  }

 private:
  struct Shell {
    TopoDS_Shell shape;
    Rational volume = 0;  // six times; negative: a cavity
    std::uint32_t some_point = 0;
  };

  gp_Pnt point(std::uint32_t p) const {
    const RationalPoint& q = model_.points[p];
    return {to_double(q[0]), to_double(q[1]), to_double(q[2])};
  }

  const TopoDS_Vertex& vertex(std::uint32_t p) {
    if (vertices_[p].IsNull()) builder_.MakeVertex(vertices_[p], point(p), Precision::Confusion());
    return vertices_[p];
  }

  /// From the smaller to the greater point.
  TopoDS_Edge edge(std::uint32_t a, std::uint32_t b) {
    TopoDS_Edge& made = edges_[std::minmax(a, b)];
    if (made.IsNull()) {
      BRepBuilderAPI_MakeEdge maker(vertex(std::min(a, b)), vertex(std::max(a, b)));
      if (!maker.IsDone()) throw Refusal("input", "an edge is shorter than the tolerance");
      made = maker.Edge();
    }
    return made;
  }

  TopoDS_Face face_of(const Model::Face& face) {
    const PointLoop& loop = face.loops[0];
    if (face.loops.size() != 1) throw Refusal("input", "a face has holes");
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      builder_.Add(wire, edge(a, b).Oriented(a < b ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
    wire.Closed(true);
    RationalPoint normal = doubled_area(model_.points, loop);
    Rational longest = 0;
    for (const Rational& x : normal) longest = std::max(longest, Rational(abs(x)));
    if (longest == 0) throw Refusal("input", "an operand has a face without area");
    for (Rational& x : normal) x /= longest;
    const gp_Dir direction(to_double(normal[0]), to_double(normal[1]), to_double(normal[2]));
    BRepBuilderAPI_MakeFace maker(gp_Pln(point(loop[0]), direction), wire, Standard_False);
    if (!maker.IsDone()) throw Refusal("input", "a face is not planar");
    return maker.Face();
  }

  /// Faces that are connected by edges are one shell.
  std::vector<Shell> shells() {
    UnionFind pieces(model_.faces.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, int>> sides;  // a face; how many
    for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
      if (!model_.faces[f].solid) continue;
      const PointLoop& loop = model_.faces[f].loops[0];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto key = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
        auto& [first, count] = sides.try_emplace(key, f, 0).first->second;
        ++count;
        pieces.unite(first, f);
      }
    }
    for (const auto& [ends, side] : sides)
      if (side.second != 2) throw Refusal("input", "an operand is no closed 2-manifold");
    std::map<std::uint32_t, Shell> found;
    for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
      const Model::Face& face = model_.faces[f];
      if (!face.solid) continue;
      Shell& shell = found[pieces.find(f)];
      if (shell.shape.IsNull()) builder_.MakeShell(shell.shape);
      builder_.Add(shell.shape, face_of(face));
      shell.volume += dot(doubled_area(model_.points, face.loops[0]), model_.points[face.loops[0][0]]);
      shell.some_point = face.loops[0][0];
    }
    std::vector<Shell> list;
    for (auto& [f, shell] : found) {
      shell.shape.Closed(true);
      list.push_back(std::move(shell));
    }
    return list;
  }

  /// A cavity goes to the smallest solid around it.
  void add_solids() {
    std::vector<Shell> all = shells();
    const auto is_smaller = [](const Shell& a, const Shell& b) { return abs(a.volume) < abs(b.volume); };
    std::stable_sort(all.begin(), all.end(), is_smaller);
    std::vector<TopoDS_Solid> solids;
    for (const Shell& shell : all) {
      if (shell.volume <= 0) continue;
      builder_.MakeSolid(solids.emplace_back());
      builder_.Add(solids.back(), shell.shape);
    }
    const std::vector<TopoDS_Solid> full = solids;
    for (const Shell& shell : all) {
      if (shell.volume > 0) continue;
      std::size_t i = 0;
      while (i < full.size() && !contains(full[i], shell)) ++i;
      if (i == full.size()) throw Refusal("input", "an operand is inside out");
      builder_.Add(solids[i], shell.shape);
    }
    arguments_.insert(arguments_.end(), solids.begin(), solids.end());
  }

  bool contains(const TopoDS_Solid& solid, const Shell& cavity) const {
    BRepClass3d_SolidClassifier classifier(solid, point(cavity.some_point), Precision::Confusion());
    return classifier.State() == TopAbs_IN;
  }

  void add_compound(const TopTools_ListOfShape& shapes) {
    if (shapes.IsEmpty()) return;
    TopoDS_Compound compound;
    builder_.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) builder_.Add(compound, shape);
    arguments_.push_back(compound);
  }

  const Model& model_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, TopoDS_Edge> edges_;
  OcctArguments arguments_;
};

}  // namespace

OcctArguments occt_arguments(const Model& model) { return ArgumentMaker(model).run(); }

}  // namespace cnrg::bench
