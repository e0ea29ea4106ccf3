// What a sweep says of itself beside its rows, for those who read them:
//
//   rows/systems.json    a list of `SystemInfo`, in the order of the systems, ours first
//   rows/families.json   a list of `FamilyInfo`
//   rows/machine.json    a `MachineInfo`
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bench/peers/system.h"

namespace cnrg::bench {

/// What bench/peers/system.h says of a system.
struct SystemInfo {
  std::string name, title, guarantee, version;
  double rounding = 0;
  bool regularized = true;
  std::string absent;
  Variation varies{};
};

/// What an experiment says of itself (experiment.h).
struct FamilyInfo {
  std::string name, title, size_means, distance_means, growth;
};

struct MachineInfo {
  std::string cpu;               ///< model name
  unsigned cores = 0;            ///< that the system shows
  std::size_t memory_bytes = 0;  ///< main memory
  std::string system, compiler;  ///< operating system; compiler with its version and options
  std::string commit, date;      ///< of the sources; of the sweep, such as 2026-11-21
  std::string command;           ///< that made the rows; several one after the other
  /// Problems that could not be made, such as those of a mesh file that is broken, and why.
  std::vector<std::pair<std::string, std::string>> left_out{};
};

inline constexpr const char* kSystemsFile = "systems.json";
inline constexpr const char* kFamiliesFile = "families.json";
inline constexpr const char* kMachineFile = "machine.json";

/// JSON and back; the readers throw std::runtime_error with the member that is wrong. A sweep that goes on reads
/// systems and machine again.
std::string to_json(const std::vector<SystemInfo>& systems);
std::string to_json(const std::vector<FamilyInfo>& families);
std::string to_json(const MachineInfo& machine);
std::vector<FamilyInfo> families_of_json(const std::string& text);
std::vector<SystemInfo> systems_of_json(const std::string& text);
MachineInfo machine_of_json(const std::string& text);

}  // namespace cnrg::bench
