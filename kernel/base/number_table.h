// Equal things of a list, found by hash: an open table of their numbers.
//
// The things stay in the list of the caller; the table holds where in it they are, and asks the caller whether a
// number is that of an equal thing. It never grows and nothing leaves it, so linear probing is all there is to it.
// The order of the list is the caller's: no result depends on hashes.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace cnrg {

class NumberTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// Empty, with room for `most` numbers; half of it stays free.
  explicit NumberTable(std::size_t most = 0) : slots_(std::bit_ceil(2 * most + 1), kNone) {}

  /// The slot of the thing with this hash for whose number `same(number)` is true. Where it holds kNone the thing
  /// is new: its number is to be written there.
  template <class Same>
  std::uint32_t& slot(std::uint64_t hash, const Same& same) {
    return slots_[place(hash, same)];
  }
  /// The number in that slot; kNone: there is no such thing.
  template <class Same>
  std::uint32_t find(std::uint64_t hash, const Same& same) const {
    return slots_[place(hash, same)];
  }

 private:
  template <class Same>
  std::size_t place(std::uint64_t hash, const Same& same) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    while (slots_[slot] != kNone && !same(slots_[slot])) slot = (slot + 1) & mask;
    return slot;
  }
  std::vector<std::uint32_t> slots_;
};

}  // namespace cnrg
