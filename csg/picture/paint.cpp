// One scale for all panels: they show one model, and a part that looks larger in the next panel would lie. The
// picture is as large as what is in it: each panel is cut to what was drawn and written there, a column is as wide
// as its widest panel, a row as high as its highest. So no band of it is empty, whatever the model's proportions.
//
// What is said by a line is the same as on the page of `cnrg view`: missing faces are hatched, missing edges
// dashed, missing vertices hollow; a sheet has a weave and a thick border, a wire is thick, a point that is on no
// edge has a ring.
#include "csg/picture/paint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <vector>

#include "csg/picture/font.h"
#include "csg/picture/paper.h"
#include "csg/picture/sheet.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"
#include "kernel/base/hypotenuse.h"

namespace cnrg {
namespace {

// Where labels stand: greedily, each at the best of its places that is free.
//
// The obvious way, to put each label at its place, prints one over another as soon as two cells are near. The best
// way, all labels at once, is a hard problem (maximum independent set) whose answer changes everywhere when a cell
// is added. Greedy: labels come in order of importance, and each takes what is left. A place beside a vertex is
// one of eight around it; a text may lie over a line, since a halo parts them, but each bit of line costs.

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

/// For each label its box, or one without extent if there is no room for it. No box meets another one, a disk or
/// what lies outside of `page`; of the free places of a label that one is taken that covers the least of lines.
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

constexpr double kPageWidth = 960, kMostWidth = 640, kLeastWidth = 200;
constexpr std::size_t kInRow = 5;
constexpr double kRim = 6;     // around a panel, for lines and dots at its border
constexpr double kMargin = 4;  // of the picture
constexpr double kColumnGap = 24, kRowGap = 16;
constexpr double kLabelSize = 12, kCaptionSize = 13.5, kKeySize = 12;
constexpr double kLine = 1.32;  // from one line of text to the next, in sizes of letters
constexpr double kSwatch = 13, kKeyGap = 20;
constexpr double kCaptionLeast = 140;  // a caption may be so wide, however narrow its panel is

/// `weight`: of all lines, less than 1 in panels that are small.
PaperSheet::Look look_of(const Figure::Stroke& stroke, double weight) {
  PaperSheet::Look look{1.1, stroke.color};
  switch (stroke.line) {
    case Figure::Line::mesh: look.width = 0.45; break;
    case Figure::Line::edge: break;
    case Figure::Line::outline: look.width = 1.8; break;
    case Figure::Line::border: look.width = 2.3; break;
    case Figure::Line::wire: look.width = 3.2; break;
    case Figure::Line::ghost:
      look.width = 0.9;
      look.dash = 1.5;
      look.gap = 2.5;
      look.opacity = 0.6;
      break;
  }
  if (stroke.missing) {
    look.dash = 5 + look.width;
    look.gap = 3 + look.width;
  }
  if (stroke.hidden) {
    look.width *= 0.7;
    look.opacity = stroke.line == Figure::Line::wire ? 0.7 : 0.4;
  }
  look.width *= weight;
  return look;
}

/// Strokes of one look that meet at a point where no third one ends, as one: a dash goes on there, and no corner
/// shows two ends.
std::vector<PaperSheet::Line> join_lines(std::vector<PaperSheet::Line> lines) {
  using Key = std::pair<Point2, std::array<double, 7>>;
  const auto key_of = [](const Point2& p, const PaperSheet::Look& l) {
    return Key{p, {l.width, l.color[0], l.color[1], l.color[2], l.dash, l.gap, l.opacity}};
  };
  std::map<Key, std::vector<std::size_t>> ends;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].closed || lines[i].points.size() < 2) continue;
    ends[key_of(lines[i].points.front(), lines[i].look)].push_back(i);
    ends[key_of(lines[i].points.back(), lines[i].look)].push_back(i);
  }
  std::vector<char> used(lines.size());
  // The stroke that goes on at `p`, if there is exactly one.
  const auto next_of = [&](const Point2& p, const PaperSheet::Look& look) -> std::optional<std::size_t> {
    const std::vector<std::size_t>& here = ends.at(key_of(p, look));
    if (here.size() != 2) return std::nullopt;
    for (const std::size_t i : here)
      if (!used[i]) return i;
    return std::nullopt;
  };
  std::vector<PaperSheet::Line> joined;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    used[i] = 1;
    PaperSheet::Line chain = std::move(lines[i]);
    if (!chain.closed && chain.points.size() >= 2) {
      for (int side = 0; side < 2; ++side) {
        while (const auto next = next_of(chain.points.back(), chain.look)) {
          used[*next] = 1;
          std::vector<Point2>& points = lines[*next].points;
          if (points.front() != chain.points.back()) std::reverse(points.begin(), points.end());
          chain.points.insert(chain.points.end(), points.begin() + 1, points.end());
        }
        std::reverse(chain.points.begin(), chain.points.end());
      }
      if (chain.points.size() > 3 && chain.points.front() == chain.points.back() &&
          ends.at(key_of(chain.points.front(), chain.look)).size() == 2) {
        chain.points.pop_back();
        chain.closed = true;
      }
    }
    joined.push_back(std::move(chain));
  }
  return joined;
}

