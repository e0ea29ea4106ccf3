// The attributes of a cell at the nodes of its life, and their origin: the node that gave a name, a material or
// an attribute, the operand that handed it on, and the attributes that gave way to it.
#pragma once

#include <map>
#include <memory>

#include "csg/evaluate/evaluate.h"
#include "csg/explain/explain.h"
#include "csg/operators/cell_sources.h"

namespace cnrg {

class SaidAt {
 public:
  /// Keeps the reference; so it does with values that are asked.
  explicit SaidAt(const Complex& complex) : complex_(complex) {}

  /// What is said of a cell in a value, of which `state` is what the value makes: of a 3-cell, and of a cell
  /// inside of a region, what is said of the region; of others what they say for themselves, of components also
  /// what is said of theirs. nullptr: nothing.
  const Attributes* of(const NodeValue& value, const Location& cell, const CellState& state);

  /// Of an entity: what is said of the sheet or wire that it lies in or bounds, if it does not speak for itself.
  const Attributes* around(const NodeValue& value, const Location& cell);

  /// What changes at a node: `said` there, and what its operands say, by their names (nullptr: nothing). Empty
  /// where a node only hands on. `by_itself`: it is said of the cell, not of the component that it is in.
  static std::vector<Word> changes(const Node& node, const Attributes* said,
                                   const std::vector<std::pair<std::string, const Attributes*>>& operands,
                                   bool by_itself);

 private:
  const ValueSources& sources(const NodeValue& value);
  const Complex& complex_;
  std::map<const NodeValue*, std::unique_ptr<const ValueSources>> sources_;
};

}  // namespace cnrg
