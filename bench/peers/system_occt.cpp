// OpenCASCADE: one General Fuse of all operands (BOPAlgo_CellsBuilder), from whose parts the fold is selected.
//
// CellsBuilder is what OpenCASCADE has for Booleans of mixed dimension: BRepAlgoAPI's operators refuse most of
// them. Parts have the dimension of their argument; what two arguments have in common of lower dimension than both
// is no part. Shapes share vertices and edges as the model does, so nothing is sewn. OpenCASCADE's tolerance is
// 10^-7, whatever the unit.
#include <BOPAlgo_CellsBuilder.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <map>
#include <sstream>

#include "bench/cases/face_loops.h"
#include "bench/peers/built_in.h"
#include "bench/peers/triangles.h"
#include "kernel/base/error.h"
#include "kernel/base/union_find.h"

namespace cnrg::bench {
namespace {

constexpr int kMaterial = 1;  // parts of one material are joined in the end

// --- operands

/// The arguments of the General Fuse that together are one operand: each solid, then all of one lower dimension.
using Arguments = std::vector<TopoDS_Shape>;

class ArgumentMaker {
 public:
  explicit ArgumentMaker(const Model& model) : model_(model), vertices_(model.points.size()) {}

  Arguments run() {
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
  Arguments arguments_;
};

// --- operations

TopTools_ListOfShape list_of(const Arguments& arguments) {
  TopTools_ListOfShape list;
  for (const TopoDS_Shape& shape : arguments) list.Append(shape);
  return list;
}

/// The first line of what the algorithm reports.
template <class Dump>
std::string first_line(Dump dump) {
  std::stringstream text;
  dump(text);
  std::string line;
  std::getline(text, line);
  return line;
}

void require_no_errors(const BOPAlgo_CellsBuilder& fuse, const char* stage) {
  if (!fuse.HasErrors()) return;
  throw Refusal(stage, first_line([&](std::ostream& out) { fuse.DumpErrors(out); }));
}

/// The parts that are in all of `in` and in none of `out`.
struct Term {
  Arguments in, out;
};

/// The fold as a union of terms. A part of a surface is in a solid that it lies inside of, so it is terms that say
/// what belongs to an intersection, and not the parts of its operands.
std::vector<Term> terms_of(const Problem& problem, const std::vector<Arguments>& operands) {
  std::vector<Term> terms;
  for (const TopoDS_Shape& a : operands[0]) terms.push_back({{a}, {}});
  for (std::size_t i = 0; i < problem.steps.size(); ++i) {
    const Arguments& right = operands[i + 1];
    if (problem.steps[i] == Operation::unite) {
      for (const TopoDS_Shape& b : right) terms.push_back({{b}, {}});
    } else if (problem.steps[i] == Operation::subtract) {
      for (Term& term : terms) term.out.insert(term.out.end(), right.begin(), right.end());
    } else {
      std::vector<Term> both;
      for (const Term& term : terms)
        for (const TopoDS_Shape& b : right) both.emplace_back(term).in.push_back(b);
      terms = std::move(both);
    }
  }
  return terms;
}

void select_parts(BOPAlgo_CellsBuilder& fuse, const std::vector<Term>& terms) {
  for (const Term& term : terms) fuse.AddToResult(list_of(term.in), list_of(term.out), kMaterial);
  fuse.RemoveInternalBoundaries();
}

// --- results

class OcctModelMaker {
 public:
  explicit OcctModelMaker(const TopoDS_Shape& shape) : shape_(shape) {}

  Model run() {
    for (TopExp_Explorer solids(shape_, TopAbs_SOLID); solids.More(); solids.Next()) {
      cover(solids.Current());  // also what hangs inside of it
      for (TopExp_Explorer faces(solids.Current(), TopAbs_FACE); faces.More(); faces.Next())
        take_side(faces.Current());
    }
    for (const TopoDS_Shape& face : sides_) {
      if (side_count_(face) == 1) add_face(TopoDS::Face(face), true);
    }
    for (const TopoDS_Shape& face : of_type(TopAbs_FACE))
      if (!in_solid_.Contains(face)) add_face(TopoDS::Face(face), false);
    for (const TopoDS_Shape& edge : of_type(TopAbs_EDGE))
      if (!covered_.Contains(edge)) add_wire(TopoDS::Edge(edge));
    for (const TopoDS_Shape& vertex : of_type(TopAbs_VERTEX))
      if (!covered_.Contains(vertex)) model_.isolated.push_back(number(TopoDS::Vertex(vertex)));
    return std::move(model_);
  }

 private:
  /// Each once.
  std::vector<TopoDS_Shape> of_type(TopAbs_ShapeEnum type) const {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(shape_, type, shapes);
    std::vector<TopoDS_Shape> list;
    for (int i = 1; i <= shapes.Extent(); ++i) list.push_back(shapes(i));
    return list;
  }

