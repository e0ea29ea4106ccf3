// Enclosures are clustered axis by axis: sorted along one axis, a gap between enclosures separates what can not be
// equal; what remains is clustered along the next axis, until no axis separates any more. Only within such a
// cluster are exact coordinates compared. In general position every cluster holds one point.
#include "kernel/refine/identity.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "kernel/exact/predicates.h"
#include "kernel/refine/box.h"

namespace cnrg {

namespace {

struct Item {
  std::array<double, 3> lo, hi;
  VertexId vertex;
};

class Clusters {
 public:
  Clusters(const PointTable& table, VertexId first_new, UnionFind& identity)
      : table_(table), first_new_(first_new), identity_(identity) {}

  /// `settled` axes in a row did not separate the items.
  void split(Item* begin, Item* end, int axis, int settled) {
    if (end - begin < 2) return;
    if (std::none_of(begin, end, [&](const Item& i) { return i.vertex >= first_new_; })) return;
    if (settled == 3) {
      resolve(begin, end);
      return;
    }
    const auto before = [axis](const Item& a, const Item& b) {
      return a.lo[axis] != b.lo[axis] ? a.lo[axis] < b.lo[axis] : a.vertex < b.vertex;
    };
    if (end - begin > 4096) {
      tbb::parallel_sort(begin, end, before);
    } else {
      std::sort(begin, end, before);
    }
    Item* start = begin;
    double reach = begin->hi[axis];
    for (Item* i = begin + 1; i != end; ++i) {
      if (i->lo[axis] > reach) {
        split(start, i, (axis + 1) % 3, 0);
        start = i;
        reach = i->hi[axis];
      } else {
        reach = std::max(reach, i->hi[axis]);
      }
    }
    split(start, end, (axis + 1) % 3, start == begin ? settled + 1 : 0);
  }

 private:
  void resolve(Item* begin, Item* end) {
    std::sort(begin, end, [&](const Item& a, const Item& b) {
      const int order = compare_lex(table_, a.vertex, b.vertex);
      return order != 0 ? order < 0 : a.vertex < b.vertex;
    });
    for (Item* i = begin + 1; i != end; ++i) {
      if (compare_lex(table_, (i - 1)->vertex, i->vertex) == 0) {
        identity_.unite((i - 1)->vertex.value(), i->vertex.value());
      }
    }
  }

  const PointTable& table_;
  VertexId first_new_;
  UnionFind& identity_;
};

}  // namespace

void unite_coincident(const PointTable& table, VertexId first_new, UnionFind& identity) {
  if (first_new.index() == table.size()) return;
  Box reach;
  for (std::size_t i = first_new.index(); i < table.size(); ++i) {
    const PointView p = table.view(VertexId(i));
    reach.extend(p.lo, p.hi);
  }
  std::vector<Item> items;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const VertexId v(i);
    if (identity.find(v.value()) != v.value()) continue;  // stands for nothing but its representative
    const PointView p = table.view(v);
    if (v >= first_new || Box{p.lo, p.hi}.meets(reach)) items.push_back({p.lo, p.hi, v});
  }
  Clusters(table, first_new, identity).split(items.data(), items.data() + items.size(), 0, 0);
}

}  // namespace cnrg
