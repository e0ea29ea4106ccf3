// Plots by gnuplot as SVG for one HTML page: colours and font are the page's, ids are unique.
//
// A script takes its colours from `ink`, `muted`, `rule` and `series_colour`; in the SVG they become the CSS
// variables
// --ink, --muted, --rule and --s0, --s1, ... of the page, so that a plot follows light and dark.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cnrg::bench {

/// Series colours of the page; further systems begin again, with other dashes.
inline constexpr std::size_t kSeriesColours = 10;

struct Series {
  std::string name;
  std::size_t system = 0;                             ///< chooses colour, dashes and marker
  bool strong = false;                                ///< drawn thicker
  std::vector<std::pair<double, double>> points;      ///< on a logarithmic axis all positive
  std::size_t joined = static_cast<std::size_t>(-1);  ///< of the points, those from this one on stand alone
};

struct Tick {
  double at = 0;
  std::string text;
};

struct Axis {
  std::string title;
  bool logarithmic = false;
  double low = 0, high = 1;  ///< of the axis, ends included
  std::vector<Tick> ticks;
};

/// Lines, each named at its end on the right if there is room for names.
struct LinePlot {
  std::string title, description;  ///< the description is for readers who can not see it
  int width = 540, height = 320;   ///< CSS pixels
  bool named = true;
  Axis x, y;
  std::vector<Series> series;
};

/// One bar per line: quartiles as a box, extremes as whiskers, the median as a mark, on a logarithmic axis.
struct SpreadPlot {
  struct Bar {
    std::string name;
    std::size_t system = 0;
    double least = 0, lower = 0, median = 0, upper = 0, most = 0;
  };
  std::string title, description;
  int width = 540;
  Axis x;
  double reference = 1;  ///< a vertical line
  std::vector<Bar> bars;
};

/// A logarithmic axis with ticks at decades around the values, which are positive and at least one; the texts are
/// plain numbers from 0.001 to 1,000, powers of ten beyond.
Axis decades(const std::string& title, const std::vector<double>& values);

/// Draws in one process of gnuplot.
class Gallery {
 public:
  /// The place of its SVG in `draw`.
  std::size_t add(const LinePlot& plot);
  std::size_t add(const SpreadPlot& plot);
  /// Throws std::runtime_error if gnuplot is missing, with the package's name, or fails.
  std::vector<std::string> draw() const;

 private:
  struct Sheet {
    std::string script, title, description;
  };
  std::vector<Sheet> sheets_;
};

}  // namespace cnrg::bench
