// The obvious way, to put each label at its place, prints one over another as soon as two cells are near. The best
// way, all labels at once, is a hard problem (maximum independent set) whose answer changes everywhere when a cell
// is added. Greedy: labels come in order of importance, and each takes what is left. A place beside a vertex is
// one of eight around it; a text may lie over a line, since a halo parts them, but each bit of line costs.
#include "csg/picture/labels.h"

#include <algorithm>
#include <limits>

#include "kernel/base/hypotenuse.h"

namespace cnrg {
namespace {

LabelBox box_around(const Point2& middle, double width, double height) {
  return {{middle[0] - width / 2, middle[1] - height / 2}, {middle[0] + width / 2, middle[1] + height / 2}};
}

/// How much of the segment lies in the box.
double length_in(const LabelBox& box, const Point2& a, const Point2& b) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    const double run = b[k] - a[k];
    if (run == 0) {
      if (a[k] < box.low[k] || a[k] > box.high[k]) return 0;
      continue;
    }
    const double s = (box.low[k] - a[k]) / run, t = (box.high[k] - a[k]) / run;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return to > from ? (to - from) * hypotenuse(b[0] - a[0], b[1] - a[1]) : 0;
}

double covered(const LabelBox& box, const std::vector<PaperSheet::Line>& lines) {
  double length = 0;
  for (const PaperSheet::Line& line : lines) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      length += length_in(box, line.points[i], line.points[i + 1]);
    }
    if (line.closed) length += length_in(box, line.points.back(), line.points.front());
  }
  return length;
}

bool meets(const LabelBox& box, const PaperSheet::Disk& disk) {
  double square = 0;
  for (int k = 0; k < 2; ++k) {
    const double off = disk.at[k] - std::clamp(disk.at[k], box.low[k], box.high[k]);
    square += off * off;
  }
  const double reach = disk.radius + disk.ring / 2;
  return square < reach * reach;
}

/// The largest disk around a place.
double reach_at(const Point2& at, const std::vector<PaperSheet::Disk>& disks) {
  double reach = 0;
  for (const PaperSheet::Disk& disk : disks) {
    if (disk.at == at) reach = std::max(reach, disk.radius + disk.ring / 2);
  }
  return reach;
}

/// The boxes of a label at a place, those liked best first; beside a mark that reaches so far.
std::vector<LabelBox> boxes_at(const PaperLabel& label, const Figure::Label::Place& place, double reach) {
  if (place.room > 0) {
    // A text is longer than high: it may reach a little out of the disk, where the corners of its box are empty.
    if (hypotenuse(label.width, label.height * 0.7) / 2 > place.room) return {};
    return {box_around(place.at, label.width, label.height)};
  }
  const double straight = std::max(4.5, reach + 1), slant = std::max(3.0, reach);
  constexpr double kAround[8][2] = {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}};
  std::vector<LabelBox> boxes;
  for (const auto& side : kAround) {
    const double off = side[0] != 0 && side[1] != 0 ? slant : straight;
    boxes.push_back(box_around({place.at[0] + side[0] * (label.width / 2 + off),
                                place.at[1] + side[1] * (label.height / 2 + (side[0] == 0 ? straight : off - 2))},
                               label.width, label.height));
  }
  return boxes;
}

}  // namespace

std::vector<LabelBox> place_labels(const std::vector<PaperLabel>& labels,
                                   const std::vector<PaperSheet::Line>& lines,
                                   const std::vector<PaperSheet::Disk>& disks, const LabelBox& page) {
  std::vector<LabelBox> taken(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    double rank = 0;
    for (const Figure::Label::Place& place : labels[i].places) {
      for (const LabelBox& box : boxes_at(labels[i], place, place.room > 0 ? 0 : reach_at(place.at, disks))) {
        rank += 0.5;
        if (rank >= least) break;  // no later place can be better
        const bool outside = box.low[0] < page.low[0] || box.low[1] < page.low[1] || box.high[0] > page.high[0] ||
                             box.high[1] > page.high[1];
        const auto over = [&](const LabelBox& other) { return box.meets(other); };
        if (outside || std::any_of(taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(i), over)) continue;
        if (std::any_of(disks.begin(), disks.end(), [&](const auto& disk) { return meets(box, disk); })) continue;
        const double cost = rank + covered(box, lines);
        if (cost < least) {
          least = cost;
          taken[i] = box;
        }
      }
    }
  }
  return taken;
}

}  // namespace cnrg
