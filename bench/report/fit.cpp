#include "bench/report/fit.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cnrg::bench {
namespace {

double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  Spread s;
  s.count = values.size();
  if (values.empty()) return s;
  std::sort(values.begin(), values.end());
  s.least = values.front();
  s.lower = quantile(values, 0.25);
  s.median = quantile(values, 0.5);
  s.upper = quantile(values, 0.75);
  s.most = values.back();
  return s;
}

std::optional<PowerLaw> power_law(const std::vector<std::pair<double, double>>& points) {
  std::set<double> places;
  for (const auto& [x, y] : points) places.insert(x);
  if (places.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  double mean_x = 0, mean_y = 0;
  for (const auto& [x, y] : points) {
    mean_x += std::log(x) / n;
    mean_y += std::log(y) / n;
  }
  double xx = 0, xy = 0, yy = 0;
  for (const auto& [x, y] : points) {
    const double dx = std::log(x) - mean_x, dy = std::log(y) - mean_y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  PowerLaw law;
  law.points = points.size();
  law.exponent = xy / xx;
  law.factor = std::exp(mean_y - law.exponent * mean_x);
  const double residual = std::max(0.0, yy - law.exponent * xy);
  law.error = std::sqrt(residual / (n - 2) / xx);
  if (yy > 0) law.r_squared = 1 - residual / yy;
  return law;
}

}  // namespace cnrg::bench
