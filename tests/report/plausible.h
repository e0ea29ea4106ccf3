// Rows like those of a sweep, in memory: what systems are known to do, exaggerated; times and memory by power laws
// with noise. The same whenever they are made.
#pragma once

#include "bench/report/experiment.h"

namespace cnrg::bench {

struct PlausibleSweep {
  std::vector<SystemInfo> systems;
  std::vector<FamilyInfo> families;
  MachineInfo machine;
  std::vector<SweepRow> rows;
};

/// The first `families` families of fifteen, the first `systems` systems of seven, `seeds` problems of each kind.
PlausibleSweep plausible_sweep(std::size_t families, std::size_t systems, unsigned seeds);

/// A row that is right: of `system` on a problem of `family` with the size and seed, no distance.
SweepRow right_row(const std::string& system, const std::string& family, long size = 1, unsigned seed = 1);
/// Sets the distance, the problem's name and the verdict.
SweepRow at_distance(SweepRow row, std::optional<int> k, Verdict verdict);

/// Writes the rows as `FOLDER/rows/PROBLEM/SYSTEM.json` and the three descriptions beside them.
void write_sweep(const std::string& folder, const PlausibleSweep& sweep);

}  // namespace cnrg::bench
