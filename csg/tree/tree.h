// A tree file as data: nodes with their operators and attributes, the graph that they form, the result.
//
// Meaning of the attributes:
//   * Transforms are multiplied in the order in which they are written; they move everything below the node.
//   * `dominance: number` is the number of the node's value; without it a leaf has 0 and a Boolean the larger
//     one of its operands. `dominance: left|right|equal` is for a Boolean's own operands.
//   * `material`, `name` and `attributes` of a leaf are those of its regions that have none of their own, and of
//     its sheets, wires and points; on an inner node they replace what these had.
//   * `size` is how long edges of a mesh are to be on what comes from the leaves below the node (sizes.h).
//   * An operand that is written in place, not named, is an inline node; a YAML alias of it is the same node.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "csg/leaves/shapes.h"
#include "csg/materials/attributes.h"
#include "csg/materials/grade.h"
#include "csg/tree/position.h"

namespace cnrg {

class Dag;
struct Selector;

enum class Operator : std::uint8_t {
  leaf,
  // Group Booleans: `union`, `intersection`, `difference`.
  unite,
  intersect,
  subtract,
  // Operators of CNRG (csg/operators/cnrg.h).
  aggregate,
  unify,
  sum,
  product,
  cnrg_subtract,
  complement,
  interior,
  closure,
  boundary,
  regularize,
  // Of a surface and a solid: what of the solid is on one side (csg/operators/below.h).
  below,
  above,
  // Of values of both families.
  simplify,
  // What somebody picks out of one (csg/tree/selector.h).
  select,
};

/// Interior, closure, boundary and regularize: they may act on `each` component.
constexpr bool is_topological(Operator op) {
  return op == Operator::interior || op == Operator::closure || op == Operator::boundary ||
         op == Operator::regularize;
}

enum class DominantOperand : std::uint8_t { left, right, equal };

struct Node {
  std::string name;  ///< the key in `nodes`; of an inline node its place, such as `model/2`
  bool is_inline = false;
  std::string called{};  ///< after whom regions are called that nobody named, where it is not `name`
  const std::string& regions_called() const { return called.empty() ? name : called; }
  Position at;           ///< of the key, or of the inline node
  Position operator_at;  ///< of the operator's key
  Operator op = Operator::leaf;
  std::string operator_name;                 ///< as the file has it: `union`, `box`, ...
  std::optional<Shape> shape;                ///< of a leaf
  std::map<std::string, Position> values{};  ///< of a leaf: where the values of its keys stand; alone at ""
  std::optional<Transform> transform;
  std::string material;          ///< empty: not given
  std::string label;             ///< the attribute `name`; empty: not given
  Properties properties;         ///< the attribute `attributes`
  std::optional<Rational> size;  ///< of edges of a mesh, above 0, as a double, too
  std::optional<Rational> dominance;
  std::optional<DominantOperand> dominant;
  bool blend = false;            ///< of a union: what overlaps is a mixture (csg/operators/blend.h)
  bool regularize = false;       ///< the attribute: regularize the node's value
  bool forget_features = false;  ///< `simplify` with mode `points`
  /// Of `simplify`: what is nearer and does not touch is joined (csg/evaluate/joined_nodes.h); above 0. The node's
  /// value is computed apart and refined with others as that of a leaf.
  std::optional<Rational> within;
  bool is_layer = false;  ///< made by `layers`, so that nothing of it stands in the file
  bool each = false;      ///< interior, closure, boundary, regularize: every component by itself
  std::shared_ptr<const Selector> selector;  ///< of `select`
};

struct Material {
  std::string name, color{};            ///< color `#rrggbb`; empty: not given
  std::optional<Grade> grade{};         ///< of one that changes with position
  Position at{}, to_at{};               ///< of its key; of the node's name in `distance`
  std::optional<Rational> dominance{};  ///< who wins where numbers of nodes are equal; 0 without it
};

/// What a reader gives: a value, which refers to nothing and may be copied.
struct Tree {
  std::string file;  ///< as it was given
  IdVector<NodeId, Node> nodes;
  std::shared_ptr<const Dag> dag;       ///< who uses whom, over the same ids; no cycles
  std::map<std::string, NodeId> names;  ///< of the nodes that are not inline
  NodeId result;
  Position nodes_at;                             ///< of the key `nodes`, for what concerns all of them
  std::vector<Material> materials;               ///< in the order of the file
  std::map<std::string, Rational> parameters{};  ///< that expressions name (expression.h)
  std::optional<Rational> weld{};                ///< what is that near is made to coincide; above 0
  Position weld_at{};                            ///< of its value
  std::string yaml{};                            ///< of a `.csg` file: the tree file that it means
  std::vector<Diagnostic> warnings{};            ///< of the reader
  std::vector<std::string> inputs{};             ///< files of OpenSCAD, and those that they import

