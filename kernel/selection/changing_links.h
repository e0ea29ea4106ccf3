// How many connected pieces a graph has while links come and go.
//
// Union-find can only join. Here a link that comes or goes is answered by two searches, one from each end, that
// take turns until they meet or the smaller piece is at its end: the cost is that of the smaller side, and nothing
// where an end has no other link, as when a hole closes in a large face.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "kernel/base/ids.h"

namespace cnrg {

template <class IdT>
class ChangingLinks {
 public:
  /// One link more between a and b, `flip`: they are oriented against each other. Returns by how much the number
  /// of connected pieces changes: -1 or 0. A link of a cell to itself joins nothing.
  int add(IdT a, IdT b, bool flip) {
    if (a == b) return one_sided_ = one_sided_ || flip, 0;
    Link& link = links_[a][b];
    Link& back = links_[b][a];
    const bool known = link.count > 0;
    one_sided_ = one_sided_ || (known && link.flip != flip);
    link = back = {link.count + 1, flip};
    if (known) return 0;
    if (links_[a].size() == 1 || links_[b].size() == 1) return -1;
    const auto found = search(a, b, true);
    if (!found.met) return -1;
    one_sided_ = one_sided_ || found.flip != flip;
    return 0;
  }

  /// A link that was there before anybody asked.
  void start(IdT a, IdT b, bool flip) {
    if (a == b) return;
    links_[a][b] = links_[b][a] = {links_[a][b].count + 1, flip};
  }

  /// One link less; returns 1 or 0.
  int remove(IdT a, IdT b) {
    if (a == b) return 0;
    const auto at_a = links_.find(a), at_b = links_.find(b);
    const auto link = at_a->second.find(b), back = at_b->second.find(a);
    --back->second.count;
    if (--link->second.count > 0) return 0;
    at_a->second.erase(link);
    at_b->second.erase(back);
    const bool end_a = at_a->second.empty(), end_b = at_b->second.empty();
    if (end_a) links_.erase(a);
    if (end_b) links_.erase(b);
    return end_a || end_b || !search(a, b, false).met ? 1 : 0;
  }

  /// Some links around a circle turned the orientation over. It stays so.
  bool one_sided() const { return one_sided_; }

 private:
  struct Link {
    std::uint32_t count = 0;
    bool flip = false;
  };
  struct Found {
    bool met, flip;
  };
  struct Seen {
    bool from_b, flip;
  };

  // Whether a and b are connected, `past`: other than by a link of their own, and by how many turns.
  Found search(IdT a, IdT b, bool past) const {
    std::unordered_map<IdT, Seen> seen{{a, {false, false}}, {b, {true, false}}};
    std::array<std::vector<IdT>, 2> wave{std::vector{a}, std::vector{b}};
    std::array<std::size_t, 2> next{}, work{links_.at(a).size(), links_.at(b).size()};
    while (next[0] < wave[0].size() && next[1] < wave[1].size()) {
      const std::size_t side = work[0] <= work[1] ? 0 : 1;
      const IdT from = wave[side][next[side]++];
      const bool turned = seen.at(from).flip;
      for (const auto& [to, link] : links_.at(from)) {
        if (past && ((from == a && to == b) || (from == b && to == a))) continue;
        const auto [it, is_new] = seen.try_emplace(to, Seen{side == 1, turned != link.flip});
        if (!is_new) {
          if (it->second.from_b != (side == 1)) return {true, (turned != link.flip) != it->second.flip};
          continue;
        }
        wave[side].push_back(to);
        work[side] += links_.at(to).size();
      }
    }
    return {false, false};
  }

  std::unordered_map<IdT, std::unordered_map<IdT, Link>> links_;  // both ways
  bool one_sided_ = false;
};

}  // namespace cnrg
