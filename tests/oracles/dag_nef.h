// Random dags against Nef polyhedra, node by node: the point set of every value, open, unbounded or neither,
// equals Nef's for the same expression (csg/SEMANTICS.md#identities), and components are those of the definitions.
#pragma once

#include <string>

#include "tests/oracles/dag_values.h"
#include "tests/oracles/nef_oracle.h"

namespace cnrg::properties {

/// What the comparisons of a test met.
struct Tally {
  Coverage coverage;
  std::size_t oracle_failures = 0, contradictions = 0, nodes = 0, empty = 0, open = 0, unbounded = 0;
  std::size_t each_by_nef = 0, cells = 0;
};

/// What is wrong at the first node that differs; empty when nothing is. Throws OracleFailure when Nef itself
/// fails, or contradicts itself.
std::string compare_with_nef(const RandomDag& dag, const DagValues& values, Tally& tally);

}  // namespace cnrg::properties
