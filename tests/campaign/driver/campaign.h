// Runs families of trials for hours, and can be killed at any time.
//
// The obvious loop dies with the first crash, and a hang is worse. So trials run in short batches, each
// in a process of its own that says over a pipe which seed it is at and how the last one ended. Whoever
// crashes, hangs or eats memory is a failure with a seed, and the campaign goes on behind it. The families share
// the time: next comes the one that has had the least of its share, in seconds, not in trials, so that slow
// oracles do not take it all. A family has one batch at once, so that its seeds are tried in order and one number
// says how far.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

#include "tests/campaign/driver/isolated.h"
#include "tests/campaign/driver/state.h"

namespace cnrg::campaign {

struct Options {
  std::optional<double> hours;          ///< from now on
  std::optional<std::uint64_t> trials;  ///< in all, those of the state included
  int jobs = 1;
  std::string state;           ///< file; written every few seconds
  std::string failures;        ///< folder for the cases that failed
  double batch_seconds = 0.5;  ///< of processor time
  int shrink_seconds = 120;    ///< of one failure
  /// How many failures of a family are made smaller; a fault that shows everywhere would take all the time.
  std::size_t most_shrunk = 5;
  std::size_t most_told = 20;  ///< on the log, of each family
  Limits limits;
};

/// Goes on from `state` until the time or the trials are over, or a signal (SIGINT, SIGTERM) asks for the end.
/// Each failure is told on `log` and written to `failures`. Returns false if it was asked to end.
bool run(const Families& families, const Options& options, State& state, std::ostream& log);

/// Makes a failing trial smaller, each step in a process of its own, and writes it to the folder of failures:
/// `FAMILY-SEED.yaml`, whose first lines say what failed and how to repeat it. Returns the path.
std::string write_failure(const Family& family, std::uint64_t seed, const Outcome& outcome, const Options& options,
                          bool shrink);

}  // namespace cnrg::campaign
