#include "csg/operators/leaf_order.h"

namespace cnrg {

std::uint32_t LeafOrder::place(LeafId leaf) const {
  if (!listing_) return leaf.value();
  if (place_.empty()) {
    const std::vector<LeafId> all = listing_();
    place_.resize(all.empty() ? 0 : std::max_element(all.begin(), all.end())->index() + 1);
    for (std::uint32_t i = 0; i < all.size(); ++i) place_[all[i]] = i;
  }
  return place_[leaf];
}

std::vector<std::uint32_t> LeafOrder::places(const std::vector<LeafId>& leaves) const {
  std::vector<std::uint32_t> places;
  places.reserve(leaves.size());
  for (const LeafId leaf : leaves) places.push_back(place(leaf));
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace cnrg
