#include "csg/tree/tree_of_file.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>

#include "csg/imports/mesh_file.h"
#include "csg/leaves/leaf.h"
#include "csg/openscad/openscad_tree.h"
#include "csg/text/file.h"
#include "csg/text/input_file.h"
#include "csg/tree/dag.h"
#include "csg/tree/read_from_input.h"

namespace cnrg {
namespace {

// The tree of a `.csg` file is read as the tree file that it means, and every place moved back to where it is
// from.

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

/// A tree may be JSON, too. What tells it from a result is the first key: that of a result is none of a tree, but
/// for `materials`, which is a list there.
bool is_result(const std::string& path) {
  constexpr std::size_t kEnough = 4096;
  const std::string whole = read_file(path);
  const std::string text(without_mark(whole).substr(0, kEnough));
  const std::size_t open = text.find_first_not_of(" \t\r\n");
  if (open == std::string::npos || text[open] != '{') return false;
  const std::size_t quote = text.find_first_not_of(" \t\r\n", open + 1);
  if (quote == std::string::npos || text[quote] != '"') return false;
  const std::size_t end = text.find('"', quote + 1);
  if (end == std::string::npos) return false;
  const std::string key = text.substr(quote + 1, end - quote - 1);
  if (key == "materials") {
    const std::size_t value = text.find_first_not_of(" \t\r\n:", end + 1);
    return value != std::string::npos && text[value] == '[';
  }
  static const std::set<std::string> kKeys{"attributes", "cells",    "components",  "dominance", "edges",
                                           "faces",      "format",   "frame",       "grades",    "group",
                                           "leaves",     "node",     "patches",     "points",    "regions",
                                           "version",    "vertices", "volume_bound"};
  return kKeys.contains(key);
}

/// The leaf, and the key that a tree has for it.
std::optional<std::pair<Shape, const char*>> shape_of(const std::string& path) {
  const std::string extension = extension_of(path);
  if (is_mesh_file(path)) {
    MeshShape mesh;
    mesh.file = path;
    return std::pair(Shape(mesh), "mesh");
  }
  if (extension == ".step" || extension == ".stp" || extension == ".brep") {
    CadShape cad;
    cad.format = extension == ".brep" ? CadShape::Format::brep : CadShape::Format::step;
    cad.file = path;
    return std::pair(Shape(cad), cad.name());
  }
  if (extension == ".json" && is_result(path)) return std::pair(Shape(ResultShape{path}), "cnrg");
  return std::nullopt;
}

/// Files of programs and of our own that are no trees, and that no leaf reads.
void refuse_others(const std::string& path) {
  const std::string extension = extension_of(path);
  const auto is = [&](std::initializer_list<std::string_view> those) {
    return std::find(those.begin(), those.end(), extension) != those.end();
  };
  std::string remedy;
  if (is({".ifc"})) remedy = "convert it to .step or .obj, such as by IfcConvert";
  if (is({".dxf", ".dwg", ".igs", ".iges", ".sat", ".x_t"})) remedy = "export it as .step";
  if (is({".msh2", ".mesh", ".smesh", ".poly", ".inp", ".bdf", ".h5m", ".f3grid", ".med", ".xdmf", ".gltf"}))
    remedy = "write a result as .json, which is exact, or a surface as .stl, .ply or .vtu";
  if (!remedy.empty()) throw TreeError(path, {}, "a " + extension + " file is not read; " + remedy);
}

/// The tree in the text that `read` gives.
template <class Read>
Tree tree_in(const std::string& file, const ReadOptions& options, Read read) {
  std::string text;
  try {
    text = read();
  } catch (const InputError& e) {
    throw TreeError(file, {}, e.what() + std::string(kSmallerTree));
  } catch (const FileError& e) {
    throw FileError(to_string(file, {}) + ": error: the tree file: " + e.what());
  }
  return (is_openscad_file(file) ? parse_openscad : parse_tree)(text, file, options);
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

Tree read_tree(const std::string& path, const ReadOptions& options) {
  return tree_in(path, options, [&] { return read_file(path, {}, kMostTreeBytes); });
}

Tree read_tree_from_input(const ReadOptions& options) {
  return tree_in(kStandardInput, options, [] { return read_standard_input(kMostTreeBytes); });
}

Tree tree_of_file(const std::string& path, const ReadOptions& options) {
  auto found = shape_of(path);
  if (!found) {
    refuse_others(path);
    return read_tree(path, options);
  }
  for (const auto& [name, text] : options.parameters) {
    if (options.unknown != nullptr) options.unknown->insert(name);
  }
  if (!options.parameters.empty() && options.unknown == nullptr)
    throw InputError("the parameter `" + options.parameters.begin()->first + "`: " + path +
                     " is no tree and has none");
  return tree_of_leaf(path, std::filesystem::path(path).stem().string(), found->second, std::move(found->first));
}

Tree tree_of_leaf(const std::string& file, const std::string& name, const std::string& key, Shape shape) {
  Tree tree;
  tree.file = file;
  Node node;
  node.name = name;
  node.operator_name = key;
  node.shape = std::move(shape);
  Dag dag;
  tree.result = dag.add_node();
  tree.names.emplace(node.name, tree.result);
  tree.nodes.push_back(std::move(node));
  tree.dag = std::make_shared<const Dag>(std::move(dag));
  return tree;
}

}  // namespace cnrg
