// What bench_speed says: a table per case with its targets, summaries of groups, a JSON file.
#pragma once

#include <string>
#include <vector>

#include "bench/peers/peer.h"

namespace cnrg::bench {

/// One system on one case.
struct Row {
  std::string system;
  bool ours = false;
  std::vector<Measures> runs;
  Outcome checked;      ///< of the first run
  std::string failure;  ///< why there is no result; then the rest means nothing
  bool wrong = false;   ///< the volume is not that of the oracle
  bool done() const { return failure.empty() && !runs.empty(); }
  double median_seconds() const;
  double least_seconds() const;
  std::size_t peak_bytes() const;  ///< the largest of the runs, with the input
  std::size_t own_bytes() const;   ///< the largest of the runs, without the input
};

/// The operation of cases that are trees.
inline constexpr const char* kEvaluation = "evaluation";

struct CaseResult {
  std::string name, group, operation;
  std::size_t leaves = 0, triangles = 0, input_cells = 0;
  std::vector<Row> rows;  ///< ours come first
  std::string oracle;     ///< what the volumes were compared with; empty: nothing
  bool of_trees() const { return operation == kEvaluation; }
  const Row& ours() const { return rows[0]; }
  const Row* find(const std::string& system) const;  ///< nullptr unless it has a result
  /// Nothing of ours failed, is wrong or invalid.
  bool right() const;
  /// Seconds per cell of the input and of the refinement, by the median of our first row.
  double seconds_per_cell() const;
};

/// The case that degenerate ones are compared with.
inline constexpr const char* kGeneralPosition = "spheres10k";
inline constexpr const char* kCorefinement = "CGAL corefinement";
inline constexpr const char* kNef = "CGAL Nef";
inline constexpr const char* kNefOneByOne = "Nef, one by one";

/// Compares the volumes with the oracle (the case's own number, else Nef, else corefinement) and marks wrong rows.
/// Exact volumes must be equal, rounded ones agree to 1e-9.
void judge(CaseResult& result, const std::optional<long long>& volume);

void print_case(const CaseResult& result);
/// Growth with size and number of leaves, and degenerate cases against general position, as far as they ran.
void print_summary(const std::vector<CaseResult>& results);

/// All cases in one: the median seconds of each system, blank where it has no result or does not take the case.
void print_table(const std::vector<CaseResult>& results);

/// In the file the results replace those of the same cases; others stay. Throws std::runtime_error if it is no
/// such file or cannot be written.
void write_json(const std::string& path, const std::string& commit, const std::vector<CaseResult>& results);

}  // namespace cnrg::bench
