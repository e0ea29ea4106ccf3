// Regions as connected sets of half-faces. Half-faces that edges connect are a shell; shells that no edge connects
// (islands, cavities), wires and points are connected by one ray each.

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/parallel.h"
#include "kernel/complex/builder.h"
#include "kernel/complex/ray.h"

namespace cnrg {
namespace {

// Patches: faces joined side to side through edges that have two of them.
//
// Where two half-faces meet, their opposites meet too; so one union-find over faces does for both sides. It keeps
// for the front of each face a half-face that it is joined to, of a smaller face. Threads join at the same time
// (Anderson, Woll 1991): only a root is given a parent, by one atomic exchange; what a find writes was an ancestor
// and stays one. In the end the root is the smallest face of its patch, whatever the order.

class Patches {
 public:
  explicit Patches(std::size_t faces) : parent_(faces) {
    for (const FaceId f : IdRange<FaceId>(faces)) set(f, HalfFace(f, 0).code());
  }

  /// Joins a with b and their opposites. False if a was joined with the opposite of b: the patch has one side.
  bool unite(HalfFace a, HalfFace b);

  /// Numbers the patches by their first faces. Side 0 of a patch is the front of its first face: result[f] is
  /// 2 * patch + side for the front of f. No join may follow.
  IdVector<FaceId, std::uint32_t> number(std::size_t& count) const;

 private:
  HalfFace parent(HalfFace h) const { return half_face(get(h.face()) ^ h.side()); }
  std::uint32_t get(FaceId f) const { return parent_[f.index()].load(std::memory_order_relaxed); }
  void set(FaceId f, std::uint32_t code) { parent_[f.index()].store(code, std::memory_order_relaxed); }
  static HalfFace half_face(std::uint32_t code) { return HalfFace(FaceId(code >> 1), code & 1); }
  HalfFace root(HalfFace h);

  std::vector<std::atomic<std::uint32_t>> parent_;  // of the front of each face: the code of a half-face
};

inline HalfFace Patches::root(HalfFace h) {
  for (;;) {
    const HalfFace up = parent(h);
    if (up == h) return h;
    const HalfFace next = parent(up);
    if (next != up) set(h.face(), next.code() ^ h.side());
    h = next;
  }
}

inline bool Patches::unite(HalfFace a, HalfFace b) {
  for (;;) {
    a = root(a);
    b = root(b);
    if (a.face() == b.face()) return a == b;
    if (a.face() < b.face()) std::swap(a, b);
    std::uint32_t alone = HalfFace(a.face(), 0).code();
    if (parent_[a.face().index()].compare_exchange_strong(alone, b.code() ^ a.side(), std::memory_order_relaxed)) {
      return true;
    }
  }
}

inline IdVector<FaceId, std::uint32_t> Patches::number(std::size_t& count) const {
  IdVector<FaceId, std::uint32_t> sides(parent_.size());
  count = 0;
  for (const FaceId f : IdRange<FaceId>(parent_.size())) {
    const HalfFace up = half_face(get(f));
    sides[f] = up.face() == f ? static_cast<std::uint32_t>(2 * count++) : sides[up.face()] ^ up.side();
  }
  return sides;
}

/// More rays than these are worth a look for surfaces that need none, and a tree of boxes.
constexpr std::size_t kFewRays = 16;

}  // namespace

/// Neighbours in radial order have a shell in common: the side that looks counter-clockwise is the front for a use
/// along the edge, the back for one against it. At an edge with two uses both sides of the one face are joined to
/// both of the other, so faces grow into patches first; at all other edges, the junctions, sides of
/// patches are joined.
void ComplexBuilder::join_shells() {
  Patches patches(c_.face_count());
  tbb::enumerable_thread_specific<std::vector<EdgeId>> turning;
  for_each_index(c_.edge_count(), [&](std::size_t i) {
    const auto uses = std::as_const(c_.edge_uses)[EdgeId(i)];
    if (uses.size() != 2 || patches.unite(uses[0].after(), uses[1].before())) return;
    turning.local().push_back(EdgeId(i));
  });
  std::size_t patch_count = 0;
  front_side_ = patches.number(patch_count);

  UnionFind sides(2 * patch_count);
  const auto join_around = [&](EdgeId e) {
    const auto uses = std::as_const(c_.edge_uses)[e];
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const FaceUse &x = uses[i], &y = uses[i + 1 < uses.size() ? i + 1 : 0];
      sides.unite(patch_side(x.after()), patch_side(y.before()));
    }
  };
  for (const EdgeId e : junctions_) join_around(e);
  for (const auto& list : turning) std::for_each(list.begin(), list.end(), join_around);

