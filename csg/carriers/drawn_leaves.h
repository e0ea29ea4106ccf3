// Leaves of revolution that were drawn anew, by the lines that they are on.
//
// One leaf is drawn again and again: with further lines, and for each node with the leaves below that node. Mostly
// it is on the same lines then, and what was made of it before serves, with all that others keep by the leaf.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "csg/carriers/axes.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

class DrawnLeaves {
 public:
  /// All that the facets of a leaf depend on.
  struct Lines {
    Transform transform;  ///< to the space of the axis
    AxisLine axis;
    std::optional<Rational> rounded;  ///< the size for which corners are (Family::point)
    RevolvedGrid grid;
    friend bool operator==(const Lines&, const Lines&) = default;
  };

  /// `before` on lines, by `make()` if it was not there before.
  template <class Make>
  std::shared_ptr<const PreparedLeaf> on(const std::shared_ptr<const PreparedLeaf>& before, const Lines& lines,
                                         const Make& make) {
    auto& all = of_[before];
    for (const auto& [known, made] : all) {
      if (known == lines) return made;
    }
    return all.emplace_back(lines, make()).second;
  }

 private:
  std::map<std::shared_ptr<const PreparedLeaf>, std::vector<std::pair<Lines, std::shared_ptr<const PreparedLeaf>>>>
      of_;
};

}  // namespace cnrg
