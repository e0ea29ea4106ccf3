// Numbers rounded outward, each mostly once; see the header.
#include "csg/leaves/facet_boxes.h"

#include <algorithm>
#include <cmath>

namespace cnrg {

FacetBoxes::Index FacetBoxes::number(const Rational& value) {
  Known& known = known_[reinterpret_cast<std::uintptr_t>(&value) / sizeof(Rational) % known_.size()];
  if (known.number == kNone || known.value != value) {
    known = {value, static_cast<Index>(values_.size())};
    const double nearest = to_double(value);
    if (is_double(value)) values_.push_back({nearest, nearest});
    else values_.push_back({std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)});
  }
  return known.number;
}

void FacetBoxes::add(std::span<const std::array<const Rational*, 2>> corners) {
  auto& box = boxes_.emplace_back();
  for (std::size_t d = 0; d < 2; ++d) {
    for (const auto& corner : corners) {
      const Index n = number(*corner[d]);
      if (&corner == corners.data()) box[2 * d] = box[2 * d + 1] = n;
      if (values_[n][0] < values_[box[2 * d]][0]) box[2 * d] = n;
      if (values_[n][1] > values_[box[2 * d + 1]][1]) box[2 * d + 1] = n;
    }
  }
}

bool FacetBoxes::empty() const {
  return std::all_of(boxes_.begin(), boxes_.end(), [](const auto& box) { return box[0] == kNone; });
}

FacetBoxes::Box FacetBoxes::of(std::size_t facet) const {
  const auto& [u_low, u_high, v_low, v_high] = boxes_[facet];
  return {{{values_[u_low][0], values_[u_high][1]}, {values_[v_low][0], values_[v_high][1]}}};
}

}  // namespace cnrg
