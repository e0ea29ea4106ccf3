// Who confirms the verdict of a row, by ways that share no code with the kernel: CGAL's Nef polyhedra, else exact
// integrals, else exact points (bench/witness).
#pragma once

#include "bench/cases/family.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

/// What `witness` finds of an answer. It looks at solids alone: what has no thickness and contacts are left to
/// Nef. `verdict` and `stage` are those of the judge, who said "right", "wrong" or nothing. Integrals may
/// take long.
Confirmation confirm_by_witness(const Problem& problem, const Model& answer, double rounding, Verdict verdict,
                                const std::string& stage, bool integrals = true);

}  // namespace cnrg::bench
