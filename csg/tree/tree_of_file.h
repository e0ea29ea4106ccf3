// Any file as a tree: a tree, or the one leaf that a mesh, a CAD model or an exact result is.
#pragma once

#include <string>

#include "csg/leaves/shapes.h"
#include "csg/tree/tree.h"

namespace cnrg {

inline constexpr std::size_t kMostTreeBytes = 100'000'000;
inline constexpr const char* kSmallerTree = "; give large shapes as files that the tree names";

/// A tree with one leaf: a mesh, a CAD model or a result, read from a file as the leaf of that kind would. Any
/// other file is read as a tree. Throws what `read_tree` throws.
Tree tree_of_file(const std::string& path, const ReadOptions& options = {});

/// A tree with one node, that leaf.
Tree tree_of_leaf(const std::string& file, const std::string& name, const std::string& key, Shape shape);

/// OpenSCAD's `.csg` files as trees (csg/FORMATS.md#openscad): as `parse_tree`, of the text of such a file; places
/// are those of that file.
Tree parse_openscad(const std::string& text, const std::string& file, const ReadOptions& options = {});

}  // namespace cnrg
