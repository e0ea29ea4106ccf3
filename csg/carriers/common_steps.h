// How many steps a curve has that several leaves have, each with a fineness of its own.
//
// All that must have equal steps are tied into one class: a curve in many leaves, and the two rims of a wall of an
// extrusion with those of other walls on the same surface. A class has as many steps as the most that any
// curve in it needs for all that is asked of the class.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "csg/curves/boundary_curves.h"

namespace cnrg {

class CommonSteps {
 public:
  /// A leaf has the curve and asks for a fineness. Returns its number.
  std::size_t ask(const BezierCurve& curve, const Fineness& fineness);
  /// A number for what is no curve of a leaf, such as one that has been projected along `kind`.
  std::size_t number(const BezierCurve& curve, const RationalPoint& kind);
  /// Both get the same steps.
  void tie(std::size_t a, std::size_t b);
  /// Steps of all curves that were asked for.
  AgreedSteps agree();

 private:
  struct Asked {
    BezierCurve curve;  // canonical
    std::optional<Fineness> fineness;
    std::size_t up;  // to the first of its class, which is its own
  };
  std::size_t first_of(std::size_t a);
  std::map<std::pair<RationalPoint, ControlRow>, std::size_t> numbers_;
  std::vector<Asked> asked_;
};

}  // namespace cnrg
