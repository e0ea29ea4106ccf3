// From what is laid out to OpenCASCADE's shapes; see the header.
//
// A shape is oriented against what it is made of: a face is made with the side of S_u x S_v as its front and
// turned around where the front of the result is the other one; a region uses it so that normals point out of it.
#include "csg/exports/occt_model.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <functional>

#include "kernel/base/error.h"
#include "kernel/base/union_find.h"

namespace cnrg::occt {
namespace {

using Index = CadParts::Index;
constexpr double kLeast = 1e-7;  // the tolerance that OpenCASCADE takes for none
constexpr double kMargin = 1.5;  // what may be between the places of a measurement

class ModelMaker {
 public:
  ModelMaker(const CadParts& parts, const CadLayout& layout, const CadCurves& curves)
      : parts_(parts),
        layout_(layout),
        curves_(curves),
        vertices_(parts.points.size()),
        edges_(layout.pieces().size()) {}

  CadModelMade run(Faceted& failed) {
    for (const LaidFace& face : layout_.faces()) {
      try {
        faces_.push_back(make_face(face));
        continue;
      } catch (const InputError& error) {
        give_up(face, failed, error.what());
      } catch (const Standard_Failure& failure) {
        give_up(face, failed, std::string("OpenCASCADE fails with ") + failure.DynamicType()->Name());
      }
      faces_.emplace_back();
    }
    if (!failed.empty()) return made_;
    add_solids();
    add_sheets();
    add_wires();
    add_points();
    TopoDS_Compound whole;
    builder_.MakeCompound(whole);
    for (const CadPart& part : made_.parts) builder_.Add(whole, part.shape);
    BRepLib::UpdateTolerances(whole, false);
    made_.whole = whole;
    check(failed);
    made_.moved = curves_.moved();
    made_.farthest = curves_.farthest();
    return made_;
  }

 private:
  const CadParts& parts_;
  const CadLayout& layout_;
  const CadCurves& curves_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
  std::vector<TopoDS_Face> faces_;  // with the front of the result
  CadModelMade made_;

  static void give_up(const LaidFace& face, Faceted& failed, const std::string& why) {
    if (face.chart->flat()) throw InputError("a flat face cannot be made: " + why);
    failed.emplace(face.source, why);
  }

  const TopoDS_Vertex& vertex(Index p) {
    if (vertices_[p].IsNull()) {
      const CadPoint& at = curves_.point(p);
      builder_.MakeVertex(vertices_[p], gp_Pnt(at[0], at[1], at[2]), kLeast);
    }
    return vertices_[p];
  }

  void widen(Index p, const gp_Pnt& to) {
    const double gap = BRep_Tool::Pnt(vertex(p)).Distance(to);
    if (gap > kLeast / 2) builder_.UpdateVertex(vertex(p), 1.01 * gap);
  }

  const TopoDS_Edge& edge(Index number) {
    TopoDS_Edge& made = edges_[number];
    if (!made.IsNull()) return made;
    const Piece& piece = layout_.pieces()[number];
    const EdgeCurve& curve = curves_.curve(number);
    const Index a = piece.points.front(), b = piece.points.back();
    builder_.MakeEdge(made, curve.curve, std::max(kLeast, kMargin * curve.off));
    builder_.Add(made, vertex(a).Oriented(TopAbs_FORWARD));
    builder_.Add(made, vertex(b).Oriented(TopAbs_REVERSED));
    builder_.Range(made, curve.first, curve.last);
    widen(a, curve.curve->Value(curve.first));
    widen(b, curve.curve->Value(curve.last));
    made_.off_surface = std::max(made_.off_surface, curve.off);
    if (curve.spline) ++made_.splines;
    return made;
  }

  void take(const PlaneCurve& curve, Index piece) {
    made_.off_curve = std::max(made_.off_curve, curve.off);
    if (kMargin * curve.off > kLeast) builder_.UpdateEdge(edges_[piece], kMargin * curve.off);
  }

