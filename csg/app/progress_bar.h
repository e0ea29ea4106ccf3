// A progress bar on standard error, where that is a terminal; nothing elsewhere.
//
// Some stages cannot say how far they are, and TetGen says nothing for minutes: a thread of the bar draws it again
// and again, so that the time on it goes on and a person sees that the program lives.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "kernel/base/progress.h"

namespace cnrg::app {

class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// As `cnrg::Progress` has it. Draws a new stage at once and the same stage ten times a second at most.
  void show(std::string_view stage, std::size_t done = 0, std::size_t total = 0);
  /// What tells this bar of long work.
  Progress progress();
  /// Removes the bar, before other text is written.
  void clear();

 private:
  void draw();
  void keep_drawing();

  const bool active_;
  std::mutex mutex_;  // of all below but the thread
  std::condition_variable ended_;
  bool ends_ = false, drawn_ = false;
  std::string stage_;
  std::size_t done_ = 0, total_ = 0;
  double last_ = 0;
  std::thread thread_;
};

/// The line that a bar shows, at most `columns` wide: stage, how much of it is done if that is known, and the
/// time.
std::string progress_line(std::string_view stage, std::size_t done, std::size_t total, double seconds,
                          std::size_t columns);

}  // namespace cnrg::app
