// The cells that refinement made become arrays with incidence both ways. Radial order by symbols where it can be,
// by one sign per pair of sheets where it must.
#include "kernel/complex/builder.h"

#include <algorithm>
#include <unordered_map>

#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/radial.h"

namespace cnrg {

std::shared_ptr<Complex> ComplexBuilder::build() {
  watch_.begin("refine: cells");
  take_cells();
  do_both(
      c_.face_count(), [&] { find_uses(); }, [&] { take_attributes(); });
  do_both(
      c_.face_count(), [&] { find_vertices(); },
      [&] {
        order_radially();
        join_shells();
      });
  watch_.begin("refine: regions");
  nest_shells();
  hang_wires();
  mark_frame();
  number_regions();
  watch_.check();
  label_regions(soup_, c_);
  return built_;
}

/// What only refinement needed is freed here, before the arrays of the complex take memory.
void ComplexBuilder::take_cells() {
  take_sparse_cells();
  c_.points = std::move(r_.input.points);
  c_.sheet_plane = std::move(r_.sheet_plane);
  c_.sheet_projection = std::move(r_.sheet_projection);
  c_.segment_ends = std::move(r_.segments.ends);
  c_.segment_faces = std::move(r_.segment_faces);
  c_.edge_ends = std::move(r_.edges.ends);
  c_.edge_segments = std::move(r_.edges.segments);
  c_.face_sheet = std::move(r_.face_sheet);
  c_.face_loops = std::move(r_.face_loops);
  c_.loop = std::move(r_.loops);
  Csr<FaceId, Cover> covers = std::move(r_.face_covers);
  r_ = Refinement();
  share_covers(std::move(covers));
}

/// Wires, isolated points, and vertices in the interior of faces.
void ComplexBuilder::take_sparse_cells() {
  const RefineInput& in = r_.input;
  std::vector<std::pair<SegmentId, WireId>> wires;
  std::vector<std::pair<VertexId, LeafId>> isolated;
  for (const Soup::Isolated& p : soup_.isolated()) isolated.push_back({in.vertex_of[p.point.index()], p.leaf});
  for (std::size_t w = 0; w < in.wire_segment.size(); ++w) {
    if (in.wire_segment[w].valid()) {
      wires.push_back({in.wire_segment[w], WireId(w)});
    } else {
      isolated.push_back({in.vertex_of[soup_.wires()[w].a.index()], soup_.wires()[w].leaf});
    }
  }
  std::sort(wires.begin(), wires.end());
  c_.segment_wires = SparseLists(wires);
  sort_unique(isolated);
  c_.isolated_leaves = SparseLists(isolated);
  std::vector<std::pair<VertexId, LeafId>> ends;
  for (const Soup::Isolated& p : soup_.curve_ends()) ends.push_back({in.vertex_of[p.point.index()], p.leaf});
  sort_unique(ends);
  c_.curve_ends = SparseLists(ends);
  std::vector<std::pair<FaceId, VertexId>> face_vertices;
  std::vector<std::pair<VertexId, FaceId>> vertex_faces;
  for (const FaceId f : IdRange<FaceId>(r_.face_sheet.size())) {
    for (const VertexId v : std::as_const(r_.face_vertices)[f]) {
      face_vertices.push_back({f, v});
      vertex_faces.push_back({v, f});
    }
  }
  std::sort(vertex_faces.begin(), vertex_faces.end());
  c_.face_vertices = SparseLists(face_vertices);
  c_.vertex_faces = SparseLists(vertex_faces);
  for (const SegmentId s : in.wires) {
    const auto chain = std::as_const(r_.edges.chain)[s];
    wired_.insert(wired_.end(), chain.begin(), chain.end());
  }
  sort_unique(wired_);
}

/// Equal covers are one set; sets are numbered as they first appear. Nearly every face has one cover: a table
/// finds its set by source and side.
void ComplexBuilder::share_covers(Csr<FaceId, Cover> covers) {
  using List = std::span<const Cover>;
  const auto place = [](const Cover& x) { return 2 * std::uint64_t{x.source.value()} + (x.same ? 0 : 1); };
  const auto hash = [&](List list) {
    std::uint64_t code = 0;
    for (const Cover& x : list) code = (code ^ place(x)) * 0x9e3779b97f4a7c15ull;
    return static_cast<std::size_t>(code ^ code >> 32);
  };
  const auto equal = [](List a, List b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
  std::unordered_map<List, SourceSetId, decltype(hash), decltype(equal)> of_several(0, hash, equal);
  std::vector<SourceSetId> of_one(2 * soup_.face_count());
  c_.face_cover.resize(c_.face_count());
  std::uint32_t sets = 0;
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    const List list = std::as_const(covers)[f];
    SourceSetId& set = list.size() == 1 ? of_one[place(list[0])] : of_several[list];
    if (!set.valid()) set = SourceSetId(sets++);
    c_.face_cover[f] = set;
  }
  SourceSetId next(0);
  covers.keep_if([&](FaceId f) {
    const bool first = c_.face_cover[f] == next;
    if (first) ++next;
    return first;
  });
  c_.covers = Csr<SourceSetId, Cover>::renamed(std::move(covers));
}

void ComplexBuilder::take_attributes() {
  c_.leaf_count = soup_.leaf_count();
  for (std::size_t l = 0; l < c_.leaf_count; ++l) c_.fills.push_back(soup_.fill(LeafId(l)));
  c_.sources.reserve(soup_.face_count());
  for (std::size_t f = 0; f < soup_.face_count(); ++f) c_.sources.push_back(soup_.face(SourceId(f)));
  for (const Soup::Wire& w : soup_.wires()) c_.wires.push_back(w);
  c_.frame = soup_.frame();
  number_surfaces(c_);
}

void ComplexBuilder::find_uses() {
  c_.edge_uses = Csr<EdgeId, FaceUse>::counted(c_.edge_count(), [&](const auto& take) {
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      for (const HalfEdge h : c_.half_edges(f)) take(h.edge(), FaceUse{f, h});
    }
  });
  drop_unused_edges();
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
    const std::size_t uses = std::as_const(c_.edge_uses)[e].size();
    if (uses == 0) {
      wires_.push_back(e);
    } else if (uses != 2) {
      junctions_.push_back(e);
    }
  }
}