  TopoDS_Face make_face(const LaidFace& face) {
    const Chart& chart = *face.chart;
    TopoDS_Face made;
    // A copy: an edge has one curve in the parameters of a surface, and other faces on it have another part of
    // them.
    builder_.MakeFace(made, Handle(Geom_Surface)::DownCast(chart.surface()->Copy()), kLeast);
    // Each piece once, with one or two curves in the parameters: of its forward use, of its backward use.
    struct Curves {
      std::optional<PlaneCurve> forward, backward;
    };
    std::map<Index, Curves> in_plane;
    for (const auto& loop : face.loops) {
      for (const PieceUse& use : loop) {
        edge(use.piece);
        if (chart.flat()) continue;
        Curves& of = in_plane[use.piece];
        (use.forward == face.same ? of.forward : of.backward) = curves_.in_plane(face, use);
      }
    }
    for (const auto& [piece, of] : in_plane) {
      if (of.forward) take(*of.forward, piece);
      if (of.backward) take(*of.backward, piece);
      if (of.forward && of.backward)
        builder_.UpdateEdge(edges_[piece], of.forward->curve, of.backward->curve, made, kLeast);
      else builder_.UpdateEdge(edges_[piece], (of.forward ? of.forward : of.backward)->curve, made, kLeast);
    }
    for (const auto& loop : face.loops) add_loop(face, loop, in_plane, made);
    add_inner(face, made);
    for (const Index p : face.isolated) builder_.Add(made, vertex(p).Oriented(TopAbs_INTERNAL));
    return face.same ? made : TopoDS::Face(made.Reversed());
  }

  template <class Curves>
  void add_loop(const LaidFace& face, std::vector<PieceUse> loop, const Curves& in_plane, TopoDS_Face& made) {
    if (!face.same) std::reverse(loop.begin(), loop.end());
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    const auto ends = [&](const PieceUse& use) {
      const bool forward = use.forward == face.same;
      const auto& of = in_plane.at(use.piece);
      const PlaneCurve& curve = forward ? *of.forward : *of.backward;
      return forward ? std::pair(curve.first, curve.last) : std::pair(curve.last, curve.first);
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PieceUse& use = loop[i];
      const bool forward = use.forward == face.same;
      builder_.Add(wire, edges_[use.piece].Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
      if (face.chart->flat()) continue;
      const CadParameters from = ends(use).second, to = ends(loop[(i + 1) % loop.size()]).first;
      const Piece& piece = layout_.pieces()[use.piece];
      const auto slack = face.chart->slack();
      if (std::abs(from[0] - to[0]) <= 100 * slack[0] && std::abs(from[1] - to[1]) <= 100 * slack[1]) continue;
      add_pole(wire, made, forward ? piece.points.back() : piece.points.front(), from, to, *face.chart);
    }
    wire.Closed(true);
    builder_.Add(made, wire);
  }

  /// The jump at a pole, as an edge without length.
  void add_pole(TopoDS_Wire& wire, const TopoDS_Face& face, Index p, const CadParameters& from,
                const CadParameters& to, const Chart& chart) {
    if (!chart.is_free(0, from) && !chart.is_free(1, from))
      throw InputError("its boundary does not close in the parameters of its surface");
    const double way = std::hypot(to[0] - from[0], to[1] - from[1]);
    TopoDS_Edge pole;
    builder_.MakeEdge(pole);
    builder_.Degenerated(pole, true);
    builder_.UpdateEdge(pole,
                        new Geom2d_Line(gp_Pnt2d(from[0], from[1]), gp_Dir2d(to[0] - from[0], to[1] - from[1])),
                        face, kLeast);
    builder_.Range(pole, face, 0, way);
    builder_.Range(pole, 0, way);
    builder_.Add(pole, vertex(p).Oriented(TopAbs_FORWARD));
    builder_.Add(pole, vertex(p).Oriented(TopAbs_REVERSED));
    builder_.Add(wire, pole);
  }

  /// Edges inside of the face, where something else meets it; those that hang together are one wire.
  void add_inner(const LaidFace& face, TopoDS_Face& made) {
    UnionFind sets(face.inner.size());
    std::map<Index, std::uint32_t> at;
    for (std::uint32_t i = 0; i < face.inner.size(); ++i) {
      const std::vector<Index>& points = layout_.pieces()[face.inner[i].piece].points;
      for (const Index end : {points.front(), points.back()}) sets.unite(at.try_emplace(end, i).first->second, i);
    }
    std::map<std::uint32_t, TopoDS_Wire> wires;
    for (std::uint32_t i = 0; i < face.inner.size(); ++i) {
      const Index number = face.inner[i].piece;
      const TopoDS_Edge& of = edge(number);
      if (!face.chart->flat()) {
        const PlaneCurve curve = curves_.in_plane(face, face.inner[i]);
        take(curve, number);
        builder_.UpdateEdge(of, curve.curve, made, kLeast);
      }
      TopoDS_Wire& wire = wires[sets.find(i)];
      if (wire.IsNull()) builder_.MakeWire(wire);
      builder_.Add(wire, of.Oriented(TopAbs_INTERNAL));
    }
    for (const auto& [root, wire] : wires) builder_.Add(made, wire);
  }

  template <class Each>
  void for_each_piece(const LaidFace& face, const Each& each) const {
    for (const auto& loop : face.loops) {
      for (const PieceUse& use : loop) each(use.piece);
    }
    for (const PieceUse& use : face.inner) each(use.piece);
  }

  /// Groups of faces that hang together by edges, each ascending.
  std::vector<std::vector<Index>> connected(const std::vector<Index>& faces) const {
    UnionFind sets(faces.size());
    std::map<Index, std::uint32_t> first;
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
      for_each_piece(layout_.faces()[faces[i]], [&](Index piece) {
        const auto [it, fresh] = first.try_emplace(piece, i);
        if (!fresh) sets.unite(it->second, i);
      });
    }
    std::map<std::uint32_t, std::vector<Index>> groups;
    for (std::uint32_t i = 0; i < faces.size(); ++i) groups[sets.find(i)].push_back(faces[i]);
    std::vector<std::vector<Index>> result;
    for (auto& [root, group] : groups) result.push_back(std::move(group));
    return result;
  }

