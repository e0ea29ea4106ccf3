// Operators report conflicts of materials in cells of the complex; people know the cells of the simplified value,
// so these are named, and what would be said twice is said once.
#include "csg/evaluate/diagnostics.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "csg/leaves/geometry_leaf.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/node_value.h"
#include "csg/result/flat.h"
#include "csg/result/result_data.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

using Place = SimplifiedComplex::Place;

/// The simplified cells that hold the cells of a set, largest dimension first.
std::vector<Place> places_of(const SimplifiedComplex& simplified, const CellSet& cells) {
  std::vector<Place> places;
  const auto add = [&](const auto& list, const std::vector<Place>& map) {
    for (const auto cell : list) places.push_back(map[cell.index()]);
  };
  add(cells.regions, simplified.region_place);
  add(cells.faces, simplified.face_place);
  add(cells.edges, simplified.edge_place);
  add(cells.vertices, simplified.vertex_place);
  const auto key = [](const Place& p) { return std::pair(-p.dimension, p.index); };
  std::sort(places.begin(), places.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  return places;
}

/// The first eight by name.
std::string cell_names(const std::vector<Place>& places) {
  constexpr std::size_t kListed = 8;
  std::string text = places.size() == 1 ? "cell " : "cells ";
  for (std::size_t i = 0; i < std::min(places.size(), kListed); ++i) {
    text += (i == 0 ? "" : ", ") + cell_name(places[i].dimension, places[i].index);
  }
  return places.size() > kListed ? text + " and " + std::to_string(places.size() - kListed) + " more" : text;
}

/// The active cells among `cells`.
CellSet active_of(const Selection& selection, const CellSet& cells) {
  CellSet out;
  const auto pick = [](const auto& list, const auto& from, auto& to) {
    for (const auto id : from) {
      if (place_in(list, id) != list.size()) to.push_back(id);
    }
  };
  for_each_dimension(pick, selection, cells, out);
  return out;
}

/// Of a leaf without regions: its cells of the largest dimension that it has there.
struct NamedCells {
  int dimension = -1;
  bool has_own = false;
  std::set<std::string> others;  ///< names of other leaves on them
};

}  // namespace

std::vector<Diagnostic> lost_names(const Tree& tree, const Evaluation& evaluation, NodeId node) {
  for (const Evaluation& other : evaluation.others) {
    const auto is_here = [&](const KeptValue& kept) { return kept.node == node; };
    if (std::ranges::any_of(other.kept, is_here)) return lost_names(tree, other, node);
  }
  const auto label_of = [&](LeafId leaf) -> const std::string& {
    static const std::string kNone;
    const bool is_node = leaf.index() < evaluation.leaves->count();
    return is_node && evaluation.complex->leaf_regions[leaf] == 0
               ? tree.nodes[evaluation.leaves->node_of(leaf)].label
               : kNone;
  };
  const std::vector<LeafId>& leaves = evaluation.value(node).leaves;
  if (std::ranges::all_of(leaves, [&](LeafId leaf) { return label_of(leaf).empty(); })) return {};
  std::map<LeafId, NamedCells> named;
  const auto see = [&](int dimension, const FlatComplex::Provenance& origin) {
    for (const LeafId leaf : origin.leaves) {
      if (label_of(leaf).empty()) continue;
      NamedCells& cells = named[leaf];
      if (dimension > cells.dimension) cells = {dimension, false, {}};
      if (dimension < cells.dimension) continue;
      const std::string name = origin.said == nullptr ? "" : origin.said->name.text();
      const bool of_other = std::any_of(origin.leaves.begin(), origin.leaves.end(), [&](LeafId other) {
        return label_of(other) == name && label_of(other) != label_of(leaf);
      });
      if (of_other) cells.others.insert(name);
      else cells.has_own = true;
    }
  };
  const Result result = evaluation.result(node);
  const FlatComplex flat = flatten(result.data().view());
  for (const auto& face : flat.faces) see(2, face.origin);
  for (const auto& edge : flat.edges) see(1, edge.origin);
  for (const auto& vertex : flat.vertices) see(0, vertex.origin);
  std::vector<Diagnostic> out;
  for (const auto& [leaf, cells] : named) {
    if (cells.has_own || cells.others.empty()) continue;
    const Node& lost = tree.nodes[evaluation.leaves->node_of(leaf)];
    std::string others;
    for (const std::string& other : cells.others) others += (others.empty() ? "`" : ", `") + other + "`";
    out.push_back({tree.file, lost.operator_at, Diagnostic::Level::notice,
                   "`" + lost.name + "`: in `" + tree.nodes[node].name + "` nothing is called `" + lost.label +
                       "`, since all of it is part of " + others + "; to keep the name, let it dominate"});
  }
  return out;
}

