// How many things of one kind can be told apart: ids and places in lists have 32 bits.
//
// A cast to 32 bits would give one thing the number of another, and a result that is wrong without a word. So
// containers check their size where a new id is made, and sums of sizes are made with 64 bits: what is too large
// is an InputError that has the count.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "kernel/base/error.h"

namespace cnrg {

/// Ids of one kind: half-edges and half-faces keep one bit of 32, and the last of them names nothing.
inline constexpr std::uint64_t kMostIds = std::numeric_limits<std::int32_t>::max();
/// Places in a list: the last number names nothing.
inline constexpr std::uint64_t kMostPlaces = std::numeric_limits<std::uint32_t>::max();

[[noreturn, gnu::cold, gnu::noinline]] inline void fail_count(std::uint64_t count, const char* what,
                                                              std::uint64_t most) {
  throw InputError("the model has " + std::to_string(count) + " " + what + ", and at most " +
                   std::to_string(most) +
                   " can be numbered: use fewer or coarser leaves, or evaluate its parts one by one");
}

/// Throws InputError if there are too many things, `what` in the plural, for ids of their own.
inline void check_count(std::uint64_t count, const char* what, std::uint64_t most = kMostIds) {
  if (count > most) [[unlikely]]
    fail_count(count, what, most);
}

/// A place in a list, or its size, in 32 bits. Throws InputError if it needs more.
inline std::uint32_t place32(std::uint64_t place, const char* what) {
  check_count(place, what, kMostPlaces);
  return static_cast<std::uint32_t>(place);
}

/// The number of the next thing after `count` of them, in 32 bits. Throws InputError if it needs more.
inline std::uint32_t next_number(std::uint64_t count, const char* what) {
  check_count(count + 1, what, kMostPlaces);
  return static_cast<std::uint32_t>(count);
}

/// Turns sizes of lists into where each list ends, from the first one on. Throws InputError if the last end needs
/// more than 32 bits.
inline void sum_up(std::vector<std::uint32_t>& sizes, const char* what) {
  std::uint64_t sum = 0;
  for (std::uint32_t& size : sizes) {
    sum += size;
    size = static_cast<std::uint32_t>(sum);
  }
  check_count(sum, what, kMostPlaces);
}

}  // namespace cnrg
