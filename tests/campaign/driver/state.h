// What a campaign has done so far, as a text file that the next run goes on from.
//
//   cnrg campaign 1
//   family NAME next SEED right N wrong N declined N unknown N seconds S
//   failure NAME SEED VERDICT MESSAGE
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/campaign/driver/family.h"

namespace cnrg::campaign {

struct Tally {
  std::uint64_t next = 0;  ///< the first seed that was not tried
  std::uint64_t right = 0, wrong = 0, declined = 0, unknown = 0;
  double seconds = 0;  ///< of processor time
  std::uint64_t trials() const { return right + wrong + declined + unknown; }
  void add(Verdict verdict);
};

struct Failure {
  std::string family;
  std::uint64_t seed = 0;
  Outcome outcome;
};

struct State {
  std::map<std::string, Tally> tallies;  ///< by family
  std::vector<Failure> failures;

  /// Nothing wrong and nothing declined.
  bool clean() const;
  std::uint64_t trials() const;
};

/// On one line: line breaks and backslashes as `\n` and `\\`, at most 2000 bytes.
std::string one_line(const std::string& text);
/// The text that was put on one line.
std::string from_one_line(const std::string& line);

std::string to_text(const State& state);
/// Throws std::runtime_error with the line that is no line of a state.
State parse_state(const std::string& text);

/// The table of a campaign: family, oracle, trials, right, wrong, declined, unknown, trials/s, hours.
std::string table(const State& state, const Families& families);

}  // namespace cnrg::campaign
