// Enclosures are clustered axis by axis: sorted along one axis, a gap between enclosures separates what can not be
// equal; what remains is clustered along the next axis, until no axis separates any more. Only within such a
// cluster are exact coordinates compared. In general position every cluster holds one point.
#include "kernel/refine/identity.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>

#include "kernel/exact/predicates.h"
#include "kernel/refine/morton.h"

namespace cnrg {

namespace {

struct Item {
  std::array<double, 3> lo, hi;
  VertexId vertex;
};

/// Which of many thin strips across each axis hold a part of an item: what lies in none can not be equal to one.
class Strips {
 public:
  explicit Strips(const std::vector<Item>& items) : bits_(std::min<int>(16, 4 + std::bit_width(items.size()))) {
    Box all;
    for (const Item& i : items) all.extend(i.lo, i.hi);
    grid_ = Grid(all);
    for (std::size_t k = 0; k < 3; ++k) {
      held_[k].assign(std::size_t{1} << bits_, 0);
      lo_[k] = all.lo[k];
      hi_[k] = all.hi[k];
      for (const Item& i : items) {
        std::fill(held_[k].begin() + strip(i.lo[k], k), held_[k].begin() + strip(i.hi[k], k) + 1, 1);
      }
    }
  }
  bool meet(const PointTable& table, VertexId v) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const double lo = table.lower(v)[axis], hi = table.upper(v, axis);
      if (hi < lo_[k] || lo > hi_[k]) return false;
      bool held = false;
      for (std::int32_t i = strip(lo, k); i <= strip(hi, k) && !held; ++i) held = held_[k][static_cast<std::size_t>(i)] != 0;
      if (!held) return false;
    }
    return true;
  }

 private:
  std::int32_t strip(double x, std::size_t axis) const { return grid_(x, axis) >> (30 - bits_); }
  int bits_;
  Grid grid_;
  std::array<double, 3> lo_{}, hi_{};
  std::array<std::vector<char>, 3> held_;
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
  std::vector<Item> items;
  const auto add = [&](VertexId v) {
    if (identity.find(v.value()) != v.value()) return;  // stands for nothing but its representative
    const PointView p = table.view(v);
    items.push_back({p.lo, p.hi, v});
  };
  for (VertexId v = first_new; v.index() < table.size(); ++v) add(v);
  const Strips near(items);
  for (VertexId v(0); v < first_new; ++v) {
    if (near.meet(table, v)) add(v);
  }
  Clusters(table, first_new, identity).split(items.data(), items.data() + items.size(), 0, 0);
}

}  // namespace cnrg
