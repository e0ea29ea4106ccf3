// A tessellated CAD model as a leaf: its faces as patches, its solids as regions.
//
// Facets of a face have its number, so that a face of the model is one face of the complex, however many facets it
// has. Edges are wires along their segments and vertices isolated points: both lie on faces mostly, where they are
// features (csg/SEMANTICS.md#simplification), so the complex has the edges and vertices of the model and no
// others; each wire knows its edge. Seams are no features unless they are asked for: a cylinder's side is one face
// without a cut.
//
// A leaf whose curved faces lie on one surface with others, of its own solids or of other leaves, is drawn once
// more, by its surfaces (cad_bands.h, cad_draw.h): the model then has other facets, and all that follows stays the
// same.
//
// What the tessellation says of itself is not believed. Points with equal coordinates are made one, then:
//   * the border of a face's facets, as a chain, is the chain of its edges' segments;
//   * the facets of each solid have no border (or it vanishes in space: mesh_boundary.h).
// A face whose points lie on one plane exactly is one polygon with holes, which is its border; any other is its
// triangles. Triangles of zero area have no border in space and are left out.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/surface.h"
#include "csg/geometry/mesh_boundary.h"
#include "csg/imports/cad_draw.h"
#include "csg/imports/cad_model.h"
#include "csg/imports/cad_near.h"
#include "csg/imports/cad_round.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/coplanar.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;

class CadLeaf {
 public:
  explicit CadLeaf(const CadShape& shape) : shape_(shape), model_(read_cad(shape)) {}
  /// One that was drawn anew.
  CadLeaf(CadShape shape, DrawnCad drawn)
      : shape_(std::move(shape)), model_(std::move(drawn.model)), exact_(std::move(drawn.points)) {}

  std::unique_ptr<PreparedLeaf> prepare() {
    require_finite();
    merge_points();
    for (Index f = 0; f < model_.faces.size(); ++f) check_border(f);
    choose();
    round_ = round_faces(model_);
    if (shape_.weld) weld();
    else if (const std::string near = notice_of_near_surfaces(model_); !near.empty())
      model_.notices.push_back(near);
    return finish();
  }
  std::unique_ptr<PreparedLeaf> prepare_drawn() {
    for (Index f = 0; f < model_.faces.size(); ++f) check_border(f);
    return finish();
  }

  /// Bands of the model, if it has curved faces.
  std::optional<CadBands> bands() const {
    CadBands found = bands_of(model_, round_, exact_, Fineness(shape_.name(), shape_.tessellation), shape_.seams);
    if (found.bands.empty()) return std::nullopt;
    return found;
  }
  const CadShape& shape() const { return shape_; }
  DrawnCad draw(const CadBands& bands, const std::vector<BandGrid>& grids, double slack) const {
    return draw_by_bands(model_, exact_, bands, grids, shape_.seams, slack);
  }

  /// The parameters of the facets and wires of the leaf, in their order.
  std::shared_ptr<const LeafParameters> parameters() const {
    auto made = std::make_shared<LeafParameters>();
    for (Index f = 0; f < model_.faces.size(); ++f) {
      const CadModel::Face& face = model_.faces[f];
      made->name_patch(f, face_name(f));
      std::vector<std::vector<PatchCorner>> cells;
      for (std::size_t i = 0; i < face.triangles.size(); ++i) {
        if (!flat(face.triangles[i])) cells.push_back(cell(face.triangles[i], face.places[i]));
      }
      const bool whole = !polygon(face).empty();
      for (std::size_t use = 0; use < uses(f).size(); ++use) {
        if (whole) made->add_facet(cells);
        for (std::size_t i = 0; i < cells.size() && !whole; ++i) made->add_facet(cells[i]);
      }
    }
    for (Index e = 0; e < model_.edges.size(); ++e) {
      const CadModel::Edge& edge = model_.edges[e];
      each_segment(e, [&](std::size_t i) {
        made->add_wire({{value(edge.points[i - 1]), value(edge.points[i])},
                        {from_double(edge.parameters[i - 1]), from_double(edge.parameters[i])}});
      });
      made->name_curve(e, "edge " + std::to_string(e));
    }
    return made;
  }

