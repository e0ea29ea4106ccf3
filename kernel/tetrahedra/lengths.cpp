#include "kernel/tetrahedra/lengths.h"

#include <cmath>

#include "kernel/base/sorted.h"

namespace cnrg {
double Lengths::wanted(Index v) {
  while (wanted_.size() < mesh_.point_count())
    wanted_.push_back(options_.size(mesh_.point(Index(wanted_.size()))));
  return wanted_[v];
}

double Lengths::most(Index a, Index b) {
  const double most = kLong * std::min(wanted(a), wanted(b));
  return most * most;
}

/// In a region that has a length of its own that counts, too.
double Lengths::length(Index a, Index b, std::int32_t region) {
  double h = (wanted(a) + wanted(b)) / 2;
  const auto r = static_cast<std::size_t>(region);
  if (region >= 0 && r < options_.region_size.size()) h = std::min(h, options_.region_size[r]);
  return std::sqrt(moves_.squared(a, b)) / h;
}

void Lengths::add_edges(const Stars::Tetrahedron& t, double longer, std::vector<Edge>& out) {
  if (t.region < 0) return;
  for (const auto& [i, j] : Stars::kEdges) {
    const auto [a, b] = std::minmax(t.corners[std::size_t(i)], t.corners[std::size_t(j)]);
    if (length(a, b, t.region) > longer) out.push_back({moves_.squared(a, b), a, b});
  }
}

double Lengths::longest(const Ends& ends) {
  std::vector<Edge> edges;
  double longest = 0;
  for (Index t = 0; t < mesh_.size() && !ends(t); ++t) {
    if (!mesh_.alive(t)) continue;
    edges.clear();
    add_edges(mesh_.at(t), longest, edges);
    for (const Edge& e : edges) longest = std::max(longest, length(e.a, e.b, mesh_.at(t).region));
  }
  return longest;
}

/// The longest one goes first. What comes in its place with edges that are shorter than it has to be taken away
/// later, if they are too long as well, so that this ends.
std::size_t Lengths::halve(double longer, const Ends& ends) {
  std::vector<Edge> heap, fresh;
  for (Index t = 0; t < mesh_.size() && !ends(t); ++t)
    if (mesh_.alive(t)) add_edges(mesh_.at(t), longer, heap);
  sort_unique(heap);
  std::ranges::make_heap(heap);
  std::size_t done = 0;
  while (!heap.empty() && !ends(0)) {
    std::ranges::pop_heap(heap);
    const auto [squared, a, b] = heap.back();
    heap.pop_back();
    if (moves_.at_edge(a, b).empty()) continue;  // it is gone
    if (!moves_.remove_edge(a, b, squared)) {
      if (moves_.split(a, b) == Stars::kNoTetrahedron) continue;
      ++done;
    }
    fresh.clear();
    for (const Stars::Tetrahedron& t : moves_.made()) add_edges(t, longer, fresh);
    sort_unique(fresh);
    for (const Edge& e : fresh) {
      heap.push_back(e);
      std::ranges::push_heap(heap);
    }
  }
  return done;
}

/// Halving leaves edges that are as short as half of a long one, and with them more tetrahedra than their lengths
/// ask for. They are pulled together where shapes allow that, which is in more places after the moves.
std::size_t Lengths::collapse(double enough, const Ends& ends) {
  std::size_t done = 0;
  for (Index t = 0; t < mesh_.size() && !ends(t); ++t) {
    if (!mesh_.alive(t) || mesh_.at(t).region < 0) continue;
    const auto tet = mesh_.at(t);
    for (const auto& [i, j] : Stars::kEdges) {
      const Index a = tet.corners[std::size_t(i)], b = tet.corners[std::size_t(j)];
      if (length(a, b, tet.region) >= kShort) continue;
      if (moves_.collapse(a, b, enough, most(a, b)) || moves_.collapse(b, a, enough, most(a, b))) {
        ++done;
        break;
      }
    }
  }
  return done;
}

}  // namespace cnrg
