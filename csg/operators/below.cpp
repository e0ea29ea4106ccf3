// Pieces are sets of 3-cells of the block, joined through all faces but those of the surface. Each connected body
// of the block is colored by itself; then one face of the surface tells which color is below:
//
//   * where all faces of the surface agree which color their undersides have, any of them;
//   * where they do not (folds, overhangs), the uppermost one over some point in plan: there is nothing of the
//     surface between it and the sky;
//   * a body that the surface does not enter lies below it if a line upward meets the surface an odd number of
//   times.
#include "csg/operators/below.h"

#include <algorithm>
#include <map>
#include <optional>

#include "csg/geometry/surface_triangles.h"
#include "csg/leaves/geometry_leaf.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;

/// Where a vertical line meets faces.
class Plumb {
 public:
  struct Hit {
    FaceId face;
    Rational z;
  };
  /// A line is vertical where `transform` has moved a vertical one to it.
  Plumb(const Complex& complex, const Transform& transform)
      : complex_(complex),
        transform_(transform),
        back_(transform.inverse()),
        moved_(!transform.identity()),
        axes_(moved_axes(nullptr, transform)),
        front_(sgn(back_.determinant())) {}

  /// Before it was moved.
  RationalPoint before(const RationalPoint& p) const { return moved_ ? back_.apply(p) : p; }
  RationalPoint after(const RationalPoint& p) const { return moved_ ? transform_.apply(p) : p; }
  const LeafAxes* axes() const { return axes_ ? &*axes_ : nullptr; }

  /// The normal of a face, up to its length.
  const RationalPoint& normal(FaceId f) {
    const auto [it, fresh] = normals_.try_emplace(f);
    if (fresh) {
      const auto [a, b, c] = complex_.points.plane_points(complex_.plane(f));
      const RationalPoint p = place(a);
      it->second = Rational(front_) * cross(place(b) - p, place(c) - p);
    }
    return it->second;
  }
  bool vertical(FaceId f) { return normal(f)[2] == 0; }
  /// The 3-cell on the upper side (the lower side) of a face that is not vertical.
  RegionId over(FaceId f) { return complex_.face_regions[f][normal(f)[2] > 0 ? 0 : 1]; }
  RegionId under(FaceId f) { return complex_.face_regions[f][normal(f)[2] > 0 ? 1 : 0]; }

  /// The faces over or under a point, in no order. A point that projects onto a side that faces share belongs to
  /// one of them, and so does its place on a fold to both or none: see `uppermost`.
  template <class Faces>
  std::vector<Hit> hits(const RationalPoint& p, const Faces& faces) {
    std::vector<Hit> out;
    for (const FaceId f : faces) {
      if (!vertical(f) && covers(f, p)) out.push_back({f, height(f, p)});
    }
    return out;
  }

 private:
  Rational height(FaceId f, const RationalPoint& p) {
    const RationalPoint& n = normal(f);
    const RationalPoint o = place(complex_.points.plane_points(complex_.plane(f))[0]);
    return o[2] - (n[0] * (p[0] - o[0]) + n[1] * (p[1] - o[1])) / n[2];
  }

  /// Is the point in the face, both seen from above? Sides are half open, as in any count of crossings.
  bool covers(FaceId f, const RationalPoint& p) {
    bool inside = false;
    for (const HalfEdge h : complex_.half_edges(f)) {
      const RationalPoint &a = point(complex_.origin(h)), &b = point(complex_.target(h));
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      const Rational turn = (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
      if (turn != 0 && (b[1] > a[1]) == (turn > 0)) inside = !inside;
    }
    return inside;
  }
  const RationalPoint& point(VertexId v) {
    const auto [it, fresh] = points_.try_emplace(v);
    if (fresh) it->second = place(v);
    return it->second;
  }
  RationalPoint place(VertexId v) const { return before(complex_.points.rational(v)); }

  const Complex& complex_;
  const Transform& transform_;
  const Transform back_;
  const bool moved_;
  const std::optional<LeafAxes> axes_;
  const int front_;  // -1: it was mirrored, too
  std::map<FaceId, RationalPoint> normals_;
  std::map<VertexId, RationalPoint> points_;
};

class Parting {
 public:
  Parting(const Complex& complex, const Group& surface, const std::string& surface_name, const Group& block,
          const std::string& block_name, const Transform& transform, bool proven)
      : complex_(complex),
        surface_(surface),
        block_(block),
        surface_name_(surface_name),
        block_name_(block_name),
        cell_(complex.region_count),
        of_surface_(complex.face_count()),
        pieces_(block.cells.size()),
        bodies_(block.cells.size()),
        plumb_(complex, transform),
        proven_(proven) {}

