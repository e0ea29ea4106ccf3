// The half-planes around an axis on which all leaves about it are drawn.
//
// Facets between two half-planes are coplanar with all facets there of a cylinder or cone of the same surface, if
// the corners of every circle are its centre plus its radius times one and the same direction. So directions are
// rounded once, not corners.
#pragma once

#include <array>
#include <set>

#include "csg/curves/revolved.h"

namespace cnrg {

/// A turn less its whole turns.
Rational within_one(const Rational& turn);

class Turns {
 public:
  /// Even steps from the direction `start`; `marks`: further directions, at right angles to the
  /// axis and nearly or exactly unit vectors, in any order. Of two on one ray the one that is nearer to a unit
  /// vector stays. `others` are such directions, too, but next to marks and to those before them they are left
  /// out, and even steps next to any of all these. `lines` come last, without those nearer than 1e-12 of a turn to
  /// one that is there.
  Turns(const RationalPoint& axis, const RationalPoint& start, int segments,
        const std::vector<RationalPoint>& marks, const std::vector<RationalPoint>& others = {},
        const std::set<RationalPoint>& lines = {});

  std::vector<RationalPoint> directions(bool only_marks = false) const;
  /// The directions before and after one of these.
  std::array<RationalPoint, 2> beside(const RationalPoint& direction) const;

  /// How a leaf about the axis lies: the direction where its turn begins; `along` if its own axis runs along this
  /// one, `mirrored` if it turns against its own axis.
  struct Lie {
    RationalPoint start;
    bool along = true, mirrored = false;
  };
  /// The columns of a leaf whose turn is whole.
  std::vector<RevolvedGrid::Column> around(const Lie& lie) const;
  /// The columns of one that turns by `degrees`, up to the direction `end`.
  std::vector<RevolvedGrid::Column> part(const Lie& lie, const RationalPoint& end, const Rational& degrees) const;

 private:
  /// At right angles to each other; the second one is the axis x the first.
  struct Frame {
    RationalPoint first, second, axis;
  };
  struct Line {
    RationalPoint direction;
    Rational turn;                    ///< from `start`, 0 to 1; of a mark as a double
    bool even = false, mark = false;  ///< either or both
  };
  void add_lines(const std::set<RationalPoint>& lines);
  /// Where a direction is, 0 to 1; exact for a line of these.
  Rational turn_of(const RationalPoint& direction) const;
  const Line* find(const RationalPoint& direction) const;

  static int half_of(const Frame& frame, const RationalPoint& d);
  static int compare(const Frame& frame, const RationalPoint& a, const RationalPoint& b);

  Frame frame_;
  std::vector<Line> lines_;  ///< counter-clockwise from `start`
};

}  // namespace cnrg
