// Parts of a turn, between two directions across an axis, compared exactly.
#pragma once

#include "kernel/exact/rational.h"

namespace cnrg {

/// Counter-clockwise about the axis, its ends included; a whole turn has no ends.
struct Sector {
  RationalPoint from, to;
  bool whole = true;
};
bool same_ray(const RationalPoint& a, const RationalPoint& b);
bool meet(const Sector& a, const Sector& b, const RationalPoint& axis);
/// True if they have more than ends in common.
bool overlap(const Sector& a, const Sector& b, const RationalPoint& axis);

}  // namespace cnrg