  Group run(Side side) {
    if (!surface_.cells.empty()) {
      throw InputError("`" + surface_name_ + "` has regions, and a surface has none; use its `boundary`, or " +
                       "`difference` and `intersection` with the solid itself");
    }
    if (surface_.faces.empty()) {
      throw InputError("`" + surface_name_ + "` has no faces; name a node that is a surface");
    }
    if (block_.cells.empty()) {
      throw InputError("`" + block_name_ + "` has no region; name a node that is a solid after `within`");
    }
    for (std::size_t i = 0; i < block_.cells.size(); ++i) cell_[block_.cells[i].first] = static_cast<Index>(i + 1);
    for (const FaceId f : surface_.faces) of_surface_[f] = 1;
    join();
    color();
    decide();
    return walls(side);
  }

 private:
  /// The place of a 3-cell in the block, if it is one of it.
  std::optional<Index> place(RegionId r) const {
    const Index i = cell_.get(r);
    return i == 0 ? std::nullopt : std::optional(i - 1);
  }

  void join() {
    for (Index i = 0; i < block_.cells.size(); ++i) {
      for (const HalfFace h : complex_.region_faces[block_.cells[i].first]) {
        const auto other = place(complex_.region(h.opposite()));
        if (!other) continue;
        bodies_.unite(i, *other);
        if (of_surface_.get(h.face()) == 0) pieces_.unite(i, *other);
      }
    }
    for (const FaceId f : surface_.faces) {
      if (inside(f)) inner_.push_back(f);
    }
  }

  bool inside(FaceId f) const {
    const auto& [front, back] = complex_.face_regions[f];
    return place(front) && place(back);
  }
  Index piece(RegionId r) { return pieces_.find(*place(r)); }
  Index body(FaceId f) { return bodies_.find(*place(complex_.face_regions[f][0])); }

  /// Colors pieces so that they are different across the faces of the surface.
  void color() {
    std::map<Index, std::vector<Index>> next;  // by piece
    for (const FaceId f : inner_) {
      const Index a = piece(complex_.face_regions[f][0]), b = piece(complex_.face_regions[f][1]);
      if (a == b) refuse("ends inside", f);
      next[a].push_back(b), next[b].push_back(a);
    }
    for (const auto& [start, others] : next) {
      if (color_.contains(start)) continue;
      color_[start] = 0;
      std::vector<Index> open{start};
      while (!open.empty()) {
        const Index at = open.back();
        open.pop_back();
        for (const Index other : next.at(at)) {
          const auto [it, fresh] = color_.try_emplace(other, 1 - color_.at(at));
          if (fresh) open.push_back(other);
          else if (it->second == color_.at(at)) refuse("branches inside", {});
        }
      }
    }
  }

  /// Names a point of the surface inside of the block where it has an end, or a number of faces that is odd.
  [[noreturn]] void refuse(const std::string& what, FaceId nearby) {
    std::optional<RationalPoint> at;
    std::vector<RegionId> around;
    const auto look = [&](EdgeId e) {
      std::size_t faces = 0;
      for (const FaceUse& use : complex_.edge_uses[e]) faces += of_surface_.get(use.face);
      if (faces % 2 == 0) return;
      around.clear();
      complex_.star_regions(e, around);
      if (!std::all_of(around.begin(), around.end(), [&](RegionId r) { return place(r).has_value(); })) return;
      const RationalPoint p = interior_point(complex_, e).rational();
      if (!at || p < *at) at = p;
    };
    for (const EdgeId e : surface_.edges) look(e);
    if (!at && nearby.valid()) at = interior_point(complex_, nearby).rational();
    throw InputError("`" + surface_name_ + "` does not part `" + block_name_ + "`: it " + what +
                     (at ? ", at " + describe(*at) : std::string()) +
                     (what == "ends inside"
                          ? "; let it reach beyond the block on all sides, or take away what ends there"
                          : "; use its sheets one after the other"));
  }

