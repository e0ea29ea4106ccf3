// What is said of each cell of each value, by the words of csg/SEMANTICS.md#attributes alone, against what the
// program says, on trees of cubical groups with random names, materials, properties and numbers of dominance.
//
// The program carries what is said with the origins of its cells, by sets of leaves that are interned, merged in
// folds and kept in parts. Here it is an array over the cells of the grid, and every rule is a loop over it. Where
// the page leaves open which of two regions of one operand counts, nothing is compared.
#pragma once

#include <string>

#include "tests/oracles/cubical_dag.h"

namespace cubical {

/// Half of them have group Booleans alone, with numbers of dominance too.
CubicalDag random_said_dag(const Grid& grid, std::uint64_t seed, bool moved);

/// How much of the above was met, for tests that want to know that they test something.
struct SaidTally {
  std::size_t nodes = 0, said_cells = 0, regions = 0, conflicts = 0, counted = 0, owners = 0;
};

/// The first difference in words, or an empty string: what is said of a face, edge or vertex of a value; name,
/// material and properties of a region of a group, and of the component that a cell is of; a warning too many or
/// too few (key, what is kept, what gave way); two cells of which different things are said in one simplified
/// cell; counts of simplified cells.
std::string compare_said(const Grid& grid, const CubicalDag& dag, SaidTally* tally = nullptr);

}  // namespace cubical
