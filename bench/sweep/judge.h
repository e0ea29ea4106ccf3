// The verdict: a result is refined together with the operands of its problem, and compared as a set of cells.
//
// The exact result comes from the tables, step by step, on the operands as they are; the result of the system is a
// leaf among others. For an exact system every cell counts. Coordinates of other systems are rounded: the volume
// of the symmetric difference may be what moving the boundary by the rounding makes, and then the topology has to
// be the same: shells and genus as the system's own vertices and faces have them.
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

/// The exact result alone.
Facts exact_facts(const Problem& problem);

}  // namespace cnrg::bench
