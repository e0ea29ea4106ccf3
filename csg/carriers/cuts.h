// Where pieces of patches and curves are cut, so that all that overlap are cut alike.
//
// Each direction of a piece (u or v of a patch, the one of a curve) is a *strand*, from 0 to 1. Two strands are
// linked where they run beside each other: pieces overlap on one carrier, or a side of one lies on a side of the
// other. Then an affine map takes parameters of one to those of the other, and what falls inside of the other, an
// end or a cut, is a cut of the other. So cuts go from strand to strand, through patches from side to side, until
// nothing new comes. Lines go the same way, but nothing is cut there: a piece gets one more line of facets.
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

class Cuts {
 public:
  /// Of strands that cut each other for ever: a patch may have a part of one side as the opposite side.
  static constexpr std::size_t kMostCuts = 10'000;

  /// Strands have owners, the leaves, by number.
  std::size_t add_strand(std::size_t owner);
  /// True for intervals, in either order, that have more than a point in common.
  static bool overlap(const std::array<Rational, 2>& a, const std::array<Rational, 2>& b);
  /// `of_a`, `of_b`: parameters of the strands' beginnings and ends on what both lie on. They are linked if these
  /// overlap.
  void link(std::size_t a, const std::array<Rational, 2>& of_a, std::size_t b,
            const std::array<Rational, 2>& of_b);
  /// A line at a parameter between 0 and 1.
  void add_line(std::size_t strand, const Rational& at) { strands_[strand].lines.insert(at); }
  void concern(std::size_t owner) { concerned_.insert(owner); }
  /// Owners that have a link to another owner, and those of `concern`.
  const std::set<std::size_t>& concerned() const { return concerned_; }
  /// Makes the cuts, of concerned owners only. Throws InputError above kMostCuts; the message names the owner as
  /// `leaf N`.
  void spread();
  /// Of a strand: ascending, with 0 and 1.
  const std::set<Rational>& of(std::size_t strand) const { return strands_[strand].cuts; }
  /// Those of a strand between two cuts, as parameters from 0 to 1 between them, ascending.
  std::vector<Rational> lines(std::size_t strand, const Rational& low, const Rational& high) const;

 private:
  struct Link {
    std::size_t to;
    Rational scale, shift;
  };
  struct Strand {
    std::size_t owner = 0;
    std::vector<Link> links;
    std::set<Rational> cuts{0, 1}, lines;
  };
  void spread(std::vector<std::pair<std::size_t, Rational>> open, std::set<Rational> Strand::*marks);
  std::vector<Strand> strands_;
  std::set<std::size_t> concerned_;
};

}  // namespace cnrg
