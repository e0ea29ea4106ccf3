#include "csg/mesh/deadline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

namespace cnrg {

Deadline::Deadline(const Watch& asked, double seconds, std::string less)
    : asked_(asked),
      seconds_(std::isfinite(seconds) ? seconds : 0),
      until_(Clock::now() + std::chrono::milliseconds(std::llround(1000 * seconds_))),
      less_(std::move(less)) {
  if (!bounded()) {
    watch_ = asked_;
    return;
  }
  watch_.stop = stop_.get_token();
  watch_.progress = [this](std::string_view stage, std::size_t done, std::size_t total) {
    if (stage != stage_) stage_ = stage;
    if (asked_.progress) asked_.progress(stage, done, total);
  };
  passed_on_.emplace(asked_.stop, [this] { stop_.request_stop(); });
  try {
    timer_ = std::jthread([this](const std::stop_token& ends) {
      std::unique_lock lock(mutex_);
      ended_.wait_until(lock, ends, until_, [] { return false; });
      if (ends.stop_requested()) return;
      over_ = true;
      stop_.request_stop();
    });
  } catch (const std::system_error& e) {
    throw FileError(std::string("the system gave no thread for the time of a mesh: ") + e.what() +
                    "; end other programs, raise `ulimit -u`, or mesh with --seconds 0");
  }
}

Deadline::~Deadline() = default;

double Deadline::seconds_left() const {
  if (!bounded()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, std::chrono::duration<double>(until_ - Clock::now()).count());
}

void Deadline::fail() const {
  throw TimeOver("there is no mesh after " + std::to_string(std::llround(seconds_)) +
                 " seconds, which ended in the stage `" + stage_ +
                 "`; give more --seconds, or ask for less: a larger " + less_);
}

}  // namespace cnrg