  side_shell_.resize(sides.size());
  for (std::uint32_t s = 0; s < sides.size(); ++s) {
    const std::uint32_t first = sides.find(s);
    side_shell_[s] = first == s ? ShellId(shell_count_++) : side_shell_[first];
  }
}

/// Surfaces: faces connected through edges. One ray for each that another may hold, from a face that reaches far
/// in x, to infinity.
void ComplexBuilder::nest_shells() {
  const auto infinity = static_cast<std::uint32_t>(shell_count_);
  space_ = UnionFind(shell_count_ + 1);
  UnionFind surfaces(shell_count_);
  for (std::size_t s = 0; s < side_shell_.size(); s += 2) {
    surfaces.unite(side_shell_[s].value(), side_shell_[s + 1].value());
  }
  std::vector<FaceId> starts = farthest_faces(surfaces);
  if (starts.size() > kFewRays) starts = join_outermost(std::move(starts), surfaces);
  if (starts.empty()) return;
  const RayCaster caster(c_, starts.size() > kFewRays);
  std::vector<std::vector<std::uint32_t>> joins(starts.size());
  tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
    const RayCaster::Ray ray = caster.cast(interior_point(c_, starts[i]), starts[i]);
    joins[i].push_back(shell(caster.leaving(starts[i], ray)).value());
    for (const HalfFace h : ray.hits) {
      joins[i].push_back(shell(h).value());
      joins[i].push_back(shell(h.opposite()).value());
    }
    joins[i].push_back(infinity);
  });
  for (const auto& list : joins) {
    for (std::size_t i = 0; i < list.size(); i += 2) space_.unite(list[i], list[i + 1]);
  }
}

/// Of each surface the first face that reaches farthest in x. A surface is what the two sides of faces connect.
std::vector<FaceId> ComplexBuilder::farthest_faces(UnionFind& surfaces) const {
  std::vector<double> x(c_.points.size());
  for_each_index(x.size(), [&](std::size_t v) { x[v] = c_.points.view(VertexId(v)).hi[0]; });
  IdVector<FaceId, double> reach(c_.face_count());
  for_each_index(reach.size(), [&](std::size_t i) {
    const FaceId f(i);
    double far = -std::numeric_limits<double>::infinity();
    for (const HalfEdge h : c_.loop[c_.face_loops[f].front()]) far = std::max(far, x[c_.origin(h).index()]);
    reach[f] = far;
  });
  std::vector<FaceId> farthest(shell_count_);
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    FaceId& best = farthest[surfaces.find(shell(HalfFace(f, 0)).value())];
    if (!best.valid() || reach[f] > reach[best]) best = f;
  }
  std::erase(farthest, FaceId::none());
  return farthest;
}

/// Wires and points that touch no face: those connected through vertices hang in one region; one ray for each set.
void ComplexBuilder::hang_wires() {
  if (wires_.empty() && loose_.empty()) return;
  const auto infinity = static_cast<std::uint32_t>(shell_count_), first_wire = infinity + 1;
  const auto first_loose = first_wire + static_cast<std::uint32_t>(wires_.size());
  for (std::size_t i = 0; i < wires_.size() + loose_.size(); ++i) space_.add();
  const auto node = [&](EdgeId wire) {
    const auto place = std::lower_bound(wires_.begin(), wires_.end(), wire);
    return first_wire + static_cast<std::uint32_t>(place - wires_.begin());
  };
  const auto is_wire = [&](EdgeId e) { return std::as_const(c_.edge_uses)[e].empty(); };
  const auto touches_face = [&](VertexId v) {
    if (!std::as_const(c_.vertex_faces)[v].empty()) return true;
    const auto edges = std::as_const(c_.vertex_edges)[v];
    return !std::all_of(edges.begin(), edges.end(), is_wire);
  };
  for (const EdgeId e : wires_) {
    for (const VertexId v : c_.edge_ends[e]) {
      const auto edges = std::as_const(c_.vertex_edges)[v];
      if (edges.front() != e || touches_face(v)) continue;
      for (const EdgeId other : edges) space_.unite(node(e), node(other));
    }
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = first_wire; n < space_.size(); ++n) {
    if (space_.find(n) == n) nodes.push_back(n);
  }
  const RayCaster caster(c_, nodes.size() > kFewRays);
  std::vector<std::uint32_t> found(nodes.size());
  tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
    const ExactPoint p = nodes[i] >= first_loose ? c_.points.exact(loose_[nodes[i] - first_loose])
                                                 : interior_point(c_, wires_[nodes[i] - first_wire]);
    const RayCaster::Ray ray = caster.cast(p);
    found[i] = ray.hits.empty() ? infinity : shell(ray.hits.front()).value();
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) space_.unite(nodes[i], found[i]);
}

