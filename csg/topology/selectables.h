// What can be picked out of a value by `select`, each criterion with the number of cells for which it holds.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "csg/result/result.h"

namespace cnrg {

/// One criterion with one value.
struct Selectable {
  /// As in a tree: `dimension`, `region`, `front of`, `behind`, `name`, `material`, `attributes`, `from`,
  /// `between`.
  std::string key;
  std::string value;  ///< as in a tree; of `between` `[A, B]`, null for no region
  /// Vertices, edges, faces and regions as files number them; what comes along as their boundary is not counted.
  std::array<std::size_t, 4> cells{};
  std::vector<std::uint32_t>
      source_faces{};  ///< of `from`: faces of that leaf in which faces of the value lie; ascending
};

/// In the order of the keys above, of a key by value; dimensions downwards. Values without any cell are left out.
std::vector<Selectable> selectables(const Result& result);

/// A table of them, a line each.
std::string selectables_text(const std::vector<Selectable>& list);

}  // namespace cnrg
