// Random tree files with every operator: what the CNRG algebra is proved on.
//
// Nodes are listed operands before users; the last one is the result. A node may have any number of users, and a
// value that a group Boolean could not take gets a `closure` (csg/SEMANTICS.md#from-one-family-to-the-other).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csg/materials/attributes.h"
#include "csg/tree/tree.h"
#include "tests/scenes/scene.h"

namespace cnrg::properties {

struct DagNode {
  Operator op = Operator::leaf;
  std::size_t leaf = 0;                       ///< of a leaf
  std::vector<std::size_t> operands;          ///< smaller numbers
  std::optional<DominantOperand> dominant;    ///< of a group Boolean, sum or product
  bool each = false;                          ///< of a topological operator
  bool regularize = false;                    ///< the attribute
  bool points = false;                        ///< mode `points` of `simplify`
  std::optional<Rational> within;             ///< of `simplify`
  std::optional<int> number;                  ///< `dominance` as a number; not with `dominant`
  Attributes said;                            ///< name, material and attributes
  std::map<std::uint32_t, Attributes> parts;  ///< of a leaf: name and material of regions, by number
};

struct RandomDag {
  std::vector<scenes::Leaf> leaves;
  std::vector<DagNode> nodes;
};

/// As the tree file has it, followed by ` each`, ` points` or ` within` where the node says so.
std::string operator_name(const DagNode& node);
/// `a0` and so on for leaves, `n3` and so on for inner nodes; numbers are those of the nodes.
std::string name_of(const RandomDag& dag, std::size_t node);
/// The tree file: what the failures of a test are reported as.
std::string tree_file(const RandomDag& dag);
/// The longest way from a leaf to each node.
std::vector<int> depths(const RandomDag& dag);

/// What a group Boolean makes of a value, as far as the operators alone tell.
enum class Standing : std::uint8_t {
  group,       ///< a group
  complement,  ///< the complement of a group: stands for the group of its closure
  closed,      ///< closed components
  open,        ///< components that may lack boundary
};
std::vector<Standing> standings(const RandomDag& dag);
/// No group Boolean has an operand of standing `open`.
bool well_formed(const RandomDag& dag);

/// Two to four leaves of all dimensions, up to two more whose parts are corners, edges and facets of the others,
/// three to about a dozen inner nodes of which the result reaches most, depth at most 8. Aggregates are made of
/// operands that are disjoint.
RandomDag random_dag(std::uint64_t seed, scenes::Position position);
/// The same over given leaves, which come first; those that the result does not reach are dropped.
RandomDag random_dag(std::uint64_t seed, std::vector<scenes::Leaf> leaves);
/// Group Booleans of two operands with any dominance, each leaf once.
RandomDag boolean_tree(scenes::Random& random, std::vector<scenes::Leaf> leaves);
/// The position of a seed: half of them degenerate, a quarter tilted, a quarter general.
scenes::Position position_of(std::uint64_t seed);

/// What no path from the result reaches is dropped.
RandomDag compact(RandomDag dag);
/// Dags with less in them: the result is an inner node, a node gives way to one of its operands, an operand, an
/// attribute, a shared use or a part of a leaf goes. Each is well formed.
std::vector<RandomDag> smaller(const RandomDag& dag);

inline bool is_group_boolean(Operator op) {
  return op == Operator::unite || op == Operator::intersect || op == Operator::subtract;
}

/// How a failure begins that is a refused tree file.
inline constexpr const char* kRefused = "refused: ";

}  // namespace cnrg::properties
