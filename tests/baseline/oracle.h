// The regularized Boolean by the exact kernel, and how a result of the baseline compares with it.
#pragma once

#include <string>

#include "bench/baseline/departures.h"
#include "bench/cases/model.h"
#include "bench/cases/operation.h"

namespace cnrg::bench::baseline_test {

/// Counts of a closed surface. `genus`: handles of all shells together.
struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0, rings = 0, shells = 0;
  long genus = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& counts);

/// Of a model as it is represented. Throws std::runtime_error if it is no closed 2-manifold.
Counts counts_of(const Model& model);
/// Enclosed, signed; of faces as polygons.
Rational volume_of(const Model& model);
/// Points with the coordinates of an earlier one.
std::size_t duplicates_of(const Model& model);

struct Truth {
  Rational volume;
  /// Of the canonical form: maximal faces, no collinear edges; each place once.
  std::size_t vertices = 0, edges = 0, faces = 0;
  /// Of the canonical form of a manifold set; elsewhere of no meaning.
  long genus = 0;
  /// The model that was handed over encloses the same set.
  bool same_set = false;
};

/// The exact regularized result, and whether `answer` (closed, may be empty) is it.
Truth truth_of(const Model& a, const Model& b, Operation operation, const Model& answer);

/// Of the baseline in fractions: `same`: the exact set; `wrong`: another one, or none; else the stage of the
/// failure.
std::string outcome(const Model& a, const Model& b, Operation operation, const mantyla::Departures& departures);

}  // namespace cnrg::bench::baseline_test
