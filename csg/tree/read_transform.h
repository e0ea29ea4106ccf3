// The attributes that move a node.
#pragma once

#include "csg/geometry/transform.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

/// Of `translate`, `rotate`, `scale` or `mirror`. Throws TreeError for what is singular or has no direction.
Transform read_transform(const Value::Entry& e);

}  // namespace cnrg
