// When are two regions made of the same? Materials are called by name; a graded one is a function of position, and
// the same function may be written in many ways.
#pragma once

#include "csg/materials/material.h"

namespace cnrg {

/// Equal as functions of position, exactly:
///   * along lines: the same mixture at every point, however line and stops are written;
///   * by distances: the same stops, and distances that are measured alike to the same point set.
bool same_grade(const PlacedGrade& a, const PlacedGrade& b);

}  // namespace cnrg
