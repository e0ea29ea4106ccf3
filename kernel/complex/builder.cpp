// Radial order by symbols where it can be, by one sign per pair of sheets where it must; regions as connected sets
// of half-faces. Shells that no edge connects (islands, cavities, wires, points) are connected by one ray each.
#include "kernel/complex/builder.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <map>
#include <optional>

#include "kernel/base/error.h"
#include "kernel/complex/ray.h"

namespace cnrg {

Complex ComplexBuilder::build() {
  take_cells();
  find_vertices();
  find_uses();
  order_radially();
  join_shells();
  nest_shells();
  hang_wires();
  number_regions();
  mark_frame();
  label_regions(soup_, c_);
  return std::move(c_);
}

void ComplexBuilder::take_cells() {
  drop_unused_edges();
  c_.points = std::move(r_.input.points);
  c_.sheet_plane = std::move(r_.sheet_plane);
  c_.sheet_projection = std::move(r_.sheet_projection);
  c_.segment_ends = std::move(r_.segments.ends);
  c_.segment_faces = std::move(r_.segment_faces);
  std::vector<std::pair<SegmentId, WireId>> wires;
  for (std::size_t w = 0; w < r_.input.wire_segment.size(); ++w) {
    if (r_.input.wire_segment[w].valid()) wires.push_back({r_.input.wire_segment[w], WireId(w)});
  }
  std::sort(wires.begin(), wires.end());
  c_.segment_wires = Csr<SegmentId, WireId>::from_sorted(c_.segment_ends.size(), wires);
  c_.edge_ends = std::move(r_.edges.ends);
  c_.edge_segments = std::move(r_.edges.segments);
  c_.face_sheet = std::move(r_.face_sheet);
  c_.face_loops = std::move(r_.face_loops);
  c_.loop = std::move(r_.loops);
  c_.face_vertices = std::move(r_.face_vertices);
  // Equal covers are one set.
  std::map<std::vector<Cover>, SourceSetId> sets;
  c_.face_cover.resize(c_.face_sheet.size());
  for (const FaceId f : IdRange<FaceId>(c_.face_sheet.size())) {
    const auto list = std::as_const(r_.face_covers)[f];
    const auto [it, fresh] = sets.try_emplace(std::vector<Cover>(list.begin(), list.end()), SourceSetId());
    if (fresh) it->second = c_.covers.push_back(list);
    c_.face_cover[f] = it->second;
  }
  c_.leaf_count = soup_.leaf_count();
  for (std::size_t l = 0; l < c_.leaf_count; ++l) c_.fills.push_back(soup_.fill(LeafId(l)));
  c_.sources.reserve(soup_.face_count());
  for (std::size_t f = 0; f < soup_.face_count(); ++f) c_.sources.push_back(soup_.face(SourceId(f)));
  for (const Soup::Wire& w : soup_.wires()) c_.wires.push_back(w);
  c_.frame = soup_.frame();
}

/// Sides on which a face folds back on itself bound nothing; they are no cells unless a wire runs there.
void ComplexBuilder::drop_unused_edges() {
  const std::size_t n = r_.edges.ends.size();
  IdVector<EdgeId, char> used(n, 0);
  for (const HalfEdge h : r_.loops.values()) used[h.edge()] = 1;
  for (const SegmentId s : r_.input.wires) {
    for (const EdgeId e : std::as_const(r_.edges.chain)[s]) used[e] = 1;
  }
  if (std::find(used.begin(), used.end(), 0) == used.end()) return;
  IdVector<EdgeId, EdgeId> renamed(n);
  IdVector<EdgeId, std::array<VertexId, 2>> ends;
  Csr<EdgeId, SegmentId> segments;
  for (const EdgeId e : IdRange<EdgeId>(n)) {
    if (used[e] == 0) continue;
    renamed[e] = ends.push_back(r_.edges.ends[e]);
    segments.push_back(std::as_const(r_.edges.segments)[e]);
  }
  for (HalfEdge& h : r_.loops.values()) h = HalfEdge(renamed[h.edge()], h.direction());
  r_.edges.ends = std::move(ends);
  r_.edges.segments = std::move(segments);
}

void ComplexBuilder::find_vertices() {
  const std::size_t n = c_.points.size();
  std::vector<char> used(n, 0);
  std::vector<std::uint32_t> offsets(n + 1, 0);
  for (const auto& ends : c_.edge_ends) {
    for (const VertexId v : ends) {
      used[v.index()] = 1;
      ++offsets[v.index() + 1];
    }
  }
  for (std::size_t i = 0; i < n; ++i) offsets[i + 1] += offsets[i];
  std::vector<EdgeId> incident(offsets[n]);
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_ends.size())) {
    for (const VertexId v : c_.edge_ends[e]) incident[next[v.index()]++] = e;
  }
  c_.vertex_edges = Csr<VertexId, EdgeId>::from_parts(std::move(offsets), std::move(incident));

  std::vector<std::pair<VertexId, FaceId>> in_faces;
  for (const FaceId f : IdRange<FaceId>(c_.face_sheet.size())) {
    for (const VertexId v : std::as_const(c_.face_vertices)[f]) {
      used[v.index()] = 1;
      in_faces.push_back({v, f});
    }
  }
  std::sort(in_faces.begin(), in_faces.end());
  c_.vertex_faces = Csr<VertexId, FaceId>::from_sorted(n, in_faces);
  std::vector<std::pair<VertexId, LeafId>> isolated;
  for (const Soup::Isolated& p : soup_.isolated()) {
    isolated.push_back({r_.input.vertex_of[p.point.index()], p.leaf});
  }
  for (std::size_t w = 0; w < soup_.wires().size(); ++w) {
    if (!r_.input.wire_segment[w].valid()) {
      isolated.push_back({r_.input.vertex_of[soup_.wires()[w].a.index()], soup_.wires()[w].leaf});
    }
  }
  std::sort(isolated.begin(), isolated.end());
  isolated.erase(std::unique(isolated.begin(), isolated.end()), isolated.end());
  for (const auto& [v, leaf] : isolated) used[v.index()] = 1;
  c_.isolated_leaves = Csr<VertexId, LeafId>::from_sorted(n, isolated);
  for (std::size_t i = 0; i < n; ++i) {
    if (used[i] != 0) c_.vertices.push_back(VertexId(i));
  }
}