std::vector<Diagnostic> dropped_faces(const Tree& tree, const PreparedLeaves& leaves, const Complex& complex,
                                      const RefineReport& report) {
  std::map<LeafId, std::size_t> dropped;
  for (const SourceId source : report.zero_area) ++dropped[complex.sources[source].leaf];
  std::vector<Diagnostic> out;
  for (const auto& [leaf, count] : dropped) {
    if (leaf.index() >= leaves.instances().size()) continue;  // the frame
    const Node& node = leaves.node_of(leaf);
    out.push_back({tree.file, node.operator_at, Diagnostic::Level::notice,
                   "`" + node.name + "`: faces without area were dropped: " + std::to_string(count)});
  }
  return out;
}

std::vector<Diagnostic> material_conflicts(const Tree& tree, const Node& node, const NodeValue& value,
                                           const std::vector<AttributeConflict>& conflicts, const Complex& complex,
                                           const SimplifiedValue& simplified, const Transform& moved) {
  std::vector<Diagnostic> out;
  if (conflicts.empty()) return out;
  SimplifiedComplex own;
  const std::optional<LeafAxes> axes = moved_axes(nullptr, moved);
  if (axes) put_in_order(complex, own = *simplified, &*axes);
  const SimplifiedComplex& shown = axes ? own : *simplified;
  const Selection selection = selection_of(complex, value);
  std::set<std::string> said;  // a fold may meet the same materials in the same cells more than once
  for (const AttributeConflict& conflict : conflicts) {
    // Cells that are not active any more went in a later step of a fold.
    const CellSet cells = active_of(selection, conflict.cells);
    if (cells.empty()) continue;
    const std::vector<Place> places = places_of(shown, cells);
    const Component component = component_of(shown, places.front());
    const bool is_region = !cells.regions.empty() || !value.is_group();
    const std::string what = conflict.key.empty() ? "the material" : "the attribute `" + conflict.key + ":";
    const std::string message = "`" + node.name + "`: " +
                                (is_region ? "the region `" + value.attributes(component).name.text() + "` keeps "
                                           : std::string(places.front().dimension == 2   ? "a sheet"
                                                         : places.front().dimension == 1 ? "a wire"
                                                                                         : "a point") +
                                                 " keeps ") +
                                what + (conflict.key.empty() ? " `" : " ") + conflict.kept + "` where `" +
                                conflict.other + (conflict.kept == conflict.other ? "` placed otherwise" : "`") +
                                " has equal dominance (" + cell_names(places) +
                                "); give one of the two a greater `dominance`";
    if (!said.insert(message).second) continue;
    out.push_back({tree.file, node.operator_at, Diagnostic::Level::warning, message});
  }
  return out;
}

std::vector<Diagnostic> empty_selection(const Tree& tree, NodeId node, const NodeValue& value) {
  const Node& picking = tree.nodes[node];
  if (picking.op != Operator::select || value.component_count() != 0) return {};
  const std::string& of = tree.nodes[tree.operands(node).front()].name;
  return {{tree.file, picking.operator_at, Diagnostic::Level::warning,
           "`" + picking.name + "` picks nothing of `" + of + "`; `cnrg eval --list --node " + of +
               "` lists what can be picked"}};
}

}  // namespace cnrg
