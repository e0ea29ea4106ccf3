// Leaves are prepared node by node, whatever the number of their instances. Errors carry their place, to which the
// tree has a name and a position.
#include "csg/evaluate/prepared_leaves.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/leaf_stop.h"

namespace cnrg {
namespace {

/// Where the tree file has a face of a leaf: the face of a group, else the leaf itself.
Position position_of(const Node& node, std::size_t face) {
  const auto* group = node.shape ? std::get_if<GroupShape>(&*node.shape) : nullptr;
  if (!group || face >= group->faces.size() || group->faces[face].line == 0) return node.operator_at;
  return {group->faces[face].line, group->faces[face].column};
}

/// Where the tree file has the value of a key of a leaf.
Position position_of(const Node& node, const std::string& key) {
  for (const std::string& known : {key, std::string()}) {
    const auto it = node.values.find(known);
    if (it != node.values.end()) return it->second;
  }
  return node.operator_at;
}

/// A leaf, faces or solids of one, in words for people.
struct Mention {
  Position at;  ///< of the first face
  std::string words;
};
Mention mention_of(const Node& node, const std::vector<Attributes>& regions, const LeafPlace& place) {
  std::string words;
  for (const std::uint32_t solid : place.solids) {
    words += (words.empty() ? "solid " : ", solid ") + std::to_string(solid);
    if (solid > 0 && solid <= regions.size() && !regions[solid - 1].name.empty())
      words += " `" + regions[solid - 1].name.text() + "`";
  }
  if (!words.empty()) words += " of ";
  if (place.faces.empty()) {
    return {node.operator_at, words + "`" + node.name + "` (line " + std::to_string(node.operator_at.line) + ")"};
  }
  const char* before = "face ";
  for (const std::uint32_t face : place.faces) {
    const int line = position_of(node, face).line;
    words += before + std::to_string(face) + " (line " + std::to_string(line) + ")";
    before = ", face ";
  }
  return {position_of(node, place.faces.front()), words + " of `" + node.name + "`"};
}

}  // namespace

const std::string* file_of(const Shape& shape) {
  return std::visit(
      [](const auto& leaf) -> const std::string* {
        if constexpr (requires { leaf.file; }) return leaf.file.empty() ? nullptr : &leaf.file;
        else return nullptr;
      },
      shape);
}

PreparedLeaves::PreparedLeaves(const Tree& tree, const Unfolding& unfolding, const JoinedLeaves& joined)
    : tree_(&tree), prepared_(tree.nodes.size()), numbers_(unfolding.instances, joined) {
  for (const auto& [node, leaf] : joined) prepared_[node] = leaf.leaf;
  std::vector<NodeId> nodes;
  std::vector<char> listed(tree.nodes.size(), 0);
  for (const InstanceId i : IdRange<InstanceId>(unfolding.instances.size())) {
    const NodeId node = unfolding.instances[i].node;
    if (leaf_of(i).valid() && !std::exchange(listed[node.index()], 1)) nodes.push_back(node);
  }
  prepare_nodes(nodes);
  for (const InstanceId i : IdRange<InstanceId>(unfolding.instances.size())) {
    const LeafId leaf = leaf_of(i);
    if (!leaf.valid()) continue;
    const Instance& instance = unfolding.instances[i];
    instances_.resize(leaf.index(), {no_geometry(), {}});
    instances_.push_back({prepared_[instance.node], instance.transform, {}});
    // What is welded depends on where leaves stand.
    if (prepared_[instance.node]->form() != nullptr && !tree.weld)
      instances_.back().above = transform_above(tree, instance);
  }
  instances_.resize(numbers_.count(), {no_geometry(), {}});
}

PreparedLeaves::PreparedLeaves(const Tree& tree) : tree_(&tree), prepared_(tree.nodes.size()) {
  std::vector<NodeId> nodes;
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    if (tree.nodes[id].op == Operator::leaf) nodes.push_back(id);
  }
  prepare_nodes(nodes);
}

// Files of meshes are read at the same time.
void PreparedLeaves::prepare_nodes(const std::vector<NodeId>& nodes) {
  std::vector<std::exception_ptr> errors(nodes.size());
  const std::stop_token stop = LeafStop::token();
  tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
    const LeafStop of_this_thread(stop);
    const Node& node = tree_->nodes[nodes[i]];
    if (!node.shape || !std::holds_alternative<MeshShape>(*node.shape)) return;
    try {
      prepare_node(nodes[i]);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  Faults faults;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    faults.attempt([&] {
      if (errors[i]) std::rethrow_exception(errors[i]);
      if (!prepared_[nodes[i]]) prepare_node(nodes[i]);
    });
  }
  faults.raise();
}

