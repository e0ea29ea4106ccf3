// Triangles of all planar facets of a result together, on segments that the facets share.
//
// A facet is what lies in one plane: a flat face, or a planar piece of a curved one. Within a facet triangles know
// their neighbours, sides turn until they are Delaunay, and points come in. A segment is a piece of an edge, of a
// wire, or of a line on which two facets of one face meet; it holds the triangles of all facets around it (its
// fan), so that one that is split is split in all of them: the mesh conforms at every step.
//
// Points are doubles, and rounding has moved them off their planes. So no three-dimensional sign would be of use:
// a facet is seen along the axis on which its normal is largest, where turns are exact signs of the doubles. All
// triangles of a facet turn left there, always, so that they cover it once and cross nowhere. That says nothing of
// how high a point lies above the facet. So a facet has one plane, that of its first triangles, and points that
// come in are put on it: a normal of a thin triangle's own may point anywhere, and points that are found by it
// drift away, and take others with them. Whether a side is Delaunay is a matter of quality alone: lengths and
// angles are those in space, areas those in the plane, in doubles, and a side turns only where these leave no
// doubt.
//
// Of a model that repeats, segments on opposite sides are split together, and triangles on the far sides come
// last, as images of those on the near ones.
//
// A facet whose triangles do not turn left to begin with, since it is thinner than the digits of its points, keeps
// them as they are, and its segments their points.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "csg/mesh/periodic.h"
#include "csg/result/flat.h"
#include "kernel/base/short_list.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

class FacetMesh {
 public:
  using Index = std::uint32_t;
  using Vector = DoubleVector;
  static constexpr Index kNone = FlatComplex::kNone;

  struct Triangle {
    std::array<Index, 3> points;
    /// Across the side that is opposite to each point: the neighbour in the facet, or else the segment.
    std::array<Index, 3> next{kNone, kNone, kNone}, segments{kNone, kNone, kNone};
    Index facet = 0;
  };
  struct Segment {
    std::array<Index, 2> ends;
    Index edge = kNone;         ///< of the result; none between two facets of a face
    Index input = 0;            ///< the segment that it was a part of at first
    bool fixed = false;         ///< is not split
    Index next_tied = kNone;    ///< of those that are split together, which are a ring; none: this one alone
    bool turned = false;        ///< runs the other way than some of these
    ShortList<Index, 2> fan{};  ///< triangles
  };
  struct Facet {
    Index face = 0;
    Projection axes;
    bool fixed = false;
    Vector normal{}, center{};  ///< of its plane: of length 1, or 0 where the facet has no area; a point on it
  };

  /// `xyz`: of the points of the flattened result, which is closed. Facets of `fixed` keep their triangles, and
  /// their segments their points; it may be shorter than the list of facets. Throws InputError where the
  /// sides of a model that is to repeat differ.
  FacetMesh(const FlatComplex& flat, std::vector<Vector> xyz, const std::vector<char>& fixed,
            const PeriodicSides& sides = {});

  const std::vector<Vector>& points() const { return xyz_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Facet>& facets() const { return facets_; }
  /// 1 where three points turn left as the facet is seen along its axis, -1 to the right, 0 straight on; exact.
  int turn(Index facet, Index a, Index b, Index c) const;
  /// A segment is not split, nor are those tied to it.
  void fix(Index segment);

  /// Turns sides until all are Delaunay but those that are segments.
  void make_delaunay();
  struct Parts {
    Index first, second, point;  ///< the first part keeps the number of the segment
  };
  /// Splits a segment at a place on it, and those tied to it, and makes what is around them Delaunay. Nothing, and
  /// no change, where doubles have no room for that.
  std::vector<Parts> split(Index segment, const Vector& at);
  /// Calls see(segment) for a segment and those tied to it.
  template <class See>
  void for_each_tied(Index segment, const See& see) const {
    Index s = segment;
    do {
      const Index next = segments_[s].next_tied;
      see(s);
      s = next;
    } while (s != kNone && s != segment);
  }
  /// The place in the plane of a facet above or below another one, as the facet is seen along its axis.
  Vector on_plane(Index facet, Vector at) const;
  /// A point in a triangle, or on a side of it that is no segment; what is around it is made Delaunay. False, and
  /// no change, where it is neither.
  bool insert(Index triangle, const Vector& at);

  /// Where a walk from a triangle straight to a place in its plane ends.
  struct Walk {
    Index triangle = kNone;  ///< that holds the place, or
    Index segment = kNone;   ///< the segment in the way; none of both where the walk loses its way
  };
  Walk walk(Index from, const Vector& to) const;
  /// What a new point at a place would see: the sides of all triangles in whose circles it lies, from a triangle
  /// that holds it.
  struct Cavity {
    std::vector<Index> segments;  ///< among these sides, ascending
    double nearest;               ///< the distance to the nearest corner
  };
  Cavity cavity(Index triangle, const Vector& at) const;

  /// Triangles on far sides, like those on near ones: of each, in order, the one that it repeats.
  std::vector<Index> add_images();

  /// Triangles that were made or changed since this was asked for last; some of them more than once.
  std::vector<Index> take_changed() { return std::exchange(changed_, {}); }

 private:
  std::vector<Vector> xyz_;
  PointTable table_;
  std::vector<Triangle> triangles_;
  std::vector<Segment> segments_;
  std::vector<Facet> facets_;
  std::vector<Index> changed_;
  const PeriodicSides sides_;
  std::vector<PeriodicFaces> images_;

  struct Across {
    Index next, segment;
  };
  void add_segments(const FlatComplex& flat);
  void add_facets(const FlatComplex& flat);
  void link();
  void tie();
  Index first_facet(Index face) const;
  void fix_thin(const std::vector<char>& fixed);
  bool has_room(Index segment, Index point) const;
  Parts split_one(Index segment, Index point);
  Index add_point(const Vector& at);
  Index side_of(Index triangle, Index next) const;
  Index side_on(Index triangle, Index segment) const;
  Across across(Index t, Index k) const { return {triangles_[t].next[k], triangles_[t].segments[k]}; }
  void join(Index t, Index k, Index before, const Across& out);
  void split_triangle(Index t, Index k, Index m, Index other);
  bool is_splittable(Index t, Index k, Index m) const;
  Index new_triangle();
  double delaunay(Index facet, Index a, Index b, const Vector& p, const Vector& q) const;
  bool is_delaunay(Index t, Index k) const;
  bool flip(Index t, Index k);
  void settle(Index m, std::vector<Index> around);
};

}  // namespace cnrg
