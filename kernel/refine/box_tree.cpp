// The boxes of blocks in parallel, then those of inner nodes upward.
#include "kernel/refine/box_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "kernel/refine/morton.h"

namespace cnrg {

BoxTree::BoxTree(std::vector<Box> boxes) {
  const std::size_t n = boxes.size();
  if (n == 0) return;
  items_ = morton_order(boxes, Grid(bounds(boxes)));

  blocks_ = (n + kBlock - 1) / kBlock;
  while (leaves_ < blocks_) leaves_ *= 2;
  boxes_.resize(n);
  nodes_.assign(2 * leaves_, Box{});
  tbb::parallel_for(std::size_t{0}, blocks_, [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * kBlock, n);
    for (std::size_t i = b * kBlock; i < end; ++i) {
      boxes_[i] = boxes[items_[i]];
      nodes_[leaves_ + b].extend(boxes_[i]);
    }
  });
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].extend(nodes_[2 * node + 1]);
  }
}

}  // namespace cnrg
