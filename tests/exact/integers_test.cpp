// Integers between machine and GMP, held against their decimal digits.
#include "kernel/exact/integers.h"

#include <limits>
#include <string>
#include <vector>

#include "kernel/exact/points.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// All numbers of T that lie next to a power of two or to its negative.
template <class T>
std::vector<T> numbers() {
  std::vector<T> result{0, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};
  for (int bit = 0; bit < std::numeric_limits<T>::digits; ++bit) {
    for (int more = -2; more <= 2; ++more) {
      const std::uint64_t n = (std::uint64_t{1} << bit) + static_cast<std::uint64_t>(more);
      result.push_back(static_cast<T>(n));
      result.push_back(static_cast<T>(0 - n));
    }
  }
  return result;
}

template <class T>
void check_numbers() {
  for (const T n : numbers<T>()) {
    INFO(std::to_string(n));
    const Integer exact = to_integer(n);
    CHECK(exact == Integer(std::to_string(n)));
    REQUIRE(fits<T>(exact));
    CHECK(to_machine<T>(exact) == n);
  }
  const Integer least(std::to_string(std::numeric_limits<T>::min()));
  const Integer most(std::to_string(std::numeric_limits<T>::max()));
  for (const Integer& n :
       {Integer(least - 1), Integer(most + 1), Integer(-most - 2), Integer(most * most * most)}) {
    INFO(n.get_str());
    CHECK(!fits<T>(n));
    CHECK_THROWS_AS(to_machine<T>(n), InvariantError);
  }
}

TEST_CASE("machine integers of all widths are integers of GMP and back", "[integers]") {
  check_numbers<std::int32_t>();
  check_numbers<std::uint32_t>();
  check_numbers<std::int64_t>();
  check_numbers<std::uint64_t>();
  check_numbers<long>();
  check_numbers<unsigned long>();
  check_numbers<long long>();
  check_numbers<unsigned long long>();
}

TEST_CASE("fractions of numbers beyond 32 bits", "[integers]") {
  CHECK(fraction(-6, 4) == Rational("-3/2"));
  CHECK(fraction(1, std::int64_t{1} << 36) == Rational("1/68719476736"));
  CHECK(fraction(std::numeric_limits<std::int64_t>::min(), 3) == Rational("-9223372036854775808/3"));
  CHECK(power_of_ten(0) == 1);
  CHECK(power_of_ten(20) == Integer("100000000000000000000"));
  CHECK(binomial(70, 35) == Integer("112186277816662845432"));
}

TEST_CASE("exact points have all 53 bits of their doubles", "[integers]") {
  const double x = 0x1.fffffffffffffp52, y = -0x1.0000000000001p-30, z = 0x1.8000000000001p60;
  PointTable table;
  const RationalPoint p = table.rational(table.add(x, y, z));
  CHECK(p[0] == Rational("9007199254740991"));
  CHECK(p[1] == Rational("-4503599627370497/4835703278458516698824704"));
  CHECK(p[2] == Rational("1729382256910270720"));
}

TEST_CASE("bits of a fraction are those of its two numbers", "[integers]") {
  CHECK(bits_of(Integer(255)) == 8);
  CHECK(bits_of(Integer(-256)) == 9);
  CHECK(bits_of(Rational(-3, 8)) == 2 + 4);
  CHECK(bits_of(Rational(Integer(1) << 1000)) == 1001 + 1);
}

}  // namespace
}  // namespace cnrg