  TopoDS_Shell shell_of(const std::vector<Index>& faces, const std::function<bool(Index)>& forward) {
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const Index f : faces) builder_.Add(shell, forward(f) ? faces_[f] : faces_[f].Reversed());
    return shell;
  }

  void add_solids() {
    const FlatComplex& flat = parts_.flat;
    std::vector<std::vector<Index>> around(flat.regions.size());  // faces with the region on one side
    for (Index f = 0; f < layout_.faces().size(); ++f) {
      const auto& regions = flat.faces[layout_.faces()[f].source].regions;
      if (regions[0] == regions[1]) continue;
      for (const auto region : regions) {
        if (flat.active(region)) around[region].push_back(f);
      }
    }
    for (Index r = 0; r < flat.regions.size(); ++r) {
      if (!flat.active(r)) continue;
      TopoDS_Solid solid;
      builder_.MakeSolid(solid);
      for (const auto& group : shells_of(r, around[r])) {
        // Normals point out: the front of a face that has the region on its back.
        TopoDS_Shell shell =
            shell_of(group, [&](Index f) { return flat.faces[layout_.faces()[f].source].regions[1] == r; });
        shell.Closed(true);
        builder_.Add(solid, shell);
      }
      made_.parts.push_back({solid, {flat.regions[r].component, FlatComplex::kNone}});
    }
  }

