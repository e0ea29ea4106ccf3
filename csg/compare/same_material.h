// When are two regions made of the same? Materials are called by name; a graded one is a function of position, and
// the same function may be written in many ways.
#pragma once

#include <string>

#include "csg/materials/grade.h"

namespace cnrg {

/// Equal as functions of position, exactly:
///   * along lines: the same mixture at every point, however line and stops are written;
///   * by distances: the same stops, and distances that are measured alike to the same point set;
///   * with graded materials in mixtures: as above, where two of these are one if they are the same function by
///     these rules, whatever they are called;
///   * of blends: the same two materials, in any order, and boundaries that are the same point sets.
/// Names of materials in `b` may have a mark, which does not count.
bool same_grade(const PlacedGrade& a, const PlacedGrade& b, const std::string& mark = {});

/// A name without the marks in it.
std::string without_mark(const std::string& name, const std::string& mark);

}  // namespace cnrg
