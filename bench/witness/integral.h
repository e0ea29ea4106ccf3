// How far a solid is from the Boolean of two others: the integral of (w - f)^2 over space, w being how often the
// answer goes around a point and f 1 in the Boolean and 0 elsewhere. It is zero only where the two are the same
// but for sets without volume, and the volume of what they differ by where the answer goes around each point once.
//
// Winding numbers are sums over triangles: each with its sign counts what is below it. So the integral of a
// product of winding numbers is a sum over pairs and triples of triangles, each the integral of the lowest one's
// height over what they have in common as seen from above: convex polygons. No intersection of surfaces is needed,
// no topology.
#pragma once

#include "bench/witness/cycle.h"

namespace cnrg::bench::witness {

enum class Operation : std::uint8_t { unite, subtract, intersect };

/// p/q, q > 0, not in lowest terms: sums of many fractions need no common divisors to be compared with zero.
struct Fraction {
  mpz_class p = 0, q = 1;
};

struct Distance {
  bool operands_once = false;  ///< both operands go around each point once or not at all
  bool zero = false;
  double value = 0;  ///< rounded
};

/// All closed. Nothing if it takes more than `most` steps: a pair or triple of triangles that overlap as seen from
/// above is one, and one more for each 16 products of words of its numbers.
std::optional<Distance> distance(const Cycle& a, Operation operation, const Cycle& b, const Cycle& answer,
                                 std::size_t most);

/// The integral of the product of winding numbers, of one to three cycles; `most` as above.
std::optional<Fraction> integral(const std::vector<const Cycle*>& cycles, std::size_t most);

}  // namespace cnrg::bench::witness
