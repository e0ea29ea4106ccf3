// Curved leaves in a tree file: control nets, profiles, fineness.
#pragma once

#include "csg/tree/read_leaf.h"

namespace cnrg {

Shape read_extrude(const Value& value, const LeafContext& context);
Shape read_revolve(const Value& value, const LeafContext& context);
Shape read_sweep(const Value& value, const LeafContext& context);
Shape read_loft(const Value& value, const LeafContext& context);
Shape read_bezier(const Value& value, const LeafContext& context);
Shape read_bspline(const Value& value, const LeafContext& context);
Shape read_coons(const Value& value, const LeafContext& context);

/// `chord` or `segments`, or neither.
Tessellation read_tessellation(const Fields& f);

/// The value of `fill`, which is there.
Fill read_fill(const Fields& f);

}  // namespace cnrg
