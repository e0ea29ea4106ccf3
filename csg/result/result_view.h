// The input of writers: one node of an evaluated tree, with all data that its file holds.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "csg/result/result.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// What a region is made of: of each of its 3-cells all leaves that hold it and may say a size, each list once and
/// ascending. Empty if of some 3-cell there is none.
using LeafParts = std::vector<std::vector<LeafId>>;

/// What a writer says of a leaf.
struct LeafInfo {
  std::string name;  ///< the node's name in the tree
  /// Among the leaves below the node, in the order of its subtree (csg/operators/leaf_order.h): files number
  /// leaves so.
  std::uint32_t place = kNoPlace;
  static constexpr std::uint32_t kNoPlace = 0xffffffffu;  ///< it is not below the node
  double size = 0;  ///< how long edges of a mesh are to be on what comes from it; 0: nobody says
  /// Nobody says a size here, but users of the result may.
  bool asks = false;
  /// Of a node that joins: the `makers` leaves after it are the leaves below it, the sources of its cells.
  std::uint32_t makers = 0;
  std::shared_ptr<const std::vector<LeafParts>> regions{};  ///< and its regions, by label; nullptr of others
  bool may_say_size() const { return size > 0 || asks; }
};

/// One node of an evaluated tree, as writers see it. It owns nothing of what it points to. A Result
/// makes a view of itself (result_data.h).
struct ResultView {
  std::string node{};  ///< name of the node
  const Complex* complex = nullptr;
  const NodeValue* value = nullptr;
  const SimplifiedComplex* simplified = nullptr;
  const std::vector<LeafInfo>* leaves = nullptr;  ///< by LeafId
  std::uint32_t place(LeafId leaf) const {
    return leaves != nullptr && leaf.index() < leaves->size() ? (*leaves)[leaf.index()].place : leaf.value();
  }
  using Material = ResultNames::Material;
  std::vector<Material> materials{};
  bool of_group = false;  ///< `value` is a snapped group's components (snap.h), the last its entities
  /// Given: .json and .vtu say the parameters of faces on patches of the leaves.
  const SurfaceParameters* parameters = nullptr;
  /// Of a snapped or joined result: by RegionId what it was made of. Empty: nobody says sizes. nullptr: the leaves
  /// that hold a 3-cell tell.
  const std::vector<LeafParts>* region_parts = nullptr;
  bool one_group = false;                                 ///< as FileOptions have it
  std::function<std::optional<double>()> volume_bound{};  ///< as of Result::Data
};

}  // namespace cnrg