/// A figure in the place that it has on paper, from (0, 0) on, and the labels that have room.
struct Laid {
  PaperSheet sheet;
  std::vector<std::string> lines;  // of the caption
};

bool empty(const Figure& figure) { return figure.areas.empty() && figure.strokes.empty() && figure.dots.empty(); }

class Layout {
 public:
  Layout(const std::vector<Panel>& panels, const std::optional<PictureSize>& size, const Font& font)
      : panels_(panels), font_(font) {
    rows_ = (panels.size() + kInRow - 1) / kInRow;
    columns_ = (panels.size() + rows_ - 1) / rows_;
    const double width = std::clamp(kPageWidth / static_cast<double>(columns_), kLeastWidth, kMostWidth);
    box_ = size ? std::array{size->width, size->height} : std::array{width, width * 3 / 4};
    for (const Panel& panel : panels) {
      for (const Figure::Label& label : panel.figure.labels) {
        for (const Figure::Label::Place& place : label.places) {
          if (place.room == 0) beside_ = std::max(beside_, font.width(label.text, kLabelSize));
        }
      }
    }
    weight_ = std::clamp(std::max(box_[0], box_[1]) / 300, 0.7, 1.0);
    choose_scale();
  }

  PaperSheet sheet() {
    std::vector<Laid> laid;
    for (const Panel& panel : panels_) laid.push_back(lay(panel));
    // The grid: columns and rows as large as what is in them.
    std::vector<double> widths(columns_), heights(rows_), captions(rows_);
    for (std::size_t i = 0; i < laid.size(); ++i) {
      double& width = widths[i % columns_];
      width = std::max(width, laid[i].sheet.width);
      for (const std::string& line : laid[i].lines) width = std::max(width, font_.width(line, kCaptionSize));
      double& height = heights[i / columns_];
      height = std::max(height, laid[i].sheet.height);
      double& caption = captions[i / columns_];
      caption = std::max(caption, static_cast<double>(laid[i].lines.size()) * kCaptionSize * kLine);
    }
    PaperSheet whole;
    for (const double w : widths) whole.width += w;
    whole.width += kColumnGap * static_cast<double>(columns_ - 1);
    // The key may be wider than panels that are small.
    const std::vector<std::vector<Figure::Key>> keys = key_rows(std::max(whole.width, kLeastWidth), whole);
    const double left = (whole.width - grid_width(widths)) / 2 + kMargin;
    double top = kMargin;
    for (std::size_t row = 0; row < rows_; ++row) {
      double x = left;
      // The last row may have fewer panels: they stand in its middle.
      const std::size_t first = row * columns_, last = std::min(laid.size(), first + columns_);
      for (std::size_t i = last - first; i < columns_; ++i) x += (widths[i] + kColumnGap) / 2;
      for (std::size_t i = first; i < last; ++i) {
        const double width = widths[i - first];
        const PaperSheet& part = laid[i].sheet;
        add(whole, part, {x + (width - part.width) / 2, top + (heights[row] - part.height) / 2});
        double y = top + heights[row] + kCaptionSize * kLine * 0.55;
        for (const std::string& line : laid[i].lines) {
          whole.texts.push_back({line, {x + width / 2, y}, kCaptionSize, false});
          y += kCaptionSize * kLine;
        }
        x += width + kColumnGap;
      }
      top += heights[row] + captions[row] + (row + 1 < rows_ ? kRowGap : 0);
    }
    for (const std::vector<Figure::Key>& row : keys) {
      top += kKeySize * 0.5;
      double x = kMargin + (whole.width - key_width(row)) / 2;
      const double middle = top + kSwatch / 2 + 1;
      for (const Figure::Key& key : row) {
        add_swatch(whole, {x, middle - kSwatch / 2}, key.color);
        const double width = font_.width(key.text, kKeySize);
        whole.texts.push_back({key.text, {x + kSwatch + 6 + width / 2, middle}, kKeySize, false});
        x += kSwatch + 6 + width + kKeyGap;
      }
      top += kSwatch + 2;
    }
    whole.width = std::ceil(whole.width + 2 * kMargin);
    whole.height = std::ceil(top + kMargin);
    for (const Panel& panel : panels_) {
      if (panel.caption.empty()) continue;
      if (!whole.title.empty()) whole.title += "; ";
      whole.title += panel.caption;
    }
    return whole;
  }

