// Primitives, the grid, hulls.
#include "csg/openscad/polyset.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/geometry/planar_polygon.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/convex_hull.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg::openscad {
namespace {

/// Corners in layers, each of which goes round as the one below it.
void join_layers(Polyset& to, std::uint32_t below, std::uint32_t above, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    to.faces.push_back({below + i, below + j, above + j, above + i});
  }
}

std::uint32_t add_layer(Polyset& to, const Loop& loop, double z) {
  const auto first = static_cast<std::uint32_t>(to.points.size());
  for (const Point2& p : loop) to.points.push_back({p[0], p[1], z});
  return first;
}

void add_cap(Polyset& to, std::uint32_t first, std::uint32_t n, bool up) {
  Face& face = to.faces.emplace_back();
  for (std::uint32_t i = 0; i < n; ++i) face.push_back(first + (up ? i : n - 1 - i));
}

using Cell = std::array<std::int64_t, 3>;

/// Cells of the grid that hold corners, with the number of each.
class Grid {
 public:
  std::uint32_t number(const Point3& p) {
    const Cell cell{static_cast<std::int64_t>(p[0] / kFineGrid), static_cast<std::int64_t>(p[1] / kFineGrid),
                    static_cast<std::int64_t>(p[2] / kFineGrid)};
    const auto known = nearest(cell);
    if (known != cells_.end()) return known->second;
    points.push_back({double(cell[0]) * kFineGrid, double(cell[1]) * kFineGrid, double(cell[2]) * kFineGrid});
    return cells_.emplace(cell, static_cast<std::uint32_t>(cells_.size())).first->second;
  }
  std::vector<Point3> points;

 private:
  std::map<Cell, std::uint32_t> cells_;

  /// Of the cells that touch this one and hold a corner.
  std::map<Cell, std::uint32_t>::const_iterator nearest(const Cell& cell) const {
    auto best = cells_.find(cell);
    if (best != cells_.end()) return best;
    int least = 4;
    for (int k = 0; k < 27; ++k) {
      const int x = k / 9 - 1, y = k / 3 % 3 - 1, z = k % 3 - 1;
      const auto at = cells_.find({cell[0] + x, cell[1] + y, cell[2] + z});
      if (at == cells_.end() || x * x + y * y + z * z >= least) continue;
      least = x * x + y * y + z * z;
      best = at;
    }
    return best;
  }
};

