// What is meant to coincide is made to: the one place where a tolerance enters, before anything is refined.
//
// Files hold doubles. Two faces that their author put on one plane differ by 1e-16 there, and exact arithmetic
// finds a sliver of that thickness between them. To round points does not help: three corners of a face define its
// plane, the others are off it, and faces that overlap in part have no corners in common. So planes come first,
// and points are where planes meet. The rule, for a length d:
//
//   1. A face is flat if its corners fit between two parallel planes at most d apart (a slab). A facet of a curved
//      face counts by itself, and never with others of its face.
//   2. Flat faces whose boxes are within d of each other are near if one slab holds both. From the nearest pair
//   on,
//      the planes of near faces become one if a slab holds all faces of both. Points within d of each other are
//      joined likewise, if all are within d of each other. So chains (a near b near c) are cut where they grow
//      thicker than d, at their widest links; pairs that stay apart are counted and named.
//   3. A point lies on the planes of its own faces, and of all faces that it is within d of.
//   4. Points and planes are placed one after the other: a plane through those of its points that have a place, a
//      point where those of its planes meet that have one. An element with few partners comes late, so that it has
//      at most three to obey (order.h).
//   5. What cannot be obeyed without moving a point farther than d, or with numbers of a reasonable length, is
//   not:
//      that point stays off that plane, and facets there are cut into triangles. It is counted. Triangles whose
//      points alone are joined need no planes, and none are asked for.
//   6. What is near nothing stays as it is, to the last bit; faces that only touch, as neighbours on a surface do,
//      are near nothing for that. No point moves farther than d: that is decided exactly.
//   7. With `only_planes`, nothing is joined but planes (2), and each flat face with more than three corners gets
//      one, alone or not. So polygons whose corners were rounded become planar.
//
// Ties are decided by coordinates, never by numbers, so the order of leaves and faces does not matter.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "kernel/base/leaf_words.h"
#include "kernel/exact/rational.h"

namespace cnrg {

struct WeldModel {
  using Index = std::uint32_t;
  using Loops = std::vector<std::vector<Index>>;
  /// A planar polygon, or nearly so: the outer loop, then holes in any direction.
  struct Facet {
    Index face = 0;
    Loops loops;
  };
  struct Face {
    bool curved = false;      ///< its facets are not in one plane, however near they are
    bool may_vanish = false;  ///< a facet of a mesh, of which nobody knows by its number
  };
  /// Facets that enclose a solid, with their fronts outside if true.
  struct Solid {
    LeafWords name;
    std::vector<std::pair<Index, bool>> facets;
  };
  std::vector<RationalPoint> points;
  std::vector<Facet> facets;
  std::vector<Face> faces;
  std::vector<Solid> solids;
  bool only_planes = false;  ///< the key is `fit`, not `weld`
  // For messages.
  std::string subject;  ///< before all else: `mesh: 'part.off': `
  std::function<LeafWords(Index)> face_name;
};

struct Weld {
  std::vector<RationalPoint> points;  ///< where each is now; as it was if nothing is near
  std::size_t moved = 0;              ///< points
  double farthest = 0;                ///< of these, rounded up
  std::size_t joined_points = 0;      ///< how many fewer there are
  std::size_t joined_planes = 0;      ///< planes that several faces share now and did not before
  std::size_t left = 0;               ///< near pairs that were not joined
  LeafWords example;                  ///< of these
  std::size_t off = 0;                ///< how often a point stays off a plane
  bool only_planes = false;
  bool changed() const { return moved > 0; }
  /// What it did, in words; empty if there is nothing to say.
  LeafWords notice(const Rational& d) const;
};

/// Throws InputError if the solid would have no volume, or one of the other sign, with its points where they are
/// `after`. `weld` does so for all solids of the model.
void check_solid(const WeldModel& model, const WeldModel::Solid& solid, const std::vector<RationalPoint>& after,
                 const Rational& d);

/// The words of all that is refused, such as `leaf 3, face 2 would vanish`; throws InputError.
[[noreturn]] void refuse_weld(const std::string& subject, const LeafWords& what, const Rational& d);

/// Throws InputError, which names a face or solid, if it would vanish or be turned inside out. d > 0.
Weld weld(const WeldModel& model, const Rational& d);

}  // namespace cnrg
