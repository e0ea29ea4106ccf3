#include "csg/text/number.h"

#include "tests/catch.h"

using namespace cnrg;
using Catch::Contains;

TEST_CASE("a number is read, or its fault is told") {
  CHECK(read_number("-0.5/3").value == Rational(-1, 6));
  CHECK(read_number("1e100000").value);
  CHECK(read_number("7", 1).value == 7);
  CHECK(read_number("77", 1).fault == " has 2 characters; a number here has at most 1");
  CHECK(read_number("1e100001").fault == " has the exponent 100001; exponents are from -100000 to 100000");
  CHECK_THAT(read_number("2/1e-100001").fault, Contains("the exponent -100001;"));
  CHECK_THAT(read_number("1e" + std::string(5000, '9')).fault, Contains("999...; exponents"));
  for (const char* zero : {"1/0", "0/0.0", "-3/0e5"})
    CHECK_THAT(read_number(zero).fault, Contains("denominator is 0"));
  for (const char* none : {"", "x", "1e", "e5", "1e1000000x", "1/-2", "1/+2", "--1", "1 ", "1e+", "nan", "0x10"}) {
    INFO(none);
    CHECK_THAT(read_number(none).fault, Catch::StartsWith(" is no number; write"));
  }
}

TEST_CASE("a number for people is a decimal first, and exact") {
  CHECK(number_text(Rational(1253, 5), "") == "250.6");
  CHECK(number_text(7, "") == "7");
  CHECK(number_text(Rational(1, 6), "") == "0.166666666667 (1/6)");
  CHECK(number_text(Rational(-28, 3), "") == "-9.33333333333 (-28/3)");
  CHECK(number_text(Rational(1, 1'000'000'000), "") == "0.000000001");
  CHECK(number_text(parse_rational("1999999999e-9").value(), "") == "1.999999999");
  CHECK(number_text(parse_rational("1234567890123456789").value(), "") == "1234567890123456789");
  CHECK(number_text(parse_rational("0.1234567890123456").value(), "") ==
        "0.123456789012 (" + to_string(parse_rational("0.1234567890123456").value()) + ")");
}

TEST_CASE("digits of a fraction that is not shown are counted, not written") {
  for (const unsigned long power : {250ul, 251ul, 1000ul}) {
    Integer big;
    mpz_ui_pow_ui(big.get_mpz_t(), 10, power);
    for (const long more : {-1l, 0l, 1l}) {
      for (const int sign : {1, -1}) {
        Rational value(sign * (big + more), 7 * big * big + 1);
        value.canonicalize();
        const std::string told =
            " (the fraction has " + std::to_string(to_string(abs(value)).size() - 1) + " digits, elsewhere)";
        CHECK(number_text(value, ", elsewhere") == to_decimal(value) + told);
      }
    }
  }
  Integer ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, 260);
  CHECK(number_text(-ten, "") == "-1e260 (the number has 261 digits)");
  CHECK(number_text(ten - 1, "; there") == "1e260 (the number has 260 digits; there)");
}
