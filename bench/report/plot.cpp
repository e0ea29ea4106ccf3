// Scripts for gnuplot. Colours are placeholders that bench/report/gallery.cpp replaces: blue counts the series.
#include "bench/report/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/report/format.h"
#include "bench/report/placeholders.h"

namespace cnrg::bench {
namespace {

/// As a gnuplot string in single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += "''";
    else out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

std::string colour(std::size_t system) { return series_placeholder(system % kSeriesColours); }

std::string dashes(std::size_t system) {
  constexpr const char* kDashes[] = {"solid", "'--'", "'.-'"};
  return kDashes[(system / kSeriesColours) % 3];
}

/// Filled and empty circles, squares, triangles, diamonds.
int marker(std::size_t system) {
  constexpr int kMarkers[] = {7, 5, 9, 11, 13, 6, 4, 8, 10, 12};
  return kMarkers[system % kSeriesColours];
}

/// The texts of ticks are formats.
std::string as_format(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '%' ? "%%" : std::string(1, c);
  return out;
}

std::string ticks(const char* axis, const Axis& a) {
  std::string text = "set " + std::string(axis) + "tics (";
  for (std::size_t i = 0; i < a.ticks.size(); ++i) {
    text += (i == 0 ? "" : ", ") + quoted(as_format(a.ticks[i].text)) + " " + number(a.ticks[i].at);
  }
  return text + ") scale 0.4 nomirror textcolor rgb " + kMuted + "\n";
}

std::string range(const char* axis, const Axis& a) {
  // gnuplot leaves out a tick at the very end of a logarithmic axis when its logarithms are rounded badly.
  const double widened = a.logarithmic ? 1.001 : 1;
  std::string text =
      "set " + std::string(axis) + "range [" + number(a.low / widened) + ":" + number(a.high * widened) + "]\n";
  if (a.logarithmic) text += "set logscale " + std::string(axis) + "\n";
  return text;
}

std::string head(int width, int height) {
  return "reset\nset encoding utf8\nset terminal svg size " + std::to_string(width) + "," +
         std::to_string(height) + " dynamic noenhanced font '" + kFontPlaceholder +
         ",12'\nunset key\nunset mxtics\nunset mytics\n";
}

/// Pixels for names beside a plot: their letters are less than 7 wide on average. Half of the plot stays,
/// whatever.
int name_width(std::size_t letters, int width) {
  return std::min(width / 2, 24 + 67 * static_cast<int>(letters) / 10);
}

/// Heights of names beside the ends of lines, in the axis's own linear measure from 0 to 1, at least `gap` apart
/// and in the order of the ends.
std::vector<double> spread_names(const std::vector<double>& ends, double gap) {
  std::vector<std::size_t> order(ends.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ends[a] < ends[b]; });
  std::vector<double> heights = ends;
  for (std::size_t i = 1; i < order.size(); ++i) {
    heights[order[i]] = std::max(heights[order[i]], heights[order[i - 1]] + gap);
  }
  if (order.empty() || heights[order.back()] <= 1) return heights;
  heights[order.back()] = 1;
  for (std::size_t i = order.size() - 1; i-- > 0;) {
    heights[order[i]] = std::min(heights[order[i]], heights[order[i + 1]] - gap);
  }
  return heights;
}

double part_of(const Axis& axis, double value) {
  if (!axis.logarithmic) return (value - axis.low) / (axis.high - axis.low);
  return std::log(value / axis.low) / std::log(axis.high / axis.low);
}

/// Names to the right of the plot, joined to the ends of their lines by position and colour.
std::string names(const LinePlot& plot, double inner_height) {
  std::vector<double> ends;
  for (const Series& s : plot.series)
    ends.push_back(s.points.empty() ? 0 : part_of(plot.y, s.points.back().second));
  const std::vector<double> heights = spread_names(ends, 14.5 / inner_height);
  std::string text;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    if (plot.series[i].points.empty()) continue;
    text += "set label " + quoted(plot.series[i].name) + " at graph 1.02, graph " + number(heights[i]) +
            " left textcolor rgb " + colour(plot.series[i].system) + "\n";
  }
  return text;
}

std::string data_block(std::size_t index, const std::vector<std::pair<double, double>>& points) {
  std::string text = "$d" + std::to_string(index) + " << EOD\n";
  for (const auto& [x, y] : points) text += number(x) + " " + number(y) + "\n";
  return text + "EOD\n";
}

}  // namespace

