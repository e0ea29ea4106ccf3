// Attributes of a node in a tree file (csg/FORMATS.md#attributes).
#pragma once

#include <vector>

#include "csg/materials/attributes.h"
#include "csg/tree/read_leaf.h"
#include "csg/tree/tree.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

// Reads what people say of a part of a model beside its name and material: keys with values.

/// A map of any keys, each with a number or a text.
Properties read_properties(const Value& value);

/// One value: a number, or a text; a number in quotes is a text. `what` names it in messages.
Property read_property(const Value& value, const std::string& what);

/// `size` of a node, a length as meshers take it: above 0 as a double, too.
Rational read_size(const Value& value);

/// Reads one attribute into a node whose operator is known.
void read_attribute(Node& node, const Value::Entry& e, const LeafContext& context);

/// Moves a node as an attribute says; by `translate` and `rotate` so many times. Throws TreeError for what is
/// singular or has no direction.
void move(Node& node, const Value::Entry& e, const Rational& times = 1);

/// Where operands blend, none of them dominates.
void check_blend(const Node& node, const std::vector<Value::Entry>& entries);

}  // namespace cnrg
