// Edges to the lengths that are wanted: long ones are halved, short ones are pulled together.
//
// Which edge is halved first decides what comes of it. An edge that is the longest of all around it leaves halves
// that are hardly flatter than what they are made of (rivara1984); to halve what comes first in the list instead
// makes three to seven times as many tetrahedra as the lengths ask for, of which most have to be pulled together
// again, and in thin regions ever flatter ones.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "kernel/tetrahedra/improve.h"
#include "kernel/tetrahedra/moves.h"

namespace cnrg {

class Lengths {
 public:
  using Index = Stars::Index;
  /// Asked between moves, by a walk at that tetrahedron: does the work end?
  using Ends = std::function<bool(Index)>;
  /// Edges are as wanted between these, in lengths that are wanted.
  static constexpr double kLong = kLongestEdge, kShort = 0.7071;

  /// Of the options `size`, which is not empty, and `region_size`.
  Lengths(Stars& mesh, Moves& moves, const ImproveOptions& options)
      : mesh_(mesh), moves_(moves), options_(options) {}

  double wanted(Index v);
  /// Points from there on are others now.
  void forget(Index from) { wanted_.resize(std::min<std::size_t>(wanted_.size(), from)); }
  /// The longest edge, in lengths that are wanted there.
  double longest(const Ends& ends);
  /// Takes away edges that are longer than that, by shorter ones where this makes shapes better, else by halves.
  /// The number of halves.
  std::size_t halve(double longer, const Ends& ends);
  /// Pulls short edges together where all shapes are above `enough`, or above the worst that there was; how many.
  std::size_t collapse(double enough, const Ends& ends);
  /// What an edge between these may have at most, squared, that a move makes which pulls them together.
  double most(Index a, Index b);

 private:
  struct Edge {
    double squared;  // length
    Index a, b;      // ascending
    auto operator<=>(const Edge&) const = default;
  };
  Stars& mesh_;
  Moves& moves_;
  const ImproveOptions& options_;
  std::vector<double> wanted_;  // by vertex

  double length(Index a, Index b, std::int32_t region);
  void add_edges(const Stars::Tetrahedron& t, double longer, std::vector<Edge>& out);
};

}  // namespace cnrg
