// Facets, united with the turns between them; then a walk along what is left open. See the header.
#include "csg/exports/unrolled.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "kernel/base/limits.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using FacetTurns = std::array<std::int64_t, 2>;
using DirectedEdge = std::array<Index, 2>;

/// Facets that were put together, each with its turns against the first one of them.
class Layout {
 public:
  explicit Layout(std::size_t n) : parent_(n), turns_(n, FacetTurns{0, 0}) {
    std::iota(parent_.begin(), parent_.end(), Index(0));
  }
  std::pair<Index, FacetTurns> find(Index f) const {
    FacetTurns sum{0, 0};
    while (parent_[f] != f) {
      for (std::size_t d = 0; d < 2; ++d) sum[d] += turns_[f][d];
      f = parent_[f];
    }
    return {f, sum};
  }
  /// g is to be laid `by` turns from where its parameters say, if f is where its own say.
  enum class Answer { united, fits, contradicts };
  Answer unite(Index f, Index g, const FacetTurns& by, FacetTurns& gap) {
    const auto [root_f, of_f] = find(f);
    const auto [root_g, of_g] = find(g);
    for (std::size_t d = 0; d < 2; ++d) gap[d] = of_f[d] + by[d] - of_g[d];
    if (root_f == root_g) return gap == FacetTurns{0, 0} ? Answer::fits : Answer::contradicts;
    parent_[root_g] = root_f;
    turns_[root_g] = gap;
    return Answer::united;
  }
  void flatten() {
    for (Index f = 0; f < parent_.size(); ++f) {
      const auto [root, turns] = find(f);
      parent_[f] = root, turns_[f] = root == f ? FacetTurns{0, 0} : turns;
    }
  }

 private:
  std::vector<Index> parent_;
  std::vector<FacetTurns> turns_;
};

class Unroller {
 public:
  Unroller(const std::vector<UnrollFacet>& facets, const std::array<double, 2>& period,
           const std::array<double, 2>& slack)
      : facets_(facets), period_(period), slack_(slack) {
    for (Index f = 0; f < facets_.size(); ++f) {
      for (std::vector<UnrollCorner> loop : facets_[f]) {
        straighten(loop);
        const Index first = Index(halves_.size()), n = Index(loop.size());
        for (Index i = 0; i < n; ++i) halves_.push_back({loop[i], loop[(i + 1) % n], first + (i + 1) % n, f});
      }
    }
    for (Index h = 0; h < halves_.size(); ++h) half_of_[{halves_[h].from.point, halves_[h].to.point}] = h;
    for (Half& half : halves_) {
      const auto it = half_of_.find({half.to.point, half.from.point});
      if (it != half_of_.end()) half.twin = it->second;
    }
  }

  std::optional<Unrolled> run() {
    if (!find_turns()) return std::nullopt;
    std::array<bool, 2> around{false, false};
    if (lay(Cut{}, &around)) return walk();
    if (!around[0] && !around[1]) return std::nullopt;
    std::array<std::vector<std::int64_t>, 2> lines;
    for (std::size_t d = 0; d < 2; ++d) lines[d] = around[d] ? lines_of(d) : std::vector<std::int64_t>{-1};
    constexpr std::size_t kMost = 64;
    std::size_t tried = 0;
    for (const std::int64_t u : lines[0]) {
      for (const std::int64_t v : lines[1]) {
        if (++tried > kMost) return std::nullopt;
        if (lay(Cut{{u, v}}, nullptr)) return walk();
      }
    }
    return std::nullopt;
  }

 private:
  struct Half {
    UnrollCorner from, to;
    Index next, facet;
    Index twin = kNone;
    FacetTurns turns{0, 0};  // of the twin's facet against this one
    std::array<std::int64_t, 2> line{-1, -1};
    bool open = false;
  };
  /// The line of each parameter along which facets are cut; -1: none.
  struct Cut {
    std::array<std::int64_t, 2> line{-1, -1};
  };
  static constexpr std::int64_t kLines = std::int64_t{1} << 30;

  const std::vector<UnrollFacet>& facets_;
  const std::array<double, 2> period_, slack_;
  std::vector<Half> halves_;
  std::map<DirectedEdge, Index> half_of_;
  std::optional<Layout> layout_;

