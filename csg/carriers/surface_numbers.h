// Which curved patches of all leaves lie on one surface: numbers, equal where surfaces are.
//
// Where two half balls meet, a ball has one face, as two boxes side by side have one top. Facets cannot tell:
// those of different patches lie on one surface although they have no cell in common, and facets of different
// surfaces lie in one plane by chance. So each surface is written down in a form that is equal for equal surfaces,
// whatever shape, place, extent or direction its patch came with: quadrics by the ten coefficients of their
// equation under the transform, tori by axis and radii in the metric in which they are round, all others by the
// polynomials of their nets (net_carriers.h).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Symmetric.
using Quadric = std::array<std::array<Rational, 4>, 4>;
/// With a hole: radius > tube > 0.
struct Torus {
  RationalPoint center, axis;
  Rational radius, tube;
};
/// By numbers of surfaces. Quadrics: x' A x = 0 for x = (x, y, z, 1). Tori: those that are round with rational
/// radii.
struct SurfaceEquations {
  std::map<std::uint32_t, Quadric> quadrics;
  std::map<std::uint32_t, Torus> tori;
};

/// Makes the first number that is not zero 1: equations that differ by a factor become equal.
void divide_by_first(std::span<Rational> equation);

/// Of each instance, by the number of the patch: that of its surface, from 1. 0, also beyond the end: the patch is
/// flat, or what it lies on is not known. A patch of several nets lies on one surface with another one only if it
/// lies on all of its surfaces.
std::vector<std::vector<std::uint32_t>> surface_numbers(const std::vector<LeafInstance>& instances,
                                                        SurfaceEquations* equations = nullptr);

}  // namespace cnrg