void ComplexBuilder::find_uses() {
  const std::size_t n = c_.edge_ends.size();
  std::vector<std::uint32_t> offsets(n + 1, 0);
  for (const HalfEdge h : c_.loop.values()) ++offsets[h.edge().index() + 1];
  for (std::size_t i = 0; i < n; ++i) offsets[i + 1] += offsets[i];
  std::vector<FaceUse> uses(offsets[n]);
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const FaceId f : IdRange<FaceId>(c_.face_sheet.size())) {
    for (const LoopId loop : std::as_const(c_.face_loops)[f]) {
      for (const HalfEdge h : std::as_const(c_.loop)[loop]) uses[next[h.edge().index()]++] = {f, h};
    }
  }
  c_.edge_uses = Csr<EdgeId, FaceUse>::from_parts(std::move(offsets), std::move(uses));
}

/// Around an edge with direction d, the half-plane of a use lies at n x (+-d). The sine of the angle from one use to
/// another has the sign of d . (n x n'), times both directions; it is zero only for two sides of one sheet.
void ComplexBuilder::order_radially() {
  const PointTable& t = c_.points;
  tbb::parallel_for(std::size_t{0}, c_.edge_ends.size(), [&](std::size_t i) {
    const EdgeId e(i);
    const auto uses = c_.edge_uses[e];
    if (uses.size() < 3) return;
    const auto [a, b] = c_.edge_ends[e];
    const PointView va = t.view(a), vb = t.view(b);
    int k = -1, direction = 0;
    double best = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double up = vb.lo[axis] - va.hi[axis], down = va.lo[axis] - vb.hi[axis];
      if (std::max(up, down) > best) {
        best = std::max(up, down);
        k = axis;
        direction = up > 0 ? 1 : -1;
      }
    }
    for (int axis = 0; axis < 3 && k < 0; ++axis) {
      direction = compare(t, axis, b, a);
      if (direction != 0) k = axis;
    }
    const auto sine = [&](const FaceUse& x, const FaceUse& y) {
      const SheetId sx = c_.face_sheet[x.face], sy = c_.face_sheet[y.face];
      if (sx == sy) return 0;
      const int s = cross_normal_sign(t, c_.sheet_plane[sx], c_.sheet_plane[sy], k) * direction;
      require(s != 0, "coplanar faces at one edge are in two sheets");
      return x.half_edge.direction() == y.half_edge.direction() ? s : -s;
    };
    const FaceUse first = uses[0];
    const auto turn = [&](const FaceUse& x) {  // 0: the first; 1: less than half a turn; 2: half; 3: more
      if (x == first) return 0;
      const int s = sine(first, x);
      return s > 0 ? 1 : (s == 0 ? 2 : 3);
    };
    std::vector<std::pair<int, FaceUse>> order;
    for (const FaceUse& x : uses) order.push_back({turn(x), x});
    std::sort(order.begin(), order.end(), [&](const auto& x, const auto& y) {
      if (x.first != y.first) return x.first < y.first;
      if (x.second == y.second) return false;
      const int s = sine(x.second, y.second);
      require(s != 0, "two faces leave an edge in one half plane");
      return s > 0;
    });
    for (std::size_t j = 0; j < uses.size(); ++j) uses[j] = order[j].second;
  });
}

