// Leaves are prepared node by node, whatever the number of their instances. Messages are translated by their form:
// who throws names a place as `leaf i, face j` or as `file:line:`, and a name and a position are put there.
#include "csg/evaluate/prepared_leaves.h"

#include <tbb/parallel_for.h>

#include <exception>
#include <optional>
#include <regex>
#include <string>
#include <utility>

#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/leaf_stop.h"

namespace cnrg {
namespace {

/// The decimal number in `text`, or nothing when it is too long to be an index.
std::optional<std::size_t> index_in(const std::string& text) {
  if (text.size() > 9) return std::nullopt;
  return static_cast<std::size_t>(std::stoull(text));
}

/// What the reader of `file` said, apart: `file:line:column: error: rest`, `file:line: error: rest` or
/// `file: rest`, where the fault has no line; of `file: byte N: error: rest` the byte is in the rest.
struct FileFault {
  Position at;
  std::string rest;
};
std::optional<FileFault> split(const std::string& message, const std::string& file) {
  if (file.empty() || !message.starts_with(file + ":")) return std::nullopt;
  static const std::regex kForm(R"(^(?:(\d+):)?(?:(\d+):)? ?(?:error: )?([\s\S]*)$)");
  const std::string tail = message.substr(file.size() + 1);
  std::smatch match;
  if (!std::regex_match(tail, match, kForm)) return std::nullopt;
  FileFault fault{{}, match[3]};
  static const std::regex kByte(R"(^(byte \d+): error: )");
  fault.rest = std::regex_replace(fault.rest, kByte, "$1: ");
  if (const auto line = match[1].matched ? index_in(match[1]) : std::nullopt)
    fault.at.line = static_cast<int>(*line);
  if (const auto column = match[2].matched ? index_in(match[2]) : std::nullopt)
    fault.at.column = static_cast<int>(*column);
  return fault;
}

/// Where the tree file has a face of a leaf: the face of a group, else the leaf itself.
Position position_of(const Node& node, std::optional<std::size_t> face) {
  const auto* group = node.shape ? std::get_if<GroupShape>(&*node.shape) : nullptr;
  if (!group || !face || *face >= group->faces.size() || group->faces[*face].line == 0) return node.operator_at;
  return {group->faces[*face].line, group->faces[*face].column};
}

/// A leaf or some of its faces in words for people; `faces` is such as `, face 3, face 4`, or empty.
struct Mention {
  Position at;  ///< of the first face
  std::string words;
};
Mention mention_of(const Node& node, const std::string& faces) {
  static const std::regex kNumber(R"(\d+)");
  std::optional<Position> first;
  std::string words;
  for (std::sregex_iterator it(faces.begin(), faces.end(), kNumber), end; it != end; ++it) {
    const Position at = position_of(node, index_in(it->str()));
    words += (first ? ", face " : "face ") + it->str() + " (line " + std::to_string(at.line) + ")";
    if (!first) first = at;
  }
  if (first) return {*first, words + " of `" + node.name + "`"};
  return {node.operator_at, "`" + node.name + "` (line " + std::to_string(node.operator_at.line) + ")"};
}

/// From `, solid 1, solid 3` makes `solid 1 `bolt`, solid 3 of `; from an empty text an empty one.
std::string solids_in(const std::string& solids, const std::vector<Attributes>& regions) {
  static const std::regex kNumber(R"(\d+)");
  std::string words;
  for (std::sregex_iterator it(solids.begin(), solids.end(), kNumber), end; it != end; ++it) {
    words += (words.empty() ? "solid " : ", solid ") + it->str();
    const auto number = index_in(it->str());
    if (number && *number > 0 && *number <= regions.size() && !regions[*number - 1].name.empty())
      words += " `" + regions[*number - 1].name.text() + "`";
  }
  return words.empty() ? words : words + " of ";
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
    instances_.push_back({prepared_[instance.node], instance.transform});
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

// Files of meshes are read at the same time; if several have faults that of the first node is told.
void PreparedLeaves::prepare_nodes(const std::vector<NodeId>& nodes) {
  std::vector<std::exception_ptr> faults(nodes.size());
  const std::stop_token stop = LeafStop::token();
  tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
    const LeafStop of_this_thread(stop);
    const Node& node = tree_->nodes[nodes[i]];
    if (!node.shape || !std::holds_alternative<MeshShape>(*node.shape)) return;
    try {
      prepare_node(nodes[i]);
    } catch (...) {
      faults[i] = std::current_exception();
    }
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (faults[i]) std::rethrow_exception(faults[i]);
    if (!prepared_[nodes[i]]) prepare_node(nodes[i]);
  }
}

void PreparedLeaves::prepare_node(NodeId id) {
  const Node& node = tree_->nodes[id];
  try {
    prepared_[id] = prepare(*node.shape);
  } catch (const InputError& e) {
    const std::string* const reads = file_of(*node.shape);
    const std::string file = reads == nullptr ? std::string() : *reads;
    if (const std::optional<FileFault> fault = split(e.what(), file)) {
      throw TreeError(file, fault->at,
                      fault->rest + " (read for the node `" + node.name + "`, " +
                          to_string(tree_->file, node.operator_at) + ")");
    }
    static const std::regex kFace(R"(\bface (\d+))");
    std::cmatch match;
    std::optional<std::size_t> face;
    if (std::regex_search(e.what(), match, kFace)) face = index_in(match[1]);
    throw TreeError(tree_->file, position_of(node, face), e.what());
  } catch (const FileError& e) {
    throw FileError(to_string(tree_->file, node.operator_at) + ": error: " + e.what());
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
  } catch (const InputError& e) {
    Position first = tree_->nodes_at;
    const std::string message = in_words(e.what(), &first);
    throw TreeError(tree_->file, first, message);
  }
}

std::string PreparedLeaves::in_words(const std::string& message, Position* first) const {
  static const std::regex kPlace(R"(\bleaf (\d+)((?:, face \d+)*)((?:, solid \d+)*))");
  bool any = false;
  std::string translated;
  auto last = message.cbegin();
  for (std::sregex_iterator it(message.begin(), message.end(), kPlace), end; it != end; ++it) {
    const std::smatch& match = *it;
    const auto leaf = index_in(match[1]);
    if (!leaf || *leaf >= numbers_.count()) continue;
    Mention mention = mention_of(node_of(LeafId(*leaf)), match[2]);
    mention.words.insert(0, solids_in(match[3], instances_[*leaf].leaf->regions()));
    if (first != nullptr && !any) *first = mention.at;
    any = true;
    translated.append(last, match[0].first).append(mention.words);
    last = match[0].second;
  }
  translated.append(last, message.cend());
  return translated;
}

std::vector<Diagnostic> PreparedLeaves::located_notices(const std::vector<std::string>& messages) const {
  std::vector<Diagnostic> result;
  for (const std::string& message : messages) {
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
