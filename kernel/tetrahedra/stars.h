// Tetrahedra that change: at each vertex the tetrahedra that have it, and what of faces and edges has to stay.
//
// A local move takes some tetrahedra away and puts others into the same hole. What is around an edge or a vertex
// is found in the stars of its ends, which are short; neighbours are not kept, for they would cost more to keep
// right than to find.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "kernel/base/progress.h"
#include "kernel/tetrahedra/conforming.h"

namespace cnrg {

class Stars {
 public:
  using Index = ConformingTetrahedra::Index;
  using Point = ConformingTetrahedra::Point;
  static constexpr Index kNoTetrahedron = 0xffffffffu;
  static constexpr std::int32_t kNone = -1;   ///< no facet, no line
  static constexpr std::int32_t kRidge = -2;  ///< a line between facets that nobody named
  static constexpr std::int32_t kMany = -2;   ///< a vertex on several facets, or on a line

  struct Tetrahedron {
    std::array<Index, 4> corners;                                    ///< positively turned
    std::array<std::int32_t, 4> facets{kNone, kNone, kNone, kNone};  ///< of the faces opposite to them
    std::int32_t region = 0;
    double shape = 0;  ///< see `measure`
    int place(Index v) const {
      for (int k = 0; k < 4; ++k)
        if (corners[static_cast<std::size_t>(k)] == v) return k;
      return -1;
    }
    bool has(Index v) const { return place(v) >= 0; }
    std::array<Index, 3> face(int k) const;  ///< opposite to corner k, which is in front
    std::int32_t facet_opposite(Index v) const { return facets[static_cast<std::size_t>(place(v))]; }
  };
  /// The edges of a tetrahedron, by places of its corners.
  static constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  struct Line {
    Index to;
    std::int32_t line;
  };
  /// The tetrahedra around an edge ab: tetrahedron k has the corners a, b, around[k], around[k + 1].
  struct Ring {
    std::vector<Index> around, tetrahedra;
    bool closed = true;  ///< else the edge is on the border, and `around` has one more
  };

  /// Throws Stopped, if that was asked for.
  explicit Stars(const ConformingTetrahedra& mesh, const Watch& watch = {});
  /// What is alive; points that nothing uses stay.
  ConformingTetrahedra mesh() const;

  const Point& point(Index v) const { return points_[v]; }
  std::size_t point_count() const { return points_.size(); }
  Index add_point(const Point& p, std::int32_t facet);
  void drop_point();  ///< the last one, which nothing uses
  /// The caller measures the star again.
  void move(Index v, const Point& p) { points_[v] = p; }

  std::size_t size() const { return tetrahedra_.size(); }
  bool alive(Index t) const { return tetrahedra_[t].shape >= 0; }
  const Tetrahedron& at(Index t) const { return tetrahedra_[t]; }
  std::span<const Index> star(Index v) const { return stars_[v]; }
  /// Puts the shapes of its star, in their order, for a vertex that has moved.
  void set_shapes(Index v, std::span<const double> shapes);
  void replace(std::span<const Index> old, std::span<const Tetrahedron> fresh);

  /// No move makes the tetrahedron better, until something changes in the stars of its corners: more than these no
  /// move looks at. So sweeps of a mesh of which little changes between them cost little.
  void settle(Index t) { settled_[t] = changes_; }
  /// Other moves are tried from now on.
  void unsettle() { std::ranges::fill(settled_, 0); }
  bool is_settled(Index t) const {
    return std::ranges::none_of(tetrahedra_[t].corners, [&](Index v) { return last_change_[v] > settled_[t]; });
  }

  /// The cube of the shape 12 (3 V)^(2/3) / (sum of squared edges), which is 1 of a regular tetrahedron (liu1994):
  /// its powers are ordered alike, and it needs no roots. Far larger for a negative region, whose shape is
  /// nobody's care unless it is so flat that nothing beside it can move; -1 unless it is certainly turned right.
  /// May be -1, too, where it is not above `bar`: then exact signs are for nothing.
  double measure(const std::array<Index, 4>& corners, std::int32_t region, double bar = -1) const;

  /// False where the tetrahedra around the edge do not follow each other: the border meets itself there.
  bool ring(Index a, Index b, Ring& out) const;
  Index across(Index t, int k) const;  ///< the other tetrahedron at the face opposite to corner k, if there is one

  std::span<const Line> lines(Index v) const { return lines_[v]; }
  std::int32_t line(Index a, Index b) const;
  void add_line(Index a, Index b, std::int32_t line);
  void remove_line(Index a, Index b);
  /// The facet of a vertex inside of one; kMany, kNone.
  std::int32_t facet(Index v) const { return facet_of_[v]; }
  /// A unit normal of a facet, and a point of it.
  const Point& normal(std::int32_t facet) const { return normals_[static_cast<std::size_t>(facet)]; }
  const Point& origin(std::int32_t facet) const { return origins_[static_cast<std::size_t>(facet)]; }

 private:
  std::vector<Point> points_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<Index> free_;
  std::vector<std::vector<Index>> stars_;
  std::vector<std::vector<Line>> lines_;
  std::vector<std::int32_t> facet_of_;
  std::vector<std::uint64_t> last_change_;  // by vertex: the number of the last change of its star
  std::vector<std::uint64_t> settled_;      // by tetrahedron: the number of changes then
  std::uint64_t changes_ = 1;
  std::vector<Point> normals_, origins_;
  double scale_ = 1;
  std::int32_t named_ = 0;  // facets from here on are of the border alone

  ConformingTetrahedra with_border(const ConformingTetrahedra& mesh, const Watch& watch);
  Index add(const Tetrahedron& t);
  void set_facets(const ConformingTetrahedra& mesh, const Watch& watch);
  void set_lines(const ConformingTetrahedra& mesh);
};

}  // namespace cnrg
