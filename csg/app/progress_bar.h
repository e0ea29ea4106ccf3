// A progress bar on standard error, where that is a terminal; nothing elsewhere.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace cnrg::app {

class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// As `cnrg::Progress` has it. Draws a new stage at once and the same stage ten times a second at most.
  void show(std::string_view stage, std::size_t done, std::size_t total);
  /// Removes the bar, before other text is written.
  void clear();

 private:
  bool active_ = false, drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace cnrg::app
