// What a statement makes: nothing, an area, polygons of doubles, or an exact solid, as OpenSCAD has it at that
// place.
//
// One operand alone passes through a Boolean unchanged, so that it stays polygons of doubles. Of an exact solid
// that is a union of convex ones the corners of these are kept: hulls and Minkowski sums are faster with them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "csg/leaves/shapes.h"
#include "csg/openscad/polyset.h"
#include "csg/openscad/statement.h"

namespace cnrg::openscad {

// Exact solids: polyhedra, moved, and Booleans of them, before they are nodes of a tree.
//
// Hulls and Minkowski sums take any solid by its corners and faces. Those of a Boolean are computed in one
// complex: a face bounds the solid if the solid is on one side of it only.

struct ExactSolid;
using ExactSolidRef = std::shared_ptr<const ExactSolid>;

struct ExactSolid {
  enum class Kind { polyset, sum, moved, unite, subtract, intersect };
  Kind kind = Kind::polyset;
  const Statement* from = nullptr;        ///< what it is called after
  Polyset polyset{};                      ///< on the grid; if it is convex, that is said
  HullShape sum{};                        ///< of a sum
  Matrix matrix{};                        ///< of a moved one
  std::vector<ExactSolidRef> operands{};  ///< of a moved one its only
};

using ExactTriangle = std::array<RationalPoint, 3>;

/// Triangles that together are the boundary; not oriented.
std::vector<ExactTriangle> boundary(const ExactSolid& solid);

/// The shortest decimal that is nearest to a double: what matrices of exact solids mean.
std::string decimal(double x);

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
