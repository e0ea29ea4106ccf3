// Numbers as a reader sees them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace cnrg::bench {

/// Three significant digits without an exponent from 1e-6 to 1e6, such as `0.00123`, `12.3`, `1,230`.
std::string three_digits(double value);
/// `1,234,567`.
std::string grouped(std::size_t count);
/// A part of 1 in percent: `0 %`, `100 %`, else two significant digits, never rounded to 0 or 100.
std::string percent(double part);
/// MB of 10^6 bytes, three digits.
std::string megabytes(double bytes);
/// Of a power law, two digits after the point.
std::string exponent_text(double exponent);
/// `10⁻⁹`; 10^-k, `exact` for none.
std::string distance_text(const std::optional<int>& k);
/// `10³`.
std::string power_of_ten(int exponent);
/// Characters of a UTF-8 text.
std::size_t characters(const std::string& text);
/// `1 run`, `2 runs`.
std::string plural(std::size_t count, const std::string& noun);

}  // namespace cnrg::bench
