// How the second operand of a problem leaves the degenerate position, by a seed.
#pragma once

#include "bench/cases/family.h"
#include "bench/cases/solids.h"

namespace cnrg::bench {

/// Operands touch in the plane z = 0, about the origin; the second one is above. Seeds go in turn, from 1:
/// it moves up by 10^-k, it turns, it moves down, it turns the other way. A turn is by 2 atan(10^-k / 2) about an
/// axis near the direction of y that passes the origin at a distance of 1/2, above the plane at 1/4, so that no
/// point of the plane stays where it is. The identity without a distance.
AffineMap perturbation(const ProblemId& id);

/// Which of `kinds` a seed is: seeds in a row go through all, and `4 * kinds` of them through all pairs of a kind
/// and a way to leave.
unsigned kind_of(const ProblemId& id, unsigned kinds);

/// Where both operands of a problem go in the end: nowhere for seeds 1 and 2, a place in general position else.
AffineMap placement(const ProblemId& id);

/// Numbers that depend on the seed and on the family, so that families differ.
Random random_of(const ProblemId& id);

/// Both operands: the second one perturbed, then both placed.
std::vector<Model> placed_pair(const ProblemId& id, Model first, Model second);

}  // namespace cnrg::bench
