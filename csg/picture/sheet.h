// A picture on paper: places are in units of the page (96 to an inch, y down), widths and colors are decided.
// What remains is to write it: sheet_svg.cpp, sheet_cairo.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/picture/figure.h"

namespace cnrg {

inline constexpr Rgb kPaper{1, 1, 1};
/// Lines of a hatch and of a weave, each at 45 degrees: how far apart along x, and how wide.
inline constexpr double kHatchStep = 7, kHatchWidth = 1;
inline constexpr double kWeaveStep = 5, kWeaveWidth = 0.7;
/// Areas are this much larger than they are, so that the ground does not show between two that meet: a pixel that
/// both share would be covered twice by half, which is not once by all.
inline constexpr double kSeam = 0.6;
inline constexpr double kHalo = 3;  ///< about the letters of a label, half of it outside of them

struct PaperSheet {
  enum class Pattern : std::uint8_t { plain, hatch, weave };
  struct Area {
    std::vector<std::vector<Point2>> loops;  ///< inside where an odd number of them is around
    Rgb color{};
    Pattern pattern = Pattern::plain;
    Rgb lines{};  ///< of the pattern
    friend bool same_look(const Area& a, const Area& b) {
      return a.color == b.color && a.pattern == b.pattern && a.lines == b.lines;
    }
  };
  struct Look {
    double width = 1;
    Rgb color{};
    double dash = 0, gap = 0;  ///< lengths; 0: a full line
    double opacity = 1;
    friend bool operator==(const Look&, const Look&) = default;
  };
  struct Line {
    std::vector<Point2> points;
    bool closed = false;
    Look look;
  };
  struct Disk {
    Point2 at{};
    double radius = 0;
    std::optional<Rgb> inside;
    Rgb color{};
    double ring = 0;  ///< the width of a line of `color` around it
    double opacity = 1;
  };
  struct Text {
    std::string text;
    Point2 middle{};  ///< of the line of text, horizontally, and of its small letters, vertically
    double size = 12;
    bool halo = false;
  };
  double width = 0, height = 0;
  std::string title;  ///< for who cannot see it
  std::vector<Area> areas;
  std::vector<Line> lines;
  std::vector<Disk> disks;
  std::vector<Text> texts;
};

/// From the middle of small letters down to the line they stand on, in letters of size 1.
inline constexpr double kHalfLetter = 0.36;

std::string svg_text(const PaperSheet& sheet);

}  // namespace cnrg
