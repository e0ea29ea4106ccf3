// All that a result file says, held against the cells that it makes.
//
// A file lists cells, and then says of them what follows from where they are: which region is on which side, what
// bounds it, its volume, triangles, which cells are wires. A reader that trusts these takes an edge that was moved
// through a face for one edge, and a region without faces for nothing. So the cells of the file are refined by
// themselves. If the file is right then nothing is cut: every cell of the complex is one cell of the file, but
// that a curved face has a cell for each facet and a chain one for each step. From there on every member is the
// answer to a question to the complex, and the first one that differs is an error. The order of cells, of points
// in loops and the fronts of faces are canonical (csg/result/flat.h), so that the numbers are those of the result
// when it is written again.
//
// What a file says and its cells cannot contradict is taken as it is: which component a cell is of (as long as a
// group stays a group), features, names, parameters u and v, and where cells came from.
#include <algorithm>
#include <functional>

#include "csg/geometry/canonical_loop.h"
#include "csg/imports/result_placing.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/predicates.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::result {
namespace {

class Check {
 public:
  explicit Check(const PlacedCells& placed)
      : placed_(placed),
        root_(placed.root),
        content_(placed.content),
        table_(placed.table),
        c_(placed.complex),
        at_(placed.table.points.size()) {}

  void run() {
    check_vertices();
    check_edges();
    check_faces();
    check_regions();
    require_kept();
  }

 private:
  /// The member `region` of a cell that no face bounds or holds; other cells have none.
  void check_region(const Cursor& cell, bool wanted, const std::function<RegionId()>& around) const {
    if (!wanted) {
      if (cell.has("region"))
        cell.member("region").refuse("faces are around this cell, and say which regions are");
      return;
    }
    const Index stated = cell.member("region").number(placed_.place_of.size(), "region");
    const Index made = placed_.region_of[around()];
    if (made != stated) cell.member("region").refuse(words("region", made) + " is around this cell");
  }

  // --- components

  template <class Range>
  bool all_of(const Range& cells, Index wanted) const {
    return std::all_of(cells.begin(), cells.end(), [&](auto cell) { return placed_.component(cell) == wanted; });
  }

  /// `entity`, `feature`, and in a group the component. `around`: all cells of more dimensions around are of the
  /// component; `regions`: the regions are.
  void check_state(const Cursor& cell, Index component, bool feature, bool regions, bool around) const {
    const bool entity = component != 0 && !regions;
    if (cell.member("entity").boolean() != entity) {
      cell.member("entity").refuse(entity           ? "the regions around this cell are not all of its component"
                                   : component == 0 ? "a cell that is no part of the result is no entity"
                                                    : "this cell is in the interior of a region of its component");
    }
    if (feature && component == 0)
      cell.member("feature").refuse("a cell that is no part of the result is no feature");
    if (!table_.group || component == 0) return;
    if (component == content_.entities()) return;
    if (!around) {
      cell.member("component")
          .refuse(
              "this cell bounds a region of the group or is in none, so it is an entity, which are component " +
              std::to_string(content_.entities()));
    }
    if (feature) cell.member("feature").refuse("only entities of a group are features");
  }

  // --- vertices

  void check_vertices() {
    Index i = 0;
    std::vector<FaceId> faces;
    for (const auto& [p, stated] : table_.vertices) {
      const Cursor at = root_.member("vertices").at(i++);
      const VertexId v = vertex(p);
      at_[p] = At::vertex;
      c_.star_faces(v, faces);
      c_.star_regions(v, regions_);
      const auto edges = c_.vertex_edges[v];
      const bool regions = all_of(regions_, stated.component);
      check_state(at, stated.component, stated.feature, regions,
                  regions && all_of(faces, stated.component) && all_of(edges, stated.component));
      const bool loose = edges.empty() && c_.vertex_faces[v].empty();
      check_region(at, loose, [&] { return c_.some_region(v); });
    }
  }

  // --- edges

