// Models as nodes of a tree file.
#pragma once

#include <string>

#include "bench/cases/model.h"

namespace cnrg::bench {

/// A leaf, or the union of some, in one line. Faces have one loop each. `attributes`: further keys, such as
/// `material: "in B"`.
std::string node_text(const Model& model, const std::string& attributes = "");

/// A text in quotes, for a name or a value of a tree file.
std::string quoted_text(const std::string& text);

}  // namespace cnrg::bench
