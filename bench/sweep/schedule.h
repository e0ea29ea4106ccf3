// Units run by several processes, the next one where one has ended.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace cnrg::bench {

/// Stands for a system: who confirms the exact result.
inline constexpr const char* kTruth = "truth";

struct Unit {
  std::string problem, system;  ///< `kTruth` comes first
};

struct Progress {
  std::size_t done = 0, failed = 0, total = 0;
  double seconds_left = 0;  ///< estimated from units of the same system; 0 before anything is known
};

struct FailedUnit {
  Unit unit;
  int status = 0;       ///< of its process; negative: the signal that ended it
  bool waited = false;  ///< it never ran: the truth that it waited for failed so
};

/// Runs `arguments(unit)` (program and arguments) for each unit, at most `jobs` at a time; units of a problem wait
/// for its truth, if that is among them. A unit that ends with another status than 0 has failed, and so have those
/// that wait for it; its standard error goes through. All processes end when this one does. Returns the failed
/// ones.
std::vector<FailedUnit> run_units(const std::vector<Unit>& units, int jobs,
                                  const std::function<std::vector<std::string>(const Unit&)>& arguments,
                                  const std::function<void(const Progress&)>& progress);

}  // namespace cnrg::bench
