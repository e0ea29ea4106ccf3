// Which constructed points are one: symbols first (equal keys), then enclosures, and exact equality only where
// enclosures overlap.
#pragma once

#include "kernel/base/union_find.h"
#include "kernel/exact/points.h"

namespace cnrg {

/// Unites all vertices of `table` from `first_new` on with every vertex that has the same coordinates, among
/// themselves and among the earlier ones. The representative of a set is its smallest id.
void unite_coincident(const PointTable& table, VertexId first_new, UnionFind& identity);

}  // namespace cnrg
