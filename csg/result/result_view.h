// What writers are given: one node of an evaluated tree with all that its file says of it.
#pragma once

#include <string>
#include <vector>

#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "csg/result/result.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// What a writer says of a leaf.
struct LeafInfo {
  std::string name;  ///< the node's name in the tree
  double size = 0;   ///< how long edges of a mesh are to be on what comes from it; 0: nobody says
};

/// One node of an evaluated tree, as writers see it. It owns nothing of what it points to. A Result
/// makes a view of itself (result_data.h).
struct ResultView {
  std::string node{};  ///< name of the node
  const Complex* complex = nullptr;
  const NodeValue* value = nullptr;
  const SimplifiedComplex* simplified = nullptr;
  const std::vector<LeafInfo>* leaves = nullptr;  ///< by LeafId
  using Material = ResultNames::Material;
  std::vector<Material> materials{};
  bool of_group = false;  ///< `value` is a snapped group's components (snap.h), the last its entities
  /// Given: .json and .vtu say the parameters of faces on patches of the leaves.
  const SurfaceParameters* parameters = nullptr;
  /// Of a snapped result: by RegionId how long edges are to be there (sizes.h), 0: nobody says. Empty: nowhere.
  /// nullptr: the leaves that hold a 3-cell tell.
  const std::vector<double>* region_sizes = nullptr;
};

}  // namespace cnrg
