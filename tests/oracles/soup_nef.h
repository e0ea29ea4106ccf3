// Random soups of mixed dimension on tiny grids, where everything touches everything, against Nef polyhedra.
//
// No leaf is a solid here: triangles, polygons, wires and points in any position, in any number of leaves. The
// union of all cells of dimension up to 2 must be the union of the parts, and the cavities must be as many.
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/nef_oracle.h"
#include "tests/scenes/scene.h"

namespace cnrg::properties {

/// One to three leaves of `parts` parts on the grid points 0 .. size; half of the soups turned.
std::vector<scenes::Leaf> random_soup(std::uint64_t seed, int parts, int size);

/// What is wrong with the complex of a soup; empty when nothing is. Throws OracleFailure when Nef itself fails.
std::string compare_soup_with_nef(const std::vector<scenes::Leaf>& leaves);

}  // namespace cnrg::properties
