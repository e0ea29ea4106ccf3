// Flat parts of a model, and which of them share a plane.
//
// A *part* is a flat face, or a facet of one that is not flat. Parts are numbered by what they look like (their
// boxes, their areas), so that nothing depends on the order of the input. A *carrier* is the plane of one part or
// of several that were joined.
//
// Whether a slab holds corners is decided exactly, for a normal in doubles: the area vector of all parts
// concerned, or that of the largest; where only planes are asked for also the normal of least squares. Another
// normal might make the slab a little narrower; a rule needs one, not the best.
#pragma once

#include <array>
#include <vector>

#include "csg/weld/weld.h"
#include "kernel/refine/box.h"

namespace cnrg::welding {

using Index = WeldModel::Index;
using Vector = std::array<double, 3>;

/// normal . p = offset
struct Plane {
  RationalPoint normal{0, 0, 0};
  Rational offset = 0;
};

struct Part {
  Index face = 0;
  std::vector<Index> facets;   ///< of the model
  std::vector<Index> corners;  ///< numbers of different points, each once, ascending
  Vector area{0, 0, 0};        ///< twice its area, along its normal
  Box box;                     ///< of its corners
  std::vector<Box> boxes;      ///< of its facets
};

struct Carrier {
  Plane plane;
  std::vector<Index> parts;    ///< ascending
  std::vector<Index> corners;  ///< of these parts, each once, ascending
  bool exact = false;          ///< all corners are on it already
  bool overlap = false;        ///< some of its parts lie on each other, and are not triangles of the same points
};

struct Planes {
  std::vector<Part> parts;
  std::vector<Carrier> carriers;
  std::vector<Index> carrier_of;              ///< of each part
  std::vector<std::pair<Index, Index>> left;  ///< near parts that were not joined
};

/// `points` are different and in lexicographic order, `near` holds the same in doubles; corners of the model's
/// facets are looked up in `number`. Points that will be one have one number in `spot_of`.
Planes find_planes(const WeldModel& model, const std::vector<Index>& number,
                   const std::vector<RationalPoint>& points, const std::vector<Vector>& near,
                   const std::vector<Index>& spot_of, const Rational& d);

/// A box with some length more on each side, rounded outward.
Box grown(const Box& box, double by);
/// The loops of a facet by numbers of different points.
WeldModel::Loops numbered_loops(const WeldModel& model, Index facet, const std::vector<Index>& number);
/// Not less than d.
double rounded_up(const Rational& d);

// Is a point within some distance of a polygon, as seen along its normal? Do polygons lie on each other?

/// True for a point over the polygon (enclosed by its loops an odd number of times), and within `d` of its border
/// in space. In doubles: at the border itself either answer is a good one. `normal` of any length.
bool is_in(const WeldModel::Loops& loops, const std::vector<Vector>& points, const Vector& normal, const Vector& p,
           double d);

/// True for two convex polygons of nearly one plane that have more in common than a strip of width d; of others
/// that are not convex true also where only their hulls have. Their outer loops decide.
bool overlap(const WeldModel::Loops& a, const WeldModel::Loops& b, const std::vector<Vector>& points,
             const Vector& normal, double d);

}  // namespace cnrg::welding
