// What is said of each cell of each value, by the words of csg/SEMANTICS.md#attributes alone.
//
// The program carries what is said with the origins of its cells, by sets of leaves that are interned, merged in
// folds and kept in parts. Here it is an array over the cells of the grid, and every rule is a loop over it. Where
// the page leaves open which of two regions of one operand counts, nothing is known.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/oracles/cubical_values.h"

namespace cubical {

using cnrg::Attributes;

/// What is said of a cell, and the dimension of the sheet, wire or point that it is said of.
struct Thing {
  Attributes attributes;
  int dimension = 2;
  bool known = true;  ///< false: the page does not say what
};
using Said = std::vector<std::optional<Thing>>;  // by cell of the grid; nothing: no sheet, wire or point

using Warning = std::tuple<std::string, std::string, std::string>;  // key, kept, other

struct Saying {
  Said said;
  Said stands_for;                                 ///< of the complement of a group: of the group of its closure
  std::vector<std::optional<Attributes>> regions;  ///< of a group, by region - 1; nothing: not known here
  std::vector<std::optional<Attributes>> owners;   ///< by active cell: those of its component; nothing: not known
  std::set<Warning> warnings;
  bool warnings_known = true;
};

std::string text(const Attributes& a);
/// What `stronger` says replaces what is there, properties key by key.
void say(Attributes& a, const Attributes& stronger);

/// Of all nodes.
std::vector<Saying> sayings(const Grid& grid, const cnrg::properties::RandomDag& dag,
                            const std::vector<Value>& values);

}  // namespace cubical
