// Each vertex is held by the leaf that comes first; who comes later is listed. Which leaf that is depends on the
// threads, how many there are does not.
#include "kernel/refine/shared_vertices.h"

#include <tbb/enumerable_thread_specific.h>

#include <atomic>

#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"

namespace cnrg {

std::uint64_t shared_vertices(const Soup& soup, const RefineInput& in) {
  if (soup.leaf_count() < 2) return 0;
  constexpr std::uint32_t kFree = 0xffffffffu;
  using Later = std::vector<std::pair<VertexId, LeafId>>;
  std::vector<std::uint32_t> holders(in.points.size(), kFree);
  tbb::enumerable_thread_specific<Later> lists;
  const auto enter = [&](VertexId v, LeafId leaf) {
    const std::atomic_ref entry(holders[v.index()]);
    std::uint32_t holder = entry.load(std::memory_order_relaxed);
    if (holder == leaf.value()) return;
    if (holder == kFree && entry.compare_exchange_strong(holder, leaf.value(), std::memory_order_relaxed)) return;
    if (holder != leaf.value()) lists.local().emplace_back(v, leaf);
  };
  for_each_index(in.corners.size(), [&](std::size_t i) {
    const LeafId leaf = soup.face(SourceId(i)).leaf;
    if (leaf == soup.frame()) return;
    for (const VertexId v : in.corners[SourceId(i)]) {
      if (v.valid()) enter(v, leaf);
    }
  });
  for_each_of(soup.wires(), [&](const Soup::Wire& wire) {
    for (const PointId p : {wire.a, wire.b}) enter(in.vertex_of[p.index()], wire.leaf);
  });
  for_each_of(soup.isolated(), [&](const Soup::Isolated& p) { enter(in.vertex_of[p.point.index()], p.leaf); });
  Later later;
  for (const Later& list : lists) later.insert(later.end(), list.begin(), list.end());
  sort_unique(later);
  // The leaf that is the k-th one to come after the first makes a pair with each of the k before it.
  std::uint64_t count = 0, before = 0;
  for (std::size_t i = 0; i < later.size(); ++i) {
    before = i > 0 && later[i - 1].first == later[i].first ? before + 1 : 1;
    count += before;
  }
  return count;
}

}  // namespace cnrg
