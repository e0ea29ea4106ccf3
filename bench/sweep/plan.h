// Which problems a sweep has.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cnrg::bench {

/// What the user chose; what is empty is as the family usually has it (family.h).
struct Choice {
  std::vector<std::string> names;  ///< families, whole problem names, or one folder; `all`: all families
  std::vector<long> sizes;
  std::vector<std::string> distances;  ///< `exact` and 0 to 16
  std::vector<std::string> operations;
  int seeds = 0;  ///< seeds 1 to this; 0: as usual
  int first_seed = 1;
  std::size_t limit = 0;  ///< at most so many problems, spread evenly; 0: all
};

struct Plan {
  std::string folder;                 ///< of mesh files, absolute; empty: problems are of families
  std::vector<std::string> problems;  ///< names, in the order of the families
};

/// Throws std::runtime_error for unknown names (with those that there are), a folder among other names, a choice
/// that leaves nothing.
Plan plan_of(const Choice& choice);

}  // namespace cnrg::bench
