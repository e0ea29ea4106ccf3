// Where round leaves touch planes and each other at a point or along a line, about no common axis.
//
// A ball on a table touches it in one point, and only if this point is one of its corners do its facets touch the
// table at all. Whether two surfaces touch is decided exactly: a distance of rational square equals a sum of radii
// or it does not. Where they do, the point of contact is rational, and becomes a vertex of both.
#pragma once

#include <map>
#include <set>
#include <tuple>

#include "csg/carriers/axes.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/leaf.h"
#include "kernel/refine/box.h"

namespace cnrg {

/// What an instance must have in its tessellation beside what it shares with others about its axis.
struct TangencyMarks {
  std::vector<RationalPoint> directions;  ///< at right angles to the axis: unit vectors, exactly
  std::vector<RationalPoint> points;      ///< on balls and rings, whole ones or parts
  std::vector<MeridianPoint> circles;     ///< on arcs, as `place` (axes.h) has them
  bool needed = false;                    ///< some are no vertices of the leaf as it is
};

/// A leaf that touches another one from inside, about another axis that is parallel: see family.h. The unit
/// vector `direction` points from both axes to the contact. One of them is no ball.
struct Inside {
  std::uint32_t inner = 0, outer = 0;
  RationalPoint direction;
};

struct CircleInSpace {
  RationalPoint center, axis;  ///< the axis as `axis_line` has it
  Rational radius;
  friend bool operator<(const CircleInSpace& a, const CircleInSpace& b) {
    return std::tie(a.center, a.axis, a.radius) < std::tie(b.center, b.axis, b.radius);
  }
};
/// A circle about the axis of the leaf, or on a torus or the like its meridian in the half-plane of `direction`, a
/// unit vector.
struct HasCircle {
  std::uint32_t instance = 0;
  Rational radius;
  std::optional<RationalPoint> direction{};
  friend bool operator<(const HasCircle& a, const HasCircle& b) {
    return std::tie(a.instance, a.radius, a.direction) < std::tie(b.instance, b.radius, b.direction);
  }
};

struct Contacts {
  std::map<std::uint32_t, TangencyMarks> marks;  ///< by instance, in the space that is asked about
  /// Whole spheres of which one touches the other from inside: a point alone would not keep facets apart around
  /// it, so these two share the axis through their centres.
  std::vector<std::array<std::uint32_t, 2>> nested;
  std::vector<Inside> inside;
  /// Of two leaves or more, of one of them a meridian; about its centre also those that are a little larger or
  /// smaller.
  std::map<CircleInSpace, std::set<HasCircle>> circles;
};

/// A revolved instance, with its transform to the space and a box around it there.
struct RevolvedInstance {
  std::uint32_t instance = 0;
  Transform transform;
  Box box;
};

/// Around the corners of a leaf's own box.
Box leaf_box(const GeometryLeaf& leaf, const Transform& transform);

/// A leaf that may have planes, with revolved instances whose boxes it meets.
struct BesidePlanes {
  std::uint32_t instance = 0;
  std::vector<std::uint32_t> revolved;
};
/// Of all leaves, by boxes in the space of the tree. `alone`: leaves that need not be asked for their planes.
std::vector<BesidePlanes> beside_planes(const std::vector<LeafInstance>& instances,
                                        const std::vector<RevolvedInstance>& revolved,
                                        const std::set<std::uint32_t>& alone);

/// The contacts of balls, cylinders and planes in the space that `to_space` leads to, from that of the tree.
/// `pairs`: of revolved instances, each once.
Contacts contacts(const std::vector<LeafInstance>& instances, const Transform& to_space,
                  const std::vector<RevolvedInstance>& revolved,
                  const std::vector<std::array<std::uint32_t, 2>>& pairs, const std::vector<BesidePlanes>& planes);

}  // namespace cnrg
