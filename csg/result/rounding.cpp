// The check for a faithful rounding is a refinement of what was written: if the points, segments and triangles
// that were put in are the cells of the complex, one by one, then nothing crosses, touches or collapses. Their
// numbers alone would not do: where a triangle falls onto another one and a third is cut, there are as many as
// before. What passed through a wall as a whole shows by a 3-cell that is two places at once.
#include "csg/result/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/result/slight_moves.h"
#include "kernel/base/hypotenuse.h"

namespace cnrg {

std::array<double, 3> nearest_doubles(const PointTable& points, VertexId v) {
  std::array<double, 3> xyz = points.nearest(v);
  for (double& c : xyz) {
    if (!std::isfinite(c)) {
      throw InputError("a coordinate of the result is beyond the range of doubles; write .json, which is exact");
    }
    c += 0.0;
  }
  return xyz;
}

double distance_above(const PointTable& points, VertexId v, const std::array<double, 3>& to) {
  const RationalPoint from = points.rational(v);
  std::array<double, 3> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = to_double(from[k] - from_double(to[k]));
  return hypotenuse(d[0], d[1], d[2]) * (1 + 0x1p-50);
}

RoundedPoints round_points(const ResultView& view, const FlatComplex& flat) {
  const PointTable& table = view.complex->points;
  RoundedPoints result;
  result.xyz.reserve(flat.points.size());
  for (const VertexId v : flat.points) {
    const auto xyz = nearest_doubles(table, v);
    result.xyz.push_back(xyz);
    if (table.is_double(v)) continue;
    const RationalPoint exact = table.rational(v);
    if (is_double(exact[0]) && is_double(exact[1]) && is_double(exact[2])) continue;
    ++result.moved;
    result.reach.resize(flat.points.size());
    double& reach = result.reach[result.xyz.size() - 1];
    for (int k = 0; k < 3; ++k) reach = std::max({reach, table.upper(v, k) - xyz[k], xyz[k] - table.lower(v)[k]});
    reach = std::nextafter(reach, std::numeric_limits<double>::infinity());
  }
  return result;
}

Redrawing redraw(const RoundedPoints& points, const Drawing& drawing, const std::stop_token& stop) {
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
  std::uint32_t number = 0;
  for (const auto& t : drawing.triangles) {
    soup.add_triangle(leaf, id(t[0]), id(t[1]), id(t[2]), number, number);
    ++number;
  }
  for (const auto& s : drawing.segments) soup.add_wire(leaf, id(s[0]), id(s[1]), number++);
  for (const auto p : drawing.points) soup.add_isolated(leaf, id(p));
  RefineOptions options;
  options.watch.stop = stop;
  return {build_complex(soup, options), used, drawing.triangles.size()};
}

bool is_as_drawn(const Complex& complex, std::size_t points, std::size_t triangles) {
  if (complex.vertex_count() != points || complex.face_count() != triangles) return false;
  std::vector<char> seen(triangles, 0);
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto covers = complex.cover(f);
    const auto loops = complex.face_loops[f];
    if (covers.size() != 1 || loops.size() != 1 || complex.loop[loops[0]].size() != 3) return false;
    if (!complex.face_vertices[f].empty()) return false;
    char& drawn = seen[covers[0].source.index()];
    if (drawn) return false;
    drawn = 1;
  }
  IdVector<WireId, char> run(complex.wires.size(), 0);
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    std::size_t wires = 0;
    for (const SegmentId s : complex.edge_segments[e]) {
      for (const WireId w : complex.segment_wires[s]) {
        if (run[w]) return false;
        run[w] = 1;
        ++wires;
      }
    }
    if (wires > (complex.edge_uses[e].empty() ? 1u : 0u)) return false;
  }
  return std::all_of(run.begin(), run.end(), [](char edge) { return edge != 0; });
}

namespace {

/// The places of a drawing in its refinement.
class DrawnPlaces {
 public:
  explicit DrawnPlaces(const Complex& complex) : complex_(complex), of_(complex.region_count) {}

  /// False if the 3-cell is another place already.
  bool claim(RegionId region, std::uint32_t place) {
    std::optional<std::uint32_t>& known = of_[region];
    if (!known) known = place;
    return *known == place;
  }
  bool claim(const Drawing& drawing) {
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      const Cover& cover = complex_.cover(f)[0];
      const HalfFace front(f, cover.same ? 0 : 1);
      const auto& [before, behind] = drawing.sides[complex_.sources[cover.source].leaf_face];
      if (!claim(complex_.region(front), before) || !claim(complex_.region(front.opposite()), behind))
        return false;
    }
    return true;
  }

 private:
  const Complex& complex_;
  IdVector<RegionId, std::optional<std::uint32_t>> of_;
};

}  // namespace

bool is_faithful(const RoundedPoints& points, const Drawing& drawing, const std::stop_token& stop) {
  if (drawing.triangles.empty() && drawing.segments.empty() && drawing.points.empty()) return true;
  const Redrawing drawn = redraw(points, drawing, stop);
  if (!drawn.is_embedded()) return false;
  const Complex& complex = *drawn.complex;
  DrawnPlaces places(complex);
  if (!drawing.sides.empty() && !places.claim(drawing)) return false;
  if (drawing.around_segments.empty() && drawing.around_points.empty()) return true;
  const Locator locator(complex);
  const auto exact = [&](std::uint32_t p, int k) { return from_double(points.xyz[p][std::size_t(k)]); };
  for (std::size_t i = 0; i < drawing.around_segments.size(); ++i) {
    const auto& [a, b] = drawing.segments[i];
    RationalPoint middle;
    for (int k = 0; k < 3; ++k) middle[k] = (exact(a, k) + exact(b, k)) / 2;
    const Location at = locator.locate(middle);
    require(at.dimension == 1, "rounding: the middle of a wire is not on it");
    if (!places.claim(complex.some_region(at.edge), drawing.around_segments[i])) return false;
  }
  for (std::size_t i = 0; i < drawing.around_points.size(); ++i) {
    const std::uint32_t p = drawing.points[i];
    const Location at = locator.locate({exact(p, 0), exact(p, 1), exact(p, 2)});
    require(at.dimension == 0, "rounding: a point is not where it is");
    if (!places.claim(complex.some_region(at.vertex), drawing.around_points[i])) return false;
  }
  return true;
}

RoundingReport report_rounding(const RoundedPoints& points, const Drawing& drawing, const std::stop_token& stop) {
  const bool embedded =
      points.moved == 0 || is_surely_faithful(points, drawing) || is_faithful(points, drawing, stop);
  return {points.moved, embedded};
}

}  // namespace cnrg
