// A tree of cubical groups by brute force against the whole program, cell by cell.
#pragma once

#include <string>

#include "tests/oracles/cubical_dag.h"

namespace cubical {

/// How much was met of what is said, for tests that want to know that they test something.
struct SaidTally {
  std::size_t nodes = 0, said_cells = 0, regions = 0, conflicts = 0, counted = 0, owners = 0;
};

/// The first difference in words, or an empty string: the component of a cell; counts of the canonical form; what
/// is said of a face, edge or vertex of a value; name, material and properties of a region of a group, and of the
/// component that a cell is of; a warning too many or too few (key, what is kept, what gave way); two cells of
/// which different things are said in one simplified cell; counts of simplified cells.
std::string compare_by_brute_force(const Grid& grid, const CubicalDag& dag, SaidTally* tally = nullptr);

}  // namespace cubical
