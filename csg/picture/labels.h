// Where labels stand: greedily, each at the best of its places that is free.
#pragma once

#include <vector>

#include "csg/picture/sheet.h"

namespace cnrg {

struct LabelBox {
  Point2 low{}, high{};
  bool meets(const LabelBox& other) const {
    return low[0] < other.high[0] && other.low[0] < high[0] && low[1] < other.high[1] && other.low[1] < high[1];
  }
};

/// A label on paper: as in a Figure, with its size.
struct PaperLabel {
  std::vector<Figure::Label::Place> places;
  double width = 0, height = 0;
};

/// For each label its box, or one without extent if there is no room for it. No box meets another one, a disk or
/// what lies outside of `page`; of the free places of a label that one is taken that covers the least of lines.
std::vector<LabelBox> place_labels(const std::vector<PaperLabel>& labels,
                                   const std::vector<PaperSheet::Line>& lines,
                                   const std::vector<PaperSheet::Disk>& disks, const LabelBox& page);

}  // namespace cnrg