  void check_edges() {
    Loop before;
    std::vector<EdgeId> first(content_.edges.size());
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      if (placed_.edge_of[e] != kNone) first[placed_.edge_of[e]] = e;
    }
    std::vector<FaceId> faces;
    for (Index i = 0; i < content_.edges.size(); ++i) {
      const Cursor at = placed_.edge_at(i);
      const Edge& edge = content_.edges[i];
      const CellTable::Cell& stated = table_.edges[i];
      check_chain(at, edge, before);
      c_.star_faces(first[i], faces);
      c_.star_regions(first[i], regions_);
      const bool regions = all_of(regions_, stated.component);
      check_state(at, stated.component, stated.feature, regions, regions && all_of(faces, stated.component));
      const bool wire = edge.uses == 0;
      if (at.member("wire").boolean() != wire) {
        at.member("wire").refuse(wire ? "no face has this edge on its boundary"
                                      : "a face has this edge on its boundary");
      }
      check_region(at, wire, [&] { return c_.some_region(first[i]); });
    }
    require_points_of_edges();
  }

  void check_chain(const Cursor& at, const Edge& edge, Loop& before) {
    Loop chain = edge.points, canonical;
    if (edge.closed) {
      chain.pop_back();
      canonical = chain;
      rotate_to_least(canonical);
      if (canonical.back() < canonical[1]) std::reverse(canonical.begin() + 1, canonical.end());
    } else {
      canonical.assign(chain.rbegin(), chain.rend());
      canonical = std::min(canonical, chain);
    }
    if (chain != canonical) at.member("points").refuse("the order of these points is " + words(canonical));
    if (chain < before) at.refuse("edges are in the order of their points");
    for (std::size_t k = edge.closed ? 0 : 1; k + 1 < edge.points.size(); ++k) {
      const auto here = [&] { return at.member("points").at(k); };
      const Index p = edge.points[k];
      if (at_[p] == At::vertex) here().refuse("a vertex is no inner point of an edge");
      if (placed_.segments_at[p] != 2) here().refuse("other edges end here, so a vertex is missing");
      at_[p] = At::chain;
      const Index last = k == 0 ? edge.points[edge.points.size() - 2] : edge.points[k - 1];
      if (!edge.curved && collinear(c_.points, vertex(last), vertex(p), vertex(edge.points[k + 1]))) {
        here().refuse("this point is on the line between its neighbours and no vertex; it is left out");
      }
    }
    before = std::move(chain);
  }

  /// A point that is no vertex and on no edge is inside of a face that is not flat.
  void require_points_of_edges() const {
    std::vector<FaceId> star;
    for (Index p = 0; p < at_.size(); ++p) {
      if (at_[p] != At::face) continue;
      const VertexId v = vertex(p);
      c_.star_faces(v, star);
      const bool inside =
          c_.vertex_faces[v].empty() && std::all_of(star.begin(), star.end(), [&](FaceId f) {
            return content_.facets[placed_.facet_of[f]].face == content_.facets[placed_.facet_of[star[0]]].face;
          });
      if (!inside) root_.member("points").at(p).refuse("cells meet in this point, so a vertex is missing");
    }
  }

  // --- faces

  void check_faces() {
    std::pair<Loop, Loop> before;
    for (Index i = 0; i < content_.faces.size(); ++i) {
      const Cursor at = placed_.face_at(i);
      const Face& face = content_.faces[i];
      check_face(placed_, face, at);
      std::pair<Loop, Loop> key = key_of(face);
      if (key < before) at.refuse("faces are in the order of their points");
      before = std::move(key);
      const Index own = table_.faces[i];
      const bool inside = std::all_of(face.regions.begin(), face.regions.end(),
                                      [&](Index region) { return content_.regions[region].component == own; });
      check_state(at, own, false, inside, inside);
    }
  }

  /// Points of the boundary, and of a face that is not flat those of its facets.
  std::pair<Loop, Loop> key_of(const Face& face) const {
    std::pair<Loop, Loop> key;
    const auto add = [](const std::vector<Loop>& walks, Loop& out) {
      for (const Loop& walk : walks) out.insert(out.end(), walk.begin(), walk.end());
    };
    add(content_.walks(face), key.first);
    std::sort(key.first.begin(), key.first.end());
    if (face.flat) return key;
    for (std::size_t k = face.first; k < face.first + face.facets; ++k) add(content_.facets[k].walks, key.second);
    sort_unique(key.second);
    return key;
  }

