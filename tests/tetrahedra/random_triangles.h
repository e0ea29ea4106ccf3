// Random triangles that overlap nowhere, on lattices and in general position.
#pragma once

#include <random>

#include "kernel/tetrahedra/constrained.h"

namespace cnrg {

/// Adds their points to the table.
Constraints random_triangles(std::mt19937_64& random, PointTable& t);

}  // namespace cnrg