  /// Groups of faces around a region that are closed surfaces. Where the region touches itself along an edge, four
  /// faces or more are there, and a shell may have two of them only. Two boxes that share an edge, cut out of a
  /// block, are two shells: so faces go on across what is not the region, if that parts them, else across it.
  std::vector<std::vector<Index>> shells_of(Index r, const std::vector<Index>& faces) const {
    std::map<Index, std::vector<Index>> at;  // places among the faces, by piece
    for (Index i = 0; i < faces.size(); ++i) {
      for (const auto& loop : layout_.faces()[faces[i]].loops) {
        for (const PieceUse& use : loop) at[use.piece].push_back(i);
      }
    }
    for (const bool through : {false, true}) {
      UnionFind sets(faces.size());
      for (const auto& [piece, there] : at) {
        if (there.size() <= 2) sets.unite(there.front(), there.back());
        else
          for (const auto& [a, b] : pairs_at(r, piece, faces, there, through)) sets.unite(a, b);
      }
      std::map<Index, std::vector<Index>> groups;
      for (Index i = 0; i < faces.size(); ++i) groups[sets.find(i)].push_back(faces[i]);
      bool sound = true;
      for (const auto& [piece, there] : at) {
        std::map<Index, int> uses;
        for (const Index i : there) sound = ++uses[sets.find(i)] <= 2 && sound;
      }
      if (!sound && !through) continue;
      if (!sound) {
        throw InputError(
            "a region touches itself along an edge where no two closed shells meet, which a solid of a CAD "
            "model cannot do");
      }
      std::vector<std::vector<Index>> result;
      for (auto& [root, group] : groups) result.push_back(std::move(group));
      return result;
    }
    return {};
  }

  /// Pairs of faces that follow each other around an edge, with the region between them or without it.
  std::vector<std::pair<Index, Index>> pairs_at(Index r, Index piece, const std::vector<Index>& faces,
                                                const std::vector<Index>& there, bool through) const {
    const FlatComplex& flat = parts_.flat;
    std::vector<std::pair<Index, bool>> order;  // faces that bound the region, and if that is before them
    for (const Index side : flat.edges[*layout_.pieces()[piece].edge].around) {
      const auto& regions = flat.faces[side / 2].regions;
      if (regions[0] == regions[1] || (regions[0] != r && regions[1] != r)) continue;
      for (const Index i : there) {
        if (layout_.faces()[faces[i]].source == side / 2) order.emplace_back(i, regions[side % 2] == r);
      }
    }
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto& next = order[(k + 1) % order.size()];
      if (next.second == through) pairs.emplace_back(order[k].first, next.first);
    }
    return pairs;
  }

  void add_sheets() {
    std::map<CadPartOf, std::vector<Index>> sheets;
    for (Index f = 0; f < layout_.faces().size(); ++f) {
      const Index source = layout_.faces()[f].source;
      const FlatComplex::Face& face = parts_.flat.faces[source];
      if (face.component != 0 && parts_.flat.regions_bounded(face) == 0)
        sheets[{face.component, parts_.said_of[2][source]}].push_back(f);
    }
    for (const auto& [of, faces] : sheets) {
      for (const auto& group : connected(faces)) {
        if (group.size() == 1) {
          made_.parts.push_back({faces_[group[0]], of, leaves_of(group)});
        } else if (is_surface(group)) {
          made_.parts.push_back({shell_of(group, [](Index) { return true; }), of, leaves_of(group)});
        } else {
          for (const Index f : group) made_.parts.push_back({faces_[f], of, leaves_of({f})});
        }
      }
    }
  }

  std::set<LeafId> leaves_of(const std::vector<Index>& faces) const {
    std::set<LeafId> result;
    for (const Index f : faces) {
      const auto& leaves = parts_.flat.faces[layout_.faces()[f].source].origin.leaves;
      result.insert(leaves.begin(), leaves.end());
    }
    return result;
  }

  /// True if no edge has more than two of the faces, and two run through it in opposite directions.
  bool is_surface(const std::vector<Index>& faces) const {
    std::map<Index, std::array<int, 2>> uses;
    for (const Index f : faces) {
      for (const auto& loop : layout_.faces()[f].loops) {
        for (const PieceUse& use : loop) ++uses[use.piece][use.forward ? 0 : 1];
      }
      for (const PieceUse& use : layout_.faces()[f].inner) {
        ++uses[use.piece][0];
        ++uses[use.piece][1];
      }
    }
    return std::all_of(uses.begin(), uses.end(),
                       [](const auto& u) { return u.second[0] <= 1 && u.second[1] <= 1; });
  }

