// Steps of curves and of turns, and the count of who uses a curve; see the header.
#include "csg/curves/boundary_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "csg/curves/chord.h"
#include "csg/leaves/leaf.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

/// Lines are multiples of 1 / this.
const Rational& finest() {
  static const Rational n = to_integer(std::int64_t{1} << 40);
  return n;
}

/// The nearest integer.
Rational rounded(const Rational& x) {
  const Rational up = x + Rational(1, 2);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), up.get_num_mpz_t(), up.get_den_mpz_t());
  return whole;
}

}  // namespace

Fineness::Fineness(const char* shape, const Tessellation& tessellation) : shape_(shape) {
  if (tessellation.chord && tessellation.segments) {
    throw InputError(shape_ + ": both chord and segments are given: leave one out");
  }
  if (tessellation.chord) {
    if (*tessellation.chord <= 0) {
      throw LeafKeyError("chord",
                         shape_ + ": chord is " + to_decimal(*tessellation.chord) + ": give a positive length");
    }
    chord_ = to_double(*tessellation.chord);
    if (from_double(chord_) > *tessellation.chord) chord_ = std::nextafter(chord_, 0.0);
    if (chord_ == 0) fail_too_fine();
  }
  if (tessellation.segments) segments_ = *tessellation.segments;
  if (segments_ < 1 || segments_ > kMostSegments) {
    throw LeafKeyError("segments", shape_ + ": segments is " + std::to_string(segments_) + ": give 1 to " +
                                       std::to_string(kMostSegments));
  }
}

void Fineness::join(const Fineness& other) {
  // With a chord steps are powers of two: those of the segments that are asked for besides are rounded up.
  const auto keep = [this](int segments) {
    while (least_ < segments) least_ *= 2;
  };
  if (!by_chord() && !other.by_chord()) {
    segments_ = std::max(segments_, other.segments_);
    return;
  }
  if (!by_chord()) keep(segments_);
  if (!other.by_chord()) keep(other.segments_);
  keep(other.least_);
  if (other.by_chord()) chord_ = by_chord() ? std::min(chord_, other.chord_) : other.chord_;
}

void Fineness::fail_too_fine() const {
  throw InputError(shape_ + ": the chord is too small for this shape, a curve would have more than " +
                   std::to_string(kMostSegments) + " steps: give a larger one");
}

void Fineness::fail_unlike() const {
  throw InputError(shape_ +
                   ": leaves that share its curves ask for numbers of segments without a common factor, "
                   "and very large ones: give powers of two");
}

void Fineness::check_facets(double count) const {
  constexpr std::int64_t kMost = 10'000'000;
  if (count <= static_cast<double>(kMost)) return;
  throw InputError(shape_ + ": it would have more than " + std::to_string(kMost) + " facets: give " +
                   (by_chord() ? "a larger chord" : "fewer segments"));
}

int Fineness::steps_of_turn(double radius, double degrees) const {
  const double turns = degrees / 360;
  if (!by_chord()) return static_cast<int>(std::ceil(std::max(3, segments_) * turns));
  int n = 8;  // of a full turn; M = radius (2 pi)^2, and half of the chord is for the profile
  for (double bound = radius * 39.4784176044 / 8 / 64 * (1 + 1e-9); bound > chord_ / 2; bound /= 4) {
    n *= 2;
    if (n > kMostSegments) fail_too_fine();
  }
  return static_cast<int>(std::ceil(n * turns));
}

std::vector<Rational> CurveSteps::inside(bool backward) const {
  std::vector<Rational> result;
  for (int k = 1; k < even; ++k) result.push_back(fraction(k, even));
  for (const Rational& line : lines) {
    const Rational apart = line - rounded(line * even) / even;
    if (2 * abs(apart) * finest() > 1) result.push_back(line);
  }
  if (!lines.empty()) std::sort(result.begin(), result.end());
  if (!backward) return result;
  std::reverse(result.begin(), result.end());
  for (Rational& t : result) t = 1 - t;
  return result;
}

std::set<Rational> rounded_lines(const std::set<Rational>& lines) {
  std::set<Rational> result;
  for (const Rational& t : lines) {
    const Rational near = rounded(t * finest()) / finest();
    if (sgn(near) > 0 && near < 1) result.insert(near);
  }
  return result;
}

std::vector<Rational> BoundaryCurves::inside(const BezierCurve& curve) {
  const CanonicalCurve least = canonical(curve);
  return of(least).inside(least.reversed);
}

int BoundaryCurves::steps(const BezierCurve& curve) { return of(canonical(curve)).even; }

const CurveSteps& BoundaryCurves::of(const CanonicalCurve& curve) {
  const BezierCurve& least = curve.curve;
  const auto [place, is_new] = steps_.try_emplace(least.net);
  CurveSteps& found = place->second;
  if (!is_new || least.degree() == 0 || least.is_point()) return found;
  int& n = found.even;
  if (agreed_ != nullptr) {
    const auto agreed = agreed_->find(least.net);
    if (agreed != agreed_->end()) return found = agreed->second;
  }
  if (!fineness_.by_chord()) {
    n = least.degree() == 1 ? 1 : fineness_.segments();
    return found;
  }
  n = least.degree() == 1 ? 1 : fineness_.least();
  const PatchChord chord(BezierPatch{{least.net}});
  for (bool fine = false; !fine;) {
    fine = true;
    for (int i = 0; i < n && fine; ++i) {
      fine = chord.terms({static_cast<double>(i) / n, 0}, {static_cast<double>(i + 1) / n, 1}).sum() <=
             fineness_.chord() / 2;
    }
    if (!fine) n *= 2;
    if (n > Fineness::kMostSegments) fineness_.fail_too_fine();
  }
  return found;
}

void BoundaryCurves::use(const BezierCurve& curve, const std::string& name) {
  if (curve.is_point()) return;
  const CanonicalCurve c = canonical(curve);
  Uses& uses = uses_[c.curve.net];
  if (uses.first.empty()) uses.first = name;
  ++(c.reversed ? uses.backward : uses.forward);
}

int BoundaryCurves::uses(const BezierCurve& curve) const {
  if (curve.is_point()) return 0;
  const Uses& uses = uses_.at(canonical(curve).curve.net);
  return uses.forward + uses.backward;
}

void BoundaryCurves::check_closed(Fill fill) const {
  if (fill != Fill::winding && fill != Fill::parity) return;
  const Uses* open = nullptr;
  std::size_t count = 0;
  bool oriented_only = fill == Fill::winding;
  const ControlRow* where = nullptr;
  for (const auto& [net, uses] : uses_) {
    const bool even = (uses.forward + uses.backward) % 2 == 0;
    if (fill == Fill::winding ? uses.forward == uses.backward : even) continue;
    oriented_only = oriented_only && even;
    if (!open) open = &uses, where = &net;
    ++count;
  }
  if (!open) return;
  const std::string parity = fill == Fill::parity ? "parity" : "winding";
  throw InputError(fineness_.shape() + ": fill is " + parity + ", but the patches are " +
                   (oriented_only ? "not oriented alike along " : "not closed along ") + std::to_string(count) +
                   (count == 1 ? " curve" : " curves") + ", such as " + open->first + ", from " +
                   describe(project(where->front())) + " to " + describe(project(where->back())) + ": " +
                   (oriented_only
                        ? "turn patches round (reverse the rows), or give `fill: parity` or `fill: cells`"
                        : "give patches that meet in sides with equal control points, or `fill: cells`"));
}

}  // namespace cnrg
