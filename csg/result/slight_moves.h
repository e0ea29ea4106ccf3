// A proof, for most roundings, that they change nothing but digits.
//
// To refine all of what is written, as `is_faithful` does, costs more than the Boolean did, and mostly only few
// points have moved, by less than a billionth of what is around them. So imagine all points moving to their
// doubles at the same time. As long as no two cells come to touch that did not, and no triangle collapses, nothing
// can pass through anything: what lies where before lies there afterwards. Only cells with points that move can
// come to touch others, and only those that are near: these pairs are looked at, each as a whole, with a box
// around each moving point that holds its way. Two cells are apart all the time if there is a plane with one on
// each side, and what they have on it meets in points alone that they share. Planes tried are that of a triangle,
// and those through one of its sides or a segment: along a coordinate axis, or through a corner of the other cell.
// Signs are those of determinants in doubles with a bound of their error.
//
// Where no plane is found, or a sign is not certain, nothing is known.
#pragma once

#include "csg/result/rounding.h"

namespace cnrg {

/// True if rounding is certain to be faithful (`is_faithful`), given that the exact drawing is embedded.
bool is_surely_faithful(const RoundedPoints& points, const Drawing& drawing);

}  // namespace cnrg
