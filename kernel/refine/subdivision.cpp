// A sheet's plane graph, by order around vertices alone (no areas, no angles):
//   edges around a vertex are sorted by the exact directions of the input segments that carry them;
//   walking "next clockwise at the head" gives loops; each loop of a connected graph bounds one face, and the loop
//   that passes west of the component's leftmost vertex is its outer one;
//   components nest by a ray to the west from their leftmost vertex;
//   soup faces toggle across the edges that lie on their boundary, from the unbounded face (nothing) inward.
#include "kernel/refine/subdivision.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "kernel/base/error.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

SheetFaces Subdivider::subdivide(const SheetContent& content) {
  axes_ = content.axes;
  collect(content);
  sort_around_vertices();
  walk_loops();
  find_outer_loops();
  nest(content);
  cover(content);
  return emit(content);
}

void Subdivider::collect(const SheetContent& content) {
  edges_.clear();
  vertices_.clear();
  isolated_.clear();
  for (const SegmentId s : content.segments) {
    for (const EdgeId e : x_.edges.chain[s]) edges_.push_back({e, SegmentId(), {0, 0}, false});
  }
  const auto by_edge = [](const LocalEdge& a, const LocalEdge& b) { return a.edge < b.edge; };
  std::sort(edges_.begin(), edges_.end(), by_edge);
  edges_.erase(std::unique(edges_.begin(), edges_.end(),
                           [](const LocalEdge& a, const LocalEdge& b) { return a.edge == b.edge; }),
               edges_.end());
  for (const LocalEdge& e : edges_) {
    for (const VertexId v : x_.edges.ends[e.edge]) vertices_.push_back(v);
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  const PointTable& t = x_.input.points;
  for (LocalEdge& e : edges_) {
    const auto& ends = x_.edges.ends[e.edge];
    for (int i = 0; i < 2; ++i) {
      e.end[i] = static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), ends[i]) -
                                            vertices_.begin());
    }
    e.line = x_.edges.segments[e.edge].front();  // input segments come first
    const auto& [a, b] = x_.segments.ends[e.line];
    const int du = compare(t, axes_.u, a, b);
    e.right = du < 0 || (du == 0 && compare(t, axes_.v, a, b) < 0);
  }
  for (const VertexId v : content.points) {
    if (!std::binary_search(vertices_.begin(), vertices_.end(), v)) isolated_.push_back(v);
  }
}

/// Order of two half-edges with the same origin: counter-clockwise from straight down, exclusive.
bool Subdivider::before(std::uint32_t h, std::uint32_t g) const {
  const LocalEdge &a = edges_[h >> 1], &b = edges_[g >> 1];
  const bool right_a = a.right == ((h & 1) == 0), right_b = b.right == ((g & 1) == 0);
  if (right_a != right_b) return right_a;
  if (a.line == b.line) {
    throw InvariantError("two edges of one segment leave a vertex in the same direction");
  }
  const auto &la = x_.segments.ends[a.line], &lb = x_.segments.ends[b.line];
  int s = orient2d_vectors(x_.input.points, axes_, la[0], la[1], lb[0], lb[1]);
  if (a.right != b.right) s = -s;  // the canonical directions lie in opposite half planes
  if (s == 0) throw InvariantError("two edges leave a vertex in the same direction");
  return s > 0;
}

void Subdivider::sort_around_vertices() {
  const std::size_t n = vertices_.size(), halves = 2 * edges_.size();
  out_begin_.assign(n + 1, 0);
  for (std::uint32_t h = 0; h < halves; ++h) ++out_begin_[local_origin(h) + 1];
  std::partial_sum(out_begin_.begin(), out_begin_.end(), out_begin_.begin());
  out_.resize(halves);
  std::vector<std::uint32_t> fill(out_begin_.begin(), out_begin_.end() - 1);
  for (std::uint32_t h = 0; h < halves; ++h) out_[fill[local_origin(h)]++] = h;
  rank_.resize(halves);
  for (std::size_t v = 0; v < n; ++v) {
    const auto begin = out_.begin() + out_begin_[v], end = out_.begin() + out_begin_[v + 1];
    if (end - begin > 1)
      std::sort(begin, end, [&](std::uint32_t h, std::uint32_t g) { return h != g && before(h, g); });
  }
  for (std::size_t i = 0; i < halves; ++i) rank_[out_[i]] = static_cast<std::uint32_t>(i);
}

