// Sums of square roots: lengths and areas as they are.
//
// The length of an edge is the root of a rational, and so is the area of a face. A sum of doubles would say that a
// unit square cut in seven has an area of 1 and something; so roots are kept as q sqrt(n), and those that differ
// by a rational factor are added: the area of a box is a rational, that of its diagonal cut 2 sqrt(2). Only where
// a sum has many different roots (the facets of a sphere) it is told as a decimal, and that is the nearest one.
#pragma once

#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

class RootSum {
 public:
  /// Adds the root of a rational from 0.
  void add_root(const Rational& square);
  void add(const RootSum& other);

  bool is_zero() const { return terms_.empty() && squares_.empty(); }
  /// A rational whose relative distance to the sum is below 10^-digits.
  Rational value(int digits = 30) const;
  /// `3/2`, `1 + 2 sqrt(3)`, both with a decimal where they are long; a sum of many roots as the decimal of
  /// 12 digits that is nearest to it: `6.27305853421 (rounded)`.
  std::string text() const;

 private:
  /// factor * sqrt(radicand), both positive; no two radicands differ by a square.
  struct Term {
    Rational factor;
    Integer radicand;
  };
  void add(Term term);

  std::vector<Term> terms_;        ///< at most kMostTerms, in the order in which they came
  std::vector<Rational> squares_;  ///< of roots that would have made more terms
};

}  // namespace cnrg
