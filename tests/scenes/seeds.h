// How many random cases a test runs: CNRG_SEEDS overrides the number, CNRG_FIRST_SEED where it starts.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <utility>

namespace cnrg::scenes {

/// First seed and one past the last.
inline std::pair<std::uint64_t, std::uint64_t> seeds(std::uint64_t usual) {
  const char* count = std::getenv("CNRG_SEEDS");
  const char* first = std::getenv("CNRG_FIRST_SEED");
  const std::uint64_t begin = first ? std::strtoull(first, nullptr, 10) : 0;
  return {begin, begin + (count ? std::strtoull(count, nullptr, 10) : usual)};
}

}  // namespace cnrg::scenes