/// Sides on which a face folds back on itself bound nothing; they are no cells unless a wire runs there.
void ComplexBuilder::drop_unused_edges() {
  IdVector<EdgeId, EdgeId> renamed(c_.edge_count());
  EdgeId next(0);
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
    if (std::as_const(c_.edge_uses)[e].empty() && !std::binary_search(wired_.begin(), wired_.end(), e)) continue;
    renamed[e] = next;
    ++next;
  }
  if (next == c_.edge_ends.end_id()) return;
  const auto rename = [&](HalfEdge& h) { h = HalfEdge(renamed[h.edge()], h.direction()); };
  const auto used = [&](EdgeId e) { return renamed[e].valid(); };
  for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
    if (used(e)) c_.edge_ends[renamed[e]] = c_.edge_ends[e];
  }
  c_.edge_ends.resize(next.index());
  c_.edge_segments.keep_if(used);
  c_.edge_uses.keep_if(used);
  for (HalfEdge& h : c_.loop.values()) rename(h);
  for (FaceUse& use : c_.edge_uses.values()) rename(use.half_edge);
}

void ComplexBuilder::find_vertices() {
  const std::size_t n = c_.points.size();
  c_.vertex_edges = Csr<VertexId, EdgeId>::counted(n, [&](const auto& take) {
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      for (const VertexId v : c_.edge_ends[e]) take(v, e);
    }
  });
  c_.vertices.reserve(n);
  for (const VertexId v : IdRange<VertexId>(n)) {
    const bool bounds = !std::as_const(c_.vertex_edges)[v].empty() || !std::as_const(c_.vertex_faces)[v].empty();
    if (!bounds && std::as_const(c_.isolated_leaves)[v].empty()) continue;
    c_.vertices.push_back(v);
    if (!bounds) loose_.push_back(v);
  }
}

/// Around an edge with direction d, the half-plane of a use lies at n x (+-d). The sine of the angle from one use
/// to another has the sign of d . (n x n'), times both directions; it is zero only for two sides of one sheet.
void ComplexBuilder::order_radially() {
  const auto sort_uses = [&](std::size_t i) {
    const EdgeId e = junctions_[i];
    const auto uses = c_.edge_uses[e];
    if (uses.size() < 3) return;
    const RadialOrder radial(c_, e);
    const FaceUse first = uses[0];
    const auto turn = [&](const FaceUse& x) {  // 0: the first; 1: less than half a turn; 2: half; 3: more
      if (x == first) return 0;
      const int s = radial.sine(first, x);
      return s > 0 ? 1 : (s == 0 ? 2 : 3);
    };
    std::vector<std::pair<int, FaceUse>> order;
    for (const FaceUse& x : uses) order.push_back({turn(x), x});
    std::sort(order.begin(), order.end(), [&](const auto& x, const auto& y) {
      if (x.first != y.first) return x.first < y.first;
      if (x.second == y.second) return false;
      const int s = radial.sine(x.second, y.second);
      require(s != 0, "two faces leave an edge in one half plane");
      return s > 0;
    });
    for (std::size_t j = 0; j < uses.size(); ++j) uses[j] = order[j].second;
  };
  for_each_index(junctions_.size(), sort_uses, 64);
}

void ComplexBuilder::mark_frame() {
  if (!c_.frame.valid()) return;
  c_.frame_faces_.assign(c_.face_count(), 0);
  c_.frame_edges_.assign(c_.edge_count(), 0);
  c_.frame_vertices_.assign(c_.points.size(), 0);
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    const auto cover = c_.cover(f);
    if (std::none_of(cover.begin(), cover.end(),
                     [&](const Cover& x) { return c_.sources[x.source].leaf == c_.frame; })) {
      continue;
    }
    c_.frame_faces_[f] = 1;
    for (const HalfEdge h : c_.half_edges(f)) {
      c_.frame_edges_[h.edge()] = 1;
      c_.frame_vertices_[c_.origin(h)] = 1;
    }
  }
}

}  // namespace cnrg
