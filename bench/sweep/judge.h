// The verdict: a result is refined together with the operands of its problem, and compared as a set of cells.
//
// The exact result comes from the tables, step by step, on the operands as they are; the result of the system is a
// leaf among others. Its faces have to go around the solid once, outwards: the volume that they enclose is that of
// the set. For an exact system every cell counts.
//
// Coordinates of other systems are rounded. The volume of the symmetric difference may be what moving the boundary
// by the rounding makes, no part of it may be thicker than that, and nothing may reach out of the box of the
// operands; then shells and genus have to be the same, as the system's own vertices and faces have them or as the
// set has them, and the contacts. A spike that stays within that box, without volume, is not seen.
//
// Contacts are told apart at edges and vertices of the result. One in the interior of a face is not: models have
// no vertices and edges there.
#pragma once

#include "bench/cases/family.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

struct Judgement {
  Verdict verdict = Verdict::wrong;
  /// Of what is wrong: `surface` (bounds no solid), `volume`, `topology` (shells or genus, while the volume is
  /// right up to rounding), `dangling` (faces, wires or points too many).
  std::string stage;
  std::string message;             ///< what is wrong in words
  std::optional<Facts> facts;      ///< of the result; none if it is no point set
  Facts truth;                     ///< of the exact result
  double excess = 0, missing = 0;  ///< as in SweepRow
  std::size_t duplicates = 0;
};

/// `rounding`: of the system (system.h); 0: exact. Throws what the kernel throws for operands that are none.
Judgement judge(const Problem& problem, const Model& result, double rounding);

/// Where comparing takes too long: a volume that is far from the exact one is wrong, all else is not judged.
Judgement judge_by_volume(const Problem& problem, const Model& result, double rounding);

/// The exact result alone.
Facts exact_facts(const Problem& problem);

}  // namespace cnrg::bench
