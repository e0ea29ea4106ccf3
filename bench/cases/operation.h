// The Booleans that every system of a comparison has.
#pragma once

#include <cstdint>

namespace cnrg::bench {

/// `subtract`: the first operand without all others.
enum class Operation : std::uint8_t { unite, subtract, intersect };

/// `union`, `difference`, `intersection`.
inline const char* to_string(Operation operation) {
  constexpr const char* names[] = {"union", "difference", "intersection"};
  return names[static_cast<int>(operation)];
}

}  // namespace cnrg::bench