Axis decades(const std::string& title, const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  int low = static_cast<int>(std::floor(std::log10(*least))),
      high = static_cast<int>(std::ceil(std::log10(*most)));
  if (high <= low) high = low + 1;
  Axis axis;
  axis.title = title;
  axis.logarithmic = true;
  axis.low = std::pow(10.0, low);
  axis.high = std::pow(10.0, high);
  const int step = 1 + (high - low) / 7;
  for (int e = low; e <= high; e += step) {
    const bool plain = e >= -3 && e <= 3;
    axis.ticks.push_back({std::pow(10.0, e), plain ? three_digits(std::pow(10.0, e)) : power_of_ten(e)});
    std::string& text = axis.ticks.back().text;
    // 0.100, 1.00 and 10.0 are exact here.
    if (plain && text.find('.') != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
  }
  return axis;
}

std::size_t Gallery::add(const LinePlot& plot) {
  std::size_t longest = 0;
  for (const Series& s : plot.series) longest = std::max(longest, characters(s.name));
  const int left = 52, right = plot.named ? name_width(longest, plot.width) : 24,
            top = plot.title.empty() ? 10 : 30, bottom = plot.x.title.empty() ? 26 : 46;
  const double inner_height = plot.height - top - bottom;
  std::string text = head(plot.width, plot.height);
  const auto margin = [&](const char* side, double place) {
    text += "set " + std::string(side) + "margin at screen " + number(place) + "\n";
  };
  margin("l", double(left) / plot.width);
  margin("r", 1 - double(right) / plot.width);
  margin("t", 1 - double(top) / plot.height);
  margin("b", double(bottom) / plot.height);
  text += std::string("set border 1 linecolor rgb ") + kRule + " linewidth 1\n";
  text += std::string("set grid ytics linetype 1 linecolor rgb ") + kRule + " linewidth 0.6 dashtype solid\n";
  text += range("x", plot.x) + range("y", plot.y) + ticks("x", plot.x) + ticks("y", plot.y);
  text += "set xlabel " + quoted(plot.x.title) + " offset 0,0.4 textcolor rgb " + kMuted + "\n";
  if (!plot.title.empty()) {
    text += "set label " + quoted(plot.title) + " at graph 0, screen " + number(1 - 14.0 / plot.height) +
            " left textcolor rgb " + kInk + "\n";
  }
  if (plot.named) text += names(plot, inner_height);
  std::string plots;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    if (s.points.empty()) continue;
    text += data_block(i, s.points);
    const std::string data = "$d" + std::to_string(i), width = s.strong ? "3" : "1.6";
    const std::size_t joined = std::min(s.joined, s.points.size());
    if (joined > 1) {
      plots += (plots.empty() ? "" : ", ") + data + " every ::0::" + std::to_string(joined - 1) +
               " with lines linewidth " + width + " linecolor rgb " + colour(s.system) + " dashtype " +
               dashes(s.system) + " title " + quoted(s.name);
    }
    plots += (plots.empty() ? "" : ", ") + data + " with points pointtype " + std::to_string(marker(s.system)) +
             " pointsize " + (s.strong ? "0.7" : "0.55") + " linecolor rgb " + colour(s.system) + " title " +
             quoted(s.name);
  }
  text += plots.empty() ? "plot NaN notitle\n" : "plot " + plots + "\n";
  sheets_.push_back({text, plot.title, plot.description});
  return sheets_.size() - 1;
}

std::size_t Gallery::add(const SpreadPlot& plot) {
  const auto lines = static_cast<int>(plot.bars.size());
  std::size_t longest = 0;
  for (const SpreadPlot::Bar& bar : plot.bars) longest = std::max(longest, characters(bar.name));
  const int left = name_width(longest, plot.width), right = 20, top = plot.title.empty() ? 10 : 30, bottom = 46,
            height = top + bottom + 30 * lines;
  std::string text = head(plot.width, height);
  text += "set lmargin at screen " + number(double(left) / plot.width) + "\nset rmargin at screen " +
          number(1 - double(right) / plot.width) + "\nset tmargin at screen " + number(1 - double(top) / height) +
          "\nset bmargin at screen " + number(double(bottom) / height) + "\n";
  text += std::string("set border 1 linecolor rgb ") + kRule + " linewidth 1\n";
  text += std::string("set grid xtics linetype 1 linecolor rgb ") + kRule + " linewidth 0.6 dashtype solid\n";
  text += range("x", plot.x) + "set yrange [" + number(-0.5) + ":" + number(lines - 0.5) + "]\n" +
          ticks("x", plot.x) + "unset ytics\n";
  text += "set xlabel " + quoted(plot.x.title) + " offset 0,0.4 textcolor rgb " + kMuted + "\n";
  if (!plot.title.empty()) {
    text += "set label " + quoted(plot.title) + " at screen 0.01, screen " + number(1 - 14.0 / height) +
            " left textcolor rgb " + kInk + "\n";
  }
  text += "set arrow from " + number(plot.reference) + ", graph 0 to " + number(plot.reference) +
          ", graph 1 nohead linewidth 1.4 linecolor rgb " + kInk + "\n";
  std::string plots;
  for (std::size_t i = 0; i < plot.bars.size(); ++i) {
    const SpreadPlot::Bar& bar = plot.bars[i];
    const double y = lines - 1 - static_cast<double>(i);
    const std::string data = "$d" + std::to_string(i), paint = " linecolor rgb " + colour(bar.system);
    text += "set label " + quoted(bar.name) + " at graph -0.02, first " + number(y) + " right textcolor rgb " +
            colour(bar.system) + "\n";
    text += data + " << EOD\n" + number(bar.median) + " " + number(y) + " " + number(bar.lower) + " " +
            number(bar.upper) + " " + number(bar.least) + " " + number(bar.most) + "\nEOD\n";
    plots += (plots.empty() ? "" : ", ") + data + " using 5:2:($6-$5):(0) with vectors nohead linewidth 1.4" +
             paint + " title " + quoted(bar.name) + ", " + data +
             " using 1:2:3:4:($2-0.26):($2+0.26) with boxxyerror" + " fillstyle solid 0.35 border linewidth 1.2" +
             paint + " notitle, " + data + " using 1:($2-0.26):(0):(0.52) with vectors nohead linewidth 3" +
             paint + " notitle";
  }
  text += "plot " + plots + "\n";
  sheets_.push_back({text, plot.title, plot.description});
  return sheets_.size() - 1;
}

}  // namespace cnrg::bench
