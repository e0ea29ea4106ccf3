#include "bench/witness/cycle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace cnrg::bench::witness {
namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Number dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Of a triangle of the cycle: normal, twice its area long.
Point normal_of(const Cycle& cycle, const std::array<std::uint32_t, 3>& t) {
  const Point& a = cycle.points[t[0]];
  return cross(minus(cycle.points[t[1]], a), minus(cycle.points[t[2]], a));
}

}  // namespace

void Cycle::add_loop(const std::vector<std::uint32_t>& loop) {
  for (std::size_t i = 2; i < loop.size(); ++i) triangles.push_back({loop[0], loop[i - 1], loop[i]});
}

bool is_closed(const Cycle& cycle) {
  // Of the edges along one line, begins less ends at each place: zero everywhere if pieces there and back cancel.
  std::map<std::pair<Point, Point>, int> ends;
  for (const auto& t : cycle.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point &from = cycle.points[t[i]], &to = cycle.points[t[(i + 1) % 3]];
      Point direction = minus(to, from);
      const auto lead =
          std::find_if(direction.begin(), direction.end(), [](const Number& x) { return sgn(x) != 0; });
      if (lead == direction.end()) continue;
      const Number length = *lead;
      for (Number& x : direction) x /= length;
      ++ends[{direction, from}];
      --ends[{direction, to}];
    }
  return std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.second == 0; });
}

double area(const Cycle& cycle) {
  double sum = 0;
  for (const auto& t : cycle.triangles) {
    const Point n = normal_of(cycle, t);
    sum += std::sqrt(Number(dot(n, n)).get_d()) / 2;
  }
  return sum;
}

double extent(const Cycle& cycle) {
  double largest = 0;
  for (const Point& p : cycle.points)
    for (const Number& x : p) largest = std::max(largest, std::fabs(x.get_d()));
  return largest;
}

Locator::Locator(const Cycle& cycle) : cycle_(cycle), largest_(extent(cycle)) {
  for (const Point& p : cycle.points) rounded_.push_back({p[0].get_d(), p[1].get_d(), p[2].get_d()});
}

/// The side of the line ab as seen from above: by doubles, where no error of rounding can change the sign.
int Locator::side(std::uint32_t a, std::uint32_t b, const Point& p, const std::array<double, 2>& rounded) const {
  const auto& [ax, ay, az] = rounded_[a];
  const auto& [bx, by, bz] = rounded_[b];
  const double largest = std::max({largest_, std::fabs(rounded[0]), std::fabs(rounded[1])});
  const double error = 0x1p-44 * largest * largest + 1e-290;
  const double about = (bx - ax) * (rounded[1] - ay) - (by - ay) * (rounded[0] - ax);
  if (about > error) return 1;
  if (about < -error) return -1;
  const Point &from = cycle_.points[a], &to = cycle_.points[b];
  return sgn(Number((to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0])));
}

std::optional<int> Locator::winding(const Point& p) const {
  const std::array<double, 2> rounded{p[0].get_d(), p[1].get_d()};
  int winding = 0;
  for (const auto& t : cycle_.triangles) {
    int left = 0, right = 0;
    for (int i = 0; i < 3 && (left == 0 || right == 0); ++i) {
      const int s = side(t[i], t[(i + 1) % 3], p, rounded);
      left += s > 0;
      right += s < 0;
    }
    if (left > 0 && right > 0) continue;
    if (left < 3 && right < 3) return {};
    const int above = -sgn(dot(normal_of(cycle_, t), minus(p, cycle_.points[t[0]]))) * (left == 3 ? 1 : -1);
    if (above == 0) return {};
    if (above > 0) winding += left == 3 ? 1 : -1;
  }
  return winding;
}

bool Locator::may_be_near(const Point& p, const Number& distance) const {
  const double reach = distance.get_d() * (1 + 0x1p-40) + 0x1p-48 * largest_;
  const std::array<double, 3> rounded{p[0].get_d(), p[1].get_d(), p[2].get_d()};
  for (const auto& t : cycle_.triangles) {
    bool reaches = true;
    for (int k = 0; k < 3 && reaches; ++k) {
      const auto [low, high] = std::minmax({rounded_[t[0]][k], rounded_[t[1]][k], rounded_[t[2]][k]});
      reaches = low - reach <= rounded[k] && rounded[k] <= high + reach;
    }
    if (!reaches) continue;
    const Point n = normal_of(cycle_, t);
    const Number height = dot(n, minus(p, cycle_.points[t[0]]));
    if (height * height <= distance * distance * dot(n, n)) return true;
  }
  return false;
}

}  // namespace cnrg::bench::witness
