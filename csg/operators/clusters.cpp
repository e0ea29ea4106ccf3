// Pairs of boxes that meet, then the sets that they connect. Where two sides are compared, boxes are looked for
// among those of the side that has fewer: in a chain of Booleans one small operand meets a value of many parts in
// each step, and most of these are passed over by one comparison with the box around the few.
#include "csg/operators/clusters.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/refine/box_pairs.h"

namespace cnrg {
namespace {

struct Item {
  const PartBox* box;
  PartPlace place;
};
using Items = std::span<const Item>;

bool finite(const PartBox& box) {
  const auto all = [](const std::array<float, 3>& x) {
    return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
  };
  return all(box.low) && all(box.high);
}

Box kernel_box(const PartBox& box) {
  Box out;
  out.extend({box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]});
  return out;
}

// The bounded items in a tree of boxes, and the others.
class Boxes {
 public:
  explicit Boxes(Items items) : items_(items), pairs_(bounded_boxes()) {}

  // Calls found(item) for those whose boxes meet that of `other`.
  template <class Found>
  void for_each_meeting(const Item& other, Found found) const {
    const auto check = [&](std::uint32_t i) {
      if (items_[i].box->meets(*other.box)) found(items_[i]);
    };
    for (const std::uint32_t i : unbounded_) check(i);
    if (finite(*other.box)) pairs_.query(kernel_box(*other.box), [&](std::uint32_t b) { check(bounded_[b]); });
    else std::for_each(bounded_.begin(), bounded_.end(), check);
  }

  // Calls found(one, other) for all pairs whose boxes may meet.
  template <class Found>
  void for_each_pair(Found found) const {
    for (const std::uint32_t i : unbounded_) {
      for (const Item& other : items_) found(items_[i], other);
    }
    for (std::size_t part = 0; part < pairs_.part_count(); ++part) {
      pairs_.find(part, [&](std::uint32_t x, std::uint32_t y) {
        found(items_[bounded_[pairs_.item(x)]], items_[bounded_[pairs_.item(y)]]);
      });
    }
  }

 private:
  std::vector<Box> bounded_boxes() {
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < items_.size(); ++i) {
      if (!finite(*items_[i].box)) {
        unbounded_.push_back(i);
        continue;
      }
      bounded_.push_back(i);
      boxes.push_back(kernel_box(*items_[i].box));
    }
    return boxes;
  }

  Items items_;
  std::vector<std::uint32_t> bounded_, unbounded_;
  BoxPairs pairs_;
};

PartBox hull(Items items) {
  PartBox out = *items[0].box;
  for (const Item& item : items) {
    for (std::size_t k = 0; k < 3; ++k) {
      out.low[k] = std::min(out.low[k], item.box->low[k]);
      out.high[k] = std::max(out.high[k], item.box->high[k]);
    }
  }
  return out;
}

using Meetings = std::vector<std::pair<PartPlace, PartPlace>>;

// The pairs between `few`, the parts of one side, and the parts of `operands`, whose numbers begin with `first`.
Meetings across(Items few, std::span<const PartedGroup> operands, std::uint32_t first) {
  Meetings out;
  if (few.empty()) return out;
  const PartBox all = hull(few);
  std::optional<Boxes> boxes;
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    const std::vector<PartRef>& many = operands[k].parts;
    for (std::uint32_t i = 0; i < many.size(); ++i) {
      if (!many[i].box().meets(all)) continue;
      if (!boxes) boxes.emplace(few);
      const Item item{&many[i].box(), {first + k, i}};
      boxes->for_each_meeting(item, [&](const Item& other) { out.emplace_back(item.place, other.place); });
    }
  }
  return out;
}

Meetings among(Items items) {
  Meetings out;
  Boxes(items).for_each_pair([&](const Item& a, const Item& b) {
    if (a.place.operand != b.place.operand) out.emplace_back(a.place, b.place);
  });
  return out;
}

std::vector<Item> items_of(std::span<const PartedGroup> operands, std::uint32_t first) {
  std::vector<Item> items;
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    std::uint32_t number = 0;
    for (const PartRef& part : operands[k].parts) items.push_back({&part.box(), {first + k, number++}});
  }
  return items;
}

Meetings find_meetings(BooleanOp op, std::span<const PartedGroup> operands) {
  if (op == BooleanOp::unite && operands.size() > 2) return among(items_of(operands, 0));
  const auto first = operands.first(1), others = operands.subspan(1);
  std::size_t count = 0;
  for (const PartedGroup& operand : others) count += operand.parts.size();
  return first[0].parts.size() < count ? across(items_of(first, 0), others, 1)
                                       : across(items_of(others, 1), first, 0);
}

}  // namespace

std::vector<Cluster> find_clusters(BooleanOp op, std::span<const PartedGroup> operands) {
  const Meetings meetings = find_meetings(op, operands);
  if (meetings.empty()) return {};
  std::vector<PartPlace> met;
  for (const auto& [a, b] : meetings) met.push_back(a), met.push_back(b);
  sort_unique(met);
  const auto number = [&](const PartPlace& place) {
    return static_cast<std::uint32_t>(std::lower_bound(met.begin(), met.end(), place) - met.begin());
  };
  UnionFind sets(met.size());
  for (const auto& [a, b] : meetings) sets.unite(number(a), number(b));
  std::vector<Cluster> clusters;
  std::vector<std::size_t> cluster_of(met.size());
  for (std::uint32_t i = 0; i < met.size(); ++i) {
    const std::uint32_t first = sets.find(i);  // the smallest of its set
    if (first == i) {
      cluster_of[i] = clusters.size();
      clusters.emplace_back();
    }
    clusters[cluster_of[first]].push_back(met[i]);
  }
  return clusters;
}

}  // namespace cnrg
