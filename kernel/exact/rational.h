// Exact numbers: integers and fractions of any size, and the ways between them, text and doubles.
//
// GMP does the arithmetic. The project says Integer and Rational; functions of GMP are named only where operators
// would cost temporaries or there is none, and where the program prints versions or watches memory (csg/app).
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cnrg {

using Integer = mpz_class;
using Rational = mpq_class;
using RationalPoint = std::array<Rational, 3>;

/// The exact value of a decimal or fraction: `-12`, `0.1` (1/10), `1.5e-3`, `121/3`, `-0.5/3`.
/// Nothing (not zero) when the text is no number, has a zero denominator or an exponent beyond +-100000.
std::optional<Rational> parse_rational(std::string_view text);

/// `p` or `p/q` in lowest terms.
std::string to_string(const Rational& value);

/// The decimal expansion rounded to `digits` significant digits (nearest), such as `0.333333`;
/// an exponent is written where the plain form would be longer than 21 characters.
std::string to_decimal(const Rational& value, int digits = 12);

/// The double nearest to `value` (ties to even); infinite beyond the range of double.
double to_double(const Rational& value);

/// The exact value of a finite double.
Rational from_double(double value);

/// True when the value is a finite double exactly.
bool is_double(const Rational& value);

/// The sum of many fractions by binary splitting, canonical. Cost is that of multiplying the result's size.
Rational sum(std::vector<Rational> values);

}  // namespace cnrg
