// What operands of problems must be, and how two of them meet: by definition, on exact numbers.
#pragma once

#include <string>

#include "bench/cases/model.h"

namespace cnrg::bench {

bool operator==(const Model::Face& a, const Model::Face& b);
bool operator==(const Model& a, const Model& b);

/// A sixth of the sum of the determinants of the fans of the faces: the volume of a closed solid.
Rational volume_of(const Model& model);

/// The first of these that does not hold, in words: points are distinct and used; faces have one loop of distinct
/// corners, all in one plane, with an area. Solids: each side of a face has its opposite once, the volume is
/// positive, and the kernel finds one region of that volume in it.
std::string fault_of(const Model& model);

/// How two models meet in the complex of both.
struct Meeting {
  std::size_t faces = 0;         ///< faces on which both lie
  std::size_t edges = 0;         ///< edges on which edges of both lie
  std::size_t vertices = 0;      ///< that are in general position of neither kind: see `meeting`
  std::size_t crossings = 0;     ///< of those vertices, that are corners of neither
  Rational first, second, both;  ///< volumes of the regions of each, and of both
  bool general() const { return faces == 0 && edges == 0 && vertices == 0; }
};

/// In general position a vertex is one of one model and off the other one, or an edge of one model crosses a face
/// of the other one there; other vertices are counted.
Meeting meeting(const Model& a, const Model& b);

}  // namespace cnrg::bench
