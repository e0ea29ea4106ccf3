// Random trees with every operator on cubical groups.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/cubical.h"
#include "tests/oracles/dag.h"

namespace cubical {

struct CubicalDag {
  cnrg::properties::RandomDag dag;  ///< leaves are rectangles, wires and points on the grid
  cnrg::scenes::Motion place;       ///< where the program gets them
};

/// Two to four leaves. `moved`: turned, sheared, scaled or reflected.
CubicalDag random_cubical_dag(const Grid& grid, std::uint64_t seed, bool moved);
/// A regular map: a rational rotation, a shear, a scaling by powers of ten, a reflection, one after another.
cnrg::scenes::Motion random_place(std::uint64_t seed);

/// With the leaves where the program gets them.
cnrg::properties::RandomDag placed(const CubicalDag& dag);

/// With random names, materials, properties and numbers of dominance; half of them have group Booleans alone.
CubicalDag random_said_dag(const Grid& grid, std::uint64_t seed, bool moved);

std::string tree_file(const CubicalDag& dag);
std::vector<CubicalDag> smaller(const Grid& grid, const CubicalDag& dag);

}  // namespace cubical
