// Long work tells how far it is, and may be stopped.
//
// Who waits for it wants to hear of both on its own thread alone, while loops run on all of them. So a loop counts
// its steps wherever they are done, and tells of them on the thread that began it. A stop is asked for by a token
// that any thread may read: each step looks at it, and the exception ends the loop as any other would.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string_view>
#include <thread>

#include "kernel/base/error.h"

namespace cnrg {

/// Called at the beginning of a stage (done = 0) and after some of its steps, always on the thread that asked for
/// the work; `total` is 0 when it is not known. What it throws ends the work.
using Progress = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

/// Who is told of long work, and who may stop it; both may be empty.
struct Watch {
  Progress progress{};
  std::stop_token stop{};

  /// A stage begins; throws Stopped, if that was asked for.
  void begin(std::string_view stage, std::size_t total = 0) const {
    check();
    if (progress) progress(stage, 0, total);
  }
  /// Throws Stopped, if that was asked for. Any thread may call it.
  void check() const {
    if (stop.stop_requested()) throw Stopped();
  }
};

/// The steps of a loop, done by any thread.
class Steps {
 public:
  /// Made by the thread that begins the loop. Of the texts of stages only the address is kept.
  Steps(const Watch& watch, std::string_view stage, std::size_t total)
      : watch_(watch), stage_(stage), total_(total), owner_(std::this_thread::get_id()) {
    watch.begin(stage, total);
  }
  /// After each step: throws Stopped, if that was asked for.
  void step() {
    watch_.check();
    if (!watch_.progress) return;
    const std::size_t done = done_.fetch_add(1, std::memory_order_relaxed) + 1;
    if ((done % kTold == 0 || done == total_) && std::this_thread::get_id() == owner_)
      watch_.progress(stage_, done, total_);
  }

 private:
  static constexpr std::size_t kTold = 64;  // steps may be short
  const Watch& watch_;
  std::string_view stage_;
  std::size_t total_;
  std::thread::id owner_;
  std::atomic<std::size_t> done_{0};
};

}  // namespace cnrg
