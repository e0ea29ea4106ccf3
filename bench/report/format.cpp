#include "bench/report/format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cnrg::bench {
namespace {

std::string printed(const char* format, int digits, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

/// Commas between thousands of the digits before the point.
std::string with_commas(std::string text) {
  const std::size_t first = text.find_first_of("0123456789");
  std::size_t point = std::min(text.find('.'), text.size());
  while (point > first + 3) {
    point -= 3;
    text.insert(point, ",");
  }
  return text;
}

}  // namespace

std::string three_digits(double value) {
  if (!std::isfinite(value)) return "–";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 1e-6 || size >= 1e15) return printed("%.*g", 3, value);
  // The decade after rounding to three digits: 9.996 is 10.0.
  const double rounded = std::strtod(printed("%.*e", 2, size).c_str(), nullptr);
  const int decade = static_cast<int>(std::floor(std::log10(rounded) + 1e-9));
  if (decade <= 2) return printed("%.*f", 2 - decade, value);
  return with_commas(printed("%.*f", 0, std::copysign(rounded, value)));
}

std::string grouped(std::size_t count) { return with_commas(std::to_string(count)); }

std::string percent(double part) {
  const double value = 100 * part;
  if (value == 0 || value == 100) return printed("%.*f %%", 0, value);
  if (value > 99) return printed("%.*f %%", 2, std::min(value, 99.99));
  if (value >= 10) return printed("%.*f %%", 0, value);
  return printed("%.*g %%", 2, value);
}

std::string megabytes(double bytes) { return three_digits(bytes / 1e6); }

std::string exponent_text(double exponent) { return printed("%.*f", 2, exponent); }

std::string power_of_ten(int exponent) {
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += kDigits[c - '0'];
  return text;
}

std::string distance_text(const std::optional<int>& k) { return k ? power_of_ten(-*k) : "exact"; }

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string plural(std::size_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace cnrg::bench
