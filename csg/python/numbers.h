// Exact numbers between Python and the library: `fractions.Fraction` and what may stand for one.
#pragma once

#include "bind.h"

namespace cnrg::python {

/// As a `fractions.Fraction`.
py::object to_fraction(const Rational& value);
/// As Fractions, in a tuple of three.
py::tuple to_fractions(const RationalPoint& point);
py::object to_fractions(const std::optional<RationalPoint>& point);
/// None if there is none.
py::object to_fraction(const std::optional<Rational>& value);
/// The exact value of an int, float, str (`1/3`, `0.1`), Fraction, Decimal, or number of numpy; `what` is for
/// messages. InputError, or TypeError of Python for what is no number.
Rational to_rational(const py::handle& value, const std::string& what);
RationalPoint to_rational_point(const py::handle& value, const std::string& what);

}  // namespace cnrg::python
