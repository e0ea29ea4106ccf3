// Numbers as text, held against another writer of the standard library and read back.
#include "csg/text/digits.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

#include "tests/catch.h"

using namespace cnrg;

namespace {

/// Finite doubles of all sizes.
std::vector<double> doubles(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<double> out{0,
                          -0.0,
                          1,
                          -1.5,
                          0.1,
                          1e22,
                          1e23,
                          std::numeric_limits<double>::max(),
                          std::numeric_limits<double>::denorm_min(),
                          -std::numeric_limits<double>::min()};
  while (out.size() < count) {
    const double x = std::bit_cast<double>(random());
    if (std::isfinite(x)) out.push_back(x);
  }
  return out;
}

/// That count: without zeros at either end.
std::size_t digits_in(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if (c >= '0' && c <= '9' && !(digits.empty() && c == '0')) digits += c;
  }
  return digits.find_last_not_of('0') + 1;
}

}  // namespace

TEST_CASE("doubles are the shortest texts that read back", "[text]") {
  for (const double x : doubles(20'000)) {
    const std::string text = double_text(x);
    REQUIRE(std::strtod(text.c_str(), nullptr) == x);
    REQUIRE((x != 0 || text == "0"));
    const std::size_t digits = digits_in(text);
    if (digits < 2 || text.find_first_of(".e") == std::string::npos) continue;  // all digits of a whole number
    char fewer[64];
    std::snprintf(fewer, sizeof fewer, "%.*e", int(digits) - 2, x);
    REQUIRE(std::strtod(fewer, nullptr) != x);
  }
}

TEST_CASE("a line is the same whichever way it is cut into pieces", "[text]") {
  const std::string longer(2000, 'x');
  std::string text = "head ", expected = text;
  {
    Line line(text);
    for (int i = 0; i < 400; ++i) {
      line << i - 200 << ' ' << std::uint64_t(i) << (i % 2 == 0) << "|" << std::string(std::size_t(i), 'y');
      expected += std::to_string(i - 200) + " " + std::to_string(i) + (i % 2 == 0 ? "true|" : "false|") +
                  std::string(std::size_t(i), 'y');
    }
    line << longer << std::numeric_limits<std::int64_t>::min();
    expected += longer + std::to_string(std::numeric_limits<std::int64_t>::min());
  }
  CHECK(text == expected);
}

TEST_CASE("points as texts, and lines in blocks, are what lines one by one are", "[text]") {
  const std::vector<double> xs = doubles(30'000);
  std::vector<std::array<double, 3>> points(10'000);
  for (std::size_t i = 0; i < xs.size(); ++i) points[i / 3][i % 3] = xs[i];
  const PointTexts texts(points);
  std::string one_by_one = "all:\n", together = one_by_one;
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::string xyz;
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(texts.coordinate(p, k) == double_text(points[p][k]));
      xyz += (k == 0 ? "" : " ") + double_text(points[p][k]);
    }
    REQUIRE(texts[p] == xyz);
    one_by_one += xyz + "\n";
  }
  append_lines(together, points.size(), [&](std::string& out, std::size_t p) { Line(out) << points[p] << '\n'; });
  CHECK(together == one_by_one);
}
