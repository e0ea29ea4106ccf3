// Spreads, and power laws fitted to sizes and costs.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace cnrg::bench {

struct Spread {
  std::size_t count = 0;  ///< of values; with none of them the rest means nothing
  double least = 0, lower = 0, median = 0, upper = 0, most = 0;  ///< `lower`, `upper`: quartiles
};

/// Quartiles by linear interpolation between the sorted values at (n - 1) / 4 and 3 (n - 1) / 4, counted from 0.
Spread spread_of(std::vector<double> values);

/// y = factor * x^exponent.
struct PowerLaw {
  std::size_t points = 0;
  double exponent = 0, factor = 0;
  double error = 0;      ///< standard error of the exponent
  double r_squared = 1;  ///< the part of the variance of log y that the law explains; 1 when log y has none
};

/// Least squares on logarithms, each point with the same weight. None with fewer than three different x. All
/// numbers are positive.
std::optional<PowerLaw> power_law(const std::vector<std::pair<double, double>>& points);

}  // namespace cnrg::bench