void PreparedLeaves::prepare_node(NodeId id) {
  const Node& node = tree_->nodes[id];
  try {
    prepared_[id] = prepare(*node.shape);
  } catch (const LeafFileError& e) {
    throw TreeError(
        e.file(), {std::max(e.line(), 1), std::max(e.column(), 1)},
        e.fault() + " (read for the node `" + node.name + "`, " + to_string(tree_->file, node.operator_at) + ")");
  } catch (const LeafFaceError& e) {
    throw TreeError(tree_->file, position_of(node, e.face()), e.what());
  } catch (const LeafKeyError& e) {
    throw TreeError(tree_->file, position_of(node, e.key()), e.what());
  } catch (const InputError& e) {
    throw TreeError(tree_->file, node.operator_at, e.what());
  } catch (const FileError& e) {
    throw TreeFileError({{tree_->file, position_of(node, "file"), e.what()}});
  }
}

std::vector<Attributes> PreparedLeaves::attributes(LeafId leaf, std::uint32_t count, const Instance& instance,
                                                   Grades& grades) const {
  const Node& node = node_of(leaf);
  const std::vector<Attributes> own = instances_[leaf.index()].leaf->regions();
  const bool joined = node.within.has_value();
  const bool named = !node.label.empty() && !joined;
  NamePart name{named ? node.label : node.regions_called(), 0, named ? NameOrigin::given : NameOrigin::node};
  std::vector<Attributes> result(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i < own.size()) {
      result[i].name = own[i].name;
      result[i].properties = own[i].properties;
      // Materials of a group are names of the tree; those of a result read back are its own.
      const bool of_tree = node.shape && std::holds_alternative<GroupShape>(*node.shape);
      result[i].material =
          of_tree ? grades.on(instance, own[i].material.name()) : grades.moved(instance, own[i].material);
    }
    if (count > 1) name.ordinal = i + 1;
    if (result[i].name.empty()) result[i].name = Name(std::vector{name});
    if (joined) continue;
    if (result[i].material.empty()) result[i].material = grades.on(instance, node.material);
    result[i].properties.insert(node.properties.begin(), node.properties.end());
  }
  return result;
}

void PreparedLeaves::locate_errors(const std::function<void()>& work) const {
  try {
    work();
  } catch (const TreeError&) {
    throw;
  } catch (const LeafError& e) {
    Position first = tree_->nodes_at;
    const std::string message = in_words(e.words(), &first);
    throw TreeError(tree_->file, first, message);
  } catch (const InputError& e) {
    throw TreeError(tree_->file, tree_->nodes_at, e.what());
  }
}

std::string PreparedLeaves::in_words(const LeafWords& message, Position* first) const {
  const auto mention = [&](const LeafPlace& place) {
    return mention_of(node_of(LeafId(place.leaf)), instances_[place.leaf].leaf->regions(), place);
  };
  const auto is_here = [&](const LeafPlace& place) { return place.leaf < numbers_.count(); };  // not the frame
  const std::vector<LeafPlace> places = message.places();
  const auto known = std::find_if(places.begin(), places.end(), is_here);
  if (first != nullptr && known != places.end()) *first = mention(*known).at;
  return message.text(
      [&](const LeafPlace& place) { return is_here(place) ? mention(place).words : place.text(); });
}

std::vector<Diagnostic> PreparedLeaves::located_notices(const std::vector<LeafWords>& messages) const {
  std::vector<Diagnostic> result;
  for (const LeafWords& message : messages) {
    Position at;
    const std::string words = in_words(message, &at);
    result.push_back({tree_->file, at, Diagnostic::Level::notice, words});
  }
  return result;
}

std::vector<Diagnostic> PreparedLeaves::near_notices(const std::vector<NearSurfaces>& near) const {
  constexpr std::size_t kMost = 10;
  std::vector<Diagnostic> result;
  for (std::size_t i = 0; i < near.size() && i < kMost; ++i) {
    const Node &first = node_of(LeafId(near[i].first)), &second = node_of(LeafId(near[i].second));
    std::string text = "`" + first.name + "` and `" + second.name + "` lie on " + near[i].what + " that are " +
                       to_decimal(from_double(near[i].apart), 3) +
                       " apart, so they are two surfaces: give both the same numbers, or `weld` to the tree";
    if (i + 1 == kMost && near.size() > kMost) text += " (" + std::to_string(near.size()) + " such pairs in all)";
    result.push_back({tree_->file, first.operator_at, Diagnostic::Level::notice, std::move(text)});
  }
  return result;
}

std::vector<Diagnostic> PreparedLeaves::notices() const {
  std::vector<Diagnostic> result;
  for (const NodeId id : IdRange<NodeId>(prepared_.size())) {
    if (!prepared_[id]) continue;
    for (const std::string& notice : prepared_[id]->notices()) {
      result.push_back({tree_->file, tree_->nodes[id].operator_at, Diagnostic::Level::notice,
                        "`" + tree_->nodes[id].name + "`: " + notice});
    }
  }
  return result;
}

}  // namespace cnrg
