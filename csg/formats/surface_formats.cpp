// OFF, STL and PLY: the outer boundary of the solid regions as triangles, normals outward. Edges with more than
// two triangles, where solids touch, are what they are: the formats hold triangles by point number (STL by
// coordinates), and no two points are merged or split.
#include <array>
#include <cmath>

#include "csg/formats/formats.h"
#include "csg/result/rounding.h"
#include "csg/result/solid.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

struct RoundedSolid {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  RoundingReport rounding;
};

RoundedSolid rounded_solid(const ResultView& view, const std::string& format) {
  FlatComplex flat = flatten(view);
  SolidBoundary boundary = solid_boundary(flat, format);
  std::vector<VertexId> used;
  for (const auto p : boundary.points) used.push_back(flat.points[p]);
  flat.points = std::move(used);
  RoundedPoints points = round_points(view, flat);
  const RoundingReport rounding = report_rounding(points, {boundary.triangles, {}, {}});
  return {std::move(points.xyz), std::move(boundary.triangles), rounding};
}

void append_triangles(std::string& text, const RoundedSolid& solid) {
  for (const auto& t : solid.triangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  }
}

void append_points(std::string& text, const RoundedSolid& solid) {
  for (const auto& p : solid.points) {
    append(text, p);
    text += '\n';
  }
}

/// The unit normal, or zero for a triangle that rounding has flattened.
std::array<double, 3> normal(const RoundedSolid& solid, const std::array<std::uint32_t, 3>& t) {
  const auto &a = solid.points[t[0]], &b = solid.points[t[1]], &c = solid.points[t[2]];
  std::array<double, 3> n{};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  }
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  for (double& x : n) x /= length;
  return n;
}

}  // namespace

FileText off_text(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "OFF");
  std::string text =
      "OFF\n" + std::to_string(solid.points.size()) + " " + std::to_string(solid.triangles.size()) + " 0\n";
  append_points(text, solid);
  append_triangles(text, solid);
  return {std::move(text), solid.rounding};
}

FileText ply_text(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "PLY");
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(solid.points.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(solid.triangles.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  append_points(text, solid);
  append_triangles(text, solid);
  return {std::move(text), solid.rounding};
}

FileText stl_text(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "STL");
  const std::string name = shown(view.node);
  std::string text = "solid " + name + "\n";
  for (const auto& t : solid.triangles) {
    text += "facet normal ";
    append(text, normal(solid, t));
    text += "\nouter loop\n";
    for (const auto p : t) {
      text += "vertex ";
      append(text, solid.points[p]);
      text += '\n';
    }
    text += "endloop\nendfacet\n";
  }
  text += "endsolid " + name + "\n";
  return {std::move(text), solid.rounding};
}

}  // namespace cnrg