void Subdivider::walk_loops() {
  const std::size_t halves = 2 * edges_.size();
  next_.resize(halves);
  for (std::uint32_t h = 0; h < halves; ++h) {
    const std::uint32_t twin = h ^ 1, v = local_origin(twin);
    const std::uint32_t r = rank_[twin];
    next_[h] = r == out_begin_[v] ? out_[out_begin_[v + 1] - 1] : out_[r - 1];
  }
  loop_of_.assign(halves, kNone);
  loop_first_.clear();
  for (std::uint32_t h = 0; h < halves; ++h) {
    if (loop_of_[h] != kNone) continue;
    const auto loop = static_cast<std::uint32_t>(loop_first_.size());
    loop_first_.push_back(h);
    for (std::uint32_t g = h; loop_of_[g] == kNone; g = next_[g]) loop_of_[g] = loop;
  }
}

bool Subdivider::left_of(VertexId v, VertexId w) const {
  const PointTable& t = x_.input.points;
  const int u = compare(t, axes_.u, v, w);
  return u != 0 ? u < 0 : compare(t, axes_.v, v, w) < 0;
}

void Subdivider::find_outer_loops() {
  UnionFind joined(vertices_.size());
  for (const LocalEdge& e : edges_) joined.unite(e.end[0], e.end[1]);
  component_.assign(vertices_.size(), kNone);
  component_min_.clear();
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    const std::uint32_t root = joined.find(v);
    if (root == v) {
      component_[v] = static_cast<std::uint32_t>(component_min_.size());
      component_min_.push_back(v);
    } else {
      component_[v] = component_[root];
      std::uint32_t& least = component_min_[component_[v]];
      if (left_of(vertices_[v], vertices_[least])) least = v;
    }
  }
  component_count_ = component_min_.size();
  component_outer_.resize(component_count_);
  for (std::size_t c = 0; c < component_count_; ++c) {
    // All edges at the leftmost vertex point right; to the left of the last one lies the west.
    component_outer_[c] = loop_of_[out_[out_begin_[component_min_[c] + 1] - 1]];
  }
  // Planarity: V - E + L = 2 for each component.
  require(vertices_.size() + loop_first_.size() == edges_.size() + 2 * component_count_,
          "the edges of a sheet cross outside of their vertices");
  loop_face_.assign(loop_first_.size(), kNone);
  for (const std::uint32_t loop : component_outer_) loop_face_[loop] = 0;
  face_count_ = 1;
  for (std::uint32_t& face : loop_face_) face = face == 0 ? kNone : static_cast<std::uint32_t>(face_count_++);
}

/// Where many holes and points are to be placed among many edges: else each of them looks at each edge.
void Subdivider::index_edges() {
  edge_tree_.reset();
  constexpr std::size_t kFewQuestions = 16, kFewEdges = 64;
  if (component_count_ + isolated_.size() < kFewQuestions || edges_.size() < kFewEdges) return;
  const PointTable& t = x_.input.points;
  std::vector<Box> boxes(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    for (const std::uint32_t end : edges_[i].end) {
      const PointView p = t.view(vertices_[end]);
      boxes[i].extend({-p.hi[axes_.u], p.lo[axes_.v], 0}, {-p.lo[axes_.u], p.hi[axes_.v], 0});
    }
  }
  // Isolated: while it waits, this thread must not begin another sheet in the same memory.
  tbb::this_task_arena::isolate([&] { edge_tree_.emplace(std::move(boxes)); });
}

