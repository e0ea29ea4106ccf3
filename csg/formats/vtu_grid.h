// An unstructured grid in VTK's XML: cells of any kind with their tags, and what their names are.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "csg/result/cell_tags.h"

namespace cnrg {

/// VTK's numbers of the kinds of cells.
enum class VtuCell : std::uint8_t {
  vertex = 1,
  poly_vertex = 2,
  line = 3,
  triangle = 5,
  quad = 9,
  tetrahedron = 10,
  wedge = 13,
  quadratic_edge = 21,
  quadratic_triangle = 22,
  quadratic_tetrahedron = 24
};

/// Parameters of points on patches, for the viewer: NaN where there are none.
struct VtuParameters {
  std::vector<double> uv;             ///< u, v of each point of the grid
  std::vector<std::int32_t> patches;  ///< of each cell of the grid: from 1, a place in `names`; 0: none
  std::vector<std::string> names;     ///< `leaf: patch`
};

class VtuGrid {
 public:
  /// Adds a cell on points by number.
  template <class Range>
  void add(VtuCell kind, const Range& points, const CellTags& tags) {
    connectivity_.insert(connectivity_.end(), std::begin(points), std::end(points));
    add_tags(kind, tags);
  }
  bool empty() const { return types_.empty(); }
  /// The file: arrays in base64 of little-endian numbers, doubles unrounded. `twins`: as of a Mesh.
  std::string text(const ResultView& view, const std::vector<std::array<double, 3>>& points,
                   const VtuParameters* parameters = nullptr, const std::vector<std::uint32_t>& twins = {}) const;

 private:
  // One entry per cell of the grid.
  std::vector<std::int64_t> connectivity_, offsets_;
  std::vector<std::uint8_t> types_;
  static constexpr std::array<std::pair<const char*, std::int32_t CellTags::*>, 10> kTags{
      {{"dimension", &CellTags::dimension},
       {"cell", &CellTags::cell},
       {"component", &CellTags::component},
       {"region", &CellTags::region},
       {"region_front", &CellTags::front},
       {"region_back", &CellTags::back},
       {"regions_bounded", &CellTags::bounded},
       {"material", &CellTags::material},
       {"source_leaf", &CellTags::leaf},
       {"source_face", &CellTags::face}}};
  std::array<std::vector<std::int32_t>, kTags.size()> tags_;
  std::vector<const Attributes*> said_;  // CellTags::said
  CellTags tags(std::size_t cell) const;
  void append_fractions(std::string& text, const ResultView& view,
                        const std::vector<std::array<double, 3>>& points) const;
  void add_tags(VtuCell kind, const CellTags& tags) {
    offsets_.push_back(std::int64_t(connectivity_.size()));
    types_.push_back(std::uint8_t(kind));
    for (std::size_t k = 0; k < kTags.size(); ++k) tags_[k].push_back(tags.*kTags[k].second);
    said_.push_back(tags.said);
  }
};

}  // namespace cnrg
