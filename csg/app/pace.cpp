#include "csg/app/pace.h"

#include <cmath>

namespace cnrg::app {
namespace {

constexpr double kFirst = 1;      // seconds before anything is told
constexpr double kSample = 0.25;  // seconds that a speed is taken over at least
constexpr double kLeast = 0.01;   // part of the steps that is done
constexpr double kMemory = 4;     // seconds after which a speed counts 1 / e of what it did

}  // namespace

void Pace::begin(double now) {
  *this = {};
  begun_ = since_ = now;
}

void Pace::see(std::size_t done, std::size_t total, double now) {
  if (done < done_) begin(now);
  done_ = done;
  total_ = total;
  if (now - begun_ < kFirst || now - since_ < kSample) return;
  speed_ = speed(now);
  since_ = now;
  counted_ = done;
}

std::optional<double> Pace::speed(double now) const {
  const double time = now - since_;
  if (time <= 0) return speed_;
  const double last = double(done_ - counted_) / time;
  if (!speed_) return last;
  return *speed_ + (1 - std::exp(-time / kMemory)) * (last - *speed_);
}

std::optional<double> Pace::left(double now) const {
  if (double(done_) < kLeast * double(total_) || done_ >= total_ || now - begun_ < kFirst) return std::nullopt;
  const std::optional<double> so_fast = speed(now);
  if (!so_fast || *so_fast <= 0) return std::nullopt;
  return double(total_ - done_) / *so_fast;
}

}  // namespace cnrg::app
