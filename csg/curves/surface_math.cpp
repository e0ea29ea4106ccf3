// Constants and cosines; see the header.
#include "csg/curves/surface_math.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "kernel/exact/exact_vectors.h"

namespace cnrg::surface_math {
namespace {

/// cos(2 pi r) or, with `odd`, sin(2 pi r), for 0 <= r <= 1/8: Taylor's polynomial up to x^18 / 18! or x^19 / 19!.
/// Terms alternate and fall, so the rest is less than the next one, which is below (pi / 4)^20 / 20! < 1e-20.
Interval taylor(double r, bool odd) {
  const Interval x = turn<Interval>() * Interval(r), square = x * x;
  Interval result(0);
  for (int n = odd ? 19 : 18; n >= 2; n -= 2) result = -(square * (Interval(1) + result)) / Interval(n * (n - 1));
  result += Interval(-1e-20, 1e-20);
  return odd ? x + x * result : Interval(1) + result;
}

/// The coefficients of Taylor's polynomials in x^2 up to x^16 / 16! or x^17 / 17!, from the last one on.
template <int last>
constexpr std::array<double, last / 2 + 1> coefficients() {
  std::array<double, last / 2 + 1> all{};
  double factorial = 1;  // exact
  for (int n = 1; n <= last; ++n) {
    factorial *= n;
    if ((last - n) % 2 == 0) all[static_cast<std::size_t>((last - n) / 2)] = (n / 2 % 2 == 0 ? 1 : -1) / factorial;
  }
  if (last % 2 == 0) all.back() = 1;
  return all;
}

/// The same, of doubles, in a tenth of the time. The rest is below (pi / 4)^18 / 18! < 1e-17. In any
/// rounding mode x^2 has a relative error below 5 * 2^-52; so a step adds less than 4 * 2^-52 of its coefficient,
/// and later steps multiply that by 0.31 each, beside their own coefficients: together less than 1.3e-15. The last
/// product by x adds less than 3 * 2^-52, and the ends 2^-52.
template <class N>
N taylor_of(double r, bool odd) {
  static constexpr auto kEven = coefficients<16>(), kOdd = coefficients<17>();
  const N x = N(turn<double>()) * N(r), square = x * x;
  N value = 0;
  for (const double c : odd ? std::span<const double>(kOdd) : kEven) value = value * square + N(c);
  return odd ? value * x : value;
}
Interval wide_taylor(double r, bool odd) {
  constexpr double kError = 3e-15;
  if (r == 0) return odd ? 0 : 1;
  const enclosure::Upward value = taylor_of<enclosure::Upward>(r, odd);
  return {double(value - kError), double(value + kError)};
}

/// Where the cosine is that of r turns, or with `odd` the sine, or the negative one, and r at most an eighth.
struct InEighth {
  double r;
  bool odd, negative;
};
InEighth to_eighth(double turns) {
  double r = std::abs(turns - std::floor(turns + 0.5));  // all steps are exact, in any rounding mode
  const bool negative = r > 0.25;
  if (negative) r = std::abs(0.5 - r);
  const bool odd = r > 0.125;
  return {odd ? 0.25 - r : r, odd, negative};
}

Interval cosine_at(double turns, bool tight) {
  const auto [r, odd, negative] = to_eighth(turns);
  const Interval c = tight ? taylor(r, odd) : wide_taylor(r, odd);
  return negative ? -c : c;
}

}  // namespace

Interval enclose(const Rational& value) {
  const double d = to_double(value);
  if (!std::isfinite(d)) {
    constexpr double kMost = std::numeric_limits<double>::max(),
                     kInfinity = std::numeric_limits<double>::infinity();
    return d > 0 ? Interval(kMost, kInfinity) : Interval(-kInfinity, -kMost);
  }
  const int order = cmp(from_double(d), value);
  if (order == 0) return {d};
  return order > 0 ? Interval(std::nextafter(d, -HUGE_VAL), d) : Interval(d, std::nextafter(d, HUGE_VAL));
}

Vector3<Constant> constants(const RationalPoint& p) { return {constant(p[0]), constant(p[1]), constant(p[2])}; }

Constant length(const RationalPoint& v) {
  const enclosure::RoundOutward outward;
  return constant(CGAL::sqrt(enclose(cnrg::dot(v, v))));
}

Vector3<Constant> unit(const RationalPoint& v) {
  const enclosure::RoundOutward outward;
  const Interval norm = length(v).range;
  Vector3<Constant> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = constant(enclose(v[k]) / norm);
  return result;
}

double cosine(double turns) {
  const auto [r, odd, negative] = to_eighth(turns);
  const double c = taylor_of<double>(r, odd);
  return negative ? -c : c;
}

namespace {

Interval cosine_between(double a, double b) {
  if (!(enclosure::Upward(b) - a < 1) || !(std::abs(a) < 1e9)) return {-1, 1};
  const bool point = a == b;
  const Interval from = cosine_at(a, point), to = point ? from : cosine_at(b, false);
  double low = std::min(from.inf(), to.inf()), high = std::max(from.sup(), to.sup());
  if (std::floor(b) >= std::ceil(a)) high = 1;
  const double half = std::ceil(2 * a);  // doubling is exact
  if ((std::fmod(half, 2) != 0 ? half : half + 1) <= 2 * b) low = -1;
  return {std::max(low, -1.0), std::min(high, 1.0)};
}

}  // namespace

// Cells between the same meridians, or circles, ask the same.
Interval cosine(const Interval& turns) {
  struct Known {
    double inf = NAN, sup = NAN;
    Interval value{0};
  };
  constexpr std::size_t kKnown = 512;
  thread_local std::array<Known, kKnown> known;
  const double a = turns.inf(), b = turns.sup();
  const std::uint64_t mixed =
      (std::bit_cast<std::uint64_t>(a) * 3 + std::bit_cast<std::uint64_t>(b)) * 0x9e3779b97f4a7c15u;
  Known& one = known[mixed >> 55];
  if (one.inf != a || one.sup != b) one = {a, b, cosine_between(a, b)};
  return one.value;
}

}  // namespace cnrg::surface_math
