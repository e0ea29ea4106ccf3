#include "kernel/refine/box_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace cnrg {

namespace {

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

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) {
  const std::size_t n = boxes.size();
  if (n == 0) return;
  Box all;
  for (const Box& b : boxes) all.extend(b);
  std::array<double, 3> scale;
  for (int k = 0; k < 3; ++k) {
    const double size = all.hi[k] / 2 - all.lo[k] / 2;
    scale[k] = size > 0 && std::isfinite(size) ? 1048575.0 / size : 0.0;
    if (!std::isfinite(scale[k])) scale[k] = 0.0;
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k) {
      const double middle = boxes[i].lo[k] / 2 + boxes[i].hi[k] / 2;
      double t = (middle / 2 - all.lo[k] / 2) * scale[k] * 2;
      if (!(t >= 0)) t = 0;
      if (t > 2097151.0) t = 2097151.0;
      code |= spread(static_cast<std::uint64_t>(t)) << k;
    }
    order[i] = {code, static_cast<std::uint32_t>(i)};
  });
  tbb::parallel_sort(order.begin(), order.end());

  blocks_ = (n + kBlock - 1) / kBlock;
  while (leaves_ < blocks_) leaves_ *= 2;
  items_.resize(n);
  boxes_.resize(n);
  nodes_.assign(2 * leaves_, Box{});
  tbb::parallel_for(std::size_t{0}, blocks_, [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * kBlock, n);
    for (std::size_t i = b * kBlock; i < end; ++i) {
      items_[i] = order[i].second;
      boxes_[i] = boxes[order[i].second];
      nodes_[leaves_ + b].extend(boxes_[i]);
    }
  });
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].extend(nodes_[2 * node + 1]);
  }
}

}  // namespace cnrg
