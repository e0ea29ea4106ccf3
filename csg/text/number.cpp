// `parse_rational` says no more than that a text is no number. Which part is at fault is found by asking again
// with that part replaced, so that the grammar stands in one place.
#include "csg/text/number.h"

#include <cmath>

#include "csg/text/table.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

constexpr std::size_t kMostExponentDigits = 40;  // that are told

/// The text with a zero for each exponent; the first of them that is far from zero.
std::string without_exponents(std::string_view text, std::string_view& large) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    out += text[i++];
    if (out.back() != 'e' && out.back() != 'E') continue;
    std::size_t end =
        text.find_first_not_of("0123456789", i + (i < text.size() && (text[i] == '+' || text[i] == '-')));
    end = std::min(end, text.size());
    if (end - i > 5 && large.empty()) large = text.substr(i, end - i);
    if (end > i) out += '0';
    i = end;
  }
  return out;
}

std::string fault_of(std::string_view text) {
  std::string_view large;
  if (parse_rational(without_exponents(text, large)) && !large.empty()) {
    const bool long_one = large.size() > kMostExponentDigits;
    return " has the exponent " + std::string(large.substr(0, kMostExponentDigits)) + (long_one ? "..." : "") +
           "; exponents are from -100000 to 100000";
  }
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos && parse_rational(text.substr(0, slash)) &&
      parse_rational(text.substr(slash + 1)) && text.find_first_of("+-", slash) != slash + 1) {
    return " is no number, since its denominator is 0; write a decimal such as 0.1 or a fraction such as 1/3";
  }
  return " is no number; write a decimal such as 0.1 or 1.5e-3, or a fraction such as 1/3";
}

std::size_t digits_of(const Integer& x) {
  const std::size_t most = mpz_sizeinbase(x.get_mpz_t(), 10);  // exact, or one too many
  const Integer least = power_of_ten(most - 1);
  return mpz_cmpabs(x.get_mpz_t(), least.get_mpz_t()) < 0 ? most - 1 : most;
}

}  // namespace

NumberText read_number(std::string_view text, std::size_t most) {
  if (text.size() > most) {
    return {{}, " has " + grouped(text.size()) + " characters; a number here has at most " + grouped(most)};
  }
  std::optional<Rational> value = parse_rational(text);
  if (value) return {std::move(value), {}};
  return {{}, fault_of(text)};
}

std::string number_text(const Rational& value, std::string_view elsewhere) {
  constexpr std::size_t kReadable = 24, kPrinted = 160;
  // Bits tell how many digits there are at least: a text that is not going to be shown is not made.
  if (bits_of(value) <= 4 * kPrinted) {
    std::string exact = to_string(value), decimal = to_decimal(value);
    if (decimal.size() <= kReadable && parse_rational(decimal) == value) return decimal;
    if (exact.size() <= kReadable && value.get_den() == 1) return exact;
    if (exact.size() <= kPrinted) return decimal + " (" + exact + ")";
  }
  const bool whole = value.get_den() == 1;
  const std::size_t digits = digits_of(value.get_num()) + (whole ? 0 : digits_of(value.get_den()));
  return to_decimal(value) + " (the " + (whole ? "number" : "fraction") + " has " + std::to_string(digits) +
         " digits" + std::string(elsewhere) + ")";
}

std::string bound_text(const std::optional<double>& bound) {
  if (!bound) return "unknown";
  if (*bound == 0) return "";
  const double unit = std::pow(10.0, std::floor(std::log10(*bound)) - 2);
  std::string text;
  for (double x = *bound; text.empty() || std::stod(text) < *bound; x += unit / 2) text = decimal(x, "%.3g");
  return text;
}

}  // namespace cnrg
