// Areas swept along z and about z.
#include <algorithm>
#include <cmath>

#include "csg/openscad/polyset.h"
#include "kernel/base/hypotenuse.h"

namespace cnrg::openscad {
namespace {

/// -1, 0 or 1 as the first pair of points is nearer, as near or farther than the second, seen from above. What
/// differs by less than 1e-5 is as near.
int compare_distances(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double first = hypotenuse(a[0] - b[0], a[1] - b[1]), second = hypotenuse(c[0] - d[0], c[1] - d[1]);
  if (2e5 * std::abs(first - second) <= first + second) return 0;
  return first < second ? -1 : 1;
}

bool is_hole(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
    area += p[0] * q[1] - q[0] * p[1];
  }
  return area < 0;
}

std::size_t corner_count(const Area& area) {
  std::size_t n = 0;
  for (const Loop& loop : area.loops) n += loop.size();
  return n;
}

/// Goes through all edges of all loops, by the loop and the numbers of their ends.
template <class Use>
void for_each_edge(const Area& area, Use use) {
  std::uint32_t first = 0;
  for (const Loop& loop : area.loops) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < n; ++i) use(loop, first + i, first + (i + 1) % n);
    first += n;
  }
}

void add_caps(Polyset& to, const Area& area, std::uint32_t first, bool up) {
  for (const auto& t : triangles(area)) {
    to.faces.push_back(up ? Face{first + t[0], first + t[1], first + t[2]}
                          : Face{first + t[0], first + t[2], first + t[1]});
  }
}

int layers_of(const Area& area, const LinearExtrusion& how, const Fineness& fineness) {
  if (how.slices) return *how.slices;
  double radius = 0, shift = 0;
  for (const Loop& loop : area.loops) {
    for (const Point2& p : loop) {
      radius = std::max(radius, hypotenuse(p[0], p[1]));
      shift = std::max(shift, hypotenuse(p[0] * (1 - how.scale[0]), p[1] * (1 - how.scale[1])));
    }
  }
  const bool alike = how.scale[0] == how.scale[1];
  if (how.twist == 0) return alike ? 1 : fineness.diagonal_layers(shift, how.height);
  if (how.scale == std::array{1.0, 1.0}) return fineness.helix_layers(radius, how.height, how.twist);
  if (alike) return fineness.conical_layers(radius, how.height, how.twist, how.scale[0]);
  return std::max(fineness.diagonal_layers(shift, how.height),
                  fineness.helix_layers(radius, how.height, how.twist));
}

/// The corners of all loops at a fraction of the way.
std::vector<Point3> layer(const Area& area, const LinearExtrusion& how, int j, int layers) {
  const double low = how.center ? -how.height / 2 : 0, high = how.center ? how.height / 2 : how.height;
  const double z = low + (high - low) * j / layers, turn = how.twist * j / layers;
  const double sx = 1 - (1 - how.scale[0]) * j / layers, sy = 1 - (1 - how.scale[1]) * j / layers;
  const double c = cosine(-turn), s = sine(-turn);
  std::vector<Point3> out;
  for (const Loop& loop : area.loops) {
    for (const Point2& p : loop) out.push_back({sx * (c * p[0] - s * p[1]), sy * (s * p[0] + c * p[1]), z});
  }
  return out;
}

}  // namespace

Polyset extruded(const Area& area, const LinearExtrusion& how, const Fineness& fineness) {
  const int layers = layers_of(area, how, fineness);
  const auto n = static_cast<std::uint32_t>(corner_count(area));
  require_few(double(n) * (layers + 1.0));
  Polyset out;
  if (!is_convex(area)) out.convex = false;
  else if (how.twist == 0 && how.scale[0] == how.scale[1]) out.convex = true;
  for (int j = 0; j <= layers; ++j) {
    const std::vector<Point3> corners = layer(area, how, j, layers);
    out.points.insert(out.points.end(), corners.begin(), corners.end());
  }
  add_caps(out, area, 0, false);
  const auto last = static_cast<std::uint32_t>(layers) * n;
  if (how.scale[0] != 0 && how.scale[1] != 0) add_caps(out, area, last, true);
  const bool becomes_line = (how.scale[0] == 0) != (how.scale[1] == 0);
  for (std::uint32_t below = 0; below < last; below += n) {
    const bool other = becomes_line && below + n == last;  // the top layer has the other diagonals
    for_each_edge(area, [&](const Loop& loop, std::uint32_t i, std::uint32_t j) {
      const std::uint32_t a = below + i, b = below + j, c = b + n, d = a + n;
      const int nearer = compare_distances(out.points[b], out.points[d], out.points[a], out.points[c]);
      const bool first = nearer < 0 || (nearer == 0 && is_hole(loop) != (how.twist <= 0));
      if (first != other) out.faces.insert(out.faces.end(), {{a, b, d}, {b, c, d}});
      else out.faces.insert(out.faces.end(), {{a, b, c}, {a, c, d}});
    });
  }
  return out;
}

std::optional<Polyset> revolved(const Area& area, double degrees, const Fineness& fineness) {
  double least = 0, most = 0;
  for (const Loop& loop : area.loops) {
    for (const Point2& p : loop) {
      least = std::min(least, p[0]);
      most = std::max(most, p[0]);
    }
  }
  if (least < 0 && most > 0) return {};
  const bool whole = degrees == 360;
  const auto steps =
      static_cast<std::uint32_t>(std::max(fineness.segments(most - least) * std::abs(degrees) / 360, 1.0));
  const auto n = static_cast<std::uint32_t>(corner_count(area));
  require_few(double(n) * (steps + 1.0));
  Polyset out{{}, {}, false};
  for (std::uint32_t j = 0; j < (whole ? steps : steps + 1); ++j) {
    const double turn = whole ? -90 + j * 360.0 / steps : 90 - j * degrees / steps;
    for (const Loop& loop : area.loops) {
      for (const Point2& p : loop) out.points.push_back({p[0] * sine(turn), p[0] * cosine(turn), p[1]});
    }
  }
  // On the way x goes from front to back as seen from the area's inside; the other way, if turned or mirrored.
  const bool flip = (least < 0) != (whole || degrees < 0);
  const auto add = [&](Face face) {
    if (flip) std::reverse(face.begin(), face.end());
    out.faces.push_back(std::move(face));
  };
  for (std::uint32_t j = 0; j < steps; ++j) {
    const std::uint32_t here = j * n, there = whole ? (j + 1) % steps * n : here + n;
    for_each_edge(area, [&](const Loop&, std::uint32_t i, std::uint32_t k) {
      if (!flip) std::swap(i, k);  // the outline is gone round the other way, and diagonals lie the other way, too
      out.faces.push_back({here + k, there + k, here + i});
      out.faces.push_back({there + k, there + i, here + i});
    });
  }
  if (!whole) {
    for (const auto& t : triangles(area)) {
      add({t[0], t[1], t[2]});
      add({steps * n + t[0], steps * n + t[2], steps * n + t[1]});
    }
  }
  return out;
}

}  // namespace cnrg::openscad
