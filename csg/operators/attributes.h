// Attributes of a region of a result from those of the operands (csg/SEMANTICS.md#attributes).
#pragma once

#include <span>
#include <vector>

#include "csg/operators/group.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/selection.h"

namespace cnrg {

/// Two things that are said of one region, component, face, wire or point of a result, where dominance does not
/// decide.
struct AttributeConflict {
  std::string key;          ///< of a property; empty: materials
  std::string kept, other;  ///< `kept` is the left operand's; two materials of one name are graded differently
  CellSet cells;            ///< where `other` gave way; not empty
};
AttributeConflict conflict(const Attributes& kept, const Yielded& other, CellSet cells);

/// The attributes of one region from those of the regions that share a 3-cell with it, the strongest first; there
/// is one at least. With `strict` what the first one leaves empty stays empty; otherwise the next one that has it
/// is taken, and `yielded` becomes what gave way, materials first, by name. It has no leaves: these are merged
/// over all, by `add_leaves`.
RegionAttributes combined(std::span<const RegionAttributes* const> sources, bool strict,
                          std::vector<Yielded>& yielded);

/// Collects the cells of which two equal operands say different things, in the order in which cells are seen.
class AtOdds {
 public:
  template <class IdT>
  void see(IdT cell, const SaidPointer& left, const SaidPointer& right) {
    if (left == right || left == nullptr || right == nullptr) return;
    if (Found* found = find(left, right, dimension_of(cell))) list_for(found->cells, cell).push_back(cell);
  }
  /// Moves what was collected to the end of a list.
  void take_to(std::vector<AttributeConflict>& conflicts);

 private:
  struct Found {
    SaidPointer left, right;
    int dimension;
    std::vector<Yielded> yielded;
    CellSet cells;
  };
  Found* find(const SaidPointer& left, const SaidPointer& right, int dimension);
  std::vector<Found> found_;
};

/// The union of two ascending lists, in place.
void add_leaves(std::vector<LeafId>& leaves, const std::vector<LeafId>& more);

}  // namespace cnrg