  /// Corners of a facet are less than half a period from one another.
  void straighten(std::vector<UnrollCorner>& loop) const {
    for (std::size_t d = 0; d < 2; ++d) {
      if (period_[d] == 0) continue;
      const UnrollCorner* known = nullptr;
      for (UnrollCorner& corner : loop) {
        if (corner.free[d]) continue;
        if (known != nullptr) corner.at[d] -= period_[d] * std::round((corner.at[d] - known->at[d]) / period_[d]);
        known = &corner;
      }
    }
  }

  /// False if places of one point differ by no whole turns.
  bool find_turns() {
    for (Half& half : halves_) {
      if (half.twin == kNone) continue;
      const Half& twin = halves_[half.twin];
      for (std::size_t d = 0; d < 2; ++d) {
        std::optional<std::int64_t> turns;
        for (const auto& [a, b] : {std::pair(&half.from, &twin.to), std::pair(&half.to, &twin.from)}) {
          if (a->free[d] || b->free[d]) continue;
          const double gap = a->at[d] - b->at[d];
          const std::int64_t n = period_[d] == 0 ? 0 : std::llround(gap / period_[d]);
          if (std::abs(gap - static_cast<double>(n) * period_[d]) > slack_[d]) return false;
          if (turns && *turns != n) return false;
          turns = n;
        }
        half.turns[d] = turns.value_or(0);
        half.line[d] = line_of(half, d);
      }
    }
    return true;
  }

  /// The number of the line of a parameter on which the side lies; -1: none.
  std::int64_t line_of(const Half& half, std::size_t d) const {
    if (period_[d] == 0 || (half.from.free[d] && half.to.free[d])) return -1;
    const double a = half.from.free[d] ? half.to.at[d] : half.from.at[d];
    const double b = half.to.free[d] ? half.from.at[d] : half.to.at[d];
    if (std::abs(a - b) > slack_[d]) return -1;
    const double part = a / period_[d] - std::floor(a / period_[d]);
    return std::llround(part * static_cast<double>(kLines)) % kLines;
  }

  bool near_line(std::int64_t a, std::int64_t b, std::size_t d) const {
    if (a < 0 || b < 0) return false;
    const std::int64_t gap = std::abs(a - b), way = std::min(gap, kLines - gap);
    return static_cast<double>(way) <= 2 + slack_[d] / period_[d] * static_cast<double>(kLines);
  }

  /// Lines between facets: the one where the parameter begins, then those with most sides.
  std::vector<std::int64_t> lines_of(std::size_t d) const {
    std::map<std::int64_t, std::int64_t> sides;
    for (const Half& half : halves_) {
      if (half.twin != kNone && half.line[d] >= 0) ++sides[half.line[d]];
    }
    std::vector<std::int64_t> lines;
    for (const auto& [line, n] : sides) lines.push_back(line);
    std::stable_sort(lines.begin(), lines.end(), [&](std::int64_t a, std::int64_t b) {
      const bool zero_a = near_line(a, 0, d), zero_b = near_line(b, 0, d);
      return zero_a != zero_b ? zero_a : sides.at(a) > sides.at(b);
    });
    return lines;
  }

  bool is_cut(const Half& half, const Cut& cut) const {
    return near_line(half.line[0], cut.line[0], 0) || near_line(half.line[1], cut.line[1], 1);
  }

  /// False if facets contradict each other off the cut; `around` becomes true for parameters that go round.
  bool lay(const Cut& cut, std::array<bool, 2>* around) {
    layout_.emplace(facets_.size());
    bool fits = true;
    for (const bool cut_ones : {false, true}) {
      for (Half& half : halves_) {
        if (half.twin == kNone || half.twin < Index(&half - halves_.data()) || is_cut(half, cut) != cut_ones)
          continue;
        FacetTurns gap;
        const auto answer = layout_->unite(half.facet, halves_[half.twin].facet, half.turns, gap);
        half.open = halves_[half.twin].open = answer == Layout::Answer::contradicts;
        if (!half.open || cut_ones) continue;
        fits = false;
        if (around == nullptr) return false;
        for (std::size_t d = 0; d < 2; ++d) (*around)[d] = (*around)[d] || gap[d] != 0;
      }
    }
    return fits;
  }

  Index next_open(Index h) const {
    Index n = halves_[h].next;
    while (halves_[n].twin != kNone && !halves_[n].open) n = halves_[halves_[n].twin].next;
    return n;
  }

