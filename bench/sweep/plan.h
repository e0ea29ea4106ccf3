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
  std::optional<int> seeds, first_seed;  ///< how many, and the first one
  std::size_t limit = 0;                 ///< at most so many problems, spread evenly; 0: all
};

struct Plan {
  std::string folder;                 ///< of mesh files, absolute; empty: problems are of families
  std::vector<std::string> problems;  ///< names, in the order of the families
};

/// Throws std::runtime_error for unknown names (with those that there are), a folder among other names, and for
/// what was chosen and applies to none of the names.
Plan plan_of(const Choice& choice);

}  // namespace cnrg::bench
