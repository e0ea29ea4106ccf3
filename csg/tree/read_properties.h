// Reads what people say of a part of a model beside its name and material: keys with values.
#pragma once

#include "csg/materials/attributes.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

/// A map of any keys, each with a number or a text.
Properties read_properties(const Value& value);

/// One value: a number, or a text; a number in quotes is a text. `what` names it in messages.
Property read_property(const Value& value, const std::string& what);

/// `size` of a node, a length as meshers take it: above 0 as a double, too.
Rational read_size(const Value& value);

}  // namespace cnrg
