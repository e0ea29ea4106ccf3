// The identities that each evaluated Boolean must satisfy (SEMANTICS 5.1 to 5.3), checked cell by cell.
//
// For tests and `--check`: each call passes over the whole complex. Each function returns the first violation in
// words, naming the cell, or an empty string.
#pragma once

#include <string>

#include "csg/operators/boolean.h"

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

/// All of the above, and the Euler-Poincare formula of the result.
std::string check_boolean(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                          const Group& result);

/// |complement(G)| = cl(space - |G's regions|), and a valid group.
std::string check_complement(const Complex& complex, const Group& g, const Group& result);

}  // namespace cnrg
