// A mesh that has to be there by the clock.
//
// All loops of meshing look at a stop token. So time is nothing more to ask for between their steps: when it is
// over, the token of the work is stopped, and who began the work says why. A bound for each part of the work, the
// obvious way, bounds nothing: parts are many, and which of them a model needs shows on the way.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "kernel/base/error.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// A mesh that did not end in the time that it was given.
class TimeOver : public InputError {
 public:
  using InputError::InputError;
};

class Deadline {
 public:
  /// `asked`: who waits for the work. So many seconds from now by the clock; 0 or infinitely many: never, and no
  /// thread is begun. `less`: what takes less time, for the message. Throws FileError if the system gives no
  /// thread.
  Deadline(const Watch& asked, double seconds, std::string less = "--size, --quality or --max-volume");
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// For the work: stopped by who waits for it, and by the clock.
  const Watch& watch() const { return watch_; }
  /// For what has to end although time is over.
  const Watch& asked() const { return asked_; }
  bool bounded() const { return seconds_ > 0; }
  bool over() const { return over_; }
  /// Infinite where there is no bound, never negative.
  double seconds_left() const;

  /// Does the work; throws TimeOver, with the time and the stage that was told last, where the clock ends it.
  template <class Work>
  auto run(const Work& work) const {
    try {
      return work();
    } catch (const Stopped&) {
      if (asked_.stop.stop_requested() || !over_) throw;
    }
    fail();
  }

 private:
  using Clock = std::chrono::steady_clock;
  const Watch asked_;
  const double seconds_;  // 0: no bound
  const Clock::time_point until_;
  const std::string less_;
  std::stop_source stop_;
  Watch watch_;
  std::string stage_ = "mesh";  // of the thread that asked for the work, which alone is told
  std::atomic<bool> over_{false};
  std::optional<std::stop_callback<std::function<void()>>> passed_on_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread timer_;  // the last member: it ends before what it uses

  [[noreturn]] void fail() const;
};

}  // namespace cnrg
