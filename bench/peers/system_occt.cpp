// OpenCASCADE: one General Fuse of all operands (BOPAlgo_CellsBuilder), from whose parts the fold is selected.
//
// CellsBuilder is what OpenCASCADE has for Booleans of mixed dimension: BRepAlgoAPI's operators refuse most of
// them. Parts have the dimension of their argument; what two arguments have in common of lower dimension than both
// is no part. Shapes share vertices and edges as the model does, so nothing is sewn. OpenCASCADE's tolerance is
// 10^-7, whatever the unit.
#include <BOPAlgo_CellsBuilder.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <map>

#include "bench/cases/face_loops.h"
#include "bench/peers/built_in.h"
#include "bench/peers/occt_arguments.h"
#include "bench/peers/triangles.h"
#include "kernel/base/error.h"

namespace cnrg::bench {
namespace {

constexpr int kMaterial = 1;  // parts of one material are joined in the end

// --- operations

TopTools_ListOfShape list_of(const OcctArguments& arguments) {
  TopTools_ListOfShape list;
  for (const TopoDS_Shape& shape : arguments) list.Append(shape);
  return list;
}

/// The parts that are in all of `in` and in none of `out`.
struct Term {
  OcctArguments in, out;
};

/// The fold as a union of terms. A part of a surface is in a solid that it lies inside of, so it is terms that say
/// what belongs to an intersection, and not the parts of its operands.
std::vector<Term> terms_of(const Problem& problem, const std::vector<OcctArguments>& operands) {
  std::vector<Term> terms;
  for (const TopoDS_Shape& a : operands[0]) terms.push_back({{a}, {}});
  for (std::size_t i = 0; i < problem.steps.size(); ++i) {
    const OcctArguments& right = operands[i + 1];
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

Answer answer_of_occt(const Problem& problem) {
  Measurement measurement;
  std::vector<OcctArguments> operands;
  guarded_occt("input", [&] {
    for (const Model& operand : problem.operands) operands.push_back(occt_arguments(operand));
  });
  measurement.lap("conversion");
  BOPAlgo_CellsBuilder fuse;
  fuse.SetNonDestructive(true);
  guarded_occt("General Fuse", [&] {
    for (const OcctArguments& arguments : operands)
      for (const TopoDS_Shape& argument : arguments) fuse.AddArgument(argument);
    fuse.Perform();
  });
  require_no_occt_errors(fuse, "General Fuse");
  measurement.lap("General Fuse");
  guarded_occt("parts", [&] { select_parts(fuse, terms_of(problem, operands)); });
  require_no_occt_errors(fuse, "parts");
  measurement.lap("parts");

  Answer answer;
  answer.measures = measurement.stop();
  if (fuse.HasWarnings()) answer.note = first_occt_line([&](std::ostream& out) { fuse.DumpWarnings(out); });
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
          .evaluate = answer_of_occt,
          .arrange = arranged_by_occt};
}

}  // namespace cnrg::bench
