// A polygon whose corners were rounded, made planar: the key `fit` of polygons and prisms, by rule 7 of weld.h.
#pragma once

#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// Moves the corners of the loops (the outer one first) onto one plane, exactly, if they lie between two planes d
/// apart; else they stay. Returns what to tell of it. `name` is that of the polygon in messages; d > 0.
std::vector<std::string> fit_polygon(std::vector<std::vector<RationalPoint>>& loops, const Rational& d,
                                     const std::string& name);

}  // namespace cnrg
