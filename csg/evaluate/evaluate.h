// The driver over the DAG of a tree: one refinement for all leaves, then one selection per node.
//
// Lifetimes. An Evaluation owns all that it holds and needs nothing else: the tree and the options may go. Inside
// of it everything speaks of one complex by ids: a value, a kept value or a simplified complex that is taken out
// of it is of use as long as `complex` lives, and so are `parameters`, which hold a reference. Moving an
// Evaluation moves neither complex nor values: references to them stay good. Ids of nodes are those of the tree.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/evaluate/simplified_value.h"
#include "csg/operators/group.h"
#include "csg/operators/tables.h"
#include "csg/result/join.h"
#include "csg/result/result.h"
#include "csg/tree/tree.h"
#include "kernel/base/progress.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

class LeafNumbers;
class NodeValue;
struct Certificate;
class SurfaceParameters;

/// What is refined in one (csg/evaluate/sections.h). What else it changes than costs: csg/README.md, Refined
/// apart.
enum class Refining : std::uint8_t {
  chosen,    ///< by boxes: nodes of which much dies are refined apart
  together,  ///< all leaves; also with `raw`, `keep_all` and `validate`, and where a leaf is unbounded
  apart,     ///< every Boolean node that may be
};

/// Of which nodes rows tell counts and volumes.
enum class Rows : std::uint8_t { none, kept, all };

/// Whether curved surfaces meet as their facets do (csg/certify/proof.h). Where that is not proven facets become
/// finer, within a budget of steps.
enum class AskedProof : std::uint8_t {
  none,
  within_budget,
  to_the_end,  ///< with twenty times the steps; results read back are asked about, too
};

struct EvaluateOptions {
  int threads = 0;        ///< 0: all cores
  bool validate = false;  ///< check the complex and the identities of every node (InvariantError)
  Rows rows = Rows::all;
  bool region_volumes = false;  ///< in rows: the volume of every region of every node
  bool raw = false;             ///< keep unsimplified cells
  Refining refining = Refining::chosen;
  bool keep_all = false;  ///< keep the values of all instances in `Evaluation::values`
  /// Draw all leaves below the roots as one drawing (csg/evaluate/drawings.h), so that all values are on one
  /// complex; also with `raw`, `keep_all` and `validate`. Otherwise each node is said of as it is alone.
  bool drawn_together = false;
  AskedProof proof = AskedProof::within_budget;
  NodeId result;                     ///< in the place of the tree's, if valid
  std::vector<NodeId> nodes;         ///< kept besides the result
  std::vector<RationalPoint> reach;  ///< points that will be asked for: planes and half-spaces are cut beyond them
  Watch watch;                       ///< told of the stages, and may stop them (throws Stopped)
};

/// One instance of a node, in numbers.
struct NodeRow {
  NodeId node;
  std::string name;  ///< of the node; `name#2` for its second instance
  std::string operator_name;
  std::array<std::size_t, 4> cells{};      ///< active cells by dimension, simplified
  std::array<std::size_t, 4> raw_cells{};  ///< active cells by dimension, as the refinement has them
  Removals removals;                       ///< cells that rows of the tables removed; uncounted with Rows::none
  std::size_t removed() const { return removals.total(); }
  bool is_group = true;
  std::size_t components = 0;  ///< how many components; not filled for a group
  std::size_t regions = 0;     ///< components that hold 3-cells; in a group its regions
  /// Exact volume in cubic units of all of them together; nothing when one is unbounded.
  std::optional<Rational> total;
  const std::optional<Rational>& volume() const { return total; }
  /// How far `total`, and each of `volumes`, may be from that between the true surfaces, computed when it is asked
  /// for; nothing if of some of them only the facets are known.
  std::function<std::optional<double>()> volume_bound = [] { return 0.0; };
  /// Of each, ascending by component; filled with `EvaluateOptions::region_volumes`.
  std::vector<std::optional<Rational>> volumes;
  std::vector<std::pair<Component, std::string>> named;  ///< parallel to `volumes`: the component and its name
  double seconds = 0;                                    ///< of the operator alone
  double totals_seconds = 0;                             ///< of counts and volumes
};

/// A `simplify` that joins: its operand was evaluated by itself, and what came of it is refined as a leaf is.
struct JoinedNode {
  NodeId node;
  JoinReport report;
  std::vector<NodeRow> rows;  ///< of the nodes below it, as `Evaluation::rows`
};

/// The value of a node that was asked for; of use with the complex of its evaluation alone.
struct KeptValue {
  NodeId node;
  InstanceId instance;
  std::shared_ptr<const NodeValue> value;
  SimplifiedValue simplified;   ///< with mode raw when the options say so
  std::vector<LeafId> leaves;   ///< the leaves below it, ascending, those below joined ones included
  std::string name{};           ///< of the node
  std::vector<double> sizes{};  ///< of `leaves`, as LeafNumbers::sizes has them
  std::function<std::optional<double>()> volume_bound{};  ///< as of its row
  /// The value as a group; InvariantError when it is components.
  const Group& group() const;
};

struct Evaluation {
  std::shared_ptr<const Complex> complex;
  RefineReport refine;
  std::vector<NodeRow> rows;       ///< operands before users; after them those of nodes below `others` alone
  std::vector<JoinedNode> joined;  ///< below the roots, those below others first
  std::vector<KeptValue> kept;     ///< the result, then `EvaluateOptions::nodes` in their order; each once
  std::shared_ptr<const LeafNumbers> leaves;            ///< which leaf of which node has which number
  std::shared_ptr<const Certificate> certificate;       ///< of EvaluateOptions::proof; null: nothing was asked
  std::vector<std::string> leaf_names;                  ///< by LeafId; empty for the frame
  std::vector<Diagnostic> diagnostics;                  ///< notices of leaves, conflicts of materials
  double refine_seconds = 0;                            ///< soup and complex
  std::shared_ptr<const SurfaceParameters> parameters;  ///< of the leaves' patches and curves, found on demand
  IdVector<InstanceId, Instance> instances;             ///< below the roots, operands before users; as `rows`
  /// With `keep_all`: the value of each, those in `kept` included; otherwise empty, and each value has been freed
  /// after its last user.
  IdVector<InstanceId, std::shared_ptr<const NodeValue>> values;
  std::vector<ResultNames::Material> materials;  ///< of the tree
  bool raw = false;                              ///< EvaluateOptions::raw
  /// Of the nodes asked for besides the result, where one is drawn otherwise when it stands alone: each on a
  /// complex of its own, and `kept` has the result alone.
  std::vector<Evaluation> others;
  /// `rows`, and before them those of nodes below joined ones, of which there are none in `rows`; each once.
  std::vector<const NodeRow*> all_rows() const;
  /// The value of a node in `kept`.
  const KeptValue& value(NodeId node) const;
  /// The result of the tree, or a node that was asked for, as a value that needs the evaluation no more: to be
  /// looked at, written (csg/formats/result_file.h), snapped. InputError for the name of a node that was not kept.
  Result result() const;
  Result result(NodeId node) const;
  Result result(const std::string& name) const;
};

/// Evaluates the result of the tree and the nodes asked for, each placed by its own transform.
/// Throws TreeError for faults with a place in the tree or in a file it names, FileError for files that cannot
/// be read, InvariantError for bugs.
Evaluation evaluate(const Tree& tree, const EvaluateOptions& options = {});

/// Everything that can be checked without evaluating: leaves (used or not), files, number of instances.
/// Returns notices; throws as `evaluate` does.
std::vector<Diagnostic> check(const Tree& tree);

}  // namespace cnrg
