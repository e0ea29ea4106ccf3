// A mesh before the camera: its outside, or what is left where the elements on the camera's side of a plane are
// taken away.
//
// A plane that cuts elements shows slices of them, and a slice through the middle of a good tetrahedron may be a
// sliver. So elements stay or go as a whole: what one sees in the opening are sides of tetrahedra as they are.
#pragma once

#include <optional>
#include <vector>

#include "csg/mesh/mesh.h"
#include "csg/picture/figure.h"
#include "csg/result/result.h"

namespace cnrg {

struct MeshDrawing {
  /// More triangles in sight than this cannot be told apart on a page.
  static constexpr std::size_t kMostTriangles = 12'000;
  bool opened = false;  ///< what is nearer to the camera than the middle of the model is taken away
  /// Places that get a ring and their number from 1, also where something is in front of them; those of what was
  /// taken away get none.
  std::vector<std::array<double, 3>> marked{};
};

/// The mesh of a result, of which bad tetrahedra (csg/mesh/quality.h) are red. Nothing, if there are too many
/// triangles, or opening it would leave all or nothing.
std::optional<Figure> draw_mesh(const Result& result, const Mesh& mesh, const MeshDrawing& drawing,
                                int threads = 0);
/// The color of each region of the mesh.
std::vector<Rgb> region_colors(const Result& result, const Mesh& mesh);
/// Of a bad element.
Rgb alarm_color();

}  // namespace cnrg
