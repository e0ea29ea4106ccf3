// Segments as chains of Delaunay edges.
#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include "kernel/base/progress.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

/// Cuts segments by new points until each piece is an edge of the Delaunay tetrahedra.
///
/// A piece is no edge where other points come near. To halve it then would do in the end, but where segments meet
/// at a small angle, or run side by side, a cut of one is in the way of the other one, whose cut is in the way of
/// the first, and so on. So a piece is cut opposite to the point that is in its way; and if that is a cut of a
/// segment with a common end, as far from there as that is (si2015): cuts of all segments at one end come to lie
/// on common spheres. Where two segments nearly cross, that is done about the two points where they are nearest,
/// at which both are cut first.
class SegmentChains {
 public:
  using Index = std::uint32_t;
  SegmentChains(PointTable& points, Tetrahedra& tetrahedra, std::vector<std::array<VertexId, 2>> segments);

  /// `cuts`: for each point and segment at most. Throws NearFault, with a place, where more cuts are needed than
  /// anybody has use for: features nearly touch.
  void run(const Watch& watch, double cuts);

  /// After `run`: the points of a segment from its first end to its second one.
  std::vector<VertexId> chain(Index segment) const;

 private:
  struct Piece {
    Index segment;
    Rational from, to;  // the part of the way from the first end
  };
  using Key = std::uint64_t;
  PointTable& points_;
  Tetrahedra& tetrahedra_;
  std::vector<std::array<VertexId, 2>> segments_;
  std::vector<std::map<Rational, VertexId>> cuts_;
  std::unordered_map<Key, Piece> pieces_;           // by their ends
  std::unordered_map<VertexId, Index> segment_of_;  // of a cut

  VertexId at(Index segment, const Rational& t) const;
  VertexId in_the_way(VertexId a, VertexId b) const;
  double cosine(VertexId v, VertexId a, VertexId b) const;
  Rational place_of_cut(const Piece& piece) const;
  std::string crowded(VertexId v) const;
};

}  // namespace cnrg