/// The side that looks counter-clockwise is the front for a use along the edge, the back for one against it.
void ComplexBuilder::join_shells() {
  const std::size_t halves = 2 * c_.face_sheet.size();
  edge_node_ = static_cast<std::uint32_t>(halves);
  vertex_node_ = edge_node_ + static_cast<std::uint32_t>(c_.edge_ends.size());
  infinity_ = vertex_node_ + static_cast<std::uint32_t>(c_.points.size());
  shells_ = UnionFind(halves);
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_ends.size())) {
    const auto uses = std::as_const(c_.edge_uses)[e];
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const FaceUse &x = uses[i], &y = uses[i + 1 < uses.size() ? i + 1 : 0];
      shells_.unite(x.after().code(), y.before().code());
    }
  }
  space_ = UnionFind(infinity_ + 1);
  for (std::uint32_t h = 0; h < halves; ++h) space_.unite(h, shells_.find(h));
}

void ComplexBuilder::nest_shells() {
  const std::size_t n = c_.face_sheet.size();
  if (n == 0) return;
  // Surfaces: faces connected through edges. One ray for each, from a face that reaches far in x, to infinity.
  UnionFind surface(n);
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_ends.size())) {
    const auto uses = std::as_const(c_.edge_uses)[e];
    for (std::size_t i = 1; i < uses.size(); ++i) surface.unite(uses[0].face.value(), uses[i].face.value());
  }
  std::vector<std::uint32_t> far(n, 0xffffffffu), roots;
  std::vector<double> reach(n);
  for (std::size_t f = 0; f < n; ++f) {
    reach[f] = -std::numeric_limits<double>::infinity();
    for (const HalfEdge h : std::as_const(c_.loop)[std::as_const(c_.face_loops)[FaceId(f)].front()]) {
      reach[f] = std::max(reach[f], c_.points.view(c_.origin(h)).hi[0]);
    }
    const std::uint32_t root = surface.find(static_cast<std::uint32_t>(f));
    if (far[root] == 0xffffffffu) roots.push_back(root);
    if (far[root] == 0xffffffffu || reach[f] > reach[far[root]]) far[root] = static_cast<std::uint32_t>(f);
  }
  const RayCaster caster(c_, roots.size() > 16);
  std::vector<std::vector<std::uint32_t>> joins(roots.size());
  tbb::parallel_for(std::size_t{0}, roots.size(), [&](std::size_t i) {
    const FaceId start(far[roots[i]]);
    const RayCaster::Ray ray = caster.cast(interior_point(c_, start), start);
    joins[i].push_back(caster.leaving(start, ray).code());
    for (const HalfFace h : ray.hits) {
      joins[i].push_back(h.code());
      joins[i].push_back(h.opposite().code());
    }
    joins[i].push_back(infinity_);
  });
  for (const auto& list : joins) {
    for (std::size_t i = 0; i < list.size(); i += 2) space_.unite(list[i], list[i + 1]);
  }
}

/// Wires and points that touch no face: those connected through vertices hang in one region; one ray for each set.
void ComplexBuilder::hang_wires() {
  std::vector<std::uint32_t> nodes;
  const auto touches_face = [&](VertexId v) {
    if (!std::as_const(c_.vertex_faces)[v].empty()) return true;
    for (const EdgeId e : std::as_const(c_.vertex_edges)[v]) {
      if (!std::as_const(c_.edge_uses)[e].empty()) return true;
    }
    return false;
  };
  for (const VertexId v : c_.vertices) {
    if (touches_face(v)) continue;
    const auto edges = std::as_const(c_.vertex_edges)[v];
    for (const EdgeId e : edges) space_.unite(edge_node_ + edges[0].value(), edge_node_ + e.value());
    if (edges.empty()) nodes.push_back(vertex_node_ + v.value());
  }
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_ends.size())) {
    const std::uint32_t node = edge_node_ + e.value();
    if (std::as_const(c_.edge_uses)[e].empty() && space_.find(node) == node) nodes.push_back(node);
  }
  if (nodes.empty()) return;
  const RayCaster caster(c_, nodes.size() > 16);
  std::vector<std::uint32_t> found(nodes.size());
  tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
    const ExactPoint p = nodes[i] >= vertex_node_ ? c_.points.exact(VertexId(nodes[i] - vertex_node_))
                                                  : interior_point(c_, EdgeId(nodes[i] - edge_node_));
    const RayCaster::Ray ray = caster.cast(p);
    found[i] = ray.hits.empty() ? infinity_ : ray.hits.front().code();
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) space_.unite(nodes[i], found[i]);
}