  /// What carries its faces and edges, by name; it computes no points on them.
  std::shared_ptr<const LeafSurfaces> surfaces() const {
    auto made = std::make_shared<LeafSurfaces>();
    for (Index f = 0; f < model_.faces.size(); ++f) {
      const CadModel::Face& face = model_.faces[f];
      const CadSurface::Kind kind = face.surface.kind;
      if (face.places.empty()) continue;
      if (kind == CadSurface::Kind::other) {
        made->add_unknown();
        continue;
      }
      SurfaceForm form{.surface = face.surface};
      form.low = form.high = face.places[0].at[0];
      for (const CadModel::Place& place : face.places) {
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t d = 0; d < 2; ++d) {
            if (k == place.pole && d == place.free) continue;
            form.low[d] = std::min(form.low[d], place.at[k][d]);
            form.high[d] = std::max(form.high[d], place.at[k][d]);
          }
        }
      }
      made->add_form(f, std::move(form));
    }
    for (Index e = 0; e < model_.edges.size(); ++e) {
      if (model_.edges[e].curve.kind == CadCurve::Kind::spline)
        made->add_form(e, CurveForm{model_.edges[e].curve});
    }
    return made;
  }

 private:
  std::unique_ptr<PreparedLeaf> finish() {
    fill_ = decide_fill();
    if (fill_ == Fill::solids) {
      for (Index s = 0; s < model_.solids.size(); ++s) check_solid(s);
    }
    if (fill_ == Fill::winding) check_all();
    leaf_ = soup_.add_leaf(fill_);
    ids_.assign(model_.points.size(), PointId());
    for (Index f = 0; f < model_.faces.size(); ++f) add_face(f);
    add_edges();
    return std::make_unique<GeometryLeaf>(std::move(soup_), regions(), std::move(model_.notices));
  }

  /// A face with its sides: `back` and `front` are the regions there.
  struct Use {
    bool forward = true;
    Index back = 0, front = 0;
  };

  std::string what() const { return cad_subject(shape_); }
  std::string face_name(Index f) const { return "face " + std::to_string(f); }
  std::string solid_name(Index s) const {
    const std::string& name = model_.solids[s];
    return "solid " + std::to_string(s + 1) + (name.empty() ? "" : " `" + name + "`");
  }

  /// A model with huge numbers in it may overflow where OpenCASCADE computes its facets.
  void require_finite() const {
    const auto require = [this](const auto& numbers, const std::string& where) {
      for (const double x : numbers) {
        if (!std::isfinite(x)) {
          throw InputError(what() + "OpenCASCADE computes no finite numbers for " + where +
                           ": repair the part where it was made");
        }
      }
    };
    for (const auto& p : model_.points) require(p, "its points");
    for (Index f = 0; f < model_.faces.size(); ++f) {
      for (const CadModel::Place& place : model_.faces[f].places) {
        for (const auto& uv : place.at) require(uv, face_name(f));
      }
    }
    for (Index e = 0; e < model_.edges.size(); ++e) {
      require(model_.edges[e].parameters, "edge " + std::to_string(e));
    }
  }

  /// Equal coordinates get one number, here and in all of the model.
  void merge_points() {
    for (auto& p : model_.points) {
      for (double& x : p) x += 0.0;  // turns -0 into 0
    }
    number_anew(model_.points);
  }

  /// Near points and planes become one, before anything is judged but what the file itself says.
  void weld() {
    const auto name = [this](Index f) { return face_name(f); };
    round_ = welded_round_faces(model_, *shape_.weld, name);
    if (!round_.notice.empty()) model_.notices.push_back(round_.notice);
    const Rational left = *shape_.weld - round_.moved;
    round_.slack = to_double(round_.moved);
    if (left == 0) return;
    Weld made = weld_cad(model_, left, what(), name, [this](Index s) { return solid_name(s); });
    if (const std::string words = made.notice(*shape_.weld).text(); !words.empty())
      model_.notices.push_back(words);
    if (!made.changed()) return;
    round_.slack += made.farthest;
    exact_ = std::move(made.points);
    number_anew(exact_);
  }

  /// Equal points get one number.
  template <class Point>
  void number_anew(const std::vector<Point>& points) {
    std::map<Point, Index> first;
    std::vector<Index> number;
    for (const Point& p : points)
      number.push_back(first.try_emplace(p, static_cast<Index>(number.size())).first->second);
    for (CadModel::Face& face : model_.faces) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < face.triangles.size(); ++i) {
        Triangle t = face.triangles[i];
        for (Index& p : t) p = number[p];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        face.triangles[kept] = t;
        face.places[kept++] = face.places[i];
      }
      face.triangles.resize(kept);
      face.places.resize(kept);
    }
    for (CadModel::Edge& edge : model_.edges) {
      for (Index& p : edge.points) p = number[p];
    }
    for (CadModel::Vertex& vertex : model_.vertices) vertex.point = number[vertex.point];
  }

  // --- some solids only

  std::vector<bool> chosen_solids() const {
    std::vector<bool> chosen(model_.solids.size(), shape_.solids.empty());
    for (const std::string& wanted : shape_.solids) {
      bool found = false;
      for (Index s = 0; s < model_.solids.size(); ++s) {
        if (wanted != std::to_string(s + 1) && wanted != model_.solids[s]) continue;
        chosen[s] = found = true;
      }
      if (found) continue;
      std::string names;
      for (Index s = 0; s < model_.solids.size() && s < 20; ++s) names += (s == 0 ? "" : ", ") + solid_name(s);
      throw InputError(what() + "there is no solid `" + wanted + "` in it; it has " +
                       (names.empty() ? "no solids" : names) + (model_.solids.size() > 20 ? ", ..." : ""));
    }
    return chosen;
  }

  /// Drops all but the solids that the shape names, and what bounds them. Faces and edges keep their numbers.
  void choose() {
    if (shape_.solids.empty()) return;
    const std::vector<bool> chosen = chosen_solids();
    std::vector<Index> region(chosen.size(), 0);
    std::vector<std::string> names;
    for (Index s = 0; s < chosen.size(); ++s) {
      region[s] = static_cast<Index>(names.size());
      if (chosen[s]) names.push_back(model_.solids[s].empty() ? std::to_string(s + 1) : model_.solids[s]);
    }
    std::vector<bool> edge_stays(model_.edges.size(), false), point_stays(model_.points.size(), false);
    for (CadModel::Face& face : model_.faces) {
      for (auto* solids : {&face.behind, &face.before}) {
        std::erase_if(*solids, [&](Index s) { return !chosen[s]; });
        for (Index& s : *solids) s = region[s];
      }
      face.outside = false;
      if (face.behind.empty() && face.before.empty()) {
        face.triangles.clear();
        face.places.clear();
        continue;
      }
      for (const auto& [e, forward] : face.border) edge_stays[e] = true;
      for (const Triangle& t : face.triangles) {
        for (const Index p : t) point_stays[p] = true;
      }
    }
    for (std::size_t e = 0; e < edge_stays.size(); ++e) {
      if (!edge_stays[e]) model_.edges[e].points.clear();
    }
    std::erase_if(model_.vertices, [&](const CadModel::Vertex& v) { return !point_stays[v.point]; });
    model_.solids = std::move(names);
  }

  RationalPoint value(Index p) const { return exact_.empty() ? from_doubles(model_.points[p]) : exact_[p]; }

  /// A chain of sides, `face` in each is for messages.
  class Chain {
   public:
    void add(Index from, Index to, Index face) {
      if (from != to) sides_.push_back({std::min(from, to), std::max(from, to), face, from < to});
    }
    void add(const Triangle& t, bool forward, Index face) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        forward ? add(a, b, face) : add(b, a, face);
      }
    }
    /// The border, in numbers of the model's points. Points are numbered anew: a face needs few of all.
    std::vector<ChainEdge> border() {
      for (const PolygonSide& side : sides_) points_.insert(points_.end(), {side.low, side.high});
      sort_unique(points_);
      const auto local = [&](Index p) {
        return static_cast<Index>(std::lower_bound(points_.begin(), points_.end(), p) - points_.begin());
      };
      std::vector<PolygonSide> sides = sides_;
      for (PolygonSide& side : sides) side.low = local(side.low), side.high = local(side.high);
      std::vector<ChainEdge> chain = boundary(SideTable(sides, points_.size()), false);
      for (ChainEdge& e : chain) e.from = points_[e.from], e.to = points_[e.to];
      return chain;
    }
    std::set<Index> faces_at(const ChainEdge& e) const {
      std::set<Index> faces;
      for (const PolygonSide& side : sides_) {
        if (side.low == std::min(e.from, e.to) && side.high == std::max(e.from, e.to)) faces.insert(side.face);
      }
      return faces;
    }

   private:
    std::vector<PolygonSide> sides_;
    std::vector<Index> points_;
  };

  std::string between(const ChainEdge& e) const {
    return describe(value(e.from)) + " to " + describe(value(e.to));
  }

  void check_border(Index f) const {
    const CadModel::Face& face = model_.faces[f];
    Chain chain;
    for (const Triangle& t : face.triangles) chain.add(t, true, f);
    for (const auto& [e, forward] : face.border) {
      const std::vector<Index>& p = model_.edges[e].points;
      for (std::size_t i = 1; i < p.size(); ++i) chain.add(p[forward ? i : i - 1], p[forward ? i - 1 : i], f);
    }
    const std::vector<ChainEdge> rest = chain.border();
    if (rest.empty()) return;
    throw InputError(what() + "the facets of " + face_name(f) + " do not end at its edges, for example along " +
                     between(rest[0]) +
                     ": give another `chord` or `segments`, or repair the face where it was made");
  }

  /// `ways(f)`: the ways round in which a face is of what has to be closed.
  template <class Ways>
  void check_closed(const std::string& subject, const Ways& ways) const {
    Chain chain;
    for (Index f = 0; f < model_.faces.size(); ++f) {
      for (const bool forward : ways(f)) {
        for (const Triangle& t : model_.faces[f].triangles) chain.add(t, forward, f);
      }
    }
    const std::vector<ChainEdge> rest = chain.border();
    ChainEdge open{};
    if (vanishes(
            rest, false, [&](Index p) { return value(p); }, &open))
      return;
    std::string at;
    for (const Index f : chain.faces_at(open)) at += (at.empty() ? " of " : ", ") + face_name(f);
    throw InputError(what() + subject + " not closed, along " + counted(rest.size(), "segment", "segments") +
                     ", such as " + between(open) + at +
                     ": sew its faces where it was made, or give `fill: none` for surfaces or `fill: cells` for "
                     "their cavities");
  }

  void check_solid(Index s) const {
    check_closed(solid_name(s) + " is", [&](Index f) {
      const CadModel::Face& face = model_.faces[f];
      std::vector<bool> ways(std::size_t(std::ranges::count(face.behind, s)), true);
      ways.insert(ways.end(), std::size_t(std::ranges::count(face.before, s)), false);
      return ways;
    });
  }

  void check_all() const {
    check_closed("its faces together are", [&](Index f) {
      std::vector<bool> ways;
      for (const Use& use : uses(f)) ways.push_back(use.forward);
      return ways;
    });
  }

  Fill decide_fill() const {
    if (!shape_.fill) return model_.solids.empty() ? Fill::none : Fill::solids;
    const Fill fill = *shape_.fill;
    if (fill == Fill::solids && model_.solids.empty()) {
      throw InputError(what() +
                       "there are no solids in it: give `fill: winding` where its faces are closed, "
                       "`fill: cells` for their cavities, or `fill: none`");
    }
    if (fill == Fill::parity || fill == Fill::sides) {
      throw InputError(what() + "a CAD model has solids: give the fill solids, winding, cells or none");
    }
    return fill;
  }

  /// How often and which way round a face goes to the soup. Fill::solids: once, with the solids on its sides, or
  /// more often where several solids lie on one side (they overlap). Fill::winding: once for each solid, turned
  /// outward, but a face inside of a solid both ways, so that it cancels out. Otherwise once.
  std::vector<Use> uses(Index f) const {
    const CadModel::Face& face = model_.faces[f];
    std::vector<Use> list;
    if (fill_ == Fill::solids) {
      const std::size_t count = std::max({face.behind.size(), face.before.size(), std::size_t{1}});
      for (std::size_t i = 0; i < count; ++i) {
        list.push_back({true, i < face.behind.size() ? face.behind[i] + 1 : 0,
                        i < face.before.size() ? face.before[i] + 1 : 0});
      }
    } else if (fill_ == Fill::winding) {
      list.assign(face.behind.size(), {true});
      list.insert(list.end(), face.before.size(), {false});
      if (face.outside) list.push_back({true});
      if (list.empty()) list = {{true}, {false}};
    } else {
      list.push_back({});
    }
    return list;
  }

  PointId id(Index p) {
    const auto& x = model_.points[p];
    if (!ids_[p].valid())
      ids_[p] = exact_.empty() ? soup_.add_point(x[0], x[1], x[2]) : soup_.add_point(exact_[p]);
    return ids_[p];
  }

  void add_face(Index f) {
    const CadModel::Face& face = model_.faces[f];
    std::vector<std::vector<Index>> loops = polygon(face);
    for (const Use& use : uses(f)) {
      if (loops.empty()) {
        for (const Triangle& t : face.triangles) {
          if (flat(t)) continue;
          const PointId a = id(t[0]), b = id(t[use.forward ? 1 : 2]), c = id(t[use.forward ? 2 : 1]);
          soup_.add_triangle(leaf_, a, b, c, f, f, use.front, use.back);
        }
        continue;
      }
      std::vector<std::vector<PointId>> rings;
      for (const auto& loop : loops) {
        auto& ring = rings.emplace_back();
        for (const Index p : loop) ring.push_back(id(p));
        if (!use.forward) std::reverse(ring.begin(), ring.end());
      }
      soup_.add_face(leaf_, rings, f, f, use.front, use.back);
    }
  }

  bool flat(const Triangle& t) const {
    if (exact_.empty()) return cnrg::collinear(xyz(t[0]), xyz(t[1]), xyz(t[2]));
    return cnrg::collinear(exact_[t[0]], exact_[t[1]], exact_[t[2]]);
  }
  bool in_plane(const Triangle& t, Index p) const {
    if (exact_.empty()) return coplanar(xyz(t[0]), xyz(t[1]), xyz(t[2]), xyz(p));
    return volume6(exact_[t[0]], exact_[t[1]], exact_[t[2]], exact_[p]) == 0;
  }
  const double* xyz(Index p) const { return model_.points[p].data(); }

  /// The border of a face whose points lie on one plane exactly, as loops, the outer one first and
  /// counter-clockwise from the front. Nothing for any other face, nor where facets of the face lie on each other.
  std::vector<std::vector<Index>> polygon(const CadModel::Face& face) const {
    const auto first =
        std::find_if(face.triangles.begin(), face.triangles.end(), [&](const Triangle& t) { return !flat(t); });
    if (first == face.triangles.end()) return {};
    for (const Triangle& t : face.triangles) {
      for (const Index p : t) {
        if (p == (*first)[0] || p == (*first)[1] || p == (*first)[2]) continue;
        if (!in_plane(*first, p)) return {};
      }
    }
    const RationalPoint a = value((*first)[0]);
    const RationalPoint normal = cross(value((*first)[1]) - a, value((*first)[2]) - a);
    Chain chain;
    for (const Triangle& t : face.triangles) {
      if (!flat(t) && dot(cross(value(t[1]) - value(t[0]), value(t[2]) - value(t[0])), normal) < 0) return {};
      chain.add(t, true, 0);
    }
    std::multimap<Index, Index> next;
    for (const ChainEdge& e : chain.border()) {
      if (e.coefficient != 1) return {};
      next.emplace(e.from, e.to);
    }
    std::vector<std::vector<Index>> loops;
    Rational most = 0;
    while (!next.empty()) {
      auto& loop = loops.emplace_back();
      const Index start = next.begin()->first;
      do {
        const auto side = next.find(loop.empty() ? start : loop.back());
        loop.push_back(side->second);
        next.erase(side);
      } while (loop.back() != start);
      RationalPoint area{0, 0, 0};
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        area = area + cross(value(loop[i]) - value(loop[0]), value(loop[i + 1]) - value(loop[0]));
      }
      const Rational extent = dot(area, normal);
      if (extent <= most) continue;
      most = extent;
      std::swap(loops.front(), loops.back());
    }
    return loops;
  }

  /// The triangle with parameters; with a pole it has four corners, two of them there (parameters.h).
  std::vector<PatchCorner> cell(const Triangle& t, const CadModel::Place& place) const {
    const auto corner = [&](std::size_t k) {
      return PatchCorner{value(t[k]), {from_double(place.at[k][0]), from_double(place.at[k][1])}};
    };
    if (place.pole > 2) return {corner(0), corner(1), corner(2)};
    const PatchCorner a = corner((place.pole + 1u) % 3), b = corner((place.pole + 2u) % 3);
    PatchCorner at_b = corner(place.pole), at_a = at_b;
    at_a.at[place.free] = a.at[place.free];
    at_b.at[place.free] = b.at[place.free];
    return {a, b, at_b, at_a};
  }

  /// Calls visit(i) for every segment of an edge that becomes a wire; i is the point where it ends.
  template <class Visit>
  void each_segment(Index e, Visit visit) const {
    const CadModel::Edge& edge = model_.edges[e];
    if (edge.seam && !shape_.seams) return;
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      if (edge.points[i - 1] != edge.points[i]) visit(i);
    }
  }

  void add_edges() {
    for (Index e = 0; e < model_.edges.size(); ++e) {
      const std::vector<Index>& points = model_.edges[e].points;
      each_segment(e, [&](std::size_t i) {
        const PointId a = id(points[i - 1]), b = id(points[i]);
        soup_.add_wire(leaf_, a, b, e);
      });
    }
    for (const CadModel::Vertex& vertex : model_.vertices) {
      if (!vertex.seam || shape_.seams) soup_.add_isolated(leaf_, id(vertex.point));
    }
  }

  std::vector<Attributes> regions() const {
    if (fill_ == Fill::winding) return {Attributes()};
    if (fill_ != Fill::solids) return {};
    std::vector<Attributes> result;
    for (const std::string& name : model_.solids) result.push_back({name, ""});
    return result;
  }

  CadShape shape_;
  CadModel model_;
  CadRound round_;                    // of a model as its file has it
  std::vector<RationalPoint> exact_;  // the points, where they were welded
  Fill fill_ = Fill::none;
  Soup soup_;
  LeafId leaf_;
  std::vector<PointId> ids_;
};