  void cover(const TopoDS_Shape& shape) {
    for (const TopAbs_ShapeEnum type : {TopAbs_EDGE, TopAbs_VERTEX})
      for (TopExp_Explorer parts(shape, type); parts.More(); parts.Next()) covered_.Add(parts.Current());
  }

  /// A face with solids on both sides is none of the boundary.
  void take_side(const TopoDS_Shape& face) {
    in_solid_.Add(face);
    if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) return;
    sides_.push_back(face);
    if (side_count_.IsBound(face)) ++side_count_(face);
    else side_count_.Bind(face, 1);
  }

  std::uint32_t number(const TopoDS_Vertex& vertex) {
    const int index = numbers_.FindIndex(vertex);
    if (index > 0) return static_cast<std::uint32_t>(index - 1);
    numbers_.Add(vertex);
    const gp_Pnt p = BRep_Tool::Pnt(vertex);
    RationalPoint& point = model_.points.emplace_back();
    for (int k = 0; k < 3; ++k) point[k] = from_double(p.Coord(k + 1));
    return static_cast<std::uint32_t>(model_.points.size() - 1);
  }

  std::array<std::uint32_t, 2> ends(const TopoDS_Edge& edge) {
    const std::uint32_t from = number(TopExp::FirstVertex(edge, Standard_True));
    return {from, number(TopExp::LastVertex(edge, Standard_True))};
  }

  /// Closed walks of the face's sides, to its left as seen from the surface's front.
  std::vector<PointLoop> walks(const TopoDS_Shape& forward_face) {
    std::multimap<std::uint32_t, std::uint32_t> next;
    for (TopExp_Explorer edges(forward_face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
      const auto [from, to] = ends(edge);
      if (from != to) next.emplace(from, to);
    }
    std::vector<PointLoop> found;
    while (!next.empty()) {
      PointLoop& walk = found.emplace_back();
      const std::uint32_t start = next.begin()->first;
      std::uint32_t at = start;
      do {
        const auto side = next.find(at);
        if (side == next.end()) throw Refusal("output", "a face of the result is not closed");
        walk.push_back(at);
        at = side->second;
        next.erase(side);
      } while (at != start);
    }
    return found;
  }

  /// Coordinates are rounded, so faces are given in triangles.
  void add_face(const TopoDS_Face& face, bool solid) {
    cover(face);
    const Model::Face polygon{walks(face.Oriented(TopAbs_FORWARD)), solid};
    for (auto [a, b, c] : triangles_of(model_.points, polygon)) {
      if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
      model_.faces.push_back({{{a, b, c}}, solid});
    }
  }

  void add_wire(const TopoDS_Edge& edge) {
    cover(edge);
    model_.wires.push_back(ends(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD))));
  }

  const TopoDS_Shape& shape_;
  TopTools_IndexedMapOfShape numbers_;
  TopTools_MapOfShape in_solid_, covered_;
  std::vector<TopoDS_Shape> sides_;
  TopTools_DataMapOfShapeInteger side_count_;
  Model model_;
};

/// Runs a stage; what OpenCASCADE throws there is a refusal.
template <class Work>
auto guarded_occt(const char* stage, Work work) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    const std::string words = failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
    throw Refusal(stage, std::string(failure.DynamicType()->Name()) + (words.empty() ? "" : ": " + words));
  }
}

Answer answer_of_occt(const Problem& problem) {
  Measurement measurement;
  std::vector<Arguments> operands;
  guarded_occt("input", [&] {
    for (const Model& operand : problem.operands) operands.push_back(ArgumentMaker(operand).run());
  });
  measurement.lap("conversion");
  BOPAlgo_CellsBuilder fuse;
  fuse.SetNonDestructive(true);
  guarded_occt("General Fuse", [&] {
    for (const Arguments& arguments : operands)
      for (const TopoDS_Shape& argument : arguments) fuse.AddArgument(argument);
    fuse.Perform();
  });
  require_no_errors(fuse, "General Fuse");
  measurement.lap("General Fuse");
  guarded_occt("parts", [&] { select_parts(fuse, terms_of(problem, operands)); });
  require_no_errors(fuse, "parts");
  measurement.lap("parts");

  Answer answer;
  answer.measures = measurement.stop();
  if (fuse.HasWarnings()) answer.note = first_line([&](std::ostream& out) { fuse.DumpWarnings(out); });
  guarded_occt("output", [&] {
    try {
      answer.model = OcctModelMaker(fuse.Shape()).run();
    } catch (const InvariantError&) {
      throw Refusal("output", "a face of the result crosses itself");
    }
  });
  return answer;
}

}  // namespace

System occt_system() {
  return {.name = "occt",
          .title = "OpenCASCADE",
          .guarantee =
              "solids, surfaces, wires, points; doubles, a tolerance of 1e-7; parts of an operand's dimension",
          .version = [] { return std::string("OpenCASCADE ") + OCC_VERSION_COMPLETE; },
          .rounding = 1e-7,
          .regularized = false,
          .absent = "",
          .evaluate = answer_of_occt};
}

}  // namespace cnrg::bench
