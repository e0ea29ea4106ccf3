// Sets of cells of random grids, and their Betti numbers by elimination over incidence matrices.
#pragma once

#include <array>
#include <memory>

#include "kernel/complex/complex.h"
#include "kernel/selection/selection.h"
#include "tests/scenes/scene.h"

namespace cnrg::elimination {

using Numbers = std::array<long, 3>;

/// Random rectangles, wires and points on the grid points 1 .. n - 1.
std::shared_ptr<const Complex> random_grid(scenes::Random& random, int n);

/// One of many ways to be a set: anything, or closed, or open, or the boundary or the complement of one.
CellSet random_set(const Complex& complex, scenes::Random& random);

/// The pieces of the complement on the 3-sphere, by union-find over all cells and the point at infinity.
long complement_pieces(const Complex& complex, const CellSet& set);

/// The Betti numbers over Z/2 of a set on a complex of `random_grid`, and those over Q.
Numbers eliminate(const Complex& complex, const CellSet& set, int n, Numbers& over_q);

}  // namespace cnrg::elimination
