// Leaves in a tree file (csg/FORMATS.md#leaves): from YAML values to the structures of shapes.h.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "csg/leaves/shapes.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

struct LeafContext {
  std::string folder;                                ///< paths in the file are relative to it
  std::string inside;                                ///< files must lie in it; empty: anywhere
  std::function<void(const Value&)> check_material;  ///< fails when the material is not declared
};

/// The path of a file that the tree names.
std::string path_in_folder(const std::string& path, const LeafContext& context);

/// The names of all leaves that can be read.
std::span<const std::string_view> leaf_names();

/// Fails for a `weld`, of a leaf or of the tree, that is no length above 0.
void check_weld(const Fields& fields);

/// The shape of a leaf called `name`, one of `leaf_names()`.
Shape read_leaf(std::string_view name, const Value& value, const LeafContext& context);

}  // namespace cnrg
