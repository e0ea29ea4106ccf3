// A result in which nothing is nearer than a distance d that does not touch: near features are joined.
//
// People type four decimals: a bolt ends 1e-5 from the fault that it should reach, a sheet misses an edge. The
// exact result has these gaps, and a mesh of it elements as small. To round all points to a grid would not help:
// two points of one place may still go to two grid points, and an edge passes by the point that lies on it. Here
// points and what they are near (near.h) are brought together, round by round; what moves takes along what it
// bounds:
//
//   1. Points nearer than d to each other: one of them stays, the others go there. Those that stay are chosen one
//      by one in the order of preference, each taking all that are near, so they are not nearer than d themselves.
//   2. If there are none, points near segments: the segment gets a joint there, and the two meet.
//   3. If there are none of these either, points near facets, and segments near segments, in the same way.
//
// Of two that meet, that one moves which is held less, that is by fewer independent planes of walls and boundaries
// of regions, or of as many by fewer of sheets. So a corner of a region stays, and an edge bends to it; a bolt's
// end goes to the fault, which stays flat; and a fault's corner on the floor of the ground goes to the edge of
// that and stays on the floor. Of equals the point goes; of two points that one stays which has fewer digits, so
// one of the input before one that was constructed, then the first by its coordinates. All of this depends on the
// value alone.
//
// The drawing of what has moved is refined exactly, so the result is a complex again whatever happened, and told
// what it is by what it was (relabel.h). Rounds end when nothing is near: then joining again changes nothing.
// That they end so is not proven: two edges may bend to each other's points in turn. After some rounds, what is
// within 2 d of a corner, later 4 d, goes there, and of two points the other one stays, which ends nearly all such
// turns. No point is moved by kMostJoinMoves times d or more in all rounds together, and rounds end, too, when
// they are many or have made twice as many points, besides those where they joined edges. Then all begins anew
// with what is nearer than somewhat more than d; of all attempts that one is taken that leaves fewest pairs near,
// and the report says so.
//
// A foot on a facet whose corners are feet has some ten times their digits. So where things meet, and where what
// has moved crosses, is as exact as what one construction from doubles makes, and else on a grid far finer than d.
// Points of the result that was given keep their coordinates as long as they stay.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/result/result.h"
#include "kernel/exact/rational.h"

namespace cnrg {

inline constexpr int kMostJoinMoves = 16;

/// What `join` did.
struct JoinReport {
  int rounds = 0;           ///< in which something was moved; 0: nothing was near, the result is the same
  bool refused = false;     ///< something was, and is left as it was (Joins::harmless)
  Rational reach;           ///< what was nearer than this was joined: the distance asked for, or up to twice that
  double displacement = 0;  ///< no point of the result moved farther (units)
  /// What met, the nearest first in each round, a line each, such as `point v3 of bolt and face f2 of fault, at
  /// (1, 2, 3): 1e-05 apart`. Numbers are those of the result that was given, so there are none after the first
  /// round.
  std::vector<std::string> merged;
  /// The regions that vanished, a line for each component: `dust, r2, at (1, 2, 3)`, and those of which pieces
  /// have: `rock (2 pieces), at (1, 2, 3)` (csg/result/vanished.h).
  std::vector<std::string> lost_regions;
  std::size_t lost_faces = 0, lost_wires = 0;
  std::size_t regions_before = 0, regions_after = 0;  ///< active ones, in one piece each
  std::size_t remaining = 0;                          ///< pairs that are nearer than asked for all the same
  double nearest = 0;                                 ///< of these, their least distance
  /// One line without its end: `joined 3 pairs nearer than 0.001, ...`.
  std::string text(const Rational& within) const;
  /// What nobody may miss, a line each: regions that vanished, what is still near.
  std::vector<std::string> warnings(const Rational& within) const;
};

enum class Joins : std::uint8_t {
  all,
  /// None at all where more pairs than kFewPairs are near, as where surfaces nearly coincide, or where a region or
  /// a wire would be lost or parted: then the result is returned as it is, with a report that says so.
  harmless
};
inline constexpr std::size_t kFewPairs = 500;

/// `within`: the distance d (units), positive. Throws InputError if it is not, if it is not smaller than the
/// result itself, if a face or line of the result reaches the frame of unbounded leaves, and if nothing would be
/// left; Stopped, as the watch asks. What the result knew of true surfaces (parameters) is gone where anything was
/// joined. Components of which nothing is left are gone; the others keep their order. A group stays a group, in
/// which a region that has been parted is two.
Result join(const Result& result, const Rational& within, JoinReport* report = nullptr, const Watch& watch = {},
            Joins joins = Joins::all);

}  // namespace cnrg