  /// The node of that name; inline nodes answer to their place, such as `model/2`. Throws InputError, without a
  /// place in the file, with the nearest name or some of all names when there is none.
  NodeId find(const std::string& name) const;
  /// The operands of a node in the order of the file; one that is used twice is there twice.
  std::vector<NodeId> operands(NodeId node) const;
  /// Those that are refined together with the node: none of a `simplify` that joins.
  std::vector<NodeId> operands_within(NodeId node) const;
  /// The material of that name, or nullptr.
  const Material* material(const std::string& name) const;
  /// The graded materials that a material is made of: itself, if it is graded, and those that stops name, at any
  /// depth, each once.
  std::vector<const Material*> graded_in(const std::string& name) const;
};

using InstanceId = Id<struct InstanceTag>;

/// A node under one accumulated transform: a node that two users place differently is two instances.
struct Instance {
  NodeId node;
  /// All transforms from a root down to the node, its own included. `simplify` without a material has
  /// none, since nobody asks, and a product of many transforms is long.
  std::shared_ptr<const Transform> transform;
  std::vector<InstanceId> operands;  ///< in the order of the node's operands
  std::uint32_t number = 1;          ///< from 1 among the instances of the node
};

/// The names of the materials that a node puts on regions by itself: its own, those of a group's regions.
std::vector<std::string> materials_of(const Node& node);

/// What the reader warned of, and a warning for each node of `nodes` that none of the roots uses, nor a distance
/// in a material of a used one.
std::vector<Diagnostic> reading_warnings(const Tree& tree, const std::vector<NodeId>& roots);

struct ReadOptions {
  /// A folder. If it is given, every file that the tree names must lie in it after links are resolved, or the leaf
  /// is an error (of `check` and `evaluate`): for trees that are not trusted.
  std::string inside{};
  /// Expressions (expression.h) in place of those of the file's `parameters`, by name.
  std::map<std::string, std::string> parameters{};
  /// Gets the names among them that the file has not, if it is given; else these are an error.
  std::set<std::string>* unknown = nullptr;
};

/// Reads a tree file (YAML 1.2 or JSON). Throws TreeError for the first fault, FileError when the file cannot be
/// read or the folder is not there. The geometry of leaves and the files that they name are not looked at: `check`
/// (csg/evaluate/evaluate.h) does that.
Tree read_tree(const std::string& path, const ReadOptions& options = {});

/// The same for a text; `file` is for messages, and paths in the text are relative to its folder.
Tree parse_tree(const std::string& text, const std::string& file, const ReadOptions& options = {});

/// Makes every curved leaf of the tree `times` as fine (1 or more): `segments` and `rings` are multiplied by it,
/// given or not, and `chord` is divided by its square, as the distance of a chord from its curve goes with the
/// square of its length. Points of the coarser shape stay points of the finer one where counts are given. Other
/// leaves are as they were: a grid, a mesh, a result that was read back. Throws TreeError at a leaf that would
/// have more segments or rings than it may.
void make_finer(Tree& tree, int times);

}  // namespace cnrg
