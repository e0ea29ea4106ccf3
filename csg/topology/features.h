// The small features of a result, which make a mesh fine or break it: what is near without touching, short edges,
// sharp angles. Distances are of the parts that near.h speaks of; lengths are of straight pieces; a dihedral angle
// is between two faces that follow each other around an edge, a face angle between two edges in a corner of a
// face.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/result/near.h"
#include "csg/result/result.h"

namespace cnrg {

struct Feature {
  enum class Kind : std::uint8_t { distance, length, dihedral_angle, face_angle };
  Kind kind = Kind::distance;
  double value = 0;                ///< units, the double nearest to the exact value; of angles degrees
  Rational squared;                ///< of distances and lengths the exact square
  std::vector<Parts::Cell> cells;  ///< two; of a length one; of a dihedral angle the edge and two faces
  std::vector<RationalPoint> at;   ///< nearest points; ends; of a face angle the corner
};

/// How many of each sort are told where nobody says how far.
inline constexpr std::size_t kTold = 10;
/// Angles of this many degrees or more are not told: a regular tetrahedron has larger ones.
inline constexpr double kSharp = 60;

/// By kind, each from the smallest on. `below`: distances and lengths that are less (units, positive); without it
/// the kTold smallest of each pair of dimensions, and lengths. Of angles below kSharp the kTold smallest in any
/// case. Throws
/// InputError for a result whose faces or lines reach the frame of unbounded leaves, for `below` that is not
/// positive, and for more than kMostPairs.
std::vector<Feature> features(const Result& result, const std::optional<Rational>& below = {});

/// What nobody draws: pairs of cells that do not touch and are nearer than a millionth of the diagonal of the box
/// around the result, in one line; empty where there is none. `4 pairs of cells do not touch and are nearer than
/// ...`; where there are very many, that these are more than so many. Of two cells that touch elsewhere nothing is
/// told. Throws InputError for a result without bounds.
std::string nearly_touching_text(const Result& result, const Watch& watch = {});

/// Notices beside every evaluation, of a kept node: names that are lost (csg/evaluate/diagnostics.h), and the same
/// of cells of different leaves, with `weld` as a remedy; not of a result without bounds, nor of one of more than
/// 20,000 facets, of which it would take long.
std::vector<Diagnostic> near_and_lost(const Tree& tree, const Evaluation& evaluation, NodeId node,
                                      const Watch& watch = {});

/// A table of them, a line each: kind, value, cells, places, the leaves that made each cell.
std::string features_text(const Result& result, const std::vector<Feature>& features);

}  // namespace cnrg
