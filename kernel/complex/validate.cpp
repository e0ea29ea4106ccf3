// Every invariant of the complex that can be checked without building it again. Geometry is checked where a wrong
// decision would show: planarity and order in each sheet, radial order about each edge, disjointness of vertices.
#include <algorithm>
#include <map>

#include "kernel/base/union_find.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

namespace {

std::string name(const char* kind, std::size_t id) { return std::string(kind) + std::to_string(id); }

class Validator {
 public:
  explicit Validator(const Complex& c) : c_(c) {}
  std::string run() {
    vertices();
    edges();
    faces();
    radial();
    regions();
    euler();
    labels();
    return error_;
  }

 private:
  void fail(const std::string& what) {
    if (error_.empty()) error_ = what;
  }

  /// Spatially distinct: neighbours in lexicographic order differ.
  void vertices() {
    std::vector<VertexId> order = c_.vertices;
    std::sort(order.begin(), order.end(),
              [&](VertexId a, VertexId b) { return compare_lex(c_.points, a, b) < 0; });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (compare_lex(c_.points, order[i - 1], order[i]) == 0) {
        fail("vertices " + name("v", order[i - 1].value()) + " and " + name("v", order[i].value()) + " coincide");
      }
    }
  }

  void edges() {
    std::vector<std::array<VertexId, 2>> ends(c_.edge_ends.begin(), c_.edge_ends.end());
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      const auto [a, b] = c_.edge_ends[e];
      if (compare_lex(c_.points, a, b) >= 0)
        fail(name("e", e.value()) + ": its ends are not in lexicographic order");
      if (c_.edge_uses[e].empty() != c_.edge_region[e].valid()) {
        fail(name("e", e.value()) + ": a wire needs a region, an edge of faces has none");
      }
      if (c_.edge_segments[e].empty()) fail(name("e", e.value()) + " lies on no segment");
      for (const VertexId v : {a, b}) {
        const auto list = c_.vertex_edges[v];
        if (std::find(list.begin(), list.end(), e) == list.end())
          fail(name("e", e.value()) + " is unknown to its vertex");
      }
    }
    std::sort(ends.begin(), ends.end());
    if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) fail("two edges have the same ends");
  }

  /// Loops are closed walks in the plane of the sheet; d d = 0 over them; every half-edge bounds one face per
  /// sheet.
  void faces() {
    std::map<std::pair<HalfEdge, SheetId>, FaceId> once;
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      if (c_.face_loops[f].empty()) fail(name("f", f.value()) + " has no loop");
      std::map<VertexId, int> boundary;
      for (const LoopId l : c_.face_loops[f]) {
        const auto loop = c_.loop[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const HalfEdge h = loop[i], next = loop[i + 1 < loop.size() ? i + 1 : 0];
          if (c_.target(h) != c_.origin(next)) fail(name("f", f.value()) + ": a loop is not closed");
          ++boundary[c_.target(h)];
          --boundary[c_.origin(h)];
          if (side_of_plane(c_.points, c_.plane(f), c_.origin(h)) != 0) {
            fail(name("v", c_.origin(h).value()) + " is off the plane of " + name("f", f.value()));
          }
          if (!once.try_emplace({h, c_.face_sheet[f]}, f).second) {
            fail(name("e", h.edge().value()) + " has two faces on one side in one sheet");
          }
          const auto uses = c_.edge_uses[h.edge()];
          if (std::find(uses.begin(), uses.end(), FaceUse{f, h}) == uses.end()) {
            fail(name("f", f.value()) + " is unknown to its edge");
          }
        }
      }
      for (const auto& [v, n] : boundary) {
        if (n != 0) fail(name("f", f.value()) + ": d d is not zero");
      }
      if (c_.cover(f).empty()) fail(name("f", f.value()) + " is covered by no soup face");
      for (const VertexId v : c_.face_vertices[f]) {
        if (side_of_plane(c_.points, c_.plane(f), v) != 0)
          fail(name("v", v.value()) + " is off the plane of its face");
        const auto list = c_.vertex_faces[v];
        if (std::find(list.begin(), list.end(), f) == list.end())
          fail(name("f", f.value()) + " is unknown to its vertex");
        if (!c_.vertex_edges[v].empty()) {
          bool free = true;
          for (const EdgeId e : c_.vertex_edges[v]) {
            for (const FaceUse& u : c_.edge_uses[e]) free = free && c_.face_sheet[u.face] != c_.face_sheet[f];
          }
          if (!free) fail(name("v", v.value()) + " is isolated in a face and on an edge of its sheet");
        }
      }
    }
    // Outer loops turn left at their leftmost vertex, all others do not: checked as the sign of the exact area.
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      const Projection axes = c_.sheet_projection[c_.face_sheet[f]];
      const auto loops = c_.face_loops[f];
      for (std::size_t i = 0; i < loops.size(); ++i) {
        const int s = turn(axes, c_.loop[loops[i]]);
        if (i == 0 ? s <= 0 : s > 0) fail(name("f", f.value()) + ": a loop turns the wrong way");
      }
    }
  }

  /// Sign of the area of a loop.
  int turn(Projection axes, std::span<const HalfEdge> loop) const {
    if (loop.size() == 3) {
      return orient2d(c_.points, axes, c_.origin(loop[0]), c_.origin(loop[1]), c_.origin(loop[2]));
    }
    Rational area = 0;
    const RationalPoint o = c_.points.rational(c_.origin(loop[0]));
    RationalPoint p = c_.points.rational(c_.target(loop[0]));
    for (std::size_t i = 1; i < loop.size(); ++i) {
      RationalPoint q = c_.points.rational(c_.target(loop[i]));
      area +=
          (p[axes.u] - o[axes.u]) * (q[axes.v] - o[axes.v]) - (p[axes.v] - o[axes.v]) * (q[axes.u] - o[axes.u]);
      p = std::move(q);
    }
    return sgn(area);
  }

  /// Consecutive uses about an edge see the same region between them.
  void radial() {
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      const auto uses = c_.edge_uses[e];
      for (std::size_t i = 0; i < uses.size(); ++i) {
        const FaceUse &x = uses[i], &y = uses[i + 1 < uses.size() ? i + 1 : 0];
        if (c_.region(x.after()) != c_.region(y.before())) {
          fail(name("e", e.value()) + ": two regions between neighbours in radial order");
        }
      }
      // With three or more uses: the turns from one to the next add up to one round, so at most one exceeds a
      // half.
      if (uses.size() < 3) continue;
      int large = 0;
      for (std::size_t i = 0; i < uses.size(); ++i)
        large += sine(e, uses[i], uses[(i + 1) % uses.size()]) < 0 ? 1 : 0;
      if (large > 1) fail(name("e", e.value()) + ": its faces are not in radial order");
    }
  }

  int sine(EdgeId e, const FaceUse& x, const FaceUse& y) const {
    const auto [a, b] = c_.edge_ends[e];
    for (int k = 0; k < 3; ++k) {
      const int d = compare(c_.points, k, b, a);
      if (d == 0) continue;
      const int s = cross_normal_sign(c_.points, c_.plane(x.face), c_.plane(y.face), k) * d;
      return x.half_edge.direction() == y.half_edge.direction() ? s : -s;
    }
    return 0;
  }

  void regions() {
    std::vector<std::size_t> sides(c_.region_count, 0);
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      for (const RegionId r : c_.face_regions[f]) {
        if (r.index() >= c_.region_count) return fail(name("f", f.value()) + " has no region");
        ++sides[r.index()];
      }
    }
    for (const RegionId r : IdRange<RegionId>(c_.region_count)) {
      const auto list = c_.region_faces[r];
      if (list.size() != sides[r.index()]) fail(name("R", r.value()) + ": its list of half-faces is not complete");
      for (const HalfFace h : list) {
        if (c_.region(h) != r) fail(name("R", r.value()) + " lists a half-face of another region");
      }
      // d d = 0: every edge is met by the region's boundary as often forward as backward.
      std::map<EdgeId, int> boundary;
      for (const HalfFace h : list) {
        for (const HalfEdge g : c_.half_edges(h.face()))
          boundary[g.edge()] += (g.direction() == 0) == (h.side() == 0) ? 1 : -1;
      }
      for (const auto& [e, n] : boundary) {
        if (n != 0) fail(name("R", r.value()) + ": its boundary is not closed at " + name("e", e.value()));
      }
    }
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      if (c_.edge_uses[e].empty() && c_.edge_region[e].valid()) wire_regions(e);
    }
  }

  /// Where an end of a wire touches no face, all wires there are in one region.
  void wire_regions(EdgeId e) {
    for (const VertexId v : c_.edge_ends[e]) {
      bool free = c_.vertex_faces[v].empty();
      for (const EdgeId g : c_.vertex_edges[v]) free = free && c_.edge_uses[g].empty();
      for (const EdgeId g : c_.vertex_edges[v]) {
        if (free && c_.edge_region[g] != c_.edge_region[e])
          fail(name("e", e.value()) + ": a wire changes its region in the open");
      }
    }
  }

  /// Euler's formula per shell: its half-faces (each a disk less its holes), joined in radial order, form a closed
  /// orientable surface, so V - E + F is even and at most 2, where V counts sectors joined around a vertex.
  void euler() {
    UnionFind shell(2 * c_.face_count());
    // Corners of a shell: sectors between consecutive edges of one half-face, joined across edges, are its
    // vertices.
    std::vector<std::uint32_t> first(2 * c_.face_count() + 1, 0);
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      std::uint32_t n = 0;
      for (const LoopId l : c_.face_loops[f]) n += static_cast<std::uint32_t>(c_.loop[l].size());
      first[2 * f.index() + 1] = first[2 * f.index()] + n;
      first[2 * f.index() + 2] = first[2 * f.index() + 1] + n;
    }
    // Sector i of a face: the corner at the origin of its i-th half-edge.
    UnionFind sector(first.back());
    std::map<std::pair<FaceId, HalfEdge>, std::uint32_t> place;
    std::vector<std::uint32_t> next_place(first.back());
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      std::uint32_t i = 0;
      for (const LoopId l : c_.face_loops[f]) {
        const auto loop = c_.loop[l];
        for (std::size_t k = 0; k < loop.size(); ++k) {
          place[{f, loop[k]}] = i + static_cast<std::uint32_t>(k);
          next_place[first[2 * f.index()] + i + k] =
              i + static_cast<std::uint32_t>(k + 1 < loop.size() ? k + 1 : 0);
        }
        i += static_cast<std::uint32_t>(loop.size());
      }
    }
    std::map<std::uint32_t, std::int64_t> characteristic;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> joints;
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      const auto uses = c_.edge_uses[e];
      for (std::size_t i = 0; i < uses.size(); ++i) {
        const FaceUse &x = uses[i], &y = uses[i + 1 < uses.size() ? i + 1 : 0];
        const std::uint32_t hx = x.after().code();
        const std::uint32_t hy = y.before().code();
        shell.unite(hx, hy);
        const auto corner = [&](const FaceUse& u, std::uint32_t half, VertexId v) {
          const std::uint32_t at = place[{u.face, u.half_edge}];
          return first[half] + (c_.origin(u.half_edge) == v ? at : next_place[first[2 * u.face.index()] + at]);
        };
        for (const VertexId v : c_.edge_ends[e]) sector.unite(corner(x, hx, v), corner(y, hy, v));
        joints.push_back({hx, hy});
      }
    }
    for (const auto& [hx, hy] : joints) --characteristic[shell.find(hx)];
    for (std::uint32_t h = 0; h < 2 * c_.face_count(); ++h) {
      characteristic[shell.find(h)] += 2 - static_cast<std::int64_t>(c_.face_loops[FaceId(h / 2)].size());
    }
    for (std::uint32_t h = 0; h < 2 * c_.face_count(); ++h) {
      for (std::uint32_t s = first[h]; s < first[h + 1]; ++s) {
        if (sector.find(s) == s) ++characteristic[shell.find(h)];
      }
    }
    for (const auto& [root, chi] : characteristic) {
      if (chi > 2 || chi % 2 != 0)
        fail("the shell of half-face " + std::to_string(root) + " is no closed surface");
    }
  }

  void labels() {
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      if (c_.on_frame(f)) continue;
      const auto front = c_.labels(c_.face_regions[f][0]), back = c_.labels(c_.face_regions[f][1]);
      std::vector<Label> differ;
      std::set_symmetric_difference(front.begin(), front.end(), back.begin(), back.end(),
                                    std::back_inserter(differ));
      for (const Label& x : differ) {
        bool wall = false;
        for (const Cover& cover : c_.cover(f)) wall = wall || c_.sources[cover.source].leaf == x.leaf;
        if (!wall)
          fail(name("f", f.value()) + ": leaf " + std::to_string(x.leaf.value()) +
               " changes its region without a wall");
      }
    }
    if (!c_.frame.valid() && !c_.labels(RegionId(0)).empty()) fail("a leaf fills the unbounded region");
  }

  const Complex& c_;
  std::string error_;
};

}  // namespace

std::string validate(const Complex& complex) { return Validator(complex).run(); }

}  // namespace cnrg
