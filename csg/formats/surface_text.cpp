// The surface mesh of a result in the formats of meshers.
#include "csg/formats/formats.h"
#include "csg/mesh/mesh.h"
#include "csg/result/solid.h"

namespace cnrg {
namespace {

/// A surface mesh as the text of a format.
FileText surface_text(const ResultView& view, const std::string& format, std::string (*text)(const Mesh&)) {
  const FlatComplex flat = flatten(view);
  require_closed_and_bounded(flat, format);
  if (flat.vertices.empty() && flat.edges.empty() && flat.faces.empty()) {
    throw InputError(format +
                     " is a mesh, and readers refuse one of nothing, as this result is; write .vtu or .json");
  }
  const RoundedPoints points = round_points(view, flat);
  return {text(surface_mesh(view, flat, points)), report_rounding(points, drawing_of(flat))};
}

}  // namespace

FileText msh_text(const ResultView& view) { return surface_text(view, "MSH", msh_text); }
FileText medit_text(const ResultView& view) { return surface_text(view, "MESH", medit_text); }

}  // namespace cnrg
