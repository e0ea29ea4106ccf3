// A pair of cubical groups as a soup for the kernel, and the comparison of both answers cell by cell.
#pragma once

#include <cstdint>
#include <string>

#include "kernel/exact/rational.h"
#include "tests/properties/cubical.h"

namespace cubical {

/// How a pair reaches the kernel.
struct Presentation {
  bool large_a = false, large_b = false;  ///< maximal rectangles instead of unit squares
  bool tilted = false;                    ///< under a rational rotation that leaves nothing axis-parallel
  bool thorough = false;                  ///< identities, classification by rays, complement, simplified counts
};

/// Compares the kernel with the brute force for every operator and dominance. Returns the first difference in
/// words, or an empty string.
std::string compare_pair(const Grid& grid, const Group& a, const Group& b, const Presentation& presentation);

/// The pair of a seed.
struct Pair {
  Group a, b;
  Presentation presentation;
};
Pair random_pair(const Grid& grid, std::uint64_t seed);

/// A smaller pair that still differs, by leaving out cubes and entities one by one.
Pair shrink(const Grid& grid, Pair pair);

}  // namespace cubical