/// What the curved faces of a leaf lie on, and the leaf anew by their bands.
class CadForm final : public BandedForm {
 public:
  CadForm(std::shared_ptr<const CadLeaf> leaf, CadBands found) : leaf_(std::move(leaf)), found_(std::move(found)) {
    bands = found_.bands;
    obstacle = found_.obstacle;
    slack = found_.slack;
  }

  Drawn draw(const std::vector<BandGrid>& grids, double slack_of_bands) const override {
    DrawnCad drawn = leaf_->draw(found_, grids, slack_of_bands);
    if (!drawn.obstacle.empty()) return {nullptr, drawn.obstacle, drawn.finer};
    const auto anew = std::make_shared<CadLeaf>(leaf_->shape(), std::move(drawn));
    try {
      Drawn result{anew->prepare_drawn(), ""};
      result.leaf->set_parameters([anew] { return anew->parameters(); });
      return result;
    } catch (const InputError& e) {  // closed as the file has it, but not as drawn
      return {nullptr, e.what()};
    }
  }

 private:
  std::shared_ptr<const CadLeaf> leaf_;
  CadBands found_;
};

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const CadShape& shape) {
  // The model is kept for parameters and to be drawn anew: read again, its file might be another one.
  const auto model = std::make_shared<CadLeaf>(shape);
  std::unique_ptr<PreparedLeaf> leaf = model->prepare();
  leaf->set_parameters([model] { return model->parameters(); });
  leaf->set_surfaces([model] { return model->surfaces(); });
  if (std::optional<CadBands> bands = model->bands())
    leaf->set_form(std::make_shared<CadForm>(model, std::move(*bands)));
  return leaf;
}

}  // namespace cnrg
