// The tags of a cell in a file: its region or component, its material and its source.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/operators/sides.h"
#include "csg/result/flat.h"

namespace cnrg {

/// Numbers of a cell for formats that hold arrays of them; what each means is in the head of vtu.cpp.
struct CellTags {
  std::int32_t dimension = 0, cell = 0, component = 0, region = 0, front = 0, back = 0, bounded = -1;
  std::int32_t material = 0, leaf = -1, face = -1;  ///< `leaf` by its place (LeafInfo)
  LeafId source;                                    ///< the same leaf
  /// What is said of the cell: of a region or a cell of a component without regions what is said of the component,
  /// of a sheet, a wire or a point what is said of it. nullptr: nothing. Lives as long as the value.
  const Attributes* said = nullptr;
};

/// By component, where it is, by the names of leaves.
std::vector<std::vector<NamedSide>> named_sides(const ResultView& view);

/// The component whose material a cell has: of an entity of a group that of its region; 0: none.
Component material_component(const ResultView& view, const CellTags& tags);

/// The properties that are said of cells of a result, as data arrays of files: numbers where all values are
/// numbers, else texts, numbered from 1 in their order.
class PropertyFields {
 public:
  explicit PropertyFields(const ResultView& view);
  struct Field {
    std::string key;
    bool numeric = true;
    std::vector<std::string> texts{};  ///< ascending; empty if numeric
  };
  const std::vector<Field>& fields() const { return fields_; }  ///< by key
  /// The double nearest to the number; not a number where nothing is said.
  static double number(const Field& field, const CellTags& tags);
  /// The place of the text, from 1; 0 where nothing is said.
  static std::int32_t text(const Field& field, const CellTags& tags);

 private:
  std::vector<Field> fields_;
};

/// Tags of the cells of a flattened result, by their numbers there.
class CellTagger {
 public:
  CellTagger(const ResultView& view, const FlatComplex& flat) : view_(view), flat_(flat) {}
  CellTags vertex(FlatComplex::Index i) const;
  CellTags edge(FlatComplex::Index i) const;
  CellTags face(FlatComplex::Index i) const;
  CellTags region(FlatComplex::Index i) const;

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  std::int32_t region_number(FlatComplex::Index region) const;
  template <class Cell>
  CellTags in_region(std::int32_t dimension, FlatComplex::Index i, const Cell& cell) const;
  void finish(CellTags& tags, const FlatComplex::Provenance& origin) const;
};

}  // namespace cnrg
