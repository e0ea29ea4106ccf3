#include "csg/result/snap.h"

#include <algorithm>

#include "csg/result/flat_drawing.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/snap_drawing.h"
#include "csg/result/vanished.h"
#include "csg/text/digits.h"
#include "csg/text/table.h"

namespace cnrg {

SnappedResult::SnappedResult(const ResultView& view, bool raw, const Watch& watch) {
  watch.begin("snap");
  const FlatComplex flat = flatten(view);
  watch.check();
  require_bounds(flat, "rounding to doubles breaks the result", ", or give --no-snap");
  if (round_points(view, flat).moved == 0) return;
  watch.check();
  MovedDrawing moved = snap(view.complex->points, drawing_of_cells(flat), watch);
  std::optional<Relabelled> made = relabel(view, flat, std::move(moved), raw, watch);
  if (!made) return;
  report_ = made->report;
  LostRegions lost;
  std::set<Component> left;
  std::vector<FlatComplex::Index> left_regions;
  for (FlatComplex::Index r = 0; r < flat.regions.size(); ++r) {
    if (!flat.active(r)) continue;
    if (std::binary_search(made->lost_regions.begin(), made->lost_regions.end(), r)) lost.add(view, flat, r, true);
    else left.insert(flat.regions[r].component), left_regions.push_back(r);
  }
  report_.lost_regions = lost.lines(left);
  made_ = std::make_shared<const Relabelled>(std::move(*made));
  const ResultView now = shown(view);
  report_.parted_regions = parted_warnings(flat, left_regions, now, flatten(now));
}

ResultView SnappedResult::shown(ResultView view) const {
  return made_ == nullptr ? view : made_->shown(std::move(view));
}

Result snap(const Result& result, SnapReport* report, const Watch& watch) {
  const SnappedResult snapped(result.data().view(), result.data().raw, watch);
  if (report != nullptr) *report = snapped.report();
  if (snapped.report().rounds == 0) return result;
  return Result(settled(relabelled(result.data(), snapped.relabelled())));
}

std::string SnapReport::text() const {
  std::string text = "snapped " + std::to_string(moved) + " of " + std::to_string(points) + " vertices, by " +
                     double_text(displacement) + " at most, in " + counted(std::size_t(rounds), "round", "rounds");
  if (added > 0) text += "; " + counted(added, "vertex is", "vertices are") + " new";
  return text + vanished_text(faces, wires, lost_regions.size());
}

std::vector<std::string> SnapReport::warnings() const {
  // What holds a larger ball keeps its middle.
  std::vector<std::string> out = vanished_warnings(lost_regions, double_text(2 * displacement));
  out.insert(out.end(), parted_regions.begin(), parted_regions.end());
  return out;
}

}  // namespace cnrg
