// Opposite sides of a model that repeats along axes: triangles on them are alike, so that nodes there are pairs.
//
// A side is what lies where a coordinate is least (near), or greatest (far). What is on the far side has to be on
// the near one, moved along the axis, but for last digits, in which copies of curved leaves may differ: points are
// moved by these, so that opposite ones differ in that coordinate alone.
#pragma once

#include <array>
#include <vector>

#include "csg/mesh/mesh.h"
#include "csg/result/flat.h"
#include "csg/result/result.h"
#include "kernel/base/vectors.h"

namespace cnrg {

struct PeriodicSides {
  PeriodicAxes axes{};
  DoubleVector near{}, far{};

  PeriodicSides() = default;
  /// Throws InputError where points have no extent along an axis.
  PeriodicSides(const PeriodicAxes& along, const std::vector<DoubleVector>& points);
  bool any() const { return axes != PeriodicAxes{}; }
  /// The axes at whose `side`, near or far, all of some points lie.
  template <class Points>
  PeriodicAxes at(const DoubleVector& side, const std::vector<DoubleVector>& xyz, const Points& points) const {
    PeriodicAxes on = axes;
    for (std::size_t k = 0; k < 3; ++k)
      for (const auto p : points) on[k] = on[k] && xyz[p][k] == side[k];
    return on;
  }
  /// The same points, those on far sides at the places opposite where they are off these by last digits.
  std::vector<DoubleVector> aligned(std::vector<DoubleVector> points) const;
  /// Moved along some axes to the near sides.
  DoubleVector folded(DoubleVector p, const PeriodicAxes& along) const;
  /// The least size at a place and at those that it repeats.
  SizeAt least(const SizeAt& size) const;
};

/// The same face on both sides of an axis.
struct PeriodicFaces {
  FlatComplex::Index near, far;
  std::size_t axis;
};
/// Throws InputError, with a place, where a vertex, a straight piece of an edge or a face on one side has none
/// opposite.
std::vector<PeriodicFaces> matched_faces(const FlatComplex& flat, const std::vector<DoubleVector>& xyz,
                                         const PeriodicSides& sides);

/// An entity on far sides of a mesh, and the one opposite, with the pairs of their nodes.
struct PeriodicLink {
  std::size_t dimension;
  Mesh::Index far, near;
  DoubleVector shift;                             ///< from the near nodes to the far ones
  std::vector<std::array<Mesh::Index, 2>> nodes;  ///< far and near, middles of edges included
};
/// Of a mesh that repeats along Mesh::periodic, by dimension and entity: this proves that it does.
std::vector<PeriodicLink> periodic_links(const Mesh& mesh);

/// A node on far sides, the one that it repeats, which is on none, and along which axes.
struct PeriodicNode {
  Mesh::Index far, near;
  PeriodicAxes axes;
};
std::vector<PeriodicNode> periodic_nodes(const Mesh& mesh);

}  // namespace cnrg
