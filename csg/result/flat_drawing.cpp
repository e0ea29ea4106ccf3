#include "csg/result/flat_drawing.h"

#include <algorithm>

#include "kernel/base/error.h"

namespace cnrg {

bool reaches_frame(const FlatComplex& flat) {
  const auto on_frame = [&](const FlatComplex::Loop& loop) {
    return std::any_of(loop.begin(), loop.end(), [&](FlatComplex::Index p) {
      return std::binary_search(flat.frame_points.begin(), flat.frame_points.end(), p);
    });
  };
  return std::any_of(flat.faces.begin(), flat.faces.end(),
                     [&](const auto& f) { return std::any_of(f.loops.begin(), f.loops.end(), on_frame); }) ||
         std::any_of(flat.edges.begin(), flat.edges.end(), [&](const auto& e) { return on_frame(e.points); });
}

void require_bounds(const FlatComplex& flat, const char* why, const char* otherwise) {
  if (reaches_frame(flat)) {
    throw InputError(
        std::string(why) +
        ", and only one whose faces and lines have bounds can be moved; cut the node with a box first "
        "(`intersection`, or `product` where it is not closed)" +
        otherwise);
  }
}

NumberedDrawing drawing_of_cells(const FlatComplex& flat) {
  NumberedDrawing drawing;
  drawing.points = flat.points;
  for (FlatComplex::Index f = 0; f < flat.faces.size(); ++f) {
    for (const auto& t : flat.faces[f].triangles) drawing.triangles.push_back({t, f});
  }
  for (FlatComplex::Index e = 0; e < flat.edges.size(); ++e) {
    for_each_segment(flat.edges[e], [&](auto a, auto b) { drawing.pieces.push_back({{a, b}, e}); });
  }
  for (const auto& v : flat.vertices) {
    if (v.free) drawing.isolated.push_back(v.point);
  }
  return drawing;
}

}  // namespace cnrg
