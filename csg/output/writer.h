// Files of results: one writer per format, chosen by the extension.
#pragma once

#include <string>
#include <vector>

#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// What a writer says of a leaf.
struct LeafInfo {
  std::string name;  ///< the node's name in the tree
};

/// One node of an evaluated tree, as writers see it.
struct ResultView {
  std::string node{};  ///< name of the node
  const Complex* complex = nullptr;
  const NodeValue* value = nullptr;
  const SimplifiedComplex* simplified = nullptr;
  const std::vector<LeafInfo>* leaves = nullptr;  ///< by LeafId
  struct Material {
    std::string name, color;
  };
  std::vector<Material> materials{};
  bool of_group = false;  ///< `value` has the components of a group (snap.h): the last are entities
  /// Given: .json and .vtu say the parameters of faces on patches of the leaves.
  const SurfaceParameters* parameters = nullptr;
};

/// What rounding to doubles did to a written file.
struct RoundingReport {
  std::size_t moved = 0;  ///< vertices whose doubles differ from their exact coordinates
  bool embedded = true;   ///< the rounded facets still meet only in shared vertices and edges
};

/// Throws InputError if no writer knows the extension of `path`: to be asked before long work.
void check_extension(const std::string& path);

/// Writes `view` to `path` in the format of its extension (.json .vtu .msh .mesh .smesh .poly .obj .off
/// .stl .ply), beside and renamed.
/// Throws InputError for an unknown extension or a result that the format can not represent (the message says
/// why and what to use instead), FileError if the file can not be written; the old file is then untouched.
RoundingReport write(const std::string& path, const ResultView& view);

}  // namespace cnrg
