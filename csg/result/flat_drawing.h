// A flattened result as a drawing whose points can be moved.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "csg/result/flat.h"
#include "kernel/complex/draft.h"

namespace cnrg {

// The drawing of a result, and the drawing with moved points, with new crossings refined.

/// What is drawn, by numbers of points; triangles of one face share its number, pieces of one edge that.
struct NumberedDrawing {
  struct Triangle {
    std::array<std::uint32_t, 3> points;
    std::uint32_t face = 0;
  };
  struct Piece {
    std::array<std::uint32_t, 2> points;
    std::uint32_t edge = 0;
  };
  std::vector<VertexId> points;  ///< in the table that it is drawn with
  std::vector<Triangle> triangles;
  std::vector<Piece> pieces;            ///< of edges, on triangles or not
  std::vector<std::uint32_t> isolated;  ///< points that are drawn by themselves
};

struct MovedDrawing {
  ComplexDraft complex;
  /// Of each face of the complex the faces of the drawing that lie on it, each as often as it does: 2 * face, and
  /// 1 more where its front is the back here.
  Csr<FaceId, std::uint32_t> faces;
  Csr<EdgeId, std::uint32_t> edges;  ///< of each edge those edges of the drawing that run along it, ascending
  std::vector<VertexId> points;      ///< where each point is; none() if all that had it has collapsed
  int rounds = 0;                    ///< refinements
  bool plain = false;                ///< moving each point by itself was enough: nothing was cut, merged or lost
  double displacement = 0;           ///< no point of the drawing moved farther (units of the model)
};

/// True if a face or line reaches the frame of unbounded leaves.
bool reaches_frame(const FlatComplex& flat);

/// Throws InputError if a face or line reaches the frame of unbounded leaves: `why` it must not, as the beginning
/// of the message.
void require_bounds(const FlatComplex& flat, const char* why, const char* otherwise);

/// All cells of a flattened result, by their numbers there.
NumberedDrawing drawing_of_cells(const FlatComplex& flat);

}  // namespace cnrg
