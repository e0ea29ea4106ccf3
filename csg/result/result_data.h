// The data that copies of a Result share; for the rooms that make and write results, not for users.
#pragma once

#include <functional>
#include <optional>

#include "csg/operators/node_value.h"
#include "csg/result/result.h"
#include "csg/result/result_view.h"

namespace cnrg {

class SurfaceParameters;

struct Result::Data {
  std::shared_ptr<const Complex> complex;
  std::shared_ptr<const NodeValue> value;
  std::shared_ptr<const SimplifiedComplex> simplified;  ///< in the order of files (put_in_order)
  /// nullptr: none are known. Refers to the evaluated complex.
  std::shared_ptr<const SurfaceParameters> parameters;
  std::string node;
  std::vector<LeafInfo> leaves;  ///< by LeafId
  std::vector<ResultView::Material> materials;
  std::shared_ptr<const std::vector<LeafParts>> region_parts;  ///< as in ResultView
  bool of_group = false;                                       ///< as in ResultView
  bool raw = false;                                            ///< its cells are not simplified
  std::function<std::optional<double>()> volume_bound{};       ///< as of NodeRow; empty: nobody knows any

  /// Sets node, leaves and materials; those of regions that are not named come after the others.
  void name(ResultNames names);
  /// What writers are given; it refers to this. `with_parameters`: they are shown.
  ResultView view(bool with_parameters = false) const;
};

}  // namespace cnrg
