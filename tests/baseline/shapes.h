// Polyhedra with rational coordinates for the tests of the baseline.
#pragma once

#include <array>
#include <vector>

#include "bench/cases/model.h"
#include "bench/cases/random.h"

namespace cnrg::bench::baseline_test {

using Polygon = std::vector<std::array<long, 2>>;

Model box(const std::array<long, 3>& low, const std::array<long, 3>& high);
/// The polygon (counter-clockwise), holes (clockwise), between two heights.
Model prism(const Polygon& outer, const std::vector<Polygon>& holes, long low, long high);
Model tetrahedron();
Model octahedron();
/// An L, a U, a cross, a polygon of `corners` on a circle of integer points.
Polygon ell();
Polygon letter_u();
Polygon plus();
/// A square frame: genus 1, two faces with rings.
Model frame();
/// The same with two windows.
Model ladder();

/// p -> (q p q*) / |q|^2 * scale + move, exact.
Model placed(Model model, const std::array<Rational, 4>& q, const Rational& scale, const RationalPoint& move);
/// Moved.
Model at(Model model, long x, long y, long z);
/// Axes permuted: x to axis k, y to the next, z to the one after; outward stays outward.
Model with_axis(Model model, int k);
/// Coordinates rounded to doubles.
Model rounded(Model model);
/// Faces cut from their first corners; for convex faces without rings.
Model fanned(const Model& model);

/// Any of the above with maximal faces, in general position: turned, scaled and moved at random.
Model random_solid(Random& random);
/// Boxes, prisms and frames on an integer grid, where everything touches.
Model random_grid_solid(Random& random);

}  // namespace cnrg::bench::baseline_test
