// Materials of a tree file: `{color, linear: {...}}`, `{color, distance: {...}}` or `{color}`.
#pragma once

#include "csg/tree/tree.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

/// The entries of `materials`. TreeError for anything that is not as csg/FORMATS.md#materials has it; nodes that a
/// distance is measured to are not looked up.
std::vector<Material> read_materials(const Value& value);

}  // namespace cnrg
