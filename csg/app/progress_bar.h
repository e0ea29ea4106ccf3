// A progress bar on standard error, where that is a terminal; nothing elsewhere.
//
// Some stages cannot say how far they are, and others say nothing for minutes: a thread of the bar draws it again
// and again, so that the time on it goes on and a person sees that the program lives. What is left of a stage is
// told from its steps; what is left of all of the work only where somebody has foretold how long that takes.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "kernel/base/progress.h"

namespace cnrg::app {

/// What somebody has foretold.
struct Foretold {
  std::string what{};    ///< all of the work; empty: nothing is foretold
  double until = 0;      ///< when it ends, by `seconds_so_far`
  bool at_most = false;  ///< it may be sooner
};

class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// As `cnrg::Progress` has it. Draws a new stage at once and the same stage ten times a second at most.
  void show(std::string_view stage, std::size_t done = 0, std::size_t total = 0);
  /// All of the work, which people call `what`, is expected to take so many seconds from now, or at most so many.
  void foretell(std::string what, double seconds, bool at_most);
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
  double begun_ = 0, last_ = 0;  // of the stage, and of what was drawn
  Foretold foretold_;
  std::thread thread_;
};

/// Seconds until all steps of a stage are done, at its speed so far; nothing in its first second and before a
/// hundredth of them is done, where steps are not known, and at the end.
std::optional<double> left_of_stage(std::size_t done, std::size_t total, double seconds);

/// `0:18 left of this stage` where `of_stage` (seconds) is known; else `about 0:40 left of the mesh`, or `up to`,
/// until what was foretold is over; else nothing.
std::string left_text(std::optional<double> of_stage, const Foretold& foretold, double now);

/// The line that a bar shows, at most `columns` wide: stage, how much of it is done if that is known, the time,
/// and if there is room what is left.
std::string progress_line(std::string_view stage, std::size_t done, std::size_t total, double seconds,
                          std::size_t columns, std::string_view left = {});

}  // namespace cnrg::app
