// Which of two operands decides where both have something to say.
#pragma once

#include <cstdint>

namespace cnrg {

enum class Dominance : std::uint8_t { left, right, equal };

}  // namespace cnrg
