// Curved leaves in a tree file: control nets, profiles, fineness.
#pragma once

#include "csg/tree/read_leaf.h"

namespace cnrg {

/// What values look like, for messages.
inline constexpr const char* kPoint = "[x, y, z]";
inline constexpr const char* kPoints = "[[x, y, z], ...]";

Shape read_extrude(const Value& value, const LeafContext& context);
Shape read_revolve(const Value& value, const LeafContext& context);
Shape read_bezier(const Value& value, const LeafContext& context);
Shape read_bspline(const Value& value, const LeafContext& context);
Shape read_coons(const Value& value, const LeafContext& context);

/// `chord` or `segments`, or neither.
Tessellation read_tessellation(const Fields& f);

/// winding, parity, cells or none.
Fill read_fill(const Value& value, const std::string& what);

}  // namespace cnrg
