// A point where many inputs meet is found by each pair of them. So repeated keys are dropped by a hash first, and
// only what is left is sorted.
#include "kernel/refine/keyed_points.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>

#include "kernel/base/number_table.h"
#include "kernel/base/point_hash.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/morton.h"

namespace cnrg {
namespace {

// Enclosures are clustered axis by axis: sorted along one axis, a gap between enclosures separates what cannot be
// equal; what remains is clustered along the next axis, until no axis separates any more. Only within such a
// cluster are exact coordinates compared. In general position every cluster holds one point. An enclosure without
// extent (points of a grid have such) is the point itself: equal ones are found by a hash, and one of each goes
// into the clusters.

struct VertexBox {
  std::array<double, 3> lo, hi;
  VertexId vertex;
};

/// Which of many thin strips across each axis hold a part of an item: a point outside of these strips along some
/// axis cannot be equal to an item.
class Strips {
 public:
  /// Around two lists of items.
  Strips(const std::vector<VertexBox>& items, const std::vector<VertexBox>& more)
      : bits_(std::min<int>(16, 4 + std::bit_width(items.size() + more.size()))) {
    Box all;
    for (const VertexBox& i : items) all.extend(i.lo, i.hi);
    for (const VertexBox& i : more) all.extend(i.lo, i.hi);
    grid_ = Grid(all);
    for (std::size_t k = 0; k < 3; ++k) {
      held_[k].assign(std::size_t{1} << bits_, 0);
      lo_[k] = all.lo[k];
      hi_[k] = all.hi[k];
      const auto hold = [&](const VertexBox& i) {
        std::fill(held_[k].begin() + strip(i.lo[k], k), held_[k].begin() + strip(i.hi[k], k) + 1, 1);
      };
      std::for_each(items.begin(), items.end(), hold);
      std::for_each(more.begin(), more.end(), hold);
    }
  }
  bool meet(const PointTable& table, VertexId v) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const double lo = table.lower(v)[axis], hi = table.upper(v, axis);
      if (hi < lo_[k] || lo > hi_[k]) return false;
      const auto first = held_[k].begin() + strip(lo, k), last = held_[k].begin() + strip(hi, k) + 1;
      if (std::find(first, last, 1) == last) return false;
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
  void split(VertexBox* begin, VertexBox* end, int axis, int settled) {
    if (end - begin < 2) return;
    if (std::none_of(begin, end, [&](const VertexBox& i) { return i.vertex >= first_new_; })) return;
    if (settled == 3) {
      resolve(begin, end);
      return;
    }
    const auto before = [axis](const VertexBox& a, const VertexBox& b) {
      return a.lo[axis] != b.lo[axis] ? a.lo[axis] < b.lo[axis] : a.vertex < b.vertex;
    };
    if (end - begin > 4096) {
      tbb::parallel_sort(begin, end, before);
    } else {
      std::sort(begin, end, before);
    }
    VertexBox* start = begin;
    double reach = begin->hi[axis];
    for (VertexBox* i = begin + 1; i != end; ++i) {
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
  void resolve(VertexBox* begin, VertexBox* end) {
    std::sort(begin, end, [&](const VertexBox& a, const VertexBox& b) {
      const int order = compare_lex(table_, a.vertex, b.vertex);
      return order != 0 ? order < 0 : a.vertex < b.vertex;
    });
    for (VertexBox* i = begin + 1; i != end; ++i) {
      if (compare_lex(table_, (i - 1)->vertex, i->vertex) == 0) {
        identity_.unite((i - 1)->vertex.value(), i->vertex.value());
      }
    }
  }

  const PointTable& table_;
  VertexId first_new_;
  UnionFind& identity_;
};

/// Unites exact items with equal coordinates; returns one of each.
std::vector<VertexBox> unite_exact(const std::vector<VertexBox>& items, UnionFind& identity) {
  NumberTable numbers(items.size());
  std::vector<VertexBox> distinct;
  for (const VertexBox& item : items) {
    std::uint32_t& number =
        numbers.slot(hash_of_point(item.lo.data()), [&](std::uint32_t k) { return distinct[k].lo == item.lo; });
    if (number == NumberTable::kNone) {
      number = static_cast<std::uint32_t>(distinct.size());
      distinct.push_back(item);
    } else {
      identity.unite(distinct[number].vertex.value(), item.vertex.value());
    }
  }
  return distinct;
}

}  // namespace

void unite_coincident(const PointTable& table, VertexId first_new, UnionFind& identity) {
  if (first_new.index() == table.size()) return;
  std::vector<VertexBox> exact, vague;  // an enclosure of one point is the point
  const auto add = [&](VertexId v) {
    if (identity.find(v.value()) != v.value()) return;  // its representative is added
    const PointView p = table.view(v);
    (p.is_double() ? exact : vague).push_back({p.lo, p.hi, v});
  };
  for (VertexId v = first_new; v.index() < table.size(); ++v) add(v);
  Strips near(exact, vague);
  for (VertexId v(0); v < first_new; ++v) {
    if (near.meet(table, v)) add(v);
  }
  exact = unite_exact(exact, identity);
  if (vague.empty()) return;
  near = Strips(vague, {});
  for (const VertexBox& item : exact) {
    if (near.meet(table, item.vertex)) vague.push_back(item);
  }
  Clusters(table, first_new, identity).split(vague.data(), vague.data() + vague.size(), 0, 0);
}

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
