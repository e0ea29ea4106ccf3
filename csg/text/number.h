// Exact numbers as people and programs write them, with limits that keep a text of digits from being an attack.
//
// Reading n digits costs a little more than n; what costs is what is done with the number afterwards. Nobody
// writes a coordinate of 100,000 digits. A result may hold longer numbers than its tree: a volume is a sum of
// fractions, and its denominator holds those of all vertices.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/exact/rational.h"

namespace cnrg {

inline constexpr std::size_t kMostDigits = 100'000;            ///< of a number in a tree, a point, a mesh
inline constexpr std::size_t kMostResultDigits = 100'000'000;  ///< of a number in a `.json`

/// Reads a number as `parse_rational`. If it is none, or more than `most` characters long, the reason follows the
/// number in a message: ` is no number; write ...`, ` has the exponent ...`.
struct NumberText {
  std::optional<Rational> value;
  std::string fault;
};
NumberText read_number(std::string_view text, std::size_t most = kMostDigits);

/// An exact number for people: a decimal, and behind one that is rounded the fraction, or, where that would fill
/// the screen, the number of its digits and `elsewhere`: where the fraction is.
std::string number_text(const Rational& value, std::string_view elsewhere);

/// A bound of an error, 0 or more, in three digits, rounded up; empty for 0, and of one that nobody knows
/// `unknown`.
std::string bound_text(const std::optional<double>& bound);

}  // namespace cnrg
