// Numbers that stand for none and for infinity.
#pragma once

#include <cstdint>
#include <limits>

namespace cnrg {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();  ///< no index
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kUlp = std::numeric_limits<double>::epsilon();  ///< from 1 to the next double

}  // namespace cnrg
