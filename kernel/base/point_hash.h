// A hash of three coordinates by their bits, for tables that find equal points. Tables only look up by it: nothing
// is put in the order of hashes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace cnrg {

/// Equal coordinates have equal hashes; -0 counts as 0.
inline std::uint64_t hash_of_point(const double* xyz) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(xyz[k] + 0.0)) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
    hash ^= hash >> 29;
  }
  return hash;
}

struct HashPoint {
  std::size_t operator()(const std::array<double, 3>& p) const { return hash_of_point(p.data()); }
};

}  // namespace cnrg