  // --- regions

  /// The sides of faces in each shell of each region: sides that see each other over an edge are of one.
  std::vector<std::vector<Loop>> shells() const {
    const auto code = [&](HalfFace h) {
      return 2 * content_.facets[placed_.facet_of[h.face()]].face +
             (placed_.same(h.face()) ? h.side() : 1 - h.side());
    };
    UnionFind sides(2 * content_.faces.size());
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      const auto uses = c_.edge_uses[e];
      for (std::size_t i = 0; i < uses.size(); ++i) {
        sides.unite(std::uint32_t(code(uses[i].after())),
                    std::uint32_t(code(uses[i + 1 < uses.size() ? i + 1 : 0].before())));
      }
    }
    std::vector<std::vector<Loop>> out(content_.regions.size());
    std::vector<Index> number(2 * content_.faces.size(), kNone);
    for (Index side = 0; side < number.size(); ++side) {
      auto& of_region = out[content_.faces[side / 2].regions[side % 2]];
      Index& shell = number[sides.find(side)];
      if (shell == kNone) {
        shell = Index(of_region.size());
        of_region.emplace_back();
      }
      of_region[shell].push_back(side);
    }
    for (auto& of_region : out) std::sort(of_region.begin(), of_region.end());
    return out;
  }

  void check_regions() {
    using Key = std::tuple<Loop, bool, Index>;
    const std::vector<std::vector<Loop>> made = shells();
    Key before;
    for (Index i = 0; i < content_.regions.size(); ++i) {
      const Cursor at = root_.member("regions").at(i);
      const bool bounded = content_.regions[i].label != 0;
      if (!placed_.place_of[i].valid()) at.refuse("no side of a face looks into this region");
      const RegionId r = placed_.place_of[i];
      if (c_.unbounded(r) == bounded) {
        at.member("bounded").refuse(bounded ? "this region reaches infinity" : "this region has bounds");
      }
      check_shells(at.member("shells").array(), made[i]);
      check_volume(at.member("volume"), r, bounded);
      Loop faces;
      for (const Loop& shell : made[i]) {
        for (const Index side : shell) faces.push_back(side / 2);
      }
      sort_unique(faces);
      Key key(std::move(faces), !bounded, content_.regions[i].component);
      if (key < before) at.refuse("regions are in the order of their faces");
      before = std::move(key);
    }
    if (table_.group) require_connected();
  }

  void check_shells(const Cursor& list, const std::vector<Loop>& made) const {
    for (std::size_t s = 0; s < list.size() || s < made.size(); ++s) {
      if (s == list.size()) list.refuse("a shell is missing, of " + words("face", made[s][0] / 2));
      const Cursor shell = list.at(s).array();
      if (s == made.size())
        shell.refuse("the faces bound this region in fewer shells: " + std::to_string(made.size()));
      for (std::size_t k = 0; k < shell.size() || k < made[s].size(); ++k) {
        const auto wanted = [&] {
          return words("face", made[s][k] / 2) + (made[s][k] % 2 == 0 ? ", its front" : ", its back");
        };
        if (k == shell.size()) shell.refuse("a side is missing: " + wanted());
        const Cursor side = shell.at(k).only({"face", "side"});
        if (k == made[s].size()) side.refuse("this side is not of this shell");
        const Index face = side.member("face").number(content_.faces.size(), "face");
        const std::string which = side.member("side").text();
        if (which != "front" && which != "back") side.member("side").refuse("`front` or `back` is needed here");
        if (2 * face + (which == "back") != made[s][k]) side.refuse("here in this shell is " + wanted());
      }
    }
  }

  void check_volume(const Cursor& at, RegionId r, bool bounded) const {
    if (at.is_null() != !bounded) {
      at.refuse(bounded ? "a bounded region has a volume" : "the volume of a region without bounds is null");
    }
    if (!bounded) return;
    const Rational stated = at.rational(), made = *volume(c_, r);
    if (stated != made) at.refuse("the volume inside of its shells is " + written(made));
  }
  static std::string written(const Rational& value) {
    const std::string text = to_string(value);
    return text.size() > 40 ? to_decimal(value) : text;
  }

  /// In a group a component is one region, in one piece but for faces that are inside of it.
  void require_connected() const {
    UnionFind sets(content_.regions.size());
    for (Index i = 0; i < content_.faces.size(); ++i) {
      const auto [front, back] = content_.faces[i].regions;
      const Index c = table_.faces[i];
      if (c != 0 && content_.regions[front].component == c && content_.regions[back].component == c)
        sets.unite(front, back);
    }
    std::vector<Index> first(content_.components.size() + 1, kNone);
    for (Index i = 0; i < content_.regions.size(); ++i) {
      const Index c = content_.regions[i].component;
      if (c == 0) continue;
      if (first[c] == kNone) first[c] = i;
      if (sets.find(i) == sets.find(first[c])) continue;
      root_.member("regions")
          .at(i)
          .member("component")
          .refuse("in a group a component is one region, and " + words("region", first[c]) + " is of this one");
    }
    for (Index c = 1; c < first.size(); ++c) {
      if (first[c] == kNone)
        root_.member("components").at(c - 1).refuse("in a group a component is a region, and none is of this one");
    }
  }

  /// Cells that are no part of the result are listed only where they bound one: also when nothing else is united.
  void require_kept() const {
    Selection active;
    Features features;
    const auto add = [](auto& list, auto cell, Index component) {
      if (component != 0) list.emplace_back(cell, component);
    };
    for (const RegionId r : IdRange<RegionId>(c_.region_count)) add(active.regions, r, placed_.component(r));
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) add(active.faces, f, placed_.component(f));
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      add(active.edges, e, placed_.component(e));
      if (placed_.edge_of[e] != kNone && table_.edges[placed_.edge_of[e]].feature) features.edges.push_back(e);
    }
    for (const VertexId v : c_.vertices) {
      const auto stated = table_.vertices.find(point(v));
      add(active.vertices, v, placed_.component(v));
      if (stated != table_.vertices.end() && stated->second.feature) features.vertices.push_back(v);
    }
    const SimplifiedComplex kept = simplify(c_, active, features, SimplifyMode::raw);
    Index i = 0;
    for (const auto& [p, vertex] : table_.vertices) {
      if (kept.vertex_place[p].dimension != 0) root_.member("vertices").at(i).refuse(kNotNeeded);
      ++i;
    }
    Index first = kNone;
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      if (placed_.edge_of[e] != kNone && kept.edge_place[e.index()].dimension != 1)
        first = std::min(first, placed_.edge_of[e]);
    }
    if (first != kNone) placed_.edge_at(first).refuse(kNotNeeded);
    for (const Facet& facet : content_.facets) {
      const FaceId f = placed_.cell_of[std::size_t(&facet - content_.facets.data())];
      if (kept.face_place[f.index()].dimension != 2) placed_.face_at(facet.face).refuse(kNotNeeded);
    }
  }
  static constexpr const char* kNotNeeded = "this cell is no part of the result and bounds none";

  enum class At : char { face, chain, vertex };

  const PlacedCells& placed_;
  const Cursor& root_;
  const Content& content_;
  const CellTable& table_;
  const Complex& c_;
  std::vector<At> at_;             // by point
  std::vector<RegionId> regions_;  // around a cell
};

}  // namespace

void check_content(const Cursor& root, const Content& content) {
  Soup soup;
  add_to(soup, content, {}, Fill::none);
  std::shared_ptr<const Complex> complex;
  try {
    complex = build_complex(soup);
  } catch (const LeafError& e) {
    // A face that is not planar.
    const std::uint32_t face = e.words().places().at(0).faces.at(0);
    const std::string text = e.words().text([](const LeafPlace&) { return std::string(); });
    root.member("faces").at(face).refuse(text.substr(2, text.find(';') - 2));
  }
  Check(PlacedCells(root, content, *complex)).run();
}

}  // namespace cnrg::result
