// Which plots the page has.
#include <algorithm>

#include "bench/report/format.h"
#include "bench/report/page.h"
#include "bench/report/plot.h"

namespace cnrg::bench {
namespace {

constexpr int kExactPlace = 19;  // on the axis of k, beyond the nearest distance

Axis distance_axis(int step, const std::string& title) {
  Axis axis;
  axis.title = title;
  axis.low = -0.6;
  axis.high = kExactPlace + 0.6;
  for (int k = 0; k <= 16; k += step) axis.ticks.push_back({double(k), power_of_ten(-k)});
  axis.ticks.push_back({kExactPlace, "exact"});
  return axis;
}

/// Lines along 0 % are drawn beside each other, each in a lane of its own below.
Axis rate_axis(std::size_t lanes, double lane) {
  Axis axis;
  axis.low = -lane * static_cast<double>(lanes + 1);
  axis.high = 1.05;
  for (const int percent : {0, 25, 50, 75, 100}) {
    axis.ticks.push_back({percent / 100.0, std::to_string(percent) + " %"});
  }
  return axis;
}

/// Ours comes first, below the others: its line is the widest, so that others that run along it are seen as well.
LinePlot distance_plot(const Page& page, const DistanceStudy& study, double lane) {
  LinePlot plot;
  plot.y = rate_axis(study.curves.size(), lane);
  for (const DistanceCurve& curve : study.curves) {
    Series series{page.label(curve.system), curve.system, page.summary.ours == curve.system, {}};
    for (const DistancePoint& point : curve.points) {
      if (!point.k) series.joined = series.points.size();
      const double rate = point.tally.failure_rate(), zero = -lane * static_cast<double>(plot.series.size());
      series.points.emplace_back(point.k ? *point.k : kExactPlace, rate > 0 ? rate : zero);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::size_t add_all_distances(const Page& page, Gallery& gallery) {
  LinePlot plot = distance_plot(page, page.summary.all_distances, 0.014);
  plot.description =
      "Failure rate against distance to degeneracy, all families with a distance, a line per system";
  plot.width = 1080;
  plot.height = 340;
  plot.x = distance_axis(1, "distance to the degenerate position, as a part of the operands' size");
  return gallery.add(plot);
}

std::size_t add_distance(const Page& page, const DistanceStudy& study, Gallery& gallery) {
  LinePlot plot = distance_plot(page, study, 0.026);
  plot.title = page.family(*study.family).name;
  plot.description = "Failure rate against distance to degeneracy, a line per system";
  plot.width = 350;
  plot.height = 220;
  plot.named = false;
  plot.x = distance_axis(4, "");
  return gallery.add(plot);
}

/// Nothing to draw when no value is positive.
std::optional<std::size_t> add_growth(const Page& page, const GrowthStudy& study, double GrowthPoint::*cost,
                                      std::optional<PowerLaw> GrowthCurve::*law, double unit,
                                      const std::string& title, Gallery& gallery) {
  LinePlot plot;
  plot.title = title;
  plot.description = page.family(study.family).name + ", against triangles of all operands, a line per system";
  plot.height = 300;
  std::vector<double> triangles, costs;
  for (const GrowthCurve& curve : study.curves) {
    Series series{page.label(curve.system), curve.system, page.summary.ours == curve.system, {}};
    if (curve.*law) series.name += " " + exponent_text((curve.*law)->exponent);
    for (const GrowthPoint& p : curve.points) {
      if (p.triangles <= 0 || p.*cost <= 0) continue;
      series.points.emplace_back(p.triangles, p.*cost / unit);
      triangles.push_back(p.triangles);
      costs.push_back(p.*cost / unit);
    }
    plot.series.push_back(std::move(series));
  }
  if (triangles.empty()) return std::nullopt;
  plot.x = decades("triangles of all operands", triangles);
  plot.y = decades("", costs);
  return gallery.add(plot);
}

std::optional<std::size_t> add_ratios(const Page& page, Spread Ratio::*which, const std::string& title,
                                      Gallery& gallery) {
  SpreadPlot plot;
  plot.title = title;
  plot.description = "Least, quartiles, median and most, a bar per system; ours is 1";
  std::vector<double> ends = {1};
  for (const Ratio& ratio : page.summary.ratios) {
    const Spread& s = ratio.*which;
    if (s.count == 0) continue;
    plot.bars.push_back({page.label(ratio.system), ratio.system, s.least, s.lower, s.median, s.upper, s.most});
    ends.push_back(s.least);
    ends.push_back(s.most);
  }
  if (plot.bars.empty()) return std::nullopt;
  plot.x = decades("as a multiple of ours", ends);
  return gallery.add(plot);
}

}  // namespace

Drawings make_drawings(const Page& page) {
  const Summary& summary = page.summary;
  Gallery gallery;
  std::optional<std::size_t> all;
  if (!summary.all_distances.curves.empty()) all = add_all_distances(page, gallery);
  std::vector<std::size_t> distances;
  for (const DistanceStudy& study : summary.distances) distances.push_back(add_distance(page, study, gallery));
  std::vector<std::array<std::optional<std::size_t>, 2>> growth;
  for (const GrowthStudy& study : summary.growth) {
    growth.push_back(
        {add_growth(page, study, &GrowthPoint::seconds, &GrowthCurve::time, 1, "time, seconds", gallery),
         add_growth(page, study, &GrowthPoint::own_bytes, &GrowthCurve::memory, 1e6, "memory, MB", gallery)});
  }
  const auto time = add_ratios(page, &Ratio::time, "time", gallery);
  const auto memory = add_ratios(page, &Ratio::memory, "memory", gallery);

  const std::vector<std::string> drawn = gallery.draw();
  const auto drawing = [&](const std::optional<std::size_t>& place) {
    return place ? drawn[*place] : std::string();
  };
  Drawings out;
  out.all_distances = drawing(all);
  for (const std::size_t place : distances) out.distances.push_back(drawn[place]);
  for (const auto& [seconds, bytes] : growth) out.growth.push_back({drawing(seconds), drawing(bytes)});
  out.time_ratios = drawing(time);
  out.memory_ratios = drawing(memory);
  return out;
}

}  // namespace cnrg::bench
