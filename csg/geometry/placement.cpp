// Why what cancels is short: let H and K be two such matrices of four rows, the last one (0, 0, 0, denominator),
// and c divide all numbers of the product H K. Then c divides all of H K adj(K) = det(K) H, and as nothing but 1
// divides all of H, it divides det(K) = det(linear part) * denominator of K, the inner and short one.
#include "csg/geometry/placement.h"

#include <algorithm>

namespace cnrg {
namespace {

constexpr std::size_t kDenominator = 12;

}  // namespace

Placement::Placement(const Transform& transform) {
  Integer& d = numbers_[kDenominator];
  const auto entry = [&](std::size_t i, std::size_t j) -> const Rational& {
    return j < 3 ? transform.linear[i][j] : transform.offset[i];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) d = lcm(d, entry(i, j).get_den());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) at(i, j) = entry(i, j).get_num() * (d / entry(i, j).get_den());
  }
}

Placement Placement::operator*(const Placement& inner) const {
  Placement product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      Integer& sum = product.at(i, j);
      sum = at(i, 0) * inner.at(0, j);
      sum += at(i, 1) * inner.at(1, j);
      sum += at(i, 2) * inner.at(2, j);
    }
    product.at(i, 3) += at(i, 3) * inner.denominator();
  }
  product.numbers_[kDenominator] = denominator() * inner.denominator();

  const auto minor = [&](std::size_t j, std::size_t k) {
    return Integer(inner.at(1, j) * inner.at(2, k) - inner.at(1, k) * inner.at(2, j));
  };
  Integer common = inner.at(0, 0) * minor(1, 2) + inner.at(0, 1) * minor(2, 0) + inner.at(0, 2) * minor(0, 1);
  common *= inner.denominator();
  for (std::size_t k = product.numbers_.size(); k-- > 0 && common != 1;) common = gcd(common, product.numbers_[k]);
  if (common != 1) {
    for (Integer& number : product.numbers_)
      mpz_divexact(number.get_mpz_t(), number.get_mpz_t(), common.get_mpz_t());
  }
  return product;
}

Transform Placement::transform() const {
  Transform out;
  const auto entry = [&](std::size_t i, std::size_t j) {
    Rational value(at(i, j), denominator());
    value.canonicalize();
    return value;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out.linear[i][j] = entry(i, j);
    out.offset[i] = entry(i, 3);
  }
  return out;
}

std::size_t Placement::bits() const {
  std::size_t most = 0;
  for (const Integer& number : numbers_) most = std::max(most, mpz_sizeinbase(number.get_mpz_t(), 2));
  return most;
}

}  // namespace cnrg
