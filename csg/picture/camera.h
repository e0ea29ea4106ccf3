// A camera far away: the model turned so that x goes to the right of the picture, y up, and z towards who looks.
//
// A rotation by 30 degrees has no fractions; a rounded one would not be a rotation, and points of one plane would
// not stay in it. So a camera stands at the nearest angle whose sine and cosine are fractions, s = 2t / (1 + t^2)
// and c = (1 - t^2) / (1 + t^2), where t is a multiple of 1/512: nobody sees the quarter of a degree, and what
// hides what is decided exactly. Denominators are multiplied away: coordinates of few bits stay doubles.
#pragma once

#include "csg/geometry/transform.h"
#include "csg/picture/draw.h"

namespace cnrg {

class Camera {
 public:
  explicit Camera(const DrawOptions::Camera& angles);
  /// Where a point of the model is in the picture, and how near: all three `scale` times as long.
  RationalPoint view(const RationalPoint& p) const { return turn_.apply(p); }
  /// From the model to who looks.
  const RationalPoint& towards() const { return towards_; }
  const Rational& scale() const { return scale_; }

 private:
  Transform turn_;
  RationalPoint towards_;
  Rational scale_;
};

}  // namespace cnrg
