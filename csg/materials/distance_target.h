// What a distance is measured to, from cells of a complex.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "csg/materials/grade.h"
#include "kernel/complex/complex.h"

namespace cnrg {

class TargetBuilder {
 public:
  explicit TargetBuilder(const Complex& complex) : complex_(complex), on_face_(complex.edge_count(), 0) {}
  /// Faces come first: an edge or a vertex of one that is there already adds nothing.
  void add(FaceId f);
  void add(const std::array<VertexId, 3>& triangle);
  void add(EdgeId e);
  void add(VertexId v);
  /// Nothing if a cell is unbounded.
  std::optional<DistanceTarget> take();

 private:
  std::uint32_t number(VertexId v);

  const Complex& complex_;
  std::vector<char> on_face_;  // by edge
  DistanceTarget target_;
  std::map<VertexId, std::uint32_t> numbers_;
  bool unbounded_ = false;
};

}  // namespace cnrg
