// The unit of a sweep: one system on one problem, run in a process with limits and judged in another one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/peers/system.h"
#include "bench/sweep/experiment.h"
#include "bench/sweep/process.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

/// What all units of a sweep share.
struct Setup {
  struct Planned {
    std::size_t experiment;  ///< of `experiments`
    Experiment::Named problem;
  };
  std::vector<Experiment> experiments;
  std::vector<Planned> problems;
  std::optional<double> seconds, gigabytes;  ///< limits of each run in place of those of experiments
  std::vector<System> systems;
  std::string commit;    ///< of the sources; may be empty
  std::string asserted;  ///< the program of systems with assertions (bench/asserted.cpp)

  /// Throws std::runtime_error if there is none of this name.
  const Planned& planned(const std::string& problem) const;
  const Experiment& experiment_of(const std::string& problem) const;
  Problem make(const std::string& problem) const;
  /// Of each run; judging may take five times as long. 60 s and 4 GiB if nobody says anything.
  Limits limits(const std::string& problem) const;
  /// Throws std::runtime_error with the names that there are.
  const System& system(const std::string& name) const;
};

/// Says who agrees with our exact result: Nef polyhedra, else what the experiment claims, else corefinement. One
/// who has another result is told in any case. Throws ProblemError.
Truth establish_truth(const Setup& setup, const std::string& problem);

/// A word as a shell takes it.
std::string quoted(const std::string& word);
/// The whole command that makes a row again.
std::string reproducing_command(const Setup& setup, const std::string& problem, const System& system);

/// Runs and judges; `result` gets what the system gave. Throws ProblemError.
SweepRow run_unit(const Setup& setup, const std::string& problem, const std::string& system, const Truth& truth,
                  std::optional<Model>* result = nullptr);

}  // namespace cnrg::bench
