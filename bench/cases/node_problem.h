// What other systems are given of a node of any operator: its operands as sets of marked cells, to compute its
// value from, or as solids and sheets, to part space by.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/cases/model.h"

namespace cnrg::bench {

/// Cells of any dimension, each in the set or not: the first layer without (the second without (the third ...)).
/// Layers are closed and bounded.
struct MarkedSet {
  std::vector<Model> layers;
  bool complement = false;  ///< all of space but that
};

/// A value and how it comes about: `words` is an expression in postfix, of places in `operands` and of the
/// operations `union`, `intersection`, `difference`, which is closed, `without`, which is not, `interior`,
/// `closure`, `boundary` and `regularization`.
struct SetProblem {
  std::vector<std::string> words;
  std::vector<MarkedSet> operands;
  MarkedSet value;
};

/// Text that reads back exactly; `read_set_problem` throws std::runtime_error for a text that is none.
void write_set_problem(std::ostream& out, const SetProblem& problem);
SetProblem read_set_problem(std::istream& in);

/// Disjoint regions, numbered from 1, and faces without thickness.
struct ParcelledOperand {
  struct Region {
    Model solid;
    bool outside = false;  ///< the region is what lies outside of the solid
  };
  std::vector<Region> regions;
  Model sheets;
};

/// Space parted by all faces of operands.
struct Arrangement {
  struct Part {
    std::vector<std::uint32_t> regions;  ///< of each operand; 0: none
    double volume = 0;
  };
  /// A piece of a face that parts two parts.
  struct Face {
    std::array<std::size_t, 2> parts{};
    std::vector<char> of;  ///< for each operand whether the face is one of it
    double area = 0;
  };
  std::vector<Part> parts;  ///< the first one is unbounded
  std::vector<Face> faces;
};

}  // namespace cnrg::bench