void ComplexBuilder::number_regions() {
  std::map<std::uint32_t, RegionId> number{{space_.find(infinity_), RegionId(0)}};
  const auto region = [&](std::uint32_t node) {
    return number.try_emplace(space_.find(node), RegionId(number.size())).first->second;
  };
  c_.face_regions.resize(c_.face_sheet.size());
  std::vector<std::pair<RegionId, HalfFace>> faces;
  for (const FaceId f : IdRange<FaceId>(c_.face_sheet.size())) {
    for (unsigned side = 0; side < 2; ++side) {
      const HalfFace h(f, side);
      c_.face_regions[f][side] = region(h.code());
      faces.push_back({c_.face_regions[f][side], h});
    }
  }
  std::vector<std::pair<RegionId, EdgeId>> wires;
  c_.edge_region.resize(c_.edge_ends.size());
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_ends.size())) {
    if (!std::as_const(c_.edge_uses)[e].empty()) continue;
    c_.edge_region[e] = region(edge_node_ + e.value());
    wires.push_back({c_.edge_region[e], e});
  }
  std::vector<std::pair<RegionId, VertexId>> points;
  c_.vertex_region.resize(c_.points.size());
  for (const VertexId v : c_.vertices) {
    if (!std::as_const(c_.vertex_edges)[v].empty() || !std::as_const(c_.vertex_faces)[v].empty()) continue;
    c_.vertex_region[v] = region(vertex_node_ + v.value());
    points.push_back({c_.vertex_region[v], v});
  }
  std::vector<std::pair<std::pair<RegionId, std::uint32_t>, HalfFace>> by_shell;
  by_shell.reserve(faces.size());
  for (const auto& [r, h] : faces) by_shell.push_back({{r, shells_.find(h.code())}, h});
  tbb::parallel_sort(by_shell.begin(), by_shell.end());
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = {by_shell[i].first.first, by_shell[i].second};
  c_.region_count = number.size();
  c_.region_faces = Csr<RegionId, HalfFace>::from_sorted(c_.region_count, faces);
  std::sort(wires.begin(), wires.end());
  std::sort(points.begin(), points.end());
  c_.region_wires = Csr<RegionId, EdgeId>::from_sorted(c_.region_count, wires);
  c_.region_vertices = Csr<RegionId, VertexId>::from_sorted(c_.region_count, points);
}

void ComplexBuilder::mark_frame() {
  if (!c_.frame.valid()) return;
  c_.frame_faces_.assign(c_.face_count(), 0);
  c_.frame_edges_.assign(c_.edge_count(), 0);
  c_.frame_vertices_.assign(c_.points.size(), 0);
  c_.frame_regions_.assign(c_.region_count, 0);
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    const auto cover = c_.cover(f);
    if (std::none_of(cover.begin(), cover.end(), [&](const Cover& x) { return c_.sources[x.source].leaf == c_.frame; })) {
      continue;
    }
    c_.frame_faces_[f] = 1;
    for (const RegionId r : c_.face_regions[f]) c_.frame_regions_[r] = 1;
    for (const LoopId loop : std::as_const(c_.face_loops)[f]) {
      for (const HalfEdge h : std::as_const(c_.loop)[loop]) {
        c_.frame_edges_[h.edge()] = 1;
        c_.frame_vertices_[c_.origin(h)] = 1;
      }
    }
  }
}

Complex build_complex(const Soup& soup, const RefineOptions& options, RefineReport* report) {
  RefineReport local;
  RefineReport& out = report != nullptr ? *report : local;
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  const StageCounts before = stage_counts();
  Complex complex = ComplexBuilder(soup, refine(soup, out)).build();
  const StageCounts after = stage_counts();
  out.stages = {after.filter - before.filter, after.interval - before.interval, after.exact - before.exact};
  for (const VertexId v : complex.vertices) out.constructed += complex.points.is_constructed(v) ? 1 : 0;
  return complex;
}

}  // namespace cnrg
