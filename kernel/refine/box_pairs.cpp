// The tree is filled from its blocks upward. Places of a block that hold no item get a box that meets nothing, so
// that no loop asks for them.
#include "kernel/refine/box_pairs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace cnrg {

namespace {

constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

}  // namespace

BoxPairs::BoxPairs(const std::vector<Box>& boxes) {
  const std::size_t n = boxes.size();
  if (n == 0) return;
  grid_ = Grid(bounds(boxes));
  items_ = morton_order(boxes, grid_);
  items_.resize((n + kBlock - 1) / kBlock * kBlock);

  const auto blocks = static_cast<std::uint32_t>((n + kBlock - 1) / kBlock);
  while (leaves_ < blocks) leaves_ *= 2;
  const GridBox nothing{{kNever, kNever, kNever}, {-1, -1, -1}};
  blocks_.resize(blocks);
  nodes_.assign(2 * leaves_, nothing);
  const auto extend = [](GridBox& box, const GridBox& by) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = std::min(box.lo[k], by.lo[k]);
      box.hi[k] = std::max(box.hi[k], by.hi[k]);
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, blocks, 256), [&](const auto& range) {
    for (std::uint32_t b = range.begin(); b < range.end(); ++b) {
      for (std::uint32_t i = 0; i < kBlock; ++i) {
        const std::size_t place = std::size_t{b} * kBlock + i;
        const GridBox box = place < n ? on_grid(boxes[items_[place]]) : nothing;
        for (std::size_t k = 0; k < 3; ++k) {
          blocks_[b].lo[k][i] = box.lo[k];
          blocks_[b].hi[k][i] = box.hi[k];
        }
        extend(nodes_[leaves_ + b], box);
      }
    }
  });
  for (std::uint32_t node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    extend(nodes_[node], nodes_[2 * node + 1]);
  }

  // Parts: pairs of nodes some levels down, so that threads share the work evenly.
  constexpr std::uint32_t kEnough = 512;
  parts_ = {{1, 1}};
  while (parts_.size() < kEnough && !parts_.empty() && parts_.front().a < leaves_) {
    std::vector<NodePair> next;
    for (const NodePair& p : parts_) {
      NodeStack children;
      split(p, children);
      next.insert(next.end(), children.entries.begin(), children.entries.begin() + children.size);
    }
    parts_ = std::move(next);
  }
}

}  // namespace cnrg
