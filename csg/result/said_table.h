// What is said of the cells of a result as a table: different attributes each once, numbered as cells are met.
//
// The obvious way is a list of keys and values with every cell. Thousands of cells of one sheet would all say
// `aperture: 1/1000`. Here a cell has one number, a place in the table, and what files of arrays hold is looked up
// there.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "csg/result/arrays.h"
#include "csg/result/cell_tags.h"

namespace cnrg {

/// Names that are said of sheets, wires and points, ascending.
std::vector<std::string> said_names(const ResultView& view);

/// A key as the name of an array, unlike those that the cells of a .vtu have anyway.
std::string array_name(const std::string& key);

class SaidTableMaker {
 public:
  /// The place of what is said of a cell; ResultArrays::kNone: nothing.
  std::int32_t place(const CellTags& tags);
  /// All that was met, with columns for all that is said in the result.
  SaidTable table(const ResultView& view) const;

 private:
  std::vector<Attributes> said_;
  std::map<Attributes, std::int32_t, AttributesOrder> places_;
};

}  // namespace cnrg