Point3 unit_normal(const Polyset& solid, const Face& face) {
  Point3 sum{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Point3 n = cross(minus(solid.points[face[i]], solid.points[face[0]]),
                           minus(solid.points[face[i + 1]], solid.points[face[0]]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
  }
  const double length = std::sqrt(dot(sum, sum));
  return length == 0 ? sum : Point3{sum[0] / length, sum[1] / length, sum[2] / length};
}

/// The numbers of all faces that hang together with the first one.
std::size_t connected(const std::vector<std::vector<std::size_t>>& neighbours) {
  std::vector<bool> seen(neighbours.size());
  std::vector<std::size_t> open{0};
  std::size_t count = 0;
  for (seen[0] = true; !open.empty(); ++count) {
    const std::size_t face = open.back();
    open.pop_back();
    for (const std::size_t next : neighbours[face]) {
      if (!seen[next]) open.push_back(next);
      seen[next] = true;
    }
  }
  return count;
}

}  // namespace

void require_few(double corners) {
  if (corners > 1e6) throw InputError("would have more than 1,000,000 corners; make it coarser");
}

Polyset cube(const Point3& size, bool center) {
  Polyset out{{}, {}, true};
  const Point3 low = center ? Point3{-size[0] / 2, -size[1] / 2, -size[2] / 2} : Point3{};
  const Point3 high = center ? Point3{size[0] / 2, size[1] / 2, size[2] / 2} : size;
  const Loop base{{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
  add_layer(out, base, low[2]);
  add_layer(out, base, high[2]);
  add_cap(out, 0, 4, false);
  join_layers(out, 0, 4, 4);
  add_cap(out, 4, 4, true);
  return out;
}

Loop circle(double radius, int segments) {
  require_few(segments);
  Loop out;
  for (int i = 0; i < segments; ++i) {
    const double degrees = 360.0 * i / segments;
    out.push_back({radius * cosine(degrees), radius * sine(degrees)});
  }
  return out;
}

Polyset sphere(double radius, const Fineness& fineness) {
  const int segments = fineness.segments(radius), rings = (segments + 1) / 2;
  require_few(double(segments) * rings);
  const auto n = static_cast<std::uint32_t>(segments);
  Polyset out{{}, {}, true};
  for (int i = rings - 1; i >= 0; --i) {
    const double degrees = 180.0 * (i + 0.5) / rings;
    add_layer(out, circle(radius * sine(degrees), segments), radius * cosine(degrees));
  }
  add_cap(out, 0, n, false);
  for (std::uint32_t i = 1; i < static_cast<std::uint32_t>(rings); ++i) join_layers(out, (i - 1) * n, i * n, n);
  add_cap(out, static_cast<std::uint32_t>(rings - 1) * n, n, true);
  return out;
}

Polyset cylinder(double height, double bottom, double top, bool center, const Fineness& fineness) {
  const int segments = fineness.segments(std::max(bottom, top));
  const auto n = static_cast<std::uint32_t>(segments);
  const double low = center ? -height / 2 : 0, high = center ? height / 2 : height;
  Polyset out{{}, {}, true};
  if (bottom > 0) add_cap(out, add_layer(out, circle(bottom, segments), low), n, false);
  if (top > 0) add_cap(out, add_layer(out, circle(top, segments), high), n, true);
  if (bottom > 0 && top > 0) {
    join_layers(out, 0, n, n);
    return out;
  }
  const auto apex = add_layer(out, {{0, 0}}, bottom > 0 ? high : low);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    out.faces.push_back(bottom > 0 ? Face{i, j, apex} : Face{j, i, apex});
  }
  return out;
}

double determinant(const Matrix& m) {
  return dot(Point3{m[0][0], m[0][1], m[0][2]},
             cross(Point3{m[1][0], m[1][1], m[1][2]}, Point3{m[2][0], m[2][1], m[2][2]}));
}

Polyset transformed(const Polyset& solid, const Matrix& m) {
  Polyset out = solid;
  for (Point3& p : out.points) {
    const Point3 before = p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = m[k][0] * before[0] + m[k][1] * before[1] + m[k][2] * before[2] + m[k][3];
  }
  if (determinant(m) < 0) {
    for (Face& face : out.faces) std::reverse(face.begin(), face.end());
  }
  return out;
}

Polyset on_grid(const Polyset& solid) {
  Grid grid;
  Polyset out{{}, {}, solid.convex};
  for (const Face& face : solid.faces) {
    Face moved;
    for (const std::uint32_t corner : face) {
      const std::uint32_t number = grid.number(solid.points[corner]);
      if (moved.empty() || moved.back() != number) moved.push_back(number);
    }
    while (moved.size() > 1 && moved.front() == moved.back()) moved.pop_back();
    if (moved.size() > 2) out.faces.push_back(std::move(moved));
  }
  out.points = std::move(grid.points);
  return out;
}

bool is_convex(const Polyset& solid) {
  if (solid.convex) return *solid.convex;
  if (solid.faces.empty()) return true;
  const double nearly_flat = cosine(0.1);
  std::map<std::array<std::uint32_t, 2>, std::size_t> face_at;
  std::vector<Point3> normals;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const Face& face = solid.faces[f];
    normals.push_back(unit_normal(solid, face));
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (!face_at.emplace(std::array{face[i], face[(i + 1) % face.size()]}, f).second) return false;
    }
  }
  std::vector<std::vector<std::size_t>> neighbours(solid.faces.size());
  for (const auto& [edge, f] : face_at) {
    const auto other = face_at.find({edge[1], edge[0]});
    if (other == face_at.end()) return false;
    const std::size_t g = other->second;
    neighbours[f].push_back(g);
    const Point3 along = minus(solid.points[edge[1]], solid.points[edge[0]]);
    const double bend = dot(cross(normals[f], normals[g]), along);
    if (bend < 0 && dot(normals[f], normals[g]) < nearly_flat) return false;
  }
  return connected(neighbours) == solid.faces.size();
}

std::vector<RationalPoint> exact_points(const std::vector<Point3>& points) {
  std::vector<RationalPoint> out;
  for (const Point3& p : points) out.push_back(from_doubles(p));
  return out;
}

Polyset hull(std::vector<Point3> points) {
  sort_unique(points);
  const std::vector<RationalPoint> exact = exact_points(points);
  Polyset out{std::move(points), {}, true};
  if (!are_in_a_plane(exact)) out.faces = convex_hull(exact);
  return out;
}

std::vector<Point3> sums(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  require_few(double(a.size()) * double(b.size()));
  std::vector<Point3> out;
  for (const Point3& p : a) {
    for (const Point3& q : b) out.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
  }
  return out;
}

}  // namespace cnrg::openscad