 private:
  const std::vector<Panel>& panels_;
  const Font& font_;
  std::size_t rows_ = 1, columns_ = 1;
  std::array<double, 2> box_{};
  double beside_ = 0;  // the widest text that stands beside its place; room is left for it
  double scale_ = 1;
  double weight_ = 1;            // of lines and dots
  std::set<std::string> named_;  // texts of labels that had room

  static double grid_width(const std::vector<double>& widths) {
    double sum = kColumnGap * static_cast<double>(widths.size() - 1);
    for (const double w : widths) sum += w;
    return sum;
  }

  /// Space on each side of a figure.
  Point2 space() const {
    if (beside_ == 0) return {kRim, kRim};
    return {kRim + std::min(beside_ + 4, box_[0] / 6), kRim + std::min(kLabelSize * 1.3, box_[1] / 6)};
  }

  void choose_scale() {
    double scale = std::numeric_limits<double>::infinity();
    for (const Panel& panel : panels_) {
      if (empty(panel.figure)) continue;
      for (int k = 0; k < 2; ++k) {
        // By halves: the model may be as large as doubles are.
        const double extent = panel.figure.high[k] / 2 - panel.figure.low[k] / 2;
        if (extent > 0) scale = std::min(scale, (box_[k] / 2 - space()[k]) / extent);
      }
    }
    scale_ = std::isfinite(scale) ? scale : 1;
  }

