// When two edges continue each other: on a line, or on one tessellated curve (csg/SEMANTICS.md#simplification).
//
// A curve leaves no equation in the complex, only facets that remember their patch and wires that remember their
// curve. Two edges are pieces of one curve when the same patches (of the same leaves) lie around both and the same
// wires' curves on both, and one of these is curved at the vertex: a patch with facets of more than one sheet
// there, or a shared wire curve. Where a leaf says that its curves end (the corners of a curved surface), none
// goes on. If one single patch lies around the edges they are on its border, and must turn by less than a right
// angle: a leaf of mere triangles names no corners.
//
// Only leaves that the value in question came from count: others may run along a curve for a part of its way.
#pragma once

#include <optional>
#include <span>

#include "kernel/complex/complex.h"

namespace cnrg {

/// The leaves that count at a cell, ascending; nothing: all.
using LeavesThere = std::optional<std::span<const LeafId>>;

/// True if a and b, two different edges at v, lie on one line (exact).
bool straight(const Complex& complex, VertexId v, EdgeId a, EdgeId b);

/// True if a and b, two different edges at v that are not on one line, are pieces of one tessellated curve, of
/// the leaves that count at each of them.
bool one_curve(const Complex& complex, VertexId v, EdgeId a, EdgeId b, LeavesThere at_a = {},
               LeavesThere at_b = {});

/// True if a patch (of the same leaf, which counts at both) covers both faces. When they lie in different sheets
/// it is a curved one.
bool share_patch(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f = {}, LeavesThere at_g = {});

}  // namespace cnrg
