// Random dags against Nef polyhedra, node by node: the point set of every value, open, unbounded or neither,
// equals Nef's for the same expression (csg/SEMANTICS.md#identities), and components are those of the definitions.
#pragma once

#include <string>

#include "tests/oracles/dag.h"
#include "tests/oracles/nef_oracle.h"

namespace cnrg::properties {

/// What is wrong at the first node that differs; empty when nothing is. Throws OracleFailure when Nef itself
/// fails, or contradicts itself.
std::string compare_with_nef(const RandomDag& dag);

}  // namespace cnrg::properties
