// The curves in which patches meet, sampled so that the facets on both sides fit.
//
// If each patch chose the steps of its sides, a fine one and a coarse one would leave a gap between them. Here the
// steps of a side follow from the curve alone: not from the patch, the direction in which it runs the curve, the
// scale of its weights or a degree higher than need be. So two patches, of one leaf or of two, get the same
// vertices where they meet. Steps of a curve are equal in its parameter and a power of two in number (with
// `chord`), so that vertices have short coordinates and a curve run backward has the same ones.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "csg/curves/bezier.h"
#include "csg/leaves/shapes.h"

namespace cnrg {

/// The fineness that a shape asks for, checked; `shape` names it in messages.
class Fineness {
 public:
  /// Of any circle or curve: of a million, oblique, the exact points alone take half a minute and gigabytes.
  static constexpr int kMostSegments = 500'000;
  static constexpr int kUsualSegments = 16;  ///< where nothing is asked for
  Fineness(const char* shape, const Tessellation& tessellation);
  bool by_chord() const { return chord_ > 0; }
  /// Not above what is asked for; 0 where the number of steps is given.
  double chord() const { return chord_; }
  int segments() const { return segments_; }
  /// From now on at least as fine as `other` asks for, too.
  void join(const Fineness& other);
  /// With a chord: the steps of a curve or patch to begin with, a power of two; 1 unless joined.
  int least() const { return least_; }
  const std::string& shape() const { return shape_; }
  /// Steps of a whole turn: three at least, and with `chord` eight, so that a turn is round at any size.
  int steps_of_turn(double radius, double degrees) const;
  [[noreturn]] void fail_too_fine() const;
  /// For a patch whose sides have steps, from several leaves, that go into no common grid.
  [[noreturn]] void fail_unlike() const;
  /// Throws InputError for a number of facets that no machine of today holds.
  void check_facets(double count) const;

 private:
  std::string shape_;
  double chord_ = 0;
  int segments_ = kUsualSegments;
  int least_ = 1;
};

/// Where a curve has vertices.
struct CurveSteps {
  int even = 1;
  std::set<Rational> lines{};  ///< parameters of further ones, between 0 and 1
  /// The parameters of all but the ends, ascending, or those of the curve run backward. A line that is a step but
  /// for 2^-41 is none.
  std::vector<Rational> inside(bool backward = false) const;
};

/// Multiples of 2^-40 between 0 and 1, the nearest ones.
std::set<Rational> rounded_lines(const std::set<Rational>& lines);

/// Steps of curves, by their canonical nets, that leaves have agreed on (csg/carriers).
using AgreedSteps = std::map<ControlRow, CurveSteps>;

class BoundaryCurves {
 public:
  /// Both must outlive this.
  explicit BoundaryCurves(const Fineness& fineness, const AgreedSteps* agreed = nullptr)
      : fineness_(fineness), agreed_(agreed) {}

  /// Equal steps that keep segments within half of the chord (the other half is for the facets beside it: see
  /// patch_mesh.h). One for what is straight and for a point. Of a curve that leaves have agreed on, theirs.
  int steps(const BezierCurve& curve);
  /// The parameters of these steps but for the ends, and of further lines that leaves have agreed on.
  std::vector<Rational> inside(const BezierCurve& curve);

  /// Notes that a patch has `curve` as a side; `name` is for messages.
  void use(const BezierCurve& curve, const std::string& name);
  /// How many patches have it as a side, in either direction; 0 for a point.
  int uses(const BezierCurve& curve) const;
  /// Throws InputError unless every curve is used as often in one direction as in the other (or, for parity, an
  /// even number of times).
  void check_closed(Fill fill) const;

 private:
  struct Uses {
    int forward = 0, backward = 0;
    std::string first;
  };
  const Fineness& fineness_;
  const AgreedSteps* agreed_;
  const CurveSteps& of(const CanonicalCurve& curve);
  std::map<ControlRow, CurveSteps> steps_;
  std::map<ControlRow, Uses> uses_;
};

}  // namespace cnrg