/// The loop whose face holds v, among loops of other components than `component`: that of the first edge to the
/// west of v. kNone if there is no edge.
std::uint32_t Subdivider::containing_face(VertexId v, std::uint32_t component) {
  const PointTable& t = x_.input.points;
  const PointView p = t.view(v);
  const int cu = axes_.u, cv = axes_.v;
  std::uint32_t best = kNone;                              // half-edge that runs upward
  double west = -std::numeric_limits<double>::infinity();  // no part of it lies further west
  const auto look = [&](std::uint32_t i) {
    if (component_[edges_[i].end[0]] == component) return;
    const VertexId ends[2] = {vertices_[edges_[i].end[0]], vertices_[edges_[i].end[1]]};
    const PointView a = t.view(ends[0]), b = t.view(ends[1]);
    if (std::min(a.lo[cu], b.lo[cu]) > p.hi[cu]) return;
    const int ca = compare(cv, a, p), cb = compare(cv, b, p);
    if ((ca <= 0) == (cb <= 0)) return;
    const std::uint32_t up = 2 * i + (ca <= 0 ? 0 : 1);
    if (orient2d(t, axes_, origin(up), origin(up ^ 1), v) >= 0) return;
    if (best == kNone || is_nearer(up, best)) {
      best = up;
      west = std::min(a.lo[cu], b.lo[cu]);
    }
  };
  if (edge_tree_) {
    const auto may_be_nearer = [&](const Box& box) {
      return box.hi[0] >= -p.hi[cu] && -box.lo[0] >= west && box.lo[1] <= p.hi[cv] && box.hi[1] >= p.lo[cv];
    };
    edge_tree_->query(may_be_nearer, look);
  } else {
    for (std::uint32_t i = 0; i < edges_.size(); ++i) look(i);
  }
  return best == kNone ? kNone : loop_of_[best ^ 1];  // v is to the east, so to the left of the downward half-edge
}

/// Of two edges that do not cross and have a level in common, as half-edges that run upward: does the first one
/// lie to the east of the second on that level?
bool Subdivider::is_nearer(std::uint32_t h, std::uint32_t g) const {
  const PointTable& t = x_.input.points;
  const VertexId a1 = origin(g), b1 = origin(g ^ 1), a2 = origin(h), b2 = origin(h ^ 1);
  int left;  // > 0: h lies to the left of g
  if (a1 == a2) {
    left = orient2d(t, axes_, a1, b1, b2);
  } else if (compare(t, axes_.v, a1, a2) >= 0) {
    left = -orient2d(t, axes_, a2, b2, a1);
    if (left == 0) left = -orient2d(t, axes_, a2, b2, b1);
  } else {
    left = orient2d(t, axes_, a1, b1, a2);
    if (left == 0) left = orient2d(t, axes_, a1, b1, b2);
  }
  return left < 0;
}

void Subdivider::nest(const SheetContent&) {
  isolated_face_.assign(isolated_.size(), 0);
  if (component_count_ == 1 && isolated_.empty()) {
    loop_face_[component_outer_[0]] = 0;
    return;
  }
  // Components from left to right by their leftmost vertices: a ray to the west can only meet one that begins
  // further left, and the face around that one is known by then.
  index_edges();
  std::vector<std::uint32_t> order(component_count_);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return a != b && left_of(vertices_[component_min_[a]], vertices_[component_min_[b]]);
  });
  for (const std::uint32_t c : order) {
    const std::uint32_t loop = component_count_ == 1 ? kNone : containing_face(vertices_[component_min_[c]], c);
    std::uint32_t face = 0;
    if (loop != kNone) {
      face = loop_face_[loop];
      require(face != kNone, "a component of a sheet lies west of its own container");
    }
    loop_face_[component_outer_[c]] = face;
  }
  for (std::size_t i = 0; i < isolated_.size(); ++i) {
    const std::uint32_t loop = containing_face(isolated_[i], kNone);
    isolated_face_[i] = loop == kNone ? 0 : loop_face_[loop];
  }
}

