// What of a result lies near what it does not touch.
//
// A flattened result is taken apart into *parts*: its points, the straight segments of its edges and of the folds
// between facets of one face, and its facets. Two parts that share no point do not touch, since the result is
// embedded. Of these, pairs are told whose nearest points are in the interior of both parts: point and point,
// point and segment, point and facet, segment and segment. Whatever else is near, such as two facets, is so
// because one of these pairs is as near; to list it, too, would say the same place many times.
//
// Boxes and doubles with bounds of their errors propose; what is told is exact.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "csg/result/flat.h"
#include "kernel/base/progress.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// The parts of a flattened result. It keeps a reference to that.
class Parts {
 public:
  using Index = FlatComplex::Index;
  static constexpr Index kNone = FlatComplex::kNone;
  struct Segment {
    std::array<Index, 2> ends;         ///< points, the lower number first
    Index edge = kNone, face = kNone;  ///< whose it is; of a fold the face, of any other the edge
  };
  struct Facet {
    Index face = 0, number = 0;  ///< its place among the facets of the face
    std::vector<Index> corners;  ///< all points in its closure, ascending
  };
  struct Triangle {
    std::array<Index, 3> corners;
    Index facet = 0;
  };
  /// A vertex, an edge or a face of the result that a part is of.
  struct Cell {
    int dimension = 0;
    Index number = 0;
    friend auto operator<=>(const Cell&, const Cell&) = default;
  };

  Parts(const ResultView& view, const FlatComplex& flat);

  const FlatComplex& flat() const { return flat_; }
  const std::vector<RationalPoint>& points() const { return points_; }
  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  bool is_segment(Index a, Index b) const { return sides_.contains(edge_key(a, b)); }

  /// A point that is no vertex is of an edge or, if it is on none, of a face.
  Cell cell_of_point(Index p) const { return cell_of_point_[p]; }
  Cell cell_of_segment(Index s) const;
  Cell cell_of_facet(Index f) const { return {2, facets_[f].face}; }
  /// The points of a facet's boundary, loop by loop, and those isolated in it.
  const std::vector<FlatComplex::Loop>& loops(const Facet& facet) const;
  const ShortList<Index, 2>& isolated(const Facet& facet) const;
  /// The length of the diagonal of the box of all points, rounded.
  double diagonal() const { return diagonal_; }

 private:
  friend class NearSearch;
  const FlatComplex& flat_;
  std::vector<RationalPoint> points_;
  std::vector<std::array<double, 3>> lo_, hi_;  // of each point
  std::vector<Segment> segments_;               // by ends
  std::vector<Facet> facets_;
  std::vector<Triangle> triangles_;
  std::unordered_set<std::uint64_t> sides_;
  std::vector<Cell> cell_of_point_;
  double diagonal_ = 0;
};

enum class Near : std::uint8_t { points, point_segment, point_facet, segments };
inline constexpr std::array<Near, 4> kNears{Near::points, Near::point_segment, Near::point_facet, Near::segments};

/// Two parts by their numbers, the point or else the lower number first, and their nearest points.
struct NearPair {
  Near kind = Near::points;
  Parts::Index a = 0, b = 0;
  RationalPoint at_a, at_b;
  Rational squared;  ///< the square of their distance (square units)
};

/// More pairs than these are refused: a distance that so many are below is no small one.
inline constexpr std::size_t kMostPairs = 1'000'000;

/// Whether the two ends of one segment are a pair, too.
enum class Ends : bool { left_out, paired };

/// The pairs of one kind that are nearer than `within` (units), the nearest first, then by numbers. Throws
/// InputError if there are more than kMostPairs; Stopped, as the watch asks.
std::vector<NearPair> near_pairs(const Parts& parts, Near kind, const Rational& within, Ends ends = Ends::paired,
                                 const Watch& watch = {});
/// The same; nothing where there are more than `most` (kMostPairs at most), as soon as that is known.
std::optional<std::vector<NearPair>> near_pairs_if_few(const Parts& parts, Near kind, const Rational& within,
                                                       std::size_t most, Ends ends = Ends::paired,
                                                       const Watch& watch = {});
/// The nearest pairs of one kind: `count`, or all if there are fewer.
std::vector<NearPair> nearest_pairs(const Parts& parts, Near kind, std::size_t count, Ends ends = Ends::paired);

}  // namespace cnrg
