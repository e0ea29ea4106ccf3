// A unit of a sweep whose problem is a node of any operator: its value is compared, as a set of marked cells or by
// its regions, and not a model of a system.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/sweep/unit.h"

namespace cnrg::bench {

bool can_compare(const System& system, Compared compared);

/// As of problems of results, a digest of the operands, their number, their triangles and the operator.
nlohmann::json described_node(const Setup& setup, const std::string& problem);

/// Verdict, stage, message, times and who confirms. Throws ProblemError.
void compare_node(const Setup& setup, const System& system, SweepRow& row);

}  // namespace cnrg::bench
