// When two edges continue each other: on a line, or on one tessellated curve (csg/SEMANTICS.md#simplification).
//
// A curve leaves no equation in the complex, only facets that know the number of their surface and wires that
// remember their curve. Facets that were removed before the complex was refined count, too. Two edges are pieces
// of one curve when the same surfaces lie around both, curved ones and planes, and the same wires' curves on both,
// and one of these is curved at the vertex: a surface with facets of more than one sheet there, or a shared wire
// curve. Sides of a sheet that declares all corners are curves as well, however they are drawn
// (Soup::Face::curved_sides). Where a leaf says that its curves end (the corners of a curved surface), none goes
// on.
//
// Only leaves that the value in question came from count: others may run along a curve for a part of its way. What
// none of these makes lies on what cut it. The wall of a hole is covered by that; an edge in one surface, or in a
// region, goes on where all leaves that lie along both edges make a curve, whatever else comes along or ends.
#pragma once

#include <optional>
#include <span>

#include "kernel/complex/complex.h"

namespace cnrg {

/// The leaves that count at a cell, ascending; nothing: all.
using LeavesThere = std::optional<std::span<const LeafId>>;

/// True if a and b, two different edges at v, lie on one line (exact).
bool straight(const Complex& complex, VertexId v, EdgeId a, EdgeId b);

/// True if both are pieces of one input segment, which is on one line: no arithmetic with the point that cuts it.
bool share_segment(const Complex& complex, EdgeId a, EdgeId b);

/// An edge and what counts there.
struct PieceOfCurve {
  EdgeId edge;
  LeavesThere leaves{};
  std::span<const FaceId> bare{};  ///< faces around it of which all leaves count
  bool cut = false;                ///< others may have made it by a cut
};

/// True if a and b, two different edges at v, are pieces of one line or tessellated curve. Chords of two curves
/// may be on one line by chance: where neither two planes nor a straight wire make both, and not the same curved
/// surfaces and wires lie along them.
bool one_curve(const Complex& complex, VertexId v, const PieceOfCurve& a, const PieceOfCurve& b);

/// True if none of the leaves covers the face.
bool is_bare(const Complex& complex, FaceId f, LeavesThere leaves);

/// True if both faces lie on one surface, a curved one or a plane, by the leaves that count at each; where none of
/// them covers a face all do.
bool share_surface(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f = {}, LeavesThere at_g = {});

/// True if the same faces of leaves cover both.
bool share_facets(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f, LeavesThere at_g);

}  // namespace cnrg
