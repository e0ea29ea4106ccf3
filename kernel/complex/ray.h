// Rays through a complex: from a point to infinity, in a generic direction, hitting faces in their interior only.
#pragma once

#include <memory>
#include <vector>

#include "kernel/complex/complex.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {

/// Casts rays among the faces of a complex of which the arrays of faces, loops, edges and points are there.
/// A direction that meets an edge or a vertex is replaced by the next of a fixed sequence, so answers are exact
/// and the same every time. Thread-safe once built.
class RayCaster {
 public:
  /// `with_tree`: build a tree for many rays; without one each ray looks at every vertex and face.
  RayCaster(const Complex& complex, bool with_tree);

  struct Ray {
    std::array<double, 3> direction{};
    /// In order from the origin: the half-face through which the ray arrives.
    std::vector<HalfFace> hits;
  };
  /// The ray from `origin`. If the origin lies in the interior of a face, that face is `own`; it is no hit.
  /// `accept` (by face, if not empty) restricts the faces that are looked at.
  Ray cast(const ExactPoint& origin, FaceId own = FaceId::none(), const std::vector<char>& accept = {}) const;
  /// The tree of the faces' boxes; there is one if the caster was built with it.
  const BoxTree& faces() const { return *tree_; }
  /// The side of a face to which a ray of this direction leaves it.
  HalfFace leaving(FaceId f, const Ray& ray) const;

 private:
  bool try_cast(const PointView& origin, const std::array<double, 3>& direction, unsigned attempt, FaceId own,
                const std::vector<char>& accept, std::vector<HalfFace>& hits) const;
  Box box(FaceId f) const;
  template <class Look>
  void look_along(const PointView& origin, const std::array<double, 3>& direction, const Look& look) const;
  const Complex& c_;
  std::unique_ptr<BoxTree> tree_;
};

}  // namespace cnrg