/// Infinity is the first; all others are in the order of region_order.cpp.
void ComplexBuilder::number_regions() {
  std::vector<RegionId> region_of(space_.size());  // of the nodes of space_
  const auto number = [&](std::uint32_t node) {
    RegionId& region = region_of[space_.find(node)];
    if (!region.valid()) region = RegionId(c_.region_count++);
    region_of[node] = region;
  };
  const auto infinity = static_cast<std::uint32_t>(shell_count_);
  number(infinity);
  for (std::uint32_t n = 0; n < space_.size(); ++n) number(n);
  const std::vector<std::uint32_t> places = places_of_regions(region_of);
  for (RegionId& region : region_of) region = RegionId(places[region.index()]);
  list_region_faces(region_of);

  const std::size_t first_wire = infinity + 1, first_loose = first_wire + wires_.size();
  std::vector<std::pair<EdgeId, RegionId>> wires;
  for (std::size_t i = 0; i < wires_.size(); ++i) wires.push_back({wires_[i], region_of[first_wire + i]});
  c_.region_wires = Csr<RegionId, EdgeId>::counted(c_.region_count, [&](const auto& take) {
    for (const auto& [e, region] : wires) take(region, e);
  });
  c_.edge_region = SparseVector(std::move(wires));
  std::vector<std::pair<VertexId, RegionId>> loose;
  for (std::size_t i = 0; i < loose_.size(); ++i) loose.push_back({loose_[i], region_of[first_loose + i]});
  c_.region_vertices = Csr<RegionId, VertexId>::counted(c_.region_count, [&](const auto& take) {
    for (const auto& [v, region] : loose) take(region, v);
  });
  c_.vertex_region = SparseVector(std::move(loose));
}

/// The half-faces of a region shell by shell, ascending in each.
void ComplexBuilder::list_region_faces(const std::vector<RegionId>& region_of) {
  std::vector<std::uint32_t> size(shell_count_, 0), next(shell_count_);
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    for (const unsigned side : {0u, 1u}) ++size[shell(HalfFace(f, side)).index()];
  }
  const auto shells = Csr<RegionId, ShellId>::counted(c_.region_count, [&](const auto& take) {
    for (const ShellId s : IdRange<ShellId>(shell_count_)) take(region_of[s.index()], s);
  });
  std::vector<std::uint32_t> offsets{0};
  std::uint32_t end = 0;
  for (const RegionId r : IdRange<RegionId>(c_.region_count)) {
    for (const ShellId s : shells[r]) {
      next[s.index()] = end;
      end += size[s.index()];
    }
    offsets.push_back(end);
  }
  std::vector<HalfFace> faces(end);
  c_.face_regions.resize(c_.face_count());
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    for (const unsigned side : {0u, 1u}) {
      const HalfFace h(f, side);
      const std::size_t s = shell(h).index();
      c_.face_regions[f][side] = region_of[s];
      faces[next[s]++] = h;
    }
  }
  c_.region_faces = Csr<RegionId, HalfFace>::from_parts(std::move(offsets), std::move(faces));
  if (!c_.frame.valid()) return;
  c_.frame_regions_.assign(c_.region_count, 0);
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    if (!c_.on_frame(f)) continue;
    for (const RegionId r : c_.face_regions[f]) c_.frame_regions_[r] = 1;
  }
}

}  // namespace cnrg