  Laid lay(const Panel& panel) {
    const Figure& figure = panel.figure;
    Laid laid;
    laid.lines = wrapped(panel.caption, std::max(box_[0], kCaptionLeast));
    PaperSheet& sheet = laid.sheet;
    if (empty(figure)) {
      const std::string nothing = "empty";
      sheet.width = font_.width(nothing, kLabelSize) + 2 * kRim;
      sheet.height = 3 * kLabelSize;
      sheet.texts.push_back({nothing, {sheet.width / 2, sheet.height / 2}, kLabelSize, false});
      return laid;
    }
    const Point2 space = this->space();
    const auto place = [&](const Point2& p) {
      return Point2{(p[0] / 2 - figure.low[0] / 2) * scale_ * 2 + space[0],
                    (figure.high[1] / 2 - p[1] / 2) * scale_ * 2 + space[1]};
    };
    const auto placed = [&](const std::vector<Point2>& points) {
      std::vector<Point2> result;
      for (const Point2& p : points) result.push_back(place(p));
      return result;
    };
    LabelBox used{place({figure.low[0], figure.high[1]}), place({figure.high[0], figure.low[1]})};
    for (const Figure::Area& area : figure.areas) {
      // Nothing lies behind an area but paper: what shines through is drawn in areas and lines of its own.
      PaperSheet::Area made{{}, mix(kPaper, area.color, area.opacity)};
      if (area.missing) {
        made.pattern = PaperSheet::Pattern::hatch;
        made.lines = mix(mix(kPaper, area.color, std::max(area.opacity, 0.6)), kInk, 0.15);
        made.color = mix(kPaper, area.color, 0.22 * area.opacity);
      } else if (area.sheet) {
        made.pattern = PaperSheet::Pattern::weave;
        made.lines = mix(made.color, kInk, 0.14);
      }
      for (const std::vector<Point2>& loop : area.loops) made.loops.push_back(placed(loop));
      sheet.areas.push_back(std::move(made));
    }
    std::vector<PaperSheet::Line> lines;
    for (const Figure::Stroke& stroke : figure.strokes) {
      lines.push_back({placed(stroke.points), stroke.closed, look_of(stroke, weight_)});
    }
    sheet.lines = join_lines(std::move(lines));
    // What is behind or gone first, then thin lines, then thick ones.
    std::stable_sort(
        sheet.lines.begin(), sheet.lines.end(), [](const PaperSheet::Line& a, const PaperSheet::Line& b) {
          return std::pair(a.look.opacity == 1, a.look.width) < std::pair(b.look.opacity == 1, b.look.width);
        });
    for (const Figure::Dot& dot : figure.dots) {
      const Point2 at = place(dot.at);
      const double opacity = dot.hidden ? 0.5 : 1;
      if (dot.mark == Figure::Mark::isolated) {
        sheet.disks.push_back({at, 4.7 * weight_, {}, dot.color, 1.2 * weight_, opacity});
      }
      if (dot.missing) sheet.disks.push_back({at, 2.6 * weight_, kPaper, dot.color, 1.2 * weight_, opacity});
      else sheet.disks.push_back({at, 2.3 * weight_, dot.color, dot.color, 0, opacity});
    }
    add_labels(figure, place, space, sheet, used);
    // Cut to what is there.
    for (int k = 0; k < 2; ++k) {
      used.low[k] -= kRim;
      used.high[k] += kRim;
    }
    PaperSheet cut;
    add(cut, sheet, {-used.low[0], -used.low[1]});
    cut.width = used.high[0] - used.low[0];
    cut.height = used.high[1] - used.low[1];
    sheet = std::move(cut);
    return laid;
  }

