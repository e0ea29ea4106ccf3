// The check for a faithful rounding is a refinement of what was written: if the complex of the rounded facets
// has exactly the points, segments and triangles that were put in, then nothing crosses, touches or collapses.
#include "csg/result/rounding.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "kernel/base/error.h"

namespace cnrg {

RoundedPoints round_points(const ResultView& view, const FlatComplex& flat) {
  const PointTable& table = view.complex->points;
  RoundedPoints result;
  result.xyz.reserve(flat.points.size());
  for (const VertexId v : flat.points) {
    const auto xyz = table.nearest(v);
    for (const double c : xyz) {
      if (!std::isfinite(c)) {
        throw InputError("a coordinate of the result is beyond the range of doubles; write .json, which is exact");
      }
    }
    result.xyz.push_back(xyz);
    if (table.is_double(v)) continue;
    const RationalPoint exact = table.rational(v);
    result.moved += !(is_double(exact[0]) && is_double(exact[1]) && is_double(exact[2]));
  }
  return result;
}

Redrawing redraw(const RoundedPoints& points, const Drawing& drawing) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> ids(points.xyz.size());
  std::size_t used = 0;
  const auto id = [&](std::uint32_t p) {
    if (!ids[p].valid()) {
      const auto& c = points.xyz[p];
      ids[p] = soup.add_point(c[0], c[1], c[2]);
      ++used;
    }
    return ids[p];
  };
  std::vector<std::array<std::uint32_t, 2>> edges = drawing.segments;
  std::uint32_t number = 0;
  for (const auto& t : drawing.triangles) {
    soup.add_triangle(leaf, id(t[0]), id(t[1]), id(t[2]), number, number);
    ++number;
    for (int k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  }
  for (const auto& s : drawing.segments) soup.add_wire(leaf, id(s[0]), id(s[1]), number++);
  for (const auto p : drawing.points) soup.add_isolated(leaf, id(p));
  for (auto& e : edges) std::sort(e.begin(), e.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return {build_complex(soup), used, edges.size(), drawing.triangles.size()};
}

bool is_embedded(const RoundedPoints& points, const Drawing& drawing) {
  if (drawing.triangles.empty() && drawing.segments.empty() && drawing.points.empty()) return true;
  return redraw(points, drawing).is_embedded();
}

RoundingReport report_rounding(const RoundedPoints& points, const Drawing& drawing) {
  return {points.moved, points.moved == 0 || is_embedded(points, drawing)};
}

void append(std::string& text, double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value).ptr;
  text.append(buffer, end);
}

void append(std::string& text, const std::array<double, 3>& xyz) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) text += ' ';
    append(text, xyz[k]);
  }
}

}  // namespace cnrg
