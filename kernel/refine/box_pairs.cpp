// The tree is filled from its blocks upward. Places of a block that hold no item get a box that meets nothing, so
// that no loop asks for them.
#include "kernel/refine/box_pairs.h"

#include <tbb/parallel_for.h>

#include <limits>

#include "kernel/base/parallel.h"

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

  find_crowded(boxes);

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

namespace {

constexpr double kCrowded = 16;

double volume(const std::array<std::int32_t, 3>& lo, const std::array<std::int32_t, 3>& hi) {
  double product = 1;
  for (std::size_t k = 0; k < 3; ++k) product *= 1.0 + hi[k] - lo[k];  // flat boxes fill flat nodes
  return product;
}

}  // namespace

/// How much of a node the boxes of its items fill, each counted as often as it is there, is in how many of them a
/// point lies on average, and so how many others an item has to be compared with.
void BoxPairs::find_crowded(const std::vector<Box>& boxes) {
  constexpr double kCrowdedBelow = 4;            // below a crowded node
  constexpr std::uint32_t kFew = 8;              // blocks; too few for an average: they go with the node above
  std::vector<double> filled(nodes_.size(), 0);  // sums of volumes
  for_each_index(blocks_.size(), [&](std::size_t b) {
    for (std::uint32_t i = 0; i < kBlock && b * kBlock + i < boxes.size(); ++i) {
      const GridBox box = item_box(static_cast<std::uint32_t>(b), i);
      filled[leaves_ + b] += volume(box.lo, box.hi);
    }
  });
  for (std::uint32_t node = leaves_ - 1; node > 0; --node) filled[node] = filled[2 * node] + filled[2 * node + 1];

  crowded_.assign(nodes_.size(), 0);
  bool any = false;
  std::uint32_t blocks_below = leaves_;  // of a node of the level
  for (std::uint32_t node = 1; node < nodes_.size(); ++node) {
    if (node > 1 && (node & (node - 1)) == 0) blocks_below /= 2;
    if (is_empty(node)) continue;
    const bool above = node > 1 && crowded_[node / 2] != 0;
    const double least = (above ? kCrowdedBelow : kCrowded) * volume(nodes_[node].lo, nodes_[node].hi);
    crowded_[node] = blocks_below < kFew ? above : filled[node] > least;
    any = any || crowded_[node] != 0;
  }
  if (!any) crowded_.clear();
}

void BoxPairs::orient(const std::vector<Box>& boxes, const Describe& describe) {
  const auto n = static_cast<std::uint32_t>(boxes.size());
  const auto nodes = static_cast<std::uint32_t>(nodes_.size());
  std::vector<std::uint32_t> numbers(nodes_.size() + items_.size(), kUpright);
  upright_.resize(numbers.size());
  std::uint32_t count = 0;
  for (std::uint32_t node = 1; node < nodes; ++node) {
    if (crowded_[node] != 0) numbers[node] = count++;
  }
  for (std::uint32_t place = 0; place < n; ++place) {
    upright_[of_place(place)] = boxes[items_[place]];
    // Also what is as large among few as others are among many.
    const GridBox box = item_box(place / kBlock, place % kBlock);
    const bool large = n * volume(box.lo, box.hi) > kCrowded * volume(nodes_[1].lo, nodes_[1].hi);
    if (large || crowded_[leaves_ + place / kBlock] != 0) numbers[of_place(place)] = count++;
  }
  turned_ = std::move(numbers);
  oriented_.resize(count);
  for_each_index(n, [&](std::size_t place) {
    const std::uint32_t x = of_place(static_cast<std::uint32_t>(place));
    if (turned_[x] == kUpright) return;
    Outline outline;
    describe(items_[place], outline);
    oriented_[turned_[x]] = {oriented_around(outline.corners), outline.groups};
  });

  // From the leaves upward, first what lies in a node, then the next.
  const auto add = [&](std::uint32_t node, std::uint32_t part, bool first) {
    upright_[node].extend(upright_[part]);
    if (turned_[node] == kUpright) return;
    Turned& all = oriented_[turned_[node]];
    const Turned one = turned(part);
    if (first) {
      all = one;
      return;
    }
    all.box = around(all.box, one.box);
    for (std::uint32_t& group : all.groups) {
      if (std::find(one.groups.begin(), one.groups.end(), group) == one.groups.end()) group = kNoGroup;
    }
  };
  for (std::uint32_t node = nodes - 1; node > 0; --node) {
    if (is_empty(node)) continue;
    if (node < leaves_) {
      add(node, 2 * node, true);
      if (!is_empty(2 * node + 1)) add(node, 2 * node + 1, false);
      continue;
    }
    const std::uint32_t first = (node - leaves_) * kBlock;
    for (std::uint32_t place = first; place < std::min(first + kBlock, n); ++place) {
      add(node, of_place(place), place == first);
    }
  }
}

}  // namespace cnrg
