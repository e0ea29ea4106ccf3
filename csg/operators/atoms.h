// Sets of components overlaid one after the other: the cells that lie in the same components are an *atom*.
//
// Every cell knows its atom, so that taking in one more operand costs its own cells. Atoms are numbered in the
// order that sum(sum(x, y), z) gives its components: those of the operands so far, then by (atom, component) what
// they share with the new one, then what is of the new one alone.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "csg/operators/cnrg.h"
#include "csg/operators/component_attributes.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

class Atoms {
 public:
  explicit Atoms(const Complex& complex) : cells_(complex) {}
  /// True if some cell of `x` is in an atom.
  bool meet(const Components& x) const;
  /// Takes in the next operand. Attributes of what it shares with atoms as `sum` has them.
  void add(const Components& x, std::optional<Dominance> dominance);
  /// The atoms that have cells as components, and all conflicts.
  ComponentsResult result();

 private:
  // The cells of one dimension: lists in the order in which cells came.
  template <class IdT>
  struct Cells {
    explicit Cells(std::size_t count) : place(count) {}
    Scratch<IdT, std::uint32_t> place;  // 1 + index in the lists
    std::vector<IdT> ids;
    std::vector<std::uint32_t> atoms;
    std::vector<LeafSetId> origins;
  };
  struct Atom {
    ComponentAttributes attributes;
    std::array<std::size_t, 4> cells{};  // by dimension
    int dimension() const;
  };
  using Key = std::pair<std::uint32_t, Component>;  // an atom, or kNoAtom; a component of the new operand

  // What an atom may be reported for, if it has cells of the `least` dimension.
  struct Conflict {
    std::vector<Yielded> yielded;  // empty: nothing
    CellSet cells;
    int least = 0;
    Dominance decides = Dominance::equal;
  };

  std::vector<Conflict> add_atoms(const Components& x, const std::vector<Key>& keys,
                                  std::optional<Dominance> dominance);

  OfCells<Cells> cells_;
  std::vector<Atom> atoms_;
  LeafUnions sets_;
  Features features_;  // of all operands, in no order
  AtOdds at_odds_;
  std::vector<AttributeConflict> conflicts_;
};

}  // namespace cnrg
