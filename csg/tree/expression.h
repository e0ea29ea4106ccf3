// Numbers of a tree file that are computed: `${...}` in a text.
//
// An expression has numbers, names of parameters, + - * / ^, brackets, and functions: abs, min and max of two,
// floor, ceil; sqrt, exact where the root is rational, else the nearest double; sin, cos and tan of degrees, the
// nearest doubles (tan: their quotient); random of one number or more, from 0 to below 1, the same for the same
// numbers, a multiple of 2^-20. All else is exact.
#pragma once

#include <map>
#include <string>

#include "kernel/exact/rational.h"

namespace cnrg {

/// By name.
using ParameterValues = std::map<std::string, Rational>;

/// Throws InputError, which says what is wrong, and where in the expression.
Rational evaluate_expression(const std::string& expression, const ParameterValues& parameters);

/// The text with numbers in place of all `${...}`; `$${` stays `${`. Throws InputError.
std::string with_values(const std::string& text, const ParameterValues& parameters);

/// A letter, then letters, digits and `_`.
bool is_parameter_name(const std::string& name);

}  // namespace cnrg
