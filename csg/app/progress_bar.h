// A progress bar on standard error, where that is a terminal; nothing elsewhere.
//
// Some stages cannot say how far they are, and others say nothing for minutes: a thread of the bar draws it again
// and again, so that the time on it goes on and a person sees that the program lives. What is left of a
// stage is told from its mean speed; what is left of all of the work where somebody has foretold how long it
// takes.
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
  /// All of the work, which people call `what`, is expected to take at most so many seconds from now.
  void foretell(std::string what, double seconds);
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
  double begun_ = 0, last_ = 0;  // of the stage; drawn
  std::string foretold_;         // all of the work; empty: nothing is foretold
  double until_ = 0;             // when it ends at the latest, by `seconds_so_far`
  std::thread thread_;
};

/// `0:18 left of this stage`, if a hundredth of its steps are done after `seconds`, of which there was one at
/// least.
std::string left_text(std::size_t done, std::size_t total, double seconds);
/// `up to 0:40 left of the mesh`; nothing of nothing, nor below a second.
std::string left_text(const std::string& what, double seconds);

/// The line that a bar shows, at most `columns` wide: stage, how much of it is done if that is known, the time,
/// and if there is room what is left.
std::string progress_line(std::string_view stage, std::size_t done, std::size_t total, double seconds,
                          std::size_t columns, std::string_view left = {});

}  // namespace cnrg::app
