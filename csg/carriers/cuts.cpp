// Links, and cuts that go along them from a list of those not yet passed on; see the header.
#include "csg/carriers/cuts.h"

#include <algorithm>
#include <string>

#include "kernel/base/leaf_words.h"

namespace cnrg {

std::size_t Cuts::add_strand(std::size_t owner) {
  strands_.emplace_back().owner = owner;
  return strands_.size() - 1;
}

bool Cuts::overlap(const std::array<Rational, 2>& a, const std::array<Rational, 2>& b) {
  return std::min(a[0], a[1]) < std::max(b[0], b[1]) && std::min(b[0], b[1]) < std::max(a[0], a[1]);
}

void Cuts::link(std::size_t a, const std::array<Rational, 2>& of_a, std::size_t b,
                const std::array<Rational, 2>& of_b) {
  if (!overlap(of_a, of_b)) return;
  const Rational long_a = of_a[1] - of_a[0], long_b = of_b[1] - of_b[0];
  strands_[a].links.push_back({b, long_a / long_b, (of_a[0] - of_b[0]) / long_b});
  strands_[b].links.push_back({a, long_b / long_a, (of_b[0] - of_a[0]) / long_a});
  if (strands_[a].owner != strands_[b].owner) {
    concerned_.insert(strands_[a].owner);
    concerned_.insert(strands_[b].owner);
  }
}

void Cuts::spread() {
  std::vector<std::pair<std::size_t, Rational>> ends, lines;
  for (std::size_t s = 0; s < strands_.size(); ++s) {
    for (const Rational& t : strands_[s].lines) lines.emplace_back(s, t);
    if (strands_[s].links.empty() || !concerned_.contains(strands_[s].owner)) continue;
    ends.emplace_back(s, 0);
    ends.emplace_back(s, 1);
  }
  spread(std::move(ends), &Strand::cuts);
  spread(std::move(lines), &Strand::lines);
}

void Cuts::spread(std::vector<std::pair<std::size_t, Rational>> open, std::set<Rational> Strand::*marks) {
  while (!open.empty()) {
    const auto [from, t] = std::move(open.back());
    open.pop_back();
    for (const Link& link : strands_[from].links) {
      Strand& to = strands_[link.to];
      Rational image = link.scale * t + link.shift;
      if (sgn(image) <= 0 || image >= 1 || !(to.*marks).insert(image).second) continue;
      if ((to.*marks).size() > kMostCuts) {
        throw LeafError(
            LeafWords(LeafPlace{static_cast<std::uint32_t>(to.owner)}) +
            ": curves that it shares with other leaves cut each other into more than " +
            std::to_string(kMostCuts) +
            " pieces: a side of a patch of theirs is a part of another side of it; cut that patch there");
      }
      open.emplace_back(link.to, std::move(image));
    }
  }
}

std::vector<Rational> Cuts::lines(std::size_t strand, const Rational& low, const Rational& high) const {
  std::vector<Rational> result;
  const std::set<Rational>& all = strands_[strand].lines;
  for (auto t = all.upper_bound(low); t != all.end() && *t < high; ++t)
    result.push_back((*t - low) / (high - low));
  return result;
}

}  // namespace cnrg
