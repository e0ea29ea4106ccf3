// Numbers: text in and out, nearest doubles, sums.
#include "kernel/exact/rational.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "tests/catch.h"

using namespace cnrg;

namespace {

Rational power_of_two(int exponent) {
  Rational one = 1;
  return exponent >= 0 ? Rational(one << static_cast<mp_bitcnt_t>(exponent))
                       : Rational(one >> static_cast<mp_bitcnt_t>(-exponent));
}

}  // namespace

TEST_CASE("a number is read exactly") {
  CHECK(*parse_rational("-12") == -12);
  CHECK(*parse_rational("0.1") == Rational(1, 10));
  CHECK(*parse_rational("1.5e-3") == Rational(3, 2000));
  CHECK(*parse_rational("121/3") == Rational(121, 3));
  CHECK(*parse_rational("-0.5/3") == Rational(-1, 6));
  CHECK(*parse_rational("+2E2") == 200);
  CHECK(*parse_rational(".5") == Rational(1, 2));
  CHECK(*parse_rational("5.") == 5);
  CHECK(*parse_rational("6/4") == Rational(3, 2));
  CHECK(*parse_rational("6/4e1") == Rational(3, 20));
  CHECK(*parse_rational("007") == 7);
  CHECK(*parse_rational("0/5") == 0);
  CHECK(parse_rational("1e100000"));
}

TEST_CASE("what is no number is nothing") {
  for (const char* text : {"",
                           "-",
                           "+",
                           ".",
                           "e5",
                           "1e",
                           "1e+",
                           "1/0",
                           "1/0.0",
                           "1/",
                           "/2",
                           "1//2",
                           "1 ",
                           " 1",
                           "0x10",
                           "nan",
                           "inf",
                           "1e100001",
                           "1e99999999999999999999",
                           "1.2.3",
                           "--1",
                           "1/-2",
                           "1,5",
                           "1/2/3"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_rational(text));
  }
  CHECK_FALSE(parse_rational(std::string_view("1\0", 2)));
}

TEST_CASE("decimal expansions round to nearest") {
  CHECK(to_decimal(Rational(1, 3), 6) == "0.333333");
  CHECK(to_decimal(Rational(2, 3), 3) == "0.667");
  CHECK(to_decimal(Rational(2, 3), 1) == "0.7");
  CHECK(to_decimal(Rational(-1, 8)) == "-0.125");
  CHECK(to_decimal(0) == "0");
  CHECK(to_decimal(1200) == "1200");
  CHECK(to_decimal(Rational(9996, 10), 3) == "1000");
  CHECK(to_decimal(Rational(9999, 10000), 2) == "1");
  CHECK(to_decimal(Rational(99, 10), 12) == "9.9");
  CHECK(to_decimal(*parse_rational("1e20")) == "100000000000000000000");
  CHECK(to_decimal(*parse_rational("-1e20")) == "-1e20");
  CHECK(to_decimal(*parse_rational("1.25e30")) == "1.25e30");
  CHECK(to_decimal(*parse_rational("1e-6")) == "0.000001");
  CHECK(to_decimal(*parse_rational("1.5e-40")) == "1.5e-40");
  CHECK(to_decimal(*parse_rational("1e5000")) == "1e5000");
  CHECK(to_decimal(Rational(123456789), 3) == "123000000");
  CHECK(to_string(Rational(-1, 6)) == "-1/6");
  CHECK(to_string(Rational(4)) == "4");
}

TEST_CASE("to_double is nearest, ties to even") {
  CHECK(to_double(Rational(1, 10)) == 0.1);
  CHECK(to_double(Rational(-1, 3)) == -1.0 / 3);
  const Rational one = 1;
  CHECK(to_double(one + power_of_two(-53)) == 1.0);                           // tie, even below
  CHECK(to_double(one + 3 * power_of_two(-53)) == 1.0 + std::ldexp(1, -51));  // tie, even above
  CHECK(to_double(one + power_of_two(-53) + power_of_two(-900)) == std::nextafter(1.0, 2.0));
  CHECK(to_double(2 - power_of_two(-60)) == 2.0);  // carry into the next power
  SECTION("subnormal numbers") {
    const double smallest = std::numeric_limits<double>::denorm_min();
    CHECK(to_double(power_of_two(-1074)) == smallest);
    CHECK(to_double(power_of_two(-1075)) == 0);  // tie, even is zero
    CHECK(to_double(power_of_two(-1075) + power_of_two(-2000)) == smallest);
    CHECK(to_double(3 * power_of_two(-1075)) == 2 * smallest);
    CHECK(to_double(-power_of_two(-1076)) == 0);
    CHECK(to_double(power_of_two(-1022) - power_of_two(-1076)) == std::numeric_limits<double>::min());
    CHECK(to_double(power_of_two(-5000)) == 0);
  }
  SECTION("overflow") {
    const double largest = std::numeric_limits<double>::max();
    const Rational edge = power_of_two(1024) - power_of_two(970);  // halfway between max and 2^1024
    CHECK(to_double(from_double(largest)) == largest);
    CHECK(to_double(edge - 1) == largest);
    CHECK(std::isinf(to_double(edge)));
    CHECK(to_double(-power_of_two(3000)) == -std::numeric_limits<double>::infinity());
  }
  SECTION("decimals agree with from_chars") {
    std::mt19937_64 random(7);
    for (int i = 0; i < 2000; ++i) {
      const int exponent = static_cast<int>(random() % 700) - 345;
      const std::string text = std::to_string(random() >> 1) + "e" + std::to_string(exponent);
      double expected = 0;
      const auto result = std::from_chars(text.data(), text.data() + text.size(), expected);
      if (result.ec != std::errc()) continue;
      CAPTURE(text);
      REQUIRE(to_double(*parse_rational(text)) == expected);
    }
  }
}

TEST_CASE("doubles are recognized exactly") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    double value;
    const std::uint64_t word = random();
    std::memcpy(&value, &word, sizeof value);
    if (!std::isfinite(value)) continue;
    const Rational exact = from_double(value);
    REQUIRE(is_double(exact));
    REQUIRE(to_double(exact) == value);
    REQUIRE_FALSE(is_double(exact / 3 + Rational(1, 7)));
  }
  CHECK(is_double(0));
  CHECK(is_double(power_of_two(-1074)));
  CHECK_FALSE(is_double(power_of_two(-1075)));
  CHECK(is_double(power_of_two(1023)));
  CHECK_FALSE(is_double(power_of_two(1024)));
  CHECK_FALSE(is_double(1 + power_of_two(-53)));
  CHECK_FALSE(is_double(power_of_two(-1022) + power_of_two(-1075)));
}

TEST_CASE("sums are exact and canonical") {
  CHECK(sum({}) == 0);
  CHECK(sum({Rational(1, 2)}) == Rational(1, 2));
  std::vector<Rational> values;
  Rational expected = 0;
  for (int i = 1; i <= 137; ++i) {
    values.push_back(Rational(i % 2 ? i : -i, i * i + 1));
    values.back().canonicalize();
    expected += values.back();
    const Rational total = sum(values);
    REQUIRE(total == expected);
    REQUIRE(gcd(total.get_num(), total.get_den()) == 1);
  }
}
