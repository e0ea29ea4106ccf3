// The unit of a sweep: one system on one problem, run in a process with limits and judged in another one.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bench/cases/child.h"
#include "bench/cases/family.h"
#include "bench/peers/system.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

/// The problem itself cannot be made, such as one of a mesh file that is broken.
class ProblemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The family of problems of a folder, in rows.
inline constexpr const char* kFilesFamily = "files";

/// What all units of a sweep share.
struct Setup {
  std::string folder;                       ///< of mesh files; empty: problems are of families
  Limits limits{60, std::size_t{4} << 30};  ///< of each run; judging may take five times as long
  std::vector<System> systems;
  std::string commit;  ///< of the sources; may be empty
  Problem make(const std::string& problem) const;
  /// Throws std::runtime_error with the names that there are.
  const System& system(const std::string& name) const;
};

/// Says who agrees with our exact result: Nef polyhedra, else corefinement. Throws ProblemError.
Truth establish_truth(const Setup& setup, const std::string& problem);

/// A word as a shell takes it.
std::string quoted(const std::string& word);
/// The whole command that makes a row again.
std::string reproducing_command(const Setup& setup, const std::string& problem, const System& system);

/// Runs and judges. Throws ProblemError.
SweepRow run_unit(const Setup& setup, const std::string& problem, const std::string& system, const Truth& truth);

}  // namespace cnrg::bench
