// The operators of Constructive Non-Regularized Geometry (rossignac1991; csg/SEMANTICS.md#components).
//
//   aggregate   all components of all operands; an overlap is an error
//   unify       one component: |X|
//   sum         Xi - |Y|, Xi and Yj, Yj - |X|
//   product     Xi and Yj
//   subtract    Xi - |Y|
//   complement  one component: space - |X|
//   interior    Xi and int|X|
//   closure     the Xi; cl|X| - |X|
//   boundary    Xi and bd|X|; bd|X| - |X|
//   regularize  Xi and cl int|X|; cl int|X| - |X|
//
// Components come in the order of the table, (i, j) by i, then j; empty ones vanish. With `each` the topological
// operators act on every component by itself: a result component is the set of cells that belong to the results
// of one and the same set of components, ordered by that set.
//
// Attributes (cavalcanti1997: a region gets its material by itself): a component of the result has those of the
// component of the operand with the greater dominance; with equal dominance the left one's, what it lacks from the
// other, names joined by ` & `. What differs under equal dominance is reported with the cells. The dominance is
// the larger one. What is said of a cell (origins.h) goes by the same dominance, cell by cell.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "csg/operators/attributes.h"
#include "csg/operators/components.h"
#include "csg/operators/tables.h"

namespace cnrg {

struct ComponentsResult {
  Components value;
  std::vector<AttributeConflict> conflicts;
};

/// Throws InputError when operands overlap; the message names the two operands (their `names`, parallel) and one
/// cell that both have.
ComponentsResult aggregate(const Complex& complex, std::span<const Components* const> operands,
                           std::span<const std::string> names);
ComponentsResult unify(const Complex& complex, const Components& x);
/// `dominance` overrides that of the components.
ComponentsResult sum(const Complex& complex, const Components& x, const Components& y,
                     std::optional<Dominance> dominance = {});
ComponentsResult product(const Complex& complex, const Components& x, const Components& y,
                         std::optional<Dominance> dominance = {});
ComponentsResult subtract(const Complex& complex, const Components& x, const Components& y);
ComponentsResult complement(const Complex& complex, const Components& x);

/// sum(sum(x, y), z) ... and subtract(subtract(x, y), z) ... of two operands at least, at the cost of the cells of
/// all of them.
ComponentsResult sum(const Complex& complex, std::span<const Components* const> operands,
                     std::optional<Dominance> dominance);
ComponentsResult subtract(const Complex& complex, std::span<const Components* const> operands);

enum class Topological : std::uint8_t { interior, closure, boundary, regularize };
const char* name(Topological op);
/// A cell that the operator adds came from the cells of X next to it, and from those of the leaves `below` X
/// (ascending) that have a face, wire or point there: the wall that was taken away, for one.
ComponentsResult topological_operation(const Complex& complex, Topological op, const Components& x,
                                       std::span<const LeafId> below = {});
/// The operator on every component by itself.
ComponentsResult topological_operation_of_each(const Complex& complex, Topological op, const Components& x,
                                               std::span<const LeafId> below = {});

/// What the operator does to a point set.
CellSet topological_operation(const Complex& complex, Topological op, const CellSet& set);

}  // namespace cnrg
