// `--join`: a result with its near features joined, and the notices and warnings about that.
#pragma once

#include <string>

#include "csg/result/result.h"
#include "csg/tree/tree.h"

namespace cnrg::app {

/// Joins behind a progress bar and prints what met; `distance` is a number. Regions that vanish, what is still
/// near, and volume that changes by a hundredth or more are told even if `quiet`.
Result joined(const Tree& tree, NodeId node, const Result& result, const std::string& distance, bool quiet);

}  // namespace cnrg::app
