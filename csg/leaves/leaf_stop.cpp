#include "csg/leaves/leaf_stop.h"

#include "kernel/base/error.h"

namespace cnrg {
namespace {

thread_local const LeafStop* now = nullptr;
thread_local unsigned steps = 0;

}  // namespace

LeafStop::LeafStop(const std::stop_token& stop) : stop_(stop), before_(now) { now = this; }
LeafStop::~LeafStop() { now = before_; }

std::stop_token LeafStop::token() { return now != nullptr ? now->stop_ : std::stop_token(); }

void LeafStop::check() {
  constexpr unsigned kLooked = 256;  // steps may be short
  if (++steps % kLooked == 0 && now != nullptr && now->stop_.stop_requested()) throw Stopped();
}

}  // namespace cnrg
