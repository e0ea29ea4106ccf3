// What a report is made of: a folder of rows, and what is known of the systems, the families and the machine.
//
//   FOLDER/systems.json    a list of `SystemInfo`, in the order of the report, ours first
//   FOLDER/families.json   a list of `FamilyInfo`, in the order of the report
//   FOLDER/machine.json    a `MachineInfo`
//   FOLDER/**/*.json       one row each (bench/sweep/row.h); hidden files and folders are not looked at
//
// The first three may be missing: then the report says so and orders by name.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/sweep/row.h"

namespace cnrg::bench {

/// What bench/peers/system.h says of a system.
struct SystemInfo {
  std::string name, title, guarantee, version;
  double rounding = 0;
  bool regularized = true;
  std::string absent;
};

/// What bench/cases/family.h says of a family.
struct FamilyInfo {
  std::string name, title, size_means;
};

struct MachineInfo {
  std::string cpu;               ///< model name
  unsigned cores = 0;            ///< that the system shows
  std::size_t memory_bytes = 0;  ///< main memory
  std::string system, compiler;  ///< operating system; compiler with its version and options
  std::string commit, date;      ///< of the sources; of the sweep, such as 2026-11-21
  double limit_seconds = 0;      ///< of a run, wall time; 0: none
  std::size_t limit_bytes = 0;   ///< of a run, address space; 0: none
  std::string command;           ///< that made the rows; several one after the other
  /// Problems that could not be made, such as those of a mesh file that is broken, and why.
  std::vector<std::pair<std::string, std::string>> left_out{};
};

inline constexpr const char* kSystemsFile = "systems.json";
inline constexpr const char* kFamiliesFile = "families.json";
inline constexpr const char* kMachineFile = "machine.json";
/// The system that others are compared with.
inline constexpr const char* kOurs = "ours";

/// JSON and back; the readers throw std::runtime_error with the member that is wrong.
std::string to_json(const std::vector<SystemInfo>& systems);
std::string to_json(const std::vector<FamilyInfo>& families);
std::string to_json(const MachineInfo& machine);
std::vector<SystemInfo> systems_of_json(const std::string& text);
std::vector<FamilyInfo> families_of_json(const std::string& text);
MachineInfo machine_of_json(const std::string& text);

struct Experiment {
  /// Every system and family of a row is there, then with its name only if no file describes it.
  std::vector<SystemInfo> systems;
  std::vector<FamilyInfo> families;
  std::optional<MachineInfo> machine;
  std::vector<SweepRow> rows;  ///< by family, problem (numbers in names by value) and system
};

/// Completes the lists of systems and families and sorts. Throws std::runtime_error if a system has two rows of
/// one problem, or if there is no row.
Experiment make_experiment(std::vector<SweepRow> rows, std::vector<SystemInfo> systems,
                           std::vector<FamilyInfo> families, std::optional<MachineInfo> machine);

/// Reads a folder; `machine_file` replaces its machine.json unless it is empty. Throws std::runtime_error that
/// names the file and what to do if one is broken, and if the folder or its rows are missing.
Experiment read_experiment(const std::string& folder, const std::string& machine_file = "");

}  // namespace cnrg::bench
