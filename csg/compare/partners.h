// Which components of two values correspond.
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "kernel/selection/selection.h"

namespace cnrg {

/// The cells that two selections share, by pair of components.
using Shared = std::map<std::pair<Component, Component>, CellSet>;
Shared shared_cells(const Selection& a, const Selection& b);

struct Partners {
  std::set<std::pair<Component, Component>> pairs;  ///< that correspond
  /// Families that are not one and one.
  std::vector<std::array<std::vector<Component>, 2>> families;
};

/// Components that share cells are of one family. In a family of one and one, one and several or several and one
/// all that share correspond; in any other each component has one partner at most, pairs that share most first: by
/// volume, then area, length and number of points. `entities`: of two groups the components that their entities
/// are (0: none), which correspond to each other and to nothing else. `count`: how many components there are.
Partners partners(const Complex& complex, const Shared& shared, const std::array<Component, 2>& entities,
                  const std::array<std::size_t, 2>& count);

}  // namespace cnrg
