// TetGen's input (si2015): .smesh, a triangle per facet, and .poly, where a face on one plane is one facet with
// its holes, and each facet of a curved patch. What walks over itself (a face with a slit) is triangles there,
// too. Points are numbered from 1.
//
//   marker of a facet    the number of its group of faces
//   marker of a wire     the number of its group of wires after those of faces; a wire is a facet of two points
//   marker of a point    the number of its group of free points; 0 for any other point
//   holes                a point in each cavity that is not part of the result
//   regions              a point in each region, with the number of its group of regions as attribute
//
// Names are in comments. Faces, wires and points outside of all regions are in the file; TetGen keeps them with
// its switch -c.
#include "csg/formats/formats.h"
#include "csg/mesh/mesh.h"
#include "csg/mesh/plc.h"
#include "csg/result/solid.h"
#include "csg/text/digits.h"
#include "csg/text/escape.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Index = Plc::Index;

void append_point(std::string& text, std::size_t number, const std::array<double, 3>& point) {
  Line(text) << number << ' ' << point;
}

FileText tetgen_text(const ResultView& view, const std::string& format, bool poly) {
  const FlatComplex flat = flatten(view);
  require_closed_and_bounded(flat, format);
  if (flat.faces.empty()) {
    throw InputError(format + " holds facets, and the result has no face; write .vtu or .json");
  }
  const RoundedResult rounded(view, flat, format);
  Plc plc = plc_of(view, flat, rounded, poly ? PlcFacets::all : PlcFacets::triangles);
  set_seeds(plc, rounded);
  const MeshGroups groups = mesh_groups(view, flat);
  const auto group = [&](int dimension, Index i) {
    const auto& of = groups.of[std::size_t(dimension)][i];
    return of.empty() ? 0 : of[0];
  };
  const std::size_t faces = groups.names[2].size() - groups.sources;  // no groups by leaf, which are never first

  std::string text = "# node " + shown(view.node) + ", written by cnrg; tetgen -pA reads it\n";
  const auto name = [&](const char* kind, std::size_t dimension, std::size_t shift) {
    const std::size_t count = dimension == 2 ? faces : groups.names[dimension].size();
    for (std::size_t g = 0; g < count; ++g) {
      text += "# " + std::string(kind) + " " + std::to_string(shift + g + 1) + " " + groups.names[dimension][g];
      text += '\n';
    }
  };
  name("facets", 2, 0);
  name("facets", 1, faces);
  name("points", 0, 0);
  name("regions", 3, 0);

  std::vector<Index> marker(plc.points.size(), 0);
  for (Index i = 0; i < flat.vertices.size(); ++i) marker[flat.vertices[i].point] = group(0, i);
  text += std::to_string(plc.points.size()) + " 3 0 1\n";
  for (std::size_t i = 0; i < plc.points.size(); ++i) {
    append_point(text, i + 1, plc.points[i]);
    text += " " + std::to_string(marker[i]) + "\n";
  }

  std::size_t wires = 0;
  for (const auto& s : plc.segments) wires += s.wire;
  text += std::to_string(plc.facets.size() + wires) + " 1\n";
  const auto add_polygon = [&](const auto& points) {
    Line line(text);
    line << points.size();
    for (const Index p : points) line << ' ' << p + 1;
  };
  for (const auto& facet : plc.facets) {
    const std::string number = std::to_string(group(2, facet.face));
    if (poly) {
      text += std::to_string(facet.polygons.size()) + " " + std::to_string(facet.holes.size()) + " " + number;
      text += '\n';
    }
    for (const auto& polygon : facet.polygons) {
      add_polygon(polygon);
      text += poly ? "\n" : " " + number + "\n";
    }
    for (std::size_t k = 0; k < facet.holes.size(); ++k) {
      append_point(text, k + 1, facet.holes[k]);
      text += '\n';
    }
  }
  for (const auto& s : plc.segments) {
    if (!s.wire) continue;
    const std::string number = std::to_string(faces + group(1, s.edge));
    if (poly) text += "1 0 " + number + "\n";
    add_polygon(s.ends);
    text += poly ? "\n" : " " + number + "\n";
  }

  text += std::to_string(plc.holes.size()) + "\n";
  for (std::size_t k = 0; k < plc.holes.size(); ++k) {
    append_point(text, k + 1, plc.holes[k].point);
    text += '\n';
  }
  text += std::to_string(plc.regions.size()) + "\n";
  for (std::size_t k = 0; k < plc.regions.size(); ++k) {
    append_point(text, k + 1, plc.regions[k].point);
    text += " " + std::to_string(group(3, plc.regions[k].region)) + " -1\n";
  }
  return {std::move(text), rounded.report()};
}

}  // namespace

FileText smesh_text(const ResultView& view) { return tetgen_text(view, "SMESH", false); }
FileText poly_text(const ResultView& view) { return tetgen_text(view, "POLY", true); }

}  // namespace cnrg
