// How long a stage of work will still take, told from how fast it has been.
//
// The speed since the beginning remembers slow first steps for ever, and the speed of the last step jumps. So
// speeds are averaged with weights that fall off with their age. Where nothing is heard the speed falls, too: work
// that stands still is not told to be done soon.
#pragma once

#include <cstddef>
#include <optional>

namespace cnrg::app {

/// Times are in seconds, by any clock that is never set back; the caller has it.
class Pace {
 public:
  /// A stage begins.
  void begin(double now);
  /// So many of its steps are done. Fewer than before: it begins anew.
  void see(std::size_t done, std::size_t total, double now);
  /// Seconds until all steps are done; nothing in the first second of a stage and before a hundredth of them is
  /// done, where steps are not known, and at the end.
  std::optional<double> left(double now) const;

 private:
  double begun_ = 0;
  double since_ = 0;         // when the speed was taken last
  std::size_t counted_ = 0;  // steps that were done then
  std::size_t done_ = 0, total_ = 0;
  std::optional<double> speed_;  // steps in a second

  std::optional<double> speed(double now) const;
};

}  // namespace cnrg::app