  template <class Place>
  void add_labels(const Figure& figure, const Place& place, const Point2& space, PaperSheet& sheet,
                  LabelBox& used) {
    std::vector<PaperLabel> labels;
    for (const Figure::Label& label : figure.labels) {
      PaperLabel paper{{}, font_.width(label.text, kLabelSize), kLabelSize};
      for (const Figure::Label::Place& at : label.places) paper.places.push_back({place(at.at), at.room * scale_});
      labels.push_back(std::move(paper));
    }
    const LabelBox page{{used.low[0] - space[0], used.low[1] - space[1]},
                        {used.high[0] + space[0], used.high[1] + space[1]}};
    const std::vector<LabelBox> boxes = place_labels(labels, sheet.lines, sheet.disks, page);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const LabelBox& box = boxes[i];
      if (box.low == box.high) continue;
      named_.insert(figure.labels[i].text);
      sheet.texts.push_back({figure.labels[i].text,
                             {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2},
                             kLabelSize,
                             true});
      for (int k = 0; k < 2; ++k) {
        used.low[k] = std::min(used.low[k], box.low[k]);
        used.high[k] = std::max(used.high[k], box.high[k]);
      }
    }
  }

  static void add(PaperSheet& whole, const PaperSheet& part, const Point2& by) {
    const auto move = [&](Point2& p) {
      p[0] += by[0];
      p[1] += by[1];
    };
    for (PaperSheet::Area area : part.areas) {
      for (auto& loop : area.loops) std::for_each(loop.begin(), loop.end(), move);
      whole.areas.push_back(std::move(area));
    }
    for (PaperSheet::Line line : part.lines) {
      std::for_each(line.points.begin(), line.points.end(), move);
      whole.lines.push_back(std::move(line));
    }
    for (PaperSheet::Disk disk : part.disks) {
      move(disk.at);
      whole.disks.push_back(disk);
    }
    for (PaperSheet::Text text : part.texts) {
      move(text.middle);
      whole.texts.push_back(std::move(text));
    }
  }

  static void add_swatch(PaperSheet& whole, const Point2& at, const Rgb& color) {
    const std::vector<Point2> corners{
        at, {at[0] + kSwatch, at[1]}, {at[0] + kSwatch, at[1] + kSwatch}, {at[0], at[1] + kSwatch}};
    whole.areas.push_back({{corners}, color});
    whole.lines.push_back({corners, true, {0.8, mix(color, kInk, 0.7)}});
  }

  /// In lines no wider than `width`, where its words allow.
  std::vector<std::string> wrapped(const std::string& text, double width) const {
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      const std::string longer = lines.empty() ? word : lines.back() + " " + word;
      if (lines.empty() || font_.width(longer, kCaptionSize) > width) lines.push_back(word);
      else lines.back() = longer;
    }
    return lines;
  }

  double key_width(const std::vector<Figure::Key>& row) const {
    double width = -kKeyGap;
    for (const Figure::Key& key : row) width += kSwatch + 6 + font_.width(key.text, kKeySize) + kKeyGap;
    return width;
  }

  /// The colors of all panels, unless there is only one, labels name them all, or one stands for two things; makes
  /// `whole` as wide as they are.
  std::vector<std::vector<Figure::Key>> key_rows(double width, PaperSheet& whole) const {
    std::vector<Figure::Key> keys;
    for (const Panel& panel : panels_) {
      for (const Figure::Key& key : panel.figure.keys) {
        const auto same = [&](const Figure::Key& k) { return k.color == key.color && k.text == key.text; };
        if (std::none_of(keys.begin(), keys.end(), same)) keys.push_back(key);
      }
    }
    const auto named = [&](const Figure::Key& key) { return named_.count(key.text) != 0; };
    std::set<Rgb> colors;
    for (const Figure::Key& key : keys) colors.insert(key.color);
    std::vector<std::vector<Figure::Key>> rows;
    const bool come_again = colors.size() < keys.size();
    if (keys.size() < 2 || come_again || std::all_of(keys.begin(), keys.end(), named)) return rows;
    for (const Figure::Key& key : keys) {
      if (!rows.empty()) {
        rows.back().push_back(key);
        if (key_width(rows.back()) <= width) continue;
        rows.back().pop_back();
      }
      rows.push_back({key});
    }
    for (const auto& row : rows) whole.width = std::max(whole.width, key_width(row));
    return rows;
  }
};

/// Texts as they will be seen, so that their widths are known.
std::vector<Panel> with_shown_texts(std::vector<Panel> panels, const Font& font, bool brings_font) {
  const auto show = [&](std::string& text) {
    text = shown(text);
    if (brings_font) text = font.without_unknown(text);
  };
  for (Panel& panel : panels) {
    show(panel.caption);
    for (Figure::Label& label : panel.figure.labels) show(label.text);
    for (Figure::Key& key : panel.figure.keys) show(key.text);
  }
  return panels;
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".png" || extension == ".svg" || extension == ".pdf";
}

std::string picture_bytes(const std::string& path, const std::vector<Panel>& panels,
                          const std::optional<PictureSize>& size) {
  require(is_picture(path), "picture_bytes: unknown extension");
  require(!panels.empty(), "picture_bytes: no panel");
  const std::string extension = extension_of(path);
  const std::unique_ptr<Font> font(CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_font)());
  const PaperSheet sheet = Layout(with_shown_texts(panels, *font, extension != ".svg"), size, *font).sheet();
  if (extension == ".svg") return svg_text(sheet);
  std::string bytes;
  if (extension == ".pdf") CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_pdf)(sheet, bytes);
  else CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_png)(sheet, bytes);
  return bytes;
}

}  // namespace cnrg
