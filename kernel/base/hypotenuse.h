// Lengths of doubles, on every machine the same, as those of `std::hypot` are not.
#pragma once

#include <algorithm>
#include <cmath>

namespace cnrg {

/// sqrt(x^2 + y^2 + z^2), however large or small.
inline double hypotenuse(double x, double y, double z = 0) {
  const double most = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (!(most > 0) || !std::isfinite(most)) return most;
  const int exponent = std::ilogb(most);
  const double a = std::scalbn(x, -exponent), b = std::scalbn(y, -exponent), c = std::scalbn(z, -exponent);
  return std::scalbn(std::sqrt(a * a + b * b + c * c), exponent);
}

}  // namespace cnrg
