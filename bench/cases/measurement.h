// Time by stages and peak memory of one piece of work in its own process.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cnrg::bench {

/// What was measured.
struct Measures {
  std::vector<std::pair<std::string, double>> stages;  ///< seconds
  std::size_t base_bytes = 0;                          ///< resident before the work: the program and its input
  std::size_t peak_bytes = 0;  ///< the most that was resident during the work, the base included
  double seconds() const;
  /// What the work itself took.
  std::size_t own_bytes() const { return peak_bytes > base_bytes ? peak_bytes - base_bytes : 0; }
};

/// Starts when it is made. Memory that earlier work freed is given back to the system before, so that it is not
/// used for free.
class Measurement {
 public:
  Measurement();
  /// Ends a stage; the next one begins.
  void lap(const std::string& stage);
  /// Call it at the end of the last stage, while everything is still there.
  Measures stop();

 private:
  Measures measures_;
  double last_;
};

}  // namespace cnrg::bench
