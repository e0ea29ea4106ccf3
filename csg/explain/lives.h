// The facts of `explain`: what each node below a root made of given cells of the complex.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "csg/evaluate/operate.h"
#include "csg/explain/explain.h"
#include "csg/explain/said_at.h"
#include "csg/operators/components.h"

namespace cnrg {

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
