// The folder of a sweep: a file per unit, each written whole or not at all, so that a sweep can be killed at any
// moment and goes on where it was.
//
//   settings.json                 what all units have in common; the same command goes on, another one is refused
//   truth/PROBLEM.json            who confirms the exact result
//   rows/PROBLEM/SYSTEM.json      one row
//   rows/{systems,families,machine}.json    what a report says of them (bench/sweep/description.h)
#pragma once

#include <optional>
#include <string>

#include "bench/sweep/unit.h"

namespace cnrg::bench {

class Store {
 public:
  /// Makes the folders. Throws std::runtime_error if they cannot be made.
  explicit Store(const std::string& folder);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Writes the settings, or compares them with those that are there: commit, limits, folder of meshes, programs
  /// of the user, of which new ones may come. Throws std::runtime_error that says what differs and what to do.
  void settle(const Setup& setup);
  /// What could not be made of a folder of meshes, and why.
  using LeftOut = std::vector<std::pair<std::string, std::string>>;
  /// Writes what the report says of systems, families and this machine. What earlier commands said stays.
  void describe(const Setup& setup, const std::string& command, const LeftOut& left_out) const;
  /// Only one sweep at a time. Throws std::runtime_error if another one has the folder.
  void lock();

  std::string truth_path(const std::string& problem) const;
  std::string row_path(const std::string& problem, const std::string& system) const;
  /// Nothing when there is none yet. Throws std::runtime_error for a broken file, naming it.
  /// Also for one of another experiment than `of`, a path.
  std::optional<Truth> truth(const std::string& problem, const std::string& of) const;
  bool has_row(const std::string& problem, const std::string& system) const;
  void write_truth(const std::string& problem, const Truth& truth) const;
  void write_row(const SweepRow& row) const;

 private:
  std::string folder_;
  int lock_ = -1;
};

/// Writes beside and renames; the text is on the disk before. Throws std::runtime_error.
void write_whole(const std::string& path, const std::string& text);

}  // namespace cnrg::bench
