// The Booleans that every system of a comparison has.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cnrg::bench {

/// `subtract`: the first operand without all others.
enum class Operation : std::uint8_t { unite, subtract, intersect };

/// `union`, `difference`, `intersection`.
inline const char* to_string(Operation operation) {
  constexpr const char* names[] = {"union", "difference", "intersection"};
  return names[static_cast<int>(operation)];
}

inline std::optional<Operation> parse_operation(std::string_view name) {
  for (const Operation operation : {Operation::unite, Operation::subtract, Operation::intersect})
    if (name == to_string(operation)) return operation;
  return {};
}

}  // namespace cnrg::bench
