// Counts of segments and layers.
#include "csg/openscad/fineness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/base/hypotenuse.h"

namespace cnrg::openscad {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

/// A count of pieces that a formula gives; no larger than what the limits of leaves refuse anyway.
int count(double pieces, double least) {
  return static_cast<int>(std::clamp(std::ceil(pieces), least, 10'000'000.0));
}

/// Each turn has at least three layers.
double least_layers(double twist) { return std::max(std::ceil(twist / 120), 1.0); }

/// The length of the spiral r = a t from its centre to the angle t.
double spiral_length(double a, double t) {
  const double root = std::sqrt(1 + t * t);
  return a / 2 * (t * root + std::log(std::abs(t + root)));
}

}  // namespace

double sine(double degrees) {
  double x = std::fmod(degrees, 360);
  if (x < 0) x += 360;
  const bool below = x >= 180;
  if (below) x -= 180;
  if (x > 90) x = 180 - x;
  const double value = x == 30   ? 0.5
                       : x == 45 ? std::numbers::sqrt2 / 2
                       : x == 60 ? std::sqrt(0.75)
                       : x < 45  ? std::sin(x * kRadians)
                                 : std::cos((90 - x) * kRadians);
  return below ? -value : value;
}

double cosine(double degrees) {
  double x = std::fmod(degrees, 360);
  if (x < 0) x += 360;
  if (x > 180) x = 360 - x;
  const bool left = x > 90;
  if (left) x = 180 - x;
  const double value = x == 30   ? std::sqrt(0.75)
                       : x == 45 ? std::numbers::sqrt2 / 2
                       : x == 60 ? 0.5
                       : x > 45  ? std::sin((90 - x) * kRadians)
                                 : std::cos(x * kRadians);
  return left ? -value : value;
}

/// Too small to be divided.
bool Fineness::is_plain(double length) const { return length < kFineGrid || !std::isfinite(fn); }

int Fineness::segments(double radius) const {
  if (is_plain(radius)) return 3;
  if (fn > 0) return count(std::floor(fn), 3);
  return count(std::min(360 / fa, radius * 2 * std::numbers::pi / fs), 5);
}

int Fineness::helix_layers(double radius, double height, double twist) const {
  twist = std::abs(twist);
  const double least = least_layers(twist);
  if (is_plain(radius)) return count(least, 1);
  if (fn > 0) return count(twist / 360 * fn, least);
  const double turn = twist * kRadians, rise = height / turn;
  const double length = turn * std::sqrt(radius * radius + rise * rise);
  return count(std::min(std::ceil(twist / fa), std::ceil(length / fs)), least);
}

int Fineness::conical_layers(double radius, double height, double twist, double scale) const {
  twist = std::abs(twist);
  const double least = least_layers(twist);
  if (is_plain(radius)) return count(least, 1);
  if (fn > 0) return count(twist * fn / 360, least);
  const double turn = twist * kRadians;
  const double end = scale > 1 ? turn * scale / (scale - 1) : turn / (1 - scale);
  const double a = radius / end;
  const double flat = spiral_length(a, end) - spiral_length(a, end - turn);
  return count(std::min(std::ceil(twist / fa), std::ceil(hypotenuse(flat, height) / fs)), least);
}

int Fineness::diagonal_layers(double shift, double height) const {
  if (is_plain(shift)) return 1;
  if (fn > 0) return count(std::floor(fn), 1);
  return count(hypotenuse(shift, height) / fs, 1);
}

}  // namespace cnrg::openscad
