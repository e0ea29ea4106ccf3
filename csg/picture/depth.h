// The depth of a visible facet, segment or point, as a function of the place in the picture.
#pragma once

#include <array>
#include <optional>

#include "csg/picture/scene.h"
#include "kernel/exact/points.h"

namespace cnrg {

/// z over the picture of a facet, or of a segment over its own line there. Bounds are kept, since they decide
/// nearly always; the exact values are taken from the scene when they are asked for. Refers to the scene.
class Depth {
 public:
  enum class Facing { front, back, edge_on };
  /// Nothing for a facet that is seen edge-on.
  static std::optional<Depth> of_facet(const Scene& scene, const Scene::Facet& facet, Facing& facing);
  /// Nothing for a segment that is seen as a point.
  static std::optional<Depth> of_segment(const Scene& scene, const Scene::Segment& segment);
  /// Of a point of the scene.
  Depth(const Scene& scene, Scene::Index origin);

  struct Bounds {
    double low = 0, high = 0;
  };
  /// 1: this one is nearer to who looks, -1: the other one, 0: bounds do not tell.
  int compare(const Depth& other, const std::array<Bounds, 2>& place) const;
  /// The same exactly: 0 means that both are one point.
  int compare(const Depth& other, const ExactPoint& place) const;

 private:
  struct Exact {
    Rational a, b, c;  ///< z = a x + b y + c
  };
  Exact exact() const;

  const Scene* scene_;
  Scene::Index origin_;
  const Scene::Facet* facet_ = nullptr;      // of a facet
  const Scene::Segment* segment_ = nullptr;  // of a segment
  // Bounds of z = z0 + a (x - x0) + b (y - y0).
  std::array<Bounds, 3> start_{};  // x0, y0, z0
  std::array<Bounds, 2> slope_{};  // a, b
};

}  // namespace cnrg
