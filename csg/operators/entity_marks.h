// What a fold knows of the entities of one dimension: flags on the cells of the complex, and where each came from.
#pragma once

#include <algorithm>
#include <vector>

#include "csg/operators/origins.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

/// Flags of a cell. *Held* is the value that a fold has so far, *next* the operand that a step takes in.
inline constexpr std::uint8_t kHeld = 1;          ///< an entity of held
inline constexpr std::uint8_t kNext = 2;          ///< an entity of next
inline constexpr std::uint8_t kRemoved = 4;       ///< a row of this step removes it
inline constexpr std::uint8_t kHeldFeature = 8;   ///< a feature of held
inline constexpr std::uint8_t kNextFeature = 16;  ///< a feature of next
inline constexpr std::uint8_t kAsked = 32;        ///< in `asked`
inline constexpr std::uint8_t kBorder = 64;       ///< of next, in the closure of a face of next alone that stays
inline constexpr std::uint8_t kListed = 128;      ///< in `listed`

template <class IdT>
struct EntityMarks {
  explicit EntityMarks(std::size_t cells) : flags(cells), origin(cells) {}
  bool has(IdT cell, std::uint8_t any) const { return (flags[cell] & any) != 0; }
  /// An entity of held or next that stays.
  bool kept(IdT cell) const { return has(cell, kHeld | kNext) && !has(cell, kRemoved); }
  /// A row may remove this cell of held: it is decided about, too.
  void ask(IdT cell) {
    if (!has(cell, kHeld) || has(cell, kNext | kAsked)) return;
    flags[cell] |= kAsked;
    asked.push_back(cell);
  }

  Marks<IdT> flags;
  Scratch<IdT, LeafSetId> origin;  // of held ones
  std::vector<IdT> listed;         // all of held, and some that were removed
  std::vector<IdT> asked;          // of held and not of next, in this step
};

/// Sorts a list that was put together from a few ascending ones.
template <class T>
void merge_runs(std::vector<T>& list) {
  std::vector<std::ptrdiff_t> starts{0};
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (list[i] < list[i - 1]) starts.push_back(static_cast<std::ptrdiff_t>(i));
  }
  const auto at = [&](std::size_t run) { return run < starts.size() ? list.begin() + starts[run] : list.end(); };
  while (starts.size() > 1) {
    std::vector<std::ptrdiff_t> merged;
    for (std::size_t run = 0; run < starts.size(); run += 2) {
      std::inplace_merge(at(run), at(run + 1), at(run + 2));
      merged.push_back(starts[run]);
    }
    starts = std::move(merged);
  }
}

}  // namespace cnrg
