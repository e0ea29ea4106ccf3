// Exact solids: polyhedra, moved, and Booleans of them, before they are nodes of a tree.
//
// Hulls and Minkowski sums take any solid by its corners and faces. Those of a Boolean are computed in one
// complex: a face bounds the solid if the solid is on one side of it only.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "csg/leaves/shapes.h"
#include "csg/openscad/polyset.h"
#include "csg/openscad/statement.h"

namespace cnrg::openscad {

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

}  // namespace cnrg::openscad