  /// Which color is below, of each body.
  void decide() {
    std::map<Index, std::vector<FaceId>> entered;  // faces of the surface, by body
    for (const FaceId f : inner_) entered[body(f)].push_back(f);
    for (const auto& [body, faces] : entered) below_[body] = color_below(faces);
    for (Index i = 0; i < block_.cells.size(); ++i) {
      const Index b = bodies_.find(i);
      if (entered.contains(b) || below_.contains(b)) continue;
      if (is_curved(surface_.faces) || is_curved(block_.faces)) {
        refuse_facets("does not enter a part of `" + block_name_ + "`: facets alone tell whether this is below",
                      "that part");
      }
      below_[b] = is_below(b) ? 0 : 1;  // its one piece has the color 0
      color_[pieces_.find(b)] = 0;
    }
  }

  bool is_curved(const std::vector<FaceId>& faces) const {
    return std::ranges::any_of(faces, [&](FaceId f) { return cnrg::is_curved(complex_, f); });
  }
  /// Of what facets of curved faces tell, where that has to be proven.
  void refuse_facets(const std::string& what, const std::string& cause) const {
    if (proven_) throw InputError("`" + surface_name_ + "` " + what + "; leave out --certify, or " + cause);
  }

  int color_below(const std::vector<FaceId>& faces) {
    if (is_curved(faces))
      refuse_facets("is curved in `" + block_name_ + "`: facets alone tell which side is below",
                    "take planar faces");
    std::optional<int> agreed;
    bool agree = true;
    for (const FaceId f : faces) {
      if (plumb_.vertical(f)) continue;
      const int under = color_.at(piece(plumb_.under(f)));
      if (!agreed) agreed = under;
      agree = agree && *agreed == under;
    }
    if (!agreed) {
      throw InputError("`" + surface_name_ + "` is vertical inside of `" + block_name_ +
                       "`: neither side is below; "
                       "turn the model, or part it by a half-space");
    }
    if (agree) return *agreed;
    for (const FaceId f : faces) {
      if (plumb_.vertical(f)) continue;
      if (const auto top = uppermost(plumb_.before(interior_point(complex_, f).rational()), faces)) {
        return color_.at(piece(plumb_.under(*top)));
      }
    }
    throw InputError("`" + surface_name_ + "` has no upper side inside of `" + block_name_ + "`");
  }

  /// The uppermost of the faces at a point; nothing where two meet in a fold.
  std::optional<FaceId> uppermost(const RationalPoint& p, const std::vector<FaceId>& faces) {
    const std::vector<Plumb::Hit> hits = plumb_.hits(p, faces);
    const Plumb::Hit* top = nullptr;
    bool fold = false;
    for (const Plumb::Hit& hit : hits) {
      if (top != nullptr && hit.z == top->z) fold = true;
      if (top == nullptr || hit.z > top->z) top = &hit, fold = false;
    }
    return top == nullptr || fold ? std::nullopt : std::optional(top->face);
  }

  /// Of a body that the surface does not enter. Where lines are tried depends on the surface and the body, not on
  /// what has cut them.
  bool is_below(Index of) {
    std::vector<FaceId> skin;
    for (const auto& [r, region] : block_.cells) {
      if (bodies_.find(*place(r)) != of) continue;
      for (const HalfFace h : complex_.region_faces[r]) {
        if (!place(complex_.region(h.opposite())) && !complex_.on_frame(h.face())) skin.push_back(h.face());
      }
    }
    sort_unique(skin);
    const std::vector<RationalPoint> of_skin = middles(skin);
    if (const auto found = is_below(skin, of_skin)) return *found;
    if (const auto found = is_below(skin, middles(surface_.faces))) return *found;
    throw InputError("`" + surface_name_ + "` is neither over nor under a part of `" + block_name_ + "`" +
                     (of_skin.empty() ? std::string() : ", near " + describe(plumb_.after(of_skin.front()))) +
                     "; let it reach over all of the block, or leave that part out");
  }

