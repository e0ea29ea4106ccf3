// Reads the criteria of `select`: each is one value or a list of them.
#pragma once

#include "csg/operators/select.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

/// All but those that name nodes (`from`, `inside`, `touching`) and materials.
Criteria read_criteria(const Fields& fields);

/// The values of a list, which is not empty, or the value itself; `what` names it in messages.
std::vector<Value> one_or_more(const Value& value, const std::string& what);

}  // namespace cnrg