  UnrollCorner placed(UnrollCorner corner, Index facet) const {
    const FacetTurns turns = layout_->find(facet).second;
    for (std::size_t d = 0; d < 2; ++d) corner.at[d] += static_cast<double>(turns[d]) * period_[d];
    return corner;
  }

  std::optional<Unrolled> walk() {
    layout_->flatten();
    Unrolled result;
    std::vector<char> walked(halves_.size(), 0);
    for (Index h = 0; h < halves_.size(); ++h) {
      const Half& half = halves_[h];
      if (half.twin != kNone && half.from.point < half.to.point) {
        if (half.open) result.seams.push_back({half.from.point, half.to.point});
        else result.inner.push_back(step_of(half));
      }
      if (walked[h] || (half.twin != kNone && !half.open)) continue;
      std::vector<Unrolled::Step> loop;
      for (Index at = h; !walked[at]; at = next_open(at)) {
        walked[at] = 1;
        loop.push_back(step_of(halves_[at]));
      }
      split(loop, result.loops);
    }
    begin_with_first_turn(result);
    const auto add = [&](const UnrollCorner& a, const UnrollCorner& b) {
      result.area += (a.at[0] * b.at[1] - a.at[1] * b.at[0]) / 2;
    };
    for (const Half& half : halves_) {
      const UnrollCorner a = placed(half.from, half.facet), b = placed(half.to, half.facet);
      const UnrollCorner c = placed(halves_[half.next].to, half.facet);
      add(fixed(a, b), fixed(b, a));
      add(fixed(b, a), fixed(b, c));  // at a pole
    }
    return result;
  }

  Unrolled::Step step_of(const Half& half) const {
    const UnrollCorner from = placed(half.from, half.facet), to = placed(half.to, half.facet);
    return {fixed(from, to), fixed(to, from), half.twin != kNone};
  }

  /// The whole face moved so that its least parameters are in their first period.
  void begin_with_first_turn(Unrolled& unrolled) const {
    for (std::size_t d = 0; d < 2; ++d) {
      if (period_[d] == 0) continue;
      double least = HUGE_VAL;
      for (const auto& loop : unrolled.loops) {
        for (const Unrolled::Step& step : loop) least = std::min({least, step.from.at[d], step.to.at[d]});
      }
      const double turns = std::floor((least + slack_[d]) / period_[d]) * period_[d];
      for (auto& loop : unrolled.loops) {
        for (Unrolled::Step& step : loop) step.from.at[d] -= turns, step.to.at[d] -= turns;
      }
      for (Unrolled::Step& step : unrolled.inner) step.from.at[d] -= turns, step.to.at[d] -= turns;
    }
  }

  /// A free parameter is that of the other end of the side.
  static UnrollCorner fixed(UnrollCorner corner, const UnrollCorner& other) {
    for (std::size_t d = 0; d < 2; ++d) {
      if (corner.free[d]) corner.at[d] = other.at[d];
    }
    return corner;
  }

  bool same_place(const UnrollCorner& a, const UnrollCorner& b) const {
    if (a.point != b.point) return false;
    for (std::size_t d = 0; d < 2; ++d) {
      if (a.free[d] || std::abs(a.at[d] - b.at[d]) > slack_[d]) return false;
    }
    return true;
  }

  /// Loops that pass no place twice.
  void split(const std::vector<Unrolled::Step>& loop, std::vector<std::vector<Unrolled::Step>>& loops) const {
    std::vector<Unrolled::Step> open;
    std::multimap<Index, std::size_t> begins;  // places in `open` by the point at which steps begin
    for (const Unrolled::Step& step : loop) {
      begins.emplace(step.from.point, open.size());
      open.push_back(step);
      auto [it, end] = begins.equal_range(step.to.point);
      for (; it != end; ++it) {
        if (same_place(open[it->second].from, step.to)) break;
      }
      if (it == end) continue;
      const std::size_t first = it->second;
      loops.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
      while (open.size() > first) {
        const auto range = begins.equal_range(open.back().from.point);
        for (auto k = range.first; k != range.second; ++k) {
          if (k->second + 1 != open.size()) continue;
          begins.erase(k);
          break;
        }
        open.pop_back();
      }
    }
    if (!open.empty()) loops.push_back(std::move(open));
  }
};

}  // namespace

std::optional<Unrolled> unroll(const std::vector<UnrollFacet>& facets, const std::array<double, 2>& period,
                               const std::array<double, 2>& slack) {
  return Unroller(facets, period, slack).run();
}

}  // namespace cnrg
