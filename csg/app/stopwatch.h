// Where the time of a command went.
//
// Times that are measured each by itself leave gaps, and nobody knows what was in them. Here one clock runs from
// the start of the program, and all of its time belongs to the stage that was begun last.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cnrg::app {

/// Seconds since the program began.
double seconds_so_far();

class StageClock {
 public:
  /// Until another stage begins, all time since the start of the program is of this one.
  explicit StageClock(std::string first) : now_(std::move(first)) {}
  void begin(std::string_view stage);
  /// Of a stage, up to now.
  double seconds(std::string_view stage) const;

 private:
  std::string now_;
  double since_ = 0;
  std::map<std::string, double, std::less<>> before_;
};

}  // namespace cnrg::app
