// Numbers rounded upward by software against the machine that rounds upward: the same doubles, to the last bit.
#include "kernel/stand_ins/round_up.h"

#include <cfenv>
#include <cstring>
#include <random>

#include "kernel/exact/enclosure.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// By the machine; the compiler is not to move anything out of the mode.
template <class Work>
double rounded(int mode, double a, double b, Work work) {
  volatile double x = a, y = b, result = 0;
  std::fesetround(mode);
  result = work(x, y);
  std::fesetround(FE_TONEAREST);
  return result;
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

/// Whole numbers, eighths, powers of two, any bits, and the ends of the doubles.
double draw(std::mt19937_64& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kEnds[] = {
      0.0,     -0.0,  5e-324,    -5e-324,    0x1p-1022, round_up::kLargest, -round_up::kLargest, 0x1p-450,
      0x1p450, 1e308, kInfinity, -kInfinity, 1e-154};
  switch (random() % 6) {
    case 0: return kEnds[random() % std::size(kEnds)];
    case 1: return static_cast<double>(static_cast<int>(random() % 2001) - 1000);
    case 2: return static_cast<double>(static_cast<int>(random() % 2001) - 1000) / 8;
    case 3: return std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 100) - 100);
    case 4: return std::ldexp(1, static_cast<int>(random() % 2098) - 1074);
    default: return std::bit_cast<double>(std::uint64_t{random()});
  }
}

TEST_CASE("numbers rounded upward by software are those of a machine that does so", "[exact]") {
  std::mt19937_64 random(7);
  std::size_t differing = 0;
  const auto root = [](double x, double) { return std::sqrt(x); };
  for (int i = 0; i < 200000; ++i) {
    const double a = draw(random);
    double b = draw(random);
    if (random() % 8 == 0) b = a * (1 + static_cast<double>(random() % 9) * 0x1p-52);
    if (random() % 8 == 0) b = -b;
    differing += !same(round_up::add(a, b), rounded(FE_UPWARD, a, b, [](double x, double y) { return x + y; }));
    differing +=
        !same(round_up::multiply(a, b), rounded(FE_UPWARD, a, b, [](double x, double y) { return x * y; }));
    differing += !same(round_up::divide(a, b), rounded(FE_UPWARD, a, b, [](double x, double y) { return x / y; }));
    differing += !same(round_up::sqrt_up(a), rounded(FE_UPWARD, a, 0, root));
    differing += !same(round_up::sqrt_down(a), a > 0 ? rounded(FE_DOWNWARD, a, 0, root) : 0);
  }
  CHECK(differing == 0);
  CHECK(round_up::add(1, 1e-300) > 1);  // to nearest it is 1
  CHECK(round_up::add(1, 2) == 3);      // what is exact stays
  CHECK(round_up::multiply(1e-300, 1e-300) > 0);
}

TEST_CASE("numbers of the scope that rounds outward are rounded upward, as by software", "[exact]") {
  std::mt19937_64 random(8);
  std::size_t differing = 0;
  for (int i = 0; i < 50000; ++i) {
    const double a = draw(random), b = draw(random);
    const enclosure::RoundOutward outward;
    const enclosure::Upward x = a, y = b;
    differing += !same(double(x + y), round_up::add(a, b)) + !same(double(x - y), round_up::add(a, -b)) +
                 !same(double(x * y), round_up::multiply(a, b)) + !same(double(x / y), round_up::divide(a, b)) +
                 !same(double(sqrt(x)), round_up::sqrt_up(a));
  }
  CHECK(differing == 0);
}

TEST_CASE("within the scope that rounds outward another one rounds to nearest", "[exact]") {
  volatile double one = 1, tiny = 1e-300;
  const enclosure::RoundOutward outward;
  const double above = one + tiny;
  double nearest = 0;
  {
    const enclosure::RoundNearest scope;
    volatile double sum = one + tiny;
    nearest = sum;
  }
  volatile double after = one + tiny;
  CHECK(above > 1);
  CHECK(nearest == 1);
  CHECK(after > 1);
}

}  // namespace
}  // namespace cnrg