  /// Lines of wires, from where they end or branch.
  void add_wires() {
    const FlatComplex& flat = parts_.flat;
    std::map<Index, std::vector<Index>> at;  // wire pieces by point
    std::vector<Index> wires;
    std::map<Index, CadPartOf> part_of;
    for (Index e = 0; e < flat.edges.size(); ++e) {
      if (!flat.edges[e].wire || flat.edges[e].component == 0) continue;
      for (const Index piece : layout_.pieces_of(e)) {
        wires.push_back(piece);
        part_of[piece] = {flat.edges[e].component, parts_.said_of[1][e]};
        at[layout_.pieces()[piece].points.front()].push_back(piece);
        at[layout_.pieces()[piece].points.back()].push_back(piece);
      }
    }
    std::set<Index> done;
    const auto ends_at = [&](Index p) {
      const auto& there = at.at(p);
      return there.size() != 2 || part_of.at(there[0]) != part_of.at(there[1]);
    };
    const auto follow = [&](Index piece, Index from) {
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      const CadPartOf of = part_of.at(piece);
      std::set<LeafId> leaves;
      const Index begin = from;
      while (done.insert(piece).second) {
        const std::vector<Index>& points = layout_.pieces()[piece].points;
        const bool forward = points.front() == from;
        builder_.Add(wire, edge(piece).Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
        const auto& from_leaves = flat.edges[*layout_.pieces()[piece].edge].origin.leaves;
        leaves.insert(from_leaves.begin(), from_leaves.end());
        from = forward ? points.back() : points.front();
        if (ends_at(from)) break;
        piece = at.at(from)[0] == piece ? at.at(from)[1] : at.at(from)[0];
      }
      wire.Closed(from == begin);
      made_.parts.push_back({wire, of, leaves});
    };
    for (const bool from_end : {true, false}) {
      for (const Index piece : wires) {
        const std::vector<Index>& points = layout_.pieces()[piece].points;
        for (const Index end : {points.front(), points.back()}) {
          if (done.count(piece) == 0 && (!from_end || ends_at(end))) follow(piece, end);
        }
      }
    }
  }

  void add_points() {
    std::map<std::pair<CadPartOf, std::vector<LeafId>>, TopoDS_Compound> points;
    for (Index v = 0; v < parts_.flat.vertices.size(); ++v) {
      const FlatComplex::Vertex& of = parts_.flat.vertices[v];
      if (!of.free || of.component == 0 || !of.own) continue;
      const CadPartOf part{of.component, parts_.said_of[0][v]};
      TopoDS_Compound& all = points[{part, {of.origin.leaves.begin(), of.origin.leaves.end()}}];
      if (all.IsNull()) builder_.MakeCompound(all);
      builder_.Add(all, vertex(of.point));
    }
    for (const auto& [key, all] : points)
      made_.parts.push_back({all, key.first, {key.second.begin(), key.second.end()}});
  }

  void check(Faceted& failed) const {
    const BRepCheck_Analyzer analyzer(made_.whole);
    if (analyzer.IsValid()) return;
    bool flat = false;
    for (Index f = 0; f < faces_.size(); ++f) {
      if (BRepCheck_Analyzer(faces_[f]).IsValid()) continue;
      const LaidFace& face = layout_.faces()[f];
      if (face.chart->flat()) flat = true;
      else failed.emplace(face.source, "OpenCASCADE's check finds it wrong (" + words(analyzer, faces_[f]) + ")");
    }
    if (!failed.empty()) return;
    std::string what;
    for (const CadPart& part : made_.parts) {
      if (BRepCheck_Analyzer(part.shape).IsValid()) continue;
      what = words(analyzer, part.shape);
      break;
    }
    throw InputError(std::string("OpenCASCADE's check finds ") + (flat ? "a flat face" : "a solid or sheet") +
                     " wrong (" + what + ")");
  }

  /// The complaints about a shape and its parts.
  static std::string words(const BRepCheck_Analyzer& analyzer, const TopoDS_Shape& shape);
};

std::string ModelMaker::words(const BRepCheck_Analyzer& analyzer, const TopoDS_Shape& shape) {
  static const std::map<BRepCheck_Status, std::string> kWords{
      {BRepCheck_InvalidPointOnCurve, "InvalidPointOnCurve"},
      {BRepCheck_InvalidPointOnCurveOnSurface, "InvalidPointOnCurveOnSurface"},
      {BRepCheck_InvalidPointOnSurface, "InvalidPointOnSurface"},
      {BRepCheck_No3DCurve, "No3DCurve"},
      {BRepCheck_Multiple3DCurve, "Multiple3DCurve"},
      {BRepCheck_Invalid3DCurve, "Invalid3DCurve"},
      {BRepCheck_NoCurveOnSurface, "NoCurveOnSurface"},
      {BRepCheck_InvalidCurveOnSurface, "InvalidCurveOnSurface"},
      {BRepCheck_InvalidCurveOnClosedSurface, "InvalidCurveOnClosedSurface"},
      {BRepCheck_InvalidSameRangeFlag, "InvalidSameRangeFlag"},
      {BRepCheck_InvalidSameParameterFlag, "InvalidSameParameterFlag"},
      {BRepCheck_InvalidDegeneratedFlag, "InvalidDegeneratedFlag"},
      {BRepCheck_FreeEdge, "FreeEdge"},
      {BRepCheck_InvalidMultiConnexity, "InvalidMultiConnexity"},
      {BRepCheck_InvalidRange, "InvalidRange"},
      {BRepCheck_EmptyWire, "EmptyWire"},
      {BRepCheck_RedundantEdge, "RedundantEdge"},
      {BRepCheck_SelfIntersectingWire, "SelfIntersectingWire"},
      {BRepCheck_NoSurface, "NoSurface"},
      {BRepCheck_InvalidWire, "InvalidWire"},
      {BRepCheck_RedundantWire, "RedundantWire"},
      {BRepCheck_IntersectingWires, "IntersectingWires"},
      {BRepCheck_InvalidImbricationOfWires, "InvalidImbricationOfWires"},
      {BRepCheck_EmptyShell, "EmptyShell"},
      {BRepCheck_RedundantFace, "RedundantFace"},
      {BRepCheck_InvalidImbricationOfShells, "InvalidImbricationOfShells"},
      {BRepCheck_NotClosed, "NotClosed"},
      {BRepCheck_NotConnected, "NotConnected"},
      {BRepCheck_SubshapeNotInShape, "SubshapeNotInShape"},
      {BRepCheck_BadOrientation, "BadOrientation"},
      {BRepCheck_BadOrientationOfSubshape, "BadOrientationOfSubshape"},
      {BRepCheck_InvalidPolygonOnTriangulation, "InvalidPolygonOnTriangulation"},
      {BRepCheck_InvalidToleranceValue, "InvalidToleranceValue"},
      {BRepCheck_EnclosedRegion, "EnclosedRegion"},
      {BRepCheck_CheckFail, "CheckFail"}};
  std::set<std::string> said;
  const auto take = [&](const BRepCheck_ListOfStatus& list) {
    for (const BRepCheck_Status status : list) {
      // The last one says only that there are others.
      if (status != BRepCheck_NoError && status != BRepCheck_UnorientableShape) said.insert(kWords.at(status));
    }
  };
  const std::function<void(const TopoDS_Shape&)> search = [&](const TopoDS_Shape& of) {
    const Handle(BRepCheck_Result)& found = analyzer.Result(of);
    if (!found.IsNull()) {
      take(found->Status());
      for (found->InitContextIterator(); found->MoreShapeInContext(); found->NextShapeInContext())
        take(found->StatusOnShape());
    }
    for (TopoDS_Iterator part(of); part.More(); part.Next()) search(part.Value());
  };
  search(shape);
  std::string result;
  for (const std::string& words : said) result += (result.empty() ? "" : ", ") + words;
  return result.empty() ? "UnorientableShape" : result;
}

}  // namespace

CadModelMade make_model(const CadParts& parts, const Faceted& faceted, double tolerance, Faceted& failed) {
  const CadLayout layout(parts, faceted, failed);
  if (!failed.empty()) return {};
  const CadCurves curves(parts, layout, tolerance, failed);
  if (!failed.empty()) return {};
  return ModelMaker(parts, layout, curves).run(failed);
}

}  // namespace cnrg::occt
