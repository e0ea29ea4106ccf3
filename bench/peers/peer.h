// Systems that evaluate a case, behind one face.
//
// What is measured begins with the system's own input structure in memory and ends with its result in memory;
// making the structure from the triangles and checking the result (`Checks`) are not measured. A system that can
// not do a case throws.
#pragma once

#include "bench/cases/case.h"
#include "bench/cases/measurement.h"

namespace cnrg::bench {

struct Checks {
  bool volume = false;
  bool validate = false;  ///< all invariants of the complex (ours only)
};

struct Outcome {
  Measures measures;
  std::size_t vertices = 0, faces = 0;  ///< of the result, as the system counts them
  double volume = 0;                    ///< of the result if checked, rounded from the exact value if any
  std::string exact_volume;             ///< in lowest terms, if the system is exact
  std::size_t cells = 0;                ///< of the refinement, vertices to regions (ours only)
  double exact_share = 0;               ///< of predicate calls that went to the exact stage (ours only)
  std::string invalid;                  ///< the first invariant that does not hold
  std::string note;
};

/// The library: soup -> complex -> values of the leaves -> one n-ary node as a tree has it -> simplified result;
/// of trees: parsed tree -> evaluation with its volume, as `cnrg eval --quiet`.
Outcome evaluate_ours(const Case& c, const Checks& checks, int threads);
/// CGAL, EPICK, in place; more than two operands one after the other. One thread.
Outcome evaluate_corefinement(const Case& c, const Checks& checks, int threads);
/// CGAL, conversion and Boolean; unions of many by CGAL's Nef_nary_union_3. One thread.
Outcome evaluate_nef(const Case& c, const Checks& checks, int threads);
/// The same, but many operands one after the other, as a loop over `+=` does.
Outcome evaluate_nef_one_by_one(const Case& c, const Checks& checks, int threads);

/// Any program, called as `EXECUTABLE OPERATION A.off B.off... OUT.off` with CNRG_THREADS in its environment. Its
/// line `measured SECONDS BASE_BYTES PEAK_BYTES` on standard error is what is measured; without it the time and
/// peak memory of its process are.
Outcome evaluate_program(const std::string& executable, const Case& c, const Checks& checks, int threads);

}  // namespace cnrg::bench
