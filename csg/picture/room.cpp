#include "csg/picture/room.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "kernel/base/hypotenuse.h"

namespace cnrg {
namespace {

using Loops = std::vector<std::vector<Point2>>;

/// Distance to the border, negative outside.
double room_at(const Loops& loops, const Point2& p) {
  bool inside = false;
  double nearest = INFINITY;
  for (const auto& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const auto& [ax, ay] = loop[j];
      const auto& [bx, by] = loop[i];
      if ((ay > p[1]) != (by > p[1]) && p[0] < (bx - ax) * (p[1] - ay) / (by - ay) + ax) inside = !inside;
      const double dx = bx - ax, dy = by - ay, size = dx * dx + dy * dy;
      const double t = size == 0 ? 0 : std::clamp(((p[0] - ax) * dx + (p[1] - ay) * dy) / size, 0.0, 1.0);
      nearest = std::min(nearest, hypotenuse(ax + t * dx - p[0], ay + t * dy - p[1]));
    }
  }
  return inside ? nearest : -nearest;
}

}  // namespace

Figure::Label::Place place_with_room(const Loops& loops) {
  Point2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const auto& loop : loops) {
    for (const Point2& p : loop) {
      for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
  }
  const double width = high[0] - low[0], height = high[1] - low[1], side = std::min(width, height);
  if (!(side > 0)) return {};
  struct Square {
    Point2 middle;
    double half, room;
    double most() const { return room + half * M_SQRT2; }
    bool operator<(const Square& other) const { return most() < other.most(); }
  };
  std::priority_queue<Square> open;
  const auto push = [&](const Point2& middle, double half) { open.push({middle, half, room_at(loops, middle)}); };
  const double half = side / 2, precision = side / 50;
  for (double x = low[0] + half; x < high[0] + half; x += side) {
    for (double y = low[1] + half; y < high[1] + half; y += side) push({x, y}, half);
  }
  Square best{{}, 0, 0};
  for (int steps = 0; !open.empty() && steps < 2000; ++steps) {
    const Square at = open.top();
    open.pop();
    if (at.room > best.room) best = at;
    if (at.most() - best.room <= precision) break;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5})
        push({at.middle[0] + x * at.half, at.middle[1] + y * at.half}, at.half / 2);
    }
  }
  return {best.middle, best.room};
}

}  // namespace cnrg