void Subdivider::cover(const SheetContent& content) {
  face_cover_.assign(face_count_, {});
  // Breadth first from the unbounded face, which nothing covers. Soup faces begin or end at the edges on their
  // boundary; across a trace nothing changes.
  std::vector<char> known(face_count_, 0);
  std::vector<std::vector<std::uint32_t>> half_edges(face_count_);
  for (std::uint32_t h = 0; h < 2 * edges_.size(); ++h) half_edges[loop_face_[loop_of_[h]]].push_back(h);
  std::vector<std::uint32_t> queue{0};
  known[0] = 1;
  std::vector<SourceId> toggles, result;
  for (std::size_t q = 0; q < queue.size(); ++q) {
    const std::uint32_t face = queue[q];
    for (const std::uint32_t h : half_edges[face]) {
      const std::uint32_t across = loop_face_[loop_of_[h ^ 1]];
      if (known[across]) continue;
      toggles.clear();
      for (const SegmentId s : x_.edges.segments[edges_[h >> 1].edge]) {
        if (x_.segments.is_trace(s)) continue;
        for (const SourceId f : x_.segment_faces[s]) {
          if (x_.sheet_of[f] == content.sheet) toggles.push_back(f);
        }
      }
      std::sort(toggles.begin(), toggles.end());
      // A soup face with this edge twice on its boundary covers both sides of it or none.
      result.clear();
      std::size_t n = 0;
      for (std::size_t i = 0; i < toggles.size();) {
        std::size_t j = i;
        while (j < toggles.size() && toggles[j] == toggles[i]) ++j;
        if ((j - i) % 2 != 0) toggles[n++] = toggles[i];
        i = j;
      }
      toggles.resize(n);
      std::set_symmetric_difference(face_cover_[face].begin(), face_cover_[face].end(), toggles.begin(),
                                    toggles.end(), std::back_inserter(result));
      face_cover_[across] = result;
      known[across] = 1;
      queue.push_back(across);
    }
  }
  require(queue.size() == face_count_, "a face of a sheet was not reached");
}

SheetFaces Subdivider::emit(const SheetContent& content) {
  const PointTable& t = x_.input.points;
  SheetFaces out;
  // Loops of each face; loop order is that of their first half-edges, the outer one first.
  std::vector<std::vector<std::uint32_t>> loops(face_count_), points(face_count_);
  std::vector<char> is_outer_of_component(loop_first_.size(), 0);
  for (const std::uint32_t loop : component_outer_) is_outer_of_component[loop] = 1;
  for (std::uint32_t loop = 0; loop < loop_first_.size(); ++loop) {
    auto& list = loops[loop_face_[loop]];
    if (is_outer_of_component[loop] == 0) {
      list.insert(list.begin(), loop);
    } else {
      list.push_back(loop);
    }
  }
  for (std::uint32_t i = 0; i < isolated_.size(); ++i) points[isolated_face_[i]].push_back(i);
  std::vector<std::pair<SourceId, bool>> same;
  for (const SourceId f : content.faces) {
    const auto [a, b, c] = t.plane_points(RefineInput::plane(f));
    same.push_back({f, RefineInput::plane(f) == content.plane || orient2d(t, axes_, a, b, c) > 0});
  }
  const auto same_side = [&](SourceId f) {
    return std::lower_bound(same.begin(), same.end(), std::pair(f, false))->second;
  };
  for (std::size_t face = 1; face < face_count_; ++face) {
    if (face_cover_[face].empty()) continue;
    for (const std::uint32_t loop : loops[face]) {
      std::uint32_t h = loop_first_[loop];
      do {
        out.half_edges.push_back(HalfEdge(edges_[h >> 1].edge, h & 1));
        h = next_[h];
      } while (h != loop_first_[loop]);
      out.loop_end.push_back(static_cast<std::uint32_t>(out.half_edges.size()));
    }
    out.face_loop_end.push_back(static_cast<std::uint32_t>(out.loop_end.size()));
    for (const std::uint32_t i : points[face]) out.isolated.push_back(isolated_[i]);
    out.face_isolated_end.push_back(place32(out.isolated.size(), "vertices in the interior of faces"));
    for (const SourceId f : face_cover_[face]) out.covers.push_back({f, same_side(f)});
    out.face_cover_end.push_back(place32(out.covers.size(), "faces of leaves that cover faces"));
  }
  return out;
}

}  // namespace cnrg
