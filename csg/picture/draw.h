// From a node's cells to a figure: cut, pulled apart, seen from a camera, and what hides what decided exactly.
#pragma once

#include <optional>
#include <vector>

#include "csg/picture/figure.h"
#include "csg/result/palette.h"
#include "csg/result/result.h"
#include "kernel/exact/rational.h"

namespace cnrg {

struct DrawOptions {
  /// Where the picture is taken from, in degrees: to the right of the negative y-axis, as seen from above, and up
  /// from the plane of x and y. Nothing: chosen so that what is long in the model lies across the picture.
  struct Camera {
    double azimuth = 0, elevation = 0;
  };
  std::optional<Camera> camera;
  /// The part of the model on the camera's side of the plane `normal . p = offset` is taken away.
  struct Cut {
    std::array<Rational, 3> normal;
    Rational offset;
  };
  std::vector<Cut> cuts;
  double apart = 0;    ///< regions are moved away from the middle by this share of their distance from it
  double opacity = 1;  ///< of faces; below 1 what is behind them shines through, hidden lines as faint ones
  std::optional<ColorBy> colors;  ///< nothing: as palette.h chooses for the node
  /// Of all leaves of the picture, if it shows other nodes beside this one: they have one color in all of them.
  std::vector<std::string> leaf_names;
  /// Which cells have their numbers beside them (`v6`, `e11`, `f2`, `r2`), and whether regions, sheets and wires
  /// have their names.
  struct Labels {
    bool vertices = false, edges = false, faces = false, regions = false, names = false;
  };
  Labels labels;
};

/// From where what is long in all of these lies across the picture, and a flat model is seen from the front.
DrawOptions::Camera camera_for(const std::vector<Result>& results);

/// `removed`, which is on the complex of the result, is shown as ghosts (`removed_entities` of
/// csg/explain/fates.h), not with cuts or `apart`. Throws InputError if an unbounded result is to be cut or pulled
/// apart, if cuts leave nothing, and for coordinates beyond 1e250.
Figure draw(const Result& result, const DrawOptions& options, const Result* removed = nullptr, int threads = 0);

}  // namespace cnrg
