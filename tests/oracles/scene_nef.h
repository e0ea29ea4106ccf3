// Random trees of Booleans against Nef polyhedra: equal point sets at every node (csg/SEMANTICS.md#identities).
#pragma once

#include <string>

#include "tests/oracles/nef_oracle.h"
#include "tests/scenes/scene.h"

namespace cnrg::properties {

/// What is wrong at the first node that differs from Nef's: the group itself, its canonical form, its volume, the
/// place of a cell. Empty when all is well. Throws OracleFailure when Nef itself fails.
std::string compare_with_nef(const scenes::Scene& scene);

}  // namespace cnrg::properties
