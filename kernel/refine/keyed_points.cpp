// A point where many inputs meet is found by each pair of them. So repeated keys are dropped by a hash first, and
// only what is left is sorted.
#include "kernel/refine/keyed_points.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "kernel/refine/identity.h"

namespace cnrg {

void KeyedPoints::add(PointTable& table, UnionFind& identity, const RefineInput& in,
                      const std::vector<PointKey>& keys) {
  collect(keys);
  std::vector<std::array<double, 3>> lo(keys_.size()), hi(keys_.size());
  tbb::parallel_for(std::size_t{0}, keys_.size(),
                    [&](std::size_t i) { table.enclose(definition_of(keys_[i], in), lo[i], hi[i]); });
  first_ = VertexId(table.size());
  identity_ = &identity;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    table.add(definition_of(keys_[i], in), lo[i], hi[i]);
    identity.add();
  }
  unite_coincident(table, first_, identity);
}

void KeyedPoints::collect(const std::vector<PointKey>& keys) {
  const auto append = [](NumberTable& places, const PointKey& key, std::vector<PointKey>& list) {
    std::uint32_t& place = places.slot(key.hash(), [&](std::uint32_t k) { return list[k] == key; });
    if (place != NumberTable::kNone) return;
    place = next_number(list.size(), "points where leaves meet");
    list.push_back(key);
  };
  std::vector<PointKey> distinct;
  NumberTable seen(keys.size());
  for (const PointKey& key : keys) {
    if (key.kind != PointKey::Kind::vertex) append(seen, key, distinct);
  }
  tbb::parallel_sort(distinct.begin(), distinct.end());
  places_ = NumberTable(distinct.size());
  keys_.clear();
  for (const PointKey& key : distinct) append(places_, key, keys_);
}

}  // namespace cnrg
