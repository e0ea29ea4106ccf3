// Counting sides of edges; cancelling collinear ones.
#include "csg/geometry/mesh_boundary.h"

#include <algorithm>
#include <map>

#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

using Line = std::pair<std::array<Integer, 3>, RationalPoint>;  // direction, moment

/// The direction of b - a with its first component that is not zero positive.
std::array<Integer, 3> direction_of(const RationalPoint& a, const RationalPoint& b, bool& reversed) {
  std::array<Integer, 3> d = primitive_direction(b - a);
  reversed = d[0] != 0 ? d[0] < 0 : d[1] != 0 ? d[1] < 0 : d[2] < 0;
  if (reversed) {
    for (Integer& x : d) x = -x;
  }
  return d;
}

bool is_nought(std::int64_t coefficient, bool parity) { return parity ? coefficient % 2 == 0 : coefficient == 0; }

}  // namespace

SideTable::SideTable(const std::vector<PolygonSide>& sides, std::size_t point_count) : sides_(sides.size()) {
  std::vector<std::uint32_t> start(point_count + 1, 0);
  for (const PolygonSide& side : sides) ++start[side.low + 1];
  for (std::size_t i = 0; i < point_count; ++i) start[i + 1] += start[i];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (const PolygonSide& side : sides) sides_[next[side.low]++] = side;
  for (std::size_t i = 0; i < point_count; ++i) {
    std::sort(
        sides_.begin() + start[i], sides_.begin() + start[i + 1], [](const PolygonSide& a, const PolygonSide& b) {
          return a.high != b.high ? a.high < b.high : a.face != b.face ? a.face < b.face : a.forward > b.forward;
        });
  }
}

std::vector<ChainEdge> boundary(const SideTable& table, bool parity) {
  std::vector<ChainEdge> chain;
  table.each_edge([&](std::span<const PolygonSide> sides) {
    std::int64_t sum = 0;
    for (const PolygonSide& side : sides) sum += side.forward ? 1 : -1;
    if (parity) sum = static_cast<std::int64_t>(sides.size() % 2);
    if (sum > 0) chain.push_back({sides[0].low, sides[0].high, sum});
    if (sum < 0) chain.push_back({sides[0].high, sides[0].low, -sum});
  });
  return chain;
}

bool vanishes(const std::vector<ChainEdge>& chain, bool parity,
              const std::function<RationalPoint(std::uint32_t)>& point, ChainEdge* example) {
  if (chain.empty()) return true;
  // No edge passes through the first point in lexicographic order, so there edges must cancel by direction alone.
  std::map<std::uint32_t, RationalPoint> points;
  for (const ChainEdge& e : chain) {
    for (std::uint32_t end : {e.from, e.to}) {
      if (!points.contains(end)) points.emplace(end, point(end));
    }
  }
  const auto first = std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first;
  std::map<std::array<Integer, 3>, std::pair<std::int64_t, ChainEdge>> leaving;
  for (const ChainEdge& e : chain) {
    if (e.from != first && e.to != first) continue;
    bool reversed = false;
    const auto direction = direction_of(points[e.from], points[e.to], reversed);
    auto& [sum, edge] = leaving.try_emplace(direction, std::int64_t{0}, e).first->second;
    sum += reversed ? -e.coefficient : e.coefficient;
  }
  for (const auto& [direction, entry] : leaving) {
    if (is_nought(entry.first, parity)) continue;
    if (example) *example = entry.second;
    return false;
  }
  // Everything else line by line: the coefficients of the edges that cover a piece must add up to zero.
  struct Event {
    Rational position;
    std::int64_t change;
    ChainEdge edge;
  };
  std::map<Line, std::vector<Event>> lines;
  for (const ChainEdge& e : chain) {
    const RationalPoint &a = points[e.from], &b = points[e.to];
    bool reversed = false;
    const std::array<Integer, 3> d = direction_of(a, b, reversed);
    const RationalPoint direction{d[0], d[1], d[2]};
    std::vector<Event>& events = lines[{d, cross(a, direction)}];
    const std::int64_t value = reversed ? -e.coefficient : e.coefficient;
    events.push_back({dot(reversed ? b : a, direction), value, e});
    events.push_back({dot(reversed ? a : b, direction), -value, e});
  }
  for (auto& [line, events] : lines) {
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.position < b.position; });
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
      sum += events[i].change;
      if (i + 1 < events.size() && events[i + 1].position == events[i].position) continue;
      if (is_nought(sum, parity)) continue;
      if (example) *example = events[i].edge;
      return false;
    }
  }
  return true;
}

}  // namespace cnrg
