// Names of the baseline's variants, such as `mantyla-double:1e-8` and `mantyla-published+arcs`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/baseline/mantyla.h"

namespace cnrg::bench::mantyla {

inline constexpr double kEpsilon = 1e-10;  ///< where a name has none

/// A rule that a name changes.
struct Change {
  const Departure* departure;
  bool on;
};

struct Variant {
  bool fractions = false;
  double epsilon = kEpsilon;  ///< of doubles; the rounding of their results, too
  Departures departures;
  std::vector<Change> changes;
};

/// `mantyla-KIND[:EPSILON][+RULE|-RULE]...`: KIND is double, exact, published or published-exact. Nothing for
/// other names. Throws std::runtime_error for what is no epsilon, and rules that are none or change nothing.
std::optional<Variant> parse_variant(const std::string& name);

}  // namespace cnrg::bench::mantyla
