// Queries on a tree: its nodes by name, its materials, its unused nodes.
#include "csg/tree/tree.h"

#include <algorithm>

#include "csg/tree/dag.h"
#include "csg/tree/suggest.h"

namespace cnrg {

NodeId Tree::find(const std::string& name) const {
  const auto it = names.find(name);
  if (it != names.end()) return it->second;
  for (const NodeId id : IdRange<NodeId>(nodes.size())) {
    if (nodes[id].is_inline && nodes[id].name == name) return id;
  }
  std::vector<std::string_view> known;
  for (const auto& [key, id] : names) known.push_back(key);
  std::string hint = did_you_mean(name, known);
  const std::string whole = name.substr(0, name.rfind('#'));
  if (whole != name && names.count(whole) != 0)
    hint = "; rows call `" + whole + "` so at one of its places: name `" + whole +
           "`, or give that place a node of its own, {simplify: " + whole + ", translate: [1, 0, 0]}";
  if (hint.empty()) {
    constexpr std::size_t kListed = 10;
    for (std::size_t i = 0; i < std::min(known.size(), kListed); ++i)
      hint += (i == 0 ? "; it has `" : ", `") + std::string(known[i]) + "`";
    if (known.size() > kListed) hint += " and " + std::to_string(known.size() - kListed) + " more";
  }
  throw InputError(file + " has no node called `" + name + "`" + hint);
}

std::vector<NodeId> Tree::operands(NodeId node) const { return dag->operands(node); }

std::vector<NodeId> Tree::operands_within(NodeId node) const {
  return nodes[node].within ? std::vector<NodeId>() : operands(node);
}

const Material* Tree::material(const std::string& name) const {
  const auto it =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return it == materials.end() ? nullptr : &*it;
}

std::vector<const Material*> Tree::graded_in(const std::string& name) const {
  std::map<std::string_view, const Material*> known;
  for (const Material& m : materials) {
    if (m.grade) known.emplace(m.name, &m);
  }
  std::vector<const Material*> out;
  const auto take = [&](std::string_view of) {
    const auto it = known.find(of);
    if (it == known.end()) return;
    out.push_back(it->second);
    known.erase(it);
  };
  take(name);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (const Grade::Stop& stop : out[i]->grade->stops) {
      for (const auto& part : stop.mixture) take(part.first);
    }
  }
  return out;
}

std::vector<std::string> materials_of(const Node& node) {
  std::vector<std::string> out;
  if (!node.material.empty()) out.push_back(node.material);
  if (const auto* group = node.shape ? std::get_if<GroupShape>(&*node.shape) : nullptr) {
    for (const auto& [number, region] : group->regions) {
      if (!region.material.empty()) out.push_back(region.material);
    }
  }
  return out;
}

std::vector<Diagnostic> reading_warnings(const Tree& tree, const std::vector<NodeId>& roots) {
  std::vector<Diagnostic> result = tree.warnings;
  std::vector<NodeId> all = roots;
  std::vector<char> used;
  for (std::size_t before = 0; before != all.size();) {
    before = all.size();
    used = tree.dag->reachable(all);
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      if (!used[id.index()]) continue;
      for (const std::string& name : materials_of(tree.nodes[id])) {
        for (const Material* material : tree.graded_in(name)) {
          const auto* distance = std::get_if<DistanceGrade>(&material->grade->along);
          if (distance && !used[tree.find(distance->to).index()]) all.push_back(tree.find(distance->to));
        }
      }
    }
  }
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    const Node& node = tree.nodes[id];
    if (used[id.index()] || node.is_inline) continue;
    result.push_back({tree.file, node.at, Diagnostic::Level::warning,
                      "the node `" + node.name + "` is not used by the result; use it or remove it"});
  }
  return result;
}

}  // namespace cnrg
