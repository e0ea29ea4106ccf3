#include "csg/result/snap.h"

#include "csg/result/relabel.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/snap_drawing.h"
#include "csg/text/table.h"

namespace cnrg {

struct SnappedResult::Data : Relabelled {};

SnappedResult::SnappedResult(const ResultView& view, bool raw) {
  const FlatComplex flat = flatten(view);
  require_bounds(flat, "rounding to doubles breaks the result", ", or give --no-snap");
  if (round_points(view, flat).moved == 0) return;
  std::optional<Relabelled> made = relabel(view, flat, snap(view.complex->points, drawing_of_cells(flat)), raw);
  if (!made) return;
  report_ = made->report;
  data_ = std::make_unique<Data>(Data{std::move(*made)});
}

SnappedResult::~SnappedResult() = default;
SnappedResult::SnappedResult(SnappedResult&&) noexcept = default;

ResultView SnappedResult::shown(ResultView view) const {
  if (data_ == nullptr) return view;
  return data_->shown(std::move(view));
}

Result snap(const Result& result, SnapReport* report) {
  const auto snapped = std::make_shared<const SnappedResult>(result.data().view(), result.data().raw);
  if (report != nullptr) *report = snapped->report();
  if (snapped->report().rounds == 0) return result;
  auto data = std::make_shared<Result::Data>(result.data());
  const ResultView shown = snapped->shown(data->view());
  data->complex = std::shared_ptr<const Complex>(snapped, shown.complex);  // all live as long as `snapped`
  data->value = std::shared_ptr<const NodeValue>(snapped, shown.value);
  data->simplified = std::shared_ptr<const SimplifiedComplex>(snapped, shown.simplified);
  data->parameters = nullptr;  // they are of points of the exact complex
  data->of_group = shown.of_group;
  data->region_sizes = std::shared_ptr<const std::vector<double>>(snapped, shown.region_sizes);
  return Result(std::move(data));
}

std::string SnapReport::text() const {
  const auto any = [](std::size_t n, const char* one, const char* many) {
    return n == 0 ? std::string("no ") + many : counted(n, one, many);
  };
  std::string distance;
  append(distance, displacement);
  std::string text = "snapped " + std::to_string(moved) + " of " + std::to_string(points) + " vertices, by " +
                     distance + " at most, in " + counted(std::size_t(rounds), "round", "rounds");
  if (added > 0) text += "; " + counted(added, "vertex is", "vertices are") + " new";
  if (faces + regions > 0) {
    text += "; " + any(faces, "face", "faces") + " and " + any(regions, "region", "regions") +
            " without thickness vanished";
  }
  if (wires > 0) text += "; " + counted(wires, "wire", "wires") + " without length vanished";
  return text;
}

}  // namespace cnrg
