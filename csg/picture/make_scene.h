// From the cells of a node to what stands before the camera: which of them are shown, where, and how they look.
#pragma once

#include <optional>

#include "csg/geometry/transform.h"
#include "csg/picture/cells.h"
#include "csg/picture/draw.h"
#include "csg/picture/scene.h"
#include "csg/result/palette.h"

namespace cnrg {

// A camera far away: the model turned so that x goes to the right of the picture, y up, and z towards who looks.
//
// A rotation by 30 degrees has no fractions; a rounded one would not be a rotation, and points of one plane would
// not stay in it. So a camera stands at the nearest angle whose sine and cosine are fractions, s = 2t / (1 + t^2)
// and c = (1 - t^2) / (1 + t^2), where t is a multiple of 1/512: nobody sees the quarter of a degree, and what
// hides what is decided exactly. Denominators are multiplied away: coordinates of few bits stay doubles.

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

/// A group's components are its regions and, as one more, all of its entities: then a color for each region.
ColorBy colors_by(const ResultView& view, const std::optional<ColorBy>& asked = {});

/// In the camera's space. Facets of it may cross where regions were pulled apart (options.apart).
Scene make_scene(const ResultView& view, const FlatComplex& flat, const PictureCells& cells,
                 const DrawOptions& options, const Camera& camera);

/// Adds cells as ghosts.
void add_ghosts(const Complex& complex, const FlatComplex& flat, const Camera& camera, Scene& scene);

/// What is seen of a scene in the space of a camera, in light and shade.
Figure figure_of(Scene& scene, const Camera& camera, int threads);

/// The same scene with facets that cross, cut where they do.
Scene without_crossings(const Scene& scene, int threads);

}  // namespace cnrg
