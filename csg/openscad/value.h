// What a statement makes: nothing, an area, polygons of doubles, or an exact solid, as OpenSCAD has it at that
// place.
//
// One operand alone passes through a Boolean unchanged, so that it stays polygons of doubles. Of an exact solid
// that is a union of convex ones the corners of these are kept: hulls and Minkowski sums are faster with them.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "csg/openscad/exact_solid.h"

namespace cnrg::openscad {

using Parts = std::vector<std::vector<Point3>>;

struct Solid {
  Polyset polyset;
  const Statement* from;
};
struct Exact {
  ExactSolidRef solid;
  std::optional<Parts> parts;  ///< of a union of convex ones
};
using Value = std::variant<std::monostate, Area, Solid, Exact>;

/// Without area or volume.
bool is_empty(const Value& value);

/// What a Boolean takes; nothing if there is no volume.
std::optional<Exact> exact_of(const Value& value);
Exact moved(const Exact& solid, const Matrix& m, const Statement& at);
/// The operands, or the only one.
Value boolean(const Statement& at, ExactSolid::Kind kind, const std::vector<Exact>& operands);

/// Points whose hull is that of solids, none empty.
std::vector<Point3> corners_of(const std::vector<Value>& solids);
/// Solids whose union is all sums of a point of each; nothing if two of them are neither convex nor a union of
/// convex ones. Sums of convex solids are hulls of sums of corners. If one, C, is not convex, the sum is C moved
/// to a point inside of the others' sum, and all sums of a triangle of C's boundary with that.
std::optional<std::vector<Value>> minkowski_sum(const std::vector<Value>& solids, const Statement& at);

}  // namespace cnrg::openscad
