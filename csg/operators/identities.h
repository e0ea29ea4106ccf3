// The identities that each evaluated Boolean must satisfy (csg/SEMANTICS.md#identities), checked cell by cell.
//
// For tests and EvaluateOptions::validate: each call passes over the whole complex. Each function returns the
// first violation in words, naming the cell, or an empty string.
#pragma once

#include <string>

#include "csg/operators/boolean.h"
#include "csg/operators/cnrg.h"

namespace cnrg {

/// A group on the complex: lists sorted and unique, entities closed under boundary, regions numbered from 1 and
/// maximal, all around a cell that is no entity one and the same region, features among the entities.
std::string check_group(const Complex& complex, const Group& g);

/// |R| = |A| or |B|, |A| and |B|, or cl(|A| - |B|), for each cell of the complex.
std::string check_point_set(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                            const Group& result);

/// The volume inside the walls of the result against the 3-cells of the operands:
/// V(A or B) + V(A and B) = V(A) + V(B), V(A - B) + V(A and B) = V(A). Unbounded groups pass.
std::string check_volumes(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                          const Group& result);

/// All of the above, and the Euler-Poincare formula of a result that is bounded, where there is no frame.
std::string check_boolean(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                          const Group& result);

/// |complement(G)| = cl(space - |G's regions|), and a valid group.
std::string check_complement(const Complex& complex, const Group& g, const Group& result);

/// Sorted lists, each cell once, components from 1 all with cells, origins parallel, features active.
std::string check_components(const Complex& complex, const Components& x);

/// The law of csg/SEMANTICS.md#components: unify(sum(X, Y)) = |X| or |Y|, unify(product) = |X| and |Y|,
/// unify(subtract) = |X| - |Y|; and no component holds cells of two components of an operand.
enum class OverlayLaw : std::uint8_t { sum, product, subtract };
std::string check_overlay(OverlayLaw law, const Complex& complex, const Components& x, const Components& y,
                          const Components& result);

/// unify(op(X)) = op(|X|); with `each` the union over the components.
std::string check_topological(const Complex& complex, Topological op, bool each, const Components& x,
                              const Components& result);

}  // namespace cnrg
