// From symbols of points to vertices: where inputs meet, each key becomes one vertex.
//
// The same key is found again and again, by threads, in an order of chance. Here every key is taken once and in
// the order of keys, so that the numbers of the new vertices are those of every run. Different keys may still be
// one point (where four planes meet, any three of them name it): coordinates decide that (below), and asking
// for a key gives the one vertex that stands for its point.
#pragma once

#include <vector>

#include "kernel/base/error.h"
#include "kernel/base/number_table.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/points.h"
#include "kernel/refine/point_key.h"

namespace cnrg {

// Which constructed points are one: symbols first (equal keys), then enclosures, and exact equality only where
// enclosures overlap.

/// Unites all vertices of `table` from `first_new` on with every vertex that has the same coordinates, among
/// themselves and among the earlier ones. The representative of a set is its smallest id.
void unite_coincident(const PointTable& table, VertexId first_new, UnionFind& identity);

class KeyedPoints {
 public:
  /// Adds a point to `table` and to `identity` for each of the keys that is not a vertex already, and unites those
  /// that coincide with one another or with earlier points. Called once. `identity` must outlive this: it may be
  /// changed and says what stands for a point later on.
  void add(PointTable& table, UnionFind& identity, const RefineInput& in, const std::vector<PointKey>& keys);

  /// The vertex of a key that was added.
  VertexId operator()(const PointKey& key) const {
    if (key.kind == PointKey::Kind::vertex) return VertexId(key.id[0]);
    const std::uint32_t place = places_.find(key.hash(), [&](std::uint32_t k) { return keys_[k] == key; });
    require(place != NumberTable::kNone, "a point key was never made");
    return VertexId(identity_->find(first_.value() + place));
  }

 private:
  void collect(const std::vector<PointKey>& keys);

  std::vector<PointKey> keys_;  // ascending, each once
  NumberTable places_;          // of them
  VertexId first_;              // that of keys_[0]; the others follow
  UnionFind* identity_ = nullptr;
};

}  // namespace cnrg
