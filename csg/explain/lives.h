// The facts of `explain`: what each node below a root made of given cells of the complex.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/operate.h"
#include "csg/explain/explain.h"
#include "csg/operators/cell_sources.h"
#include "csg/operators/components.h"

namespace cnrg {

// The attributes of a cell at the nodes of its life, and their origin: the node that gave a name, a material or
// an attribute, the operand that handed it on, and the attributes that gave way to it.

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

/// A cell of the complex; of a face also the side to which the normal of its explanation points.
struct CellSide {
  Location cell;
  unsigned side = 0;
};

/// What a value makes of a cell.
CellState state_in(const Complex& complex, const Group& group, const Location& cell);
CellState state_in(const Complex& complex, const NodeValue& value, const Location& cell);

/// The leaves that a cell of a value came from; empty when it is inactive. Who asks often gives the components of
/// the value instead.
std::vector<LeafId> origins_in(const Complex& complex, const NodeValue& value, const Location& cell);
std::vector<LeafId> origins_in(const Components& components, const Location& cell);
/// As `leaf_cells` has it, by location.
std::vector<LeafCell> leaf_cells_at(const Complex& complex, const Location& cell,
                                    const std::vector<LeafId>& leaves);

class Lives {
 public:
  /// `evaluation` must have kept all values and that of `node`. It and the tree must outlive this.
  Lives(const Tree& tree, const Evaluation& evaluation, NodeId node);

  /// The lives of the pieces, in their order. `named`: fill what StarFacts fills for lives that are shown.
  std::vector<Life> of(const std::vector<CellSide>& pieces, bool named);

  /// Which pieces of one cell live alike: a class for each piece, numbered from 0 in the order of their first
  /// pieces. `cells`: of which cell each piece is, ascending from 0 without gaps. No life is held for longer than
  /// its node.
  std::vector<std::uint32_t> classes(const std::vector<CellSide>& pieces, std::vector<std::uint32_t> cells);

 private:
  void add_steps(InstanceId id, const std::vector<CellSide>& pieces, bool named, std::vector<LifeStep>& steps);
  void add_booleans(const Node& node, InstanceId id, const std::vector<CellSide>& pieces,
                    std::vector<LifeStep>& steps);
  void add_topology(Topological op, bool each, const NodeValue& x, const std::vector<CellSide>& pieces, bool named,
                    std::vector<LifeStep>& steps);
  void add_attribute(const Node& node, InstanceId id, const std::vector<CellSide>& pieces, bool named,
                     std::vector<LifeStep>& steps);
  StarFacts star_of(const Components& x, Component only, const CellSet& star, const Location& cell,
                    const NodeValue& value, bool named);
  const SimplifiedComplex& simplified(const NodeValue& value);
  const std::string& name_of(InstanceId id) const { return evaluation_.rows[id.index()].name; }
  void add_words(InstanceId id, const std::vector<CellSide>& pieces, std::vector<LifeStep>& steps);
  std::vector<Operand> operands_of(InstanceId id) const;

  const Tree& tree_;
  const Evaluation& evaluation_;
  const Complex& complex_;
  std::vector<InstanceId> below_;         ///< the root and all below it, operands before users
  IdVector<InstanceId, LeafId> leaf_of_;  ///< none() for inner nodes
  SaidAt said_;
  std::map<const NodeValue*, SimplifiedComplex> simplified_;
  std::vector<std::unique_ptr<NodeValue>> made_;  ///< values before the attribute `regularize`
};

}  // namespace cnrg
