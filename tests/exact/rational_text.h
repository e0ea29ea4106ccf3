// Fractions in tests, as they are written.
#pragma once

#include "kernel/exact/rational.h"

namespace cnrg {

inline Rational r(const char* text) { return *parse_rational(text); }

}  // namespace cnrg
