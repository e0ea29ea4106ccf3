// When two edges continue each other at a vertex: on a line, or on one tessellated curve (SEMANTICS 6, 7).
//
// A curve leaves no equation in the complex, only facets that remember their patch and wires that remember their
// curve. Two edges are pieces of one curve when the same patches (of the same leaves) lie around both and the same
// wires' curves on both, and one of these is curved at the vertex: a patch with facets of more than one sheet
// there, or a shared wire curve. The border of one single patch (a corner of a sheet has it too) must not turn by
// a right angle or more.
#pragma once

#include "kernel/complex/complex.h"

namespace cnrg {

/// True if a and b, two different edges at v, lie on one line (exact).
bool straight(const Complex& complex, VertexId v, EdgeId a, EdgeId b);

/// True if a and b, two different edges at v that are not on one line, are pieces of one tessellated curve; of
/// `leaf` alone if it is given.
bool one_curve(const Complex& complex, VertexId v, EdgeId a, EdgeId b, LeafId leaf = LeafId::none());

/// True if a patch (of the same leaf) covers both faces. When they lie in different sheets it is a curved one.
bool share_patch(const Complex& complex, FaceId f, FaceId g);

}  // namespace cnrg
