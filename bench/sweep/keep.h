// What a run had and gave, as a tree that people look at.
#pragma once

#include <optional>
#include <string>

#include "bench/cases/family.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

/// Writes FOLDER/problem.yaml: the operands, `exact`, and of a result `given`, `missing` (exact less given),
/// `excess`, and `differs`, both; and FOLDER/row.json. Coordinates are exact. Throws std::runtime_error if they
/// cannot be written.
void keep_tree(const std::string& folder, const Problem& problem, const std::optional<Model>& result,
               const SweepRow& row);

}  // namespace cnrg::bench
