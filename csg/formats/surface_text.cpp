// The surface mesh of a result in the formats of meshers.
#include <utility>

#include "csg/formats/formats.h"
#include "csg/mesh/mesh.h"
#include "csg/result/solid.h"

namespace cnrg {
namespace {

/// What was flattened goes before the text is made: it takes as much memory as that.
std::pair<Mesh, RoundingReport> rounded_mesh(const ResultView& view, const std::string& format) {
  const FlatComplex flat = flatten(view);
  require_closed_and_bounded(flat, format);
  if (flat.vertices.empty() && flat.edges.empty() && flat.faces.empty()) {
    throw InputError(format +
                     " is a mesh, and readers refuse one of nothing, as this result is; write .vtu or .json");
  }
  const RoundedPoints points = round_points(view, flat);
  RoundingReport rounding = report_rounding(points, drawing_of(flat));
  return {surface_mesh(view, flat, points), std::move(rounding)};
}

}  // namespace

FileText surface_text(const ResultView& view, const std::string& format, std::string (*text)(const Mesh&)) {
  auto [mesh, rounding] = rounded_mesh(view, format);
  return {text(mesh), std::move(rounding)};
}

}  // namespace cnrg
