// How many steps a curve has that several leaves have, each with a fineness of its own.
//
// All that must have equal steps are tied into one class: a curve in many leaves, and the two rims of a wall of an
// extrusion with those of other walls on the same surface. A class has as many steps as the most that any
// curve in it needs for all that is asked of the class.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "csg/curves/boundary_curves.h"
#include "kernel/base/union_find.h"

namespace cnrg {

class CommonSteps {
 public:
  /// A leaf has the curve and asks for a fineness and further lines, at parameters between 0 and 1. Returns its
  /// number.
  std::uint32_t ask(const BezierCurve& curve, const Fineness& fineness, const std::vector<Rational>& lines);
  /// A number for what is no curve of a leaf: a projected one; those of different `kind`, from 1, are different.
  std::uint32_t number(const BezierCurve& curve, std::size_t kind);
  /// Both get the same even steps.
  void tie(std::uint32_t a, std::uint32_t b) { classes_.unite(a, b); }
  /// Steps of all curves that were asked for.
  AgreedSteps agree();

 private:
  struct Asked {
    BezierCurve curve;  // canonical
    std::optional<Fineness> fineness;
    std::set<Rational> lines{};
  };
  std::map<std::pair<std::size_t, ControlRow>, std::uint32_t> numbers_;
  std::vector<Asked> asked_;
  UnionFind classes_;
};

}  // namespace cnrg
