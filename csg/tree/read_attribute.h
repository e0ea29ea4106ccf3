// Attributes of a node in a tree file (csg/FORMATS.md#attributes).
#pragma once

#include <vector>

#include "csg/tree/read_leaf.h"
#include "csg/tree/tree.h"

namespace cnrg {

/// Reads one attribute into a node whose operator is known.
void read_attribute(Node& node, const Value::Entry& e, const LeafContext& context);

/// Moves a node as an attribute says; by `translate` and `rotate` so many times. Throws TreeError for what is
/// singular or has no direction.
void move(Node& node, const Value::Entry& e, const Rational& times = 1);

/// Where operands blend, none of them dominates.
void check_blend(const Node& node, const std::vector<Value::Entry>& entries);

}  // namespace cnrg
