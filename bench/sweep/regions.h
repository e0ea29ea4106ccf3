// Regions of a node's value, by a system that parts space (Arrangement) and by ours: as many, and where.
//
// A region is known by the regions of the operands that it lies in, and by its volume in each of them: so
// dominance and origin are compared, too. Which faces stay walls is said by the tables of csg/SEMANTICS.md,
// written here once more: nothing is shared with csg/operators.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/cases/node_problem.h"
#include "bench/sweep/row.h"
#include "csg/operators/dominance.h"
#include "csg/tree/tree.h"
#include "kernel/exact/rational.h"

namespace cnrg::bench {

/// For each operand the region of it, from 1, or 0.
using Place = std::vector<std::uint32_t>;

struct ExactVolume {
  Rational volume;
  double area = 0;  ///< of the boundary
};
using ExactRegion = std::map<Place, ExactVolume>;
using FoundRegion = std::map<Place, double>;
/// Areas between two regions, the lesser place in the list first.
using Walls = std::map<std::pair<std::size_t, std::size_t>, double>;

struct FoundRegions {
  std::vector<FoundRegion> regions;
  Walls walls;
};

struct RegionProblem {
  Operator op = Operator::unite;
  bool blend = false;
  std::vector<Dominance> dominances;  ///< of the steps of a Boolean
  std::vector<ParcelledOperand> operands;
  std::vector<ExactRegion> regions;  ///< of the value
  Walls walls;
  double extent = 0;  ///< the largest coordinate
};

/// The regions that the node makes of parts.
FoundRegions regions_of(const RegionProblem& problem, const Arrangement& arrangement);

/// `same`; `within_rounding` where only regions are too many or too few that are thinner than the rounding, or
/// where regions grow together or fall apart that share no wall, as at a gap or a bridge; `wrong`.
struct RegionJudgement {
  Verdict verdict = Verdict::same;
  std::string message;
};
RegionJudgement judge_regions(const RegionProblem& problem, const FoundRegions& found, double rounding);

}  // namespace cnrg::bench
