// The tree of a `.csg` file is read as the tree file that it means, and every place moved back to where it is
// from.
#include "csg/tree/read_openscad.h"

#include <algorithm>

#include "csg/leaves/leaf.h"
#include "csg/openscad/openscad_tree.h"
#include "csg/text/input_file.h"

namespace cnrg {
namespace {

Position place_of(const OpenscadTree& tree, int line) {
  const auto last = static_cast<int>(tree.places.size());
  const OpenscadTree::Place place = tree.places.at(static_cast<std::size_t>(std::clamp(line, 1, last) - 1));
  return {place.line, place.column};
}

OpenscadTree tree_of_text(const std::string& text, const std::string& file, const ReadOptions& options) {
  try {
    return openscad_tree(text, file, options.inside.empty() ? "" : folder_of_inputs(options.inside));
  } catch (const LeafFileError& e) {
    if (e.file() != file) throw;
    throw TreeError(file, {std::max(e.line(), 1), std::max(e.column(), 1)}, e.fault());
  }
}

}  // namespace

Tree parse_openscad(const std::string& text, const std::string& file, const ReadOptions& options) {
  OpenscadTree source = tree_of_text(text, file, options);
  try {
    Tree tree = parse_tree(source.yaml, file, options);
    for (Node& node : tree.nodes) node.at = node.operator_at = place_of(source, node.at.line);
    tree.nodes_at = {};
    for (auto& [place, text] : source.warnings)
      tree.warnings.push_back({file, {place.line, place.column}, Diagnostic::Level::warning, std::move(text)});
    tree.yaml = std::move(source.yaml);
    tree.inputs = std::move(source.inputs);
    return tree;
  } catch (const TreeError& e) {
    throw TreeError(file, place_of(source, e.line()), e.message());
  }
}

}  // namespace cnrg
