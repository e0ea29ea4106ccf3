// The laws of the CNRG algebra on the values of random dags (csg/SEMANTICS.md#identities), and each value by its
// definition, cell by cell.
#pragma once

#include <string>

#include "tests/oracles/dag.h"

namespace cnrg::properties {

/// The first law that a pair or triple of the dag's values breaks, or the first value that is not as defined; what
/// is refused or thrown (dag_values.h). Empty when all is well.
std::string law_failure(const RandomDag& dag);

}  // namespace cnrg::properties