  /// By the first of the points on whose line the body and the surface are.
  std::optional<bool> is_below(const std::vector<FaceId>& skin, const std::vector<RationalPoint>& points) {
    for (const RationalPoint& p : points) {
      const std::vector<Plumb::Hit> there = plumb_.hits(p, skin);
      const std::vector<Plumb::Hit> hits = there.empty() ? there : plumb_.hits(p, surface_.faces);
      if (hits.empty()) continue;
      const auto top =
          std::max_element(there.begin(), there.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
      return std::count_if(hits.begin(), hits.end(), [&](const auto& hit) { return hit.z >= top->z; }) % 2 == 1;
    }
    return std::nullopt;
  }

  /// Of the triangles of a surface, before it was moved.
  std::vector<RationalPoint> middles(const std::vector<FaceId>& faces) const {
    std::vector<RationalPoint> out;
    for (const auto& [a, b, c] : surface_triangles(complex_, faces, plumb_.axes())) {
      const RationalPoint sum =
          complex_.points.rational(a) + complex_.points.rational(b) + complex_.points.rational(c);
      out.push_back(plumb_.before(Rational(1, 3) * sum));
    }
    return out;
  }

  bool wanted(RegionId r, Side side) {
    const auto i = place(r);
    if (!i) return false;
    const bool is_below = color_.at(pieces_.find(*i)) == below_.at(bodies_.find(*i));
    return is_below == (side == Side::below);
  }

  Group walls(Side side) {
    Group out;
    std::map<Index, std::uint32_t> number;  // of pieces
    std::vector<char> is_wanted(block_.cells.size(), 0);
    Marks<FaceId> faces(complex_.face_count());
    for (Index i = 0; i < block_.cells.size(); ++i) {
      const RegionId r = block_.cells[i].first;
      if (!wanted(r, side)) continue;
      const auto [it, fresh] = number.try_emplace(pieces_.find(i), static_cast<std::uint32_t>(number.size() + 1));
      if (fresh) out.regions.emplace_back();
      out.cells.emplace_back(r, it->second);
      for (const HalfFace h : complex_.region_faces[r]) {
        if (!complex_.on_frame(h.face()) && !wanted(complex_.region(h.opposite()), side)) faces[h.face()] = 1;
      }
    }
    out.faces = faces.ids();
    Marks<EdgeId> edges(complex_.edge_count()), sheet_edges(complex_.edge_count());
    Marks<VertexId> vertices(complex_.points.size()), sheet_vertices(complex_.points.size());
    for (const FaceId f : out.faces) {
      const bool of_surface = of_surface_.get(f) != 0;
      for (const HalfEdge h : complex_.half_edges(f)) {
        if (!complex_.on_frame(h.edge())) edges[h.edge()] = 1;
        const VertexId v = complex_.origin(h);
        if (!complex_.on_frame(v)) vertices[v] = 1;
        if (of_surface) sheet_edges[h.edge()] = 1, sheet_vertices[v] = 1;
      }
      for (const VertexId v : complex_.face_vertices[f]) {
        vertices[v] = 1;
        if (of_surface) sheet_vertices[v] = 1;
      }
    }
    out.edges = edges.ids(), out.vertices = vertices.ids();
    LeafSetMap sets(surface_.origins.sets, out.origins.sets);
    const auto origins = [&](const auto& list, const auto& from, const auto& from_origins, auto& to) {
      std::size_t k = 0;
      for (const auto cell : list) {
        while (k < from.size() && from[k] < cell) ++k;
        to.push_back(k < from.size() && from[k] == cell ? sets(from_origins[k]) : LeafSetId(0));
      }
    };
    for_each_entity(origins, out, surface_, surface_.origins, out.origins);
    for (const EdgeId e : surface_.features.edges) {
      if (sheet_edges.get(e) != 0) out.features.edges.push_back(e);
    }
    for (const VertexId v : surface_.features.vertices) {
      if (sheet_vertices.get(v) != 0) out.features.vertices.push_back(v);
    }
    return out;
  }

  const Complex& complex_;
  const Group &surface_, &block_;
  const std::string &surface_name_, &block_name_;
  Scratch<RegionId, Index> cell_;  // 1 + the place in the block's list
  Marks<FaceId> of_surface_;
  UnionFind pieces_, bodies_;           // of places
  std::vector<FaceId> inner_;           // of the surface, inside of the block
  std::map<Index, int> color_, below_;  // of pieces; of bodies the color that is below
  Plumb plumb_;
  const bool proven_;
};

}  // namespace

Group part_of(const Complex& complex, Side side, const Group& surface, const std::string& surface_name,
              const Group& block, const std::string& block_name, const Transform& transform, bool proven) {
  return Parting(complex, surface, surface_name, block, block_name, transform, proven).run(side);
}

bool is_curved(const Complex& complex, FaceId f) {
  return std::ranges::any_of(complex.cover(f),
                             [&](const Cover& c) { return complex.sources[c.source].surface != 0; });
}

}  // namespace cnrg
