// Cells of a result under the names that people give them: `rock`, `boundary of rock`, `wall rock | ore`, `from
// fault` (csg/FORMATS.md#msh).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "csg/result/result.h"

namespace cnrg {

struct CellGroup {
  std::string name;                 ///< distinct within a dimension
  std::vector<std::int32_t> cells;  ///< numbers of cells of that dimension, ascending
};

/// By dimension; a cell may be in several, the first says what it is.
std::array<std::vector<CellGroup>, 4> cell_groups(const Result& result);

}  // namespace cnrg
