// A clock that is never set back.
#include "csg/app/stopwatch.h"

#include <chrono>

namespace cnrg::app {
namespace {

const auto kStart = std::chrono::steady_clock::now();  // when the program is loaded

}  // namespace

double seconds_so_far() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - kStart).count();
}

void StageClock::begin(std::string_view stage) {
  const double now = seconds_so_far();
  before_[now_] += now - since_;
  now_ = stage;
  since_ = now;
}

double StageClock::seconds(std::string_view stage) const {
  const auto found = before_.find(stage);
  return (found == before_.end() ? 0 : found->second) + (stage == now_ ? seconds_so_far() - since_ : 0);
}

}  // namespace cnrg::app
