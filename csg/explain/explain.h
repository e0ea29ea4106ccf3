// Why a cell is where it is: its life through the DAG, node by node, as plain data and as text.
//
// People name cells of a simplified value; decisions were made on the cells of the refinement. A simplified cell
// unites several of them (*pieces*), which may have different lives: pieces of one life are told together.
//
// Nothing is remembered during evaluation: with the values of all nodes kept, the steps of each Boolean are run
// again, and each piece is asked about while its two operands are there.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/operate.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/origins.h"
#include "csg/operators/verdict.h"

namespace cnrg {

/// What a value makes of a cell.
struct CellState {
  Component component = 0;  ///< 0: inactive
  std::string name;         ///< of the component; may be empty
  bool group = true;        ///< the value is a group: the component is a region, or the entities
  bool entity = false;      ///< a face, edge or vertex of the group
  friend bool operator==(const CellState&, const CellState&) = default;
};

/// A cell as a group Boolean sees it in one of its operands (pereira2012 3).
struct OperandFacts {
  std::string name;                ///< of the operand; `step 1` for the result of a step before
  bool closed_complement = false;  ///< the group that a complement stands for
  CellState state;
  /// Of a face: the regions on the side that the normal points to and on the other one.
  std::array<CellState, 2> sides;
  int regions = 0;  ///< of a face: numReg
  std::size_t bounds =
      0;  ///< of an edge: faces of the operand that it bounds (numFace), of a vertex: edges (numEdge)
  std::size_t within = 0;         ///< of an edge or a vertex: faces of the operand in whose interior it lies
  bool free = false;              ///< of an edge or a vertex that is an entity
  std::size_t walls = 0;          ///< of an edge or a vertex: how many faces with numReg > 0 it bounds
  std::vector<CellState> around;  ///< of an edge or a vertex: the regions around it, ascending; outside is one
  friend bool operator==(const OperandFacts&, const OperandFacts&) = default;
};

/// One step of a Boolean, A op B as the tables have it.
struct BooleanFacts {
  BooleanOp op = BooleanOp::unite;
  bool dominant = false;  ///< A > B; otherwise A = B. The difference does not ask.
  StepRule rule = StepRule::operands;
  std::string level_a, level_b;  ///< where materials decide: the dominance of each there; empty where one is not
  /// Of the cell to which A and B cut each other (csg/operators/pair_refinement.h): facts and verdict are about
  /// it. Where other leaves have cut it into pieces it has more dimensions than the vertices and edges between
  /// these.
  int dimension = 3;
  std::optional<std::array<Integer, 3>> normal;  ///< of such a face, for an edge or a vertex inside
  OperandFacts a, b;
  Verdict verdict;
  std::size_t kept_around = 0;  ///< kept faces (edges) that the edge (vertex) bounds; 0 in a kept face's interior
  CellState result;
  friend bool operator==(const BooleanFacts&, const BooleanFacts&) = default;
};

/// The star of a cell (itself included) against the set that a topological operator is applied to.
struct StarFacts {
  Component component = 0;  ///< with `each`: the component that is the set; otherwise 0, the set is |X|
  std::string name;         ///< of that component
  bool in_set = false;      ///< the cell itself
  bool whole = false;       ///< its whole star is in the set: interior
  bool touched = false;     ///< some cell of its star is: closure
  bool solid = false;       ///< some 3-cell of its star is: closure of the interior
  /// How many cells of the star, by dimension, are in the set and not, and some of them by their names in the
  /// simplified operand. Only filled for lives that are shown.
  std::array<std::size_t, 4> inside{}, outside{};
  std::vector<std::string> named_inside, named_outside;
  friend bool operator==(const StarFacts&, const StarFacts&) = default;
};

/// The attribute `regularize: true` on what the operator made of a cell.
struct Regularization {
  CellState before;
  std::optional<OperandFacts> group;  ///< when that is a group
  std::vector<StarFacts> stars;       ///< otherwise
  friend bool operator==(const Regularization&, const Regularization&) = default;
};

/// What is said of a cell at a node under one key, where the node does not only hand it on.
struct Word {
  std::string key;                ///< `name`, `material`, or that of an attribute
  std::string value;              ///< a text of an attribute is in quotes; empty: nothing is said any more
  bool given = false;             ///< the node says so itself
  std::vector<std::string> from;  ///< the operands that say so
  /// Operands that say something else, and what.
  std::vector<std::pair<std::string, std::string>> gave_way;
  friend bool operator==(const Word&, const Word&) = default;
};

/// A cell at one instance of a node.
struct LifeStep {
  NodeId node;
  std::string name;                                         ///< `name#2` for the second instance
  CellState state;                                          ///< in the value of the node
  std::vector<LeafCell> leaf_cells;                         ///< of a leaf: where in it the cell lies
  std::vector<std::pair<std::string, CellState>> operands;  ///< of all but leaves
  std::vector<BooleanFacts> booleans;                       ///< of a Boolean: each step of the fold
  std::vector<StarFacts> stars;                             ///< of a topological operator on components
  std::optional<OperandFacts> regularized;                  ///< of `regularize` of a group
  std::optional<Regularization> attribute;
  std::vector<Word> said;  ///< only filled for lives that are shown
  friend bool operator==(const LifeStep&, const LifeStep&) = default;
};
using Life = std::vector<LifeStep>;

/// Pieces of one and the same life, told by the first of them.
struct LifeClass {
  Life life;  ///< operands before users; the last step is the node asked about
  std::size_t pieces = 1;
  Location example;
  RationalPoint point;                           ///< exactly in the example and in no other cell
  std::optional<std::array<Integer, 3>> normal;  ///< of a face: n, shortest integer vector
  std::vector<LeafCell> origins;                 ///< in the leaves that the example came from
  Mixture mixture;                               ///< at the point, where the material is graded
  std::vector<PatchPoint> patches;               ///< of the point, on the leaves that the example came from
  std::vector<CurvePoint> curves;                ///< likewise; each patch and each curve is listed once
};

struct Explanation {
  NodeId node;
  std::string node_name;
  std::string cell;   ///< the simplified cell's name; `-` for an inactive region that touches nothing of the node
  int dimension = 0;  ///< of the simplified cell
  CellState state;    ///< in the node
  std::size_t pieces = 0;              ///< cells of its dimension in the refinement that it unites
  std::optional<RationalPoint> asked;  ///< the point, if one was asked about; the only piece is what holds it
  std::vector<LifeClass> classes;      ///< in the order of their first pieces
  std::size_t classes_left_out = 0, pieces_left_out = 0;
};

/// The life of a simplified cell (`f12`) of a node that was asked for. The evaluation must have kept all values.
/// Reports at most `most` classes. Throws InputError for an unknown name; the message tells which cells there are.
Explanation explain(const Tree& tree, const Evaluation& evaluation, NodeId node, const std::string& cell,
                    std::size_t most = 4);

/// What `explain` says of each of some cells of a node, in their order: each Boolean is run again once, not once
/// per cell. Each place is one of the node's simplified complex.
std::vector<Explanation> explain(const Tree& tree, const Evaluation& evaluation, NodeId node,
                                 const std::vector<SimplifiedComplex::Place>& cells, std::size_t most = 4);

/// The life of the cell of the refinement that holds a point, active in the node or not. Throws InputError beyond
/// the frame of unbounded leaves.
Explanation explain(const Tree& tree, const Evaluation& evaluation, NodeId node, const RationalPoint& point);

/// Likewise of each of some cells of the refinement, in their order, as of a point in it: each Boolean is run
/// again once.
std::vector<Explanation> explain(const Tree& tree, const Evaluation& evaluation, NodeId node,
                                 const std::vector<Location>& cells);

/// The explanation for people: one block per node, below it what decided.
std::string explanation_text(const Tree& tree, const Evaluation& evaluation, const Explanation& explanation);

}  // namespace cnrg
