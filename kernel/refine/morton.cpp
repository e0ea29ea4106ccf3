// The Morton code of a point takes the bits of its three coordinates in turn, the highest first: 21 bits of each
// here. Points with near codes are mostly near in space. Boxes are sorted by the codes of their middles.
#include "kernel/refine/morton.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "kernel/base/counts.h"
#include "kernel/base/parallel.h"

namespace cnrg {

namespace {

struct CodedBox {
  std::uint64_t code;
  std::uint32_t box;
  friend bool operator<(const CodedBox& a, const CodedBox& b) {
    return a.code != b.code ? a.code < b.code : a.box < b.box;
  }
};

/// Spreads the lowest 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}

/// Sorts by the highest bits into buckets, then each bucket by itself, in parallel.
void sort(std::vector<CodedBox>& items) {
  if (items.size() < 4096) {
    std::sort(items.begin(), items.end());
    return;
  }
  constexpr std::size_t kBits = 15, kShift = 63 - kBits, kBuckets = std::size_t{1} << kBits;
  std::vector<std::uint32_t> begin(kBuckets + 1, 0);
  for (const CodedBox& i : items) ++begin[(i.code >> kShift) + 1];
  for (std::size_t b = 0; b < kBuckets; ++b) begin[b + 1] += begin[b];
  std::vector<CodedBox> sorted(items.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const CodedBox& i : items) sorted[next[i.code >> kShift]++] = i;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kBuckets, 256), [&](const auto& range) {
    for (std::size_t b = range.begin(); b < range.end(); ++b) {
      if (begin[b + 1] - begin[b] > 1) std::sort(sorted.begin() + begin[b], sorted.begin() + begin[b + 1]);
    }
  });
  items = std::move(sorted);
}

}  // namespace

Grid::Grid(const Box& all) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double size = all.hi[k] / 2 - all.lo[k] / 2;
    if (!(size > 0) || !std::isfinite(size) || !std::isfinite(kLast / size)) continue;
    origin_[k] = all.lo[k] / 2;
    scale_[k] = kLast / size;
  }
}

std::vector<std::uint32_t> morton_order(const std::vector<Box>& boxes, const Grid& grid) {
  check_count(boxes.size(), "boxes");
  std::vector<CodedBox> items(boxes.size());
  for_each_index(boxes.size(), [&](std::size_t i) {
    std::uint64_t code = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double middle = boxes[i].lo[k] / 2 + boxes[i].hi[k] / 2;
      code |= spread(static_cast<std::uint64_t>(grid(middle, k)) >> 9) << k;
    }
    items[i] = {code, static_cast<std::uint32_t>(i)};
  });
  sort(items);
  std::vector<std::uint32_t> order(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].box;
  return order;
}

}  // namespace cnrg
