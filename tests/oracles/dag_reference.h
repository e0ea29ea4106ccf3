// The CNRG operators by their definition, cell by cell: what the sparse operators are checked against.
//
// Cells of all dimensions have one number; the only thing known of the complex is which cell is in whose closure.
// Sets are arrays over all cells, components are what the table of csg/SEMANTICS.md#components says of each cell
// by itself.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "csg/operators/node_value.h"
#include "kernel/complex/complex.h"
#include "tests/oracles/dag.h"

namespace cnrg::properties {

class CellIncidence {
 public:
  explicit CellIncidence(const Complex& complex);
  /// Of any cells: the cells in the boundary of each.
  explicit CellIncidence(std::vector<std::vector<std::size_t>> closure) : closure_(std::move(closure)) {}
  std::size_t size() const { return closure_.size(); }
  using Labels = std::vector<std::uint32_t>;  ///< the component of each cell; 0: inactive
  Labels labels(const Selection& selection) const;
  using Set = std::vector<char>;
  static Set support(const Labels& labels);
  Set interior(const Set& set) const;
  Set closure(const Set& set) const;
  std::size_t number(const Location& at) const;
  /// Number, dimension and kind of a cell in words.
  std::string name(std::size_t cell) const;

 private:
  std::vector<std::size_t> vertex_number_;
  std::size_t edges_ = 0, faces_ = 0, regions_ = 0;  ///< number of the first
  std::vector<std::vector<std::size_t>> closure_;    ///< the cell itself not listed
};

/// The components that an operator on components makes, by its definition; `x` are those of the operands.
CellIncidence::Labels operator_by_definition(const CellIncidence& cells, const DagNode& node,
                                             const std::vector<CellIncidence::Labels>& x);
/// cl int |X|: what the attribute `regularize` makes of components.
CellIncidence::Labels regularized_by_definition(const CellIncidence& cells, const CellIncidence::Labels& x);

/// What is wrong with the value of an inner node that is no group Boolean, given those of its operands: a cell
/// and its component by definition and by the operator. Empty when nothing is. Group Booleans are the tables'
/// matter.
std::string compare_by_definition(const Complex& complex, const CellIncidence& cells, const DagNode& node,
                                  const std::vector<const NodeValue*>& operands, const NodeValue& value);

}  // namespace cnrg::properties
