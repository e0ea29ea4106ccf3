// From the cells of a node to what stands before the camera: which of them are shown, where, and how they look.
#pragma once

#include <optional>

#include "csg/picture/camera.h"
#include "csg/picture/cells.h"
#include "csg/picture/scene.h"
#include "csg/result/palette.h"

namespace cnrg {

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
