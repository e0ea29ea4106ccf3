// Bounds by the mean value theorem; see the header.
#include "csg/certify/swept_leaf.h"

#include <algorithm>
#include <cmath>

#include "csg/certify/pieces.h"
#include "csg/leaves/geometry_leaf.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"

namespace cnrg {

using namespace surface_math;

namespace {

constexpr std::array<std::array<int, 3>, Slabs::kDirections> kDirection{{{1, 0, 0},
                                                                         {0, 1, 0},
                                                                         {0, 0, 1},
                                                                         {1, 1, 0},
                                                                         {1, -1, 0},
                                                                         {1, 0, 1},
                                                                         {1, 0, -1},
                                                                         {0, 1, 1},
                                                                         {0, 1, -1},
                                                                         {1, 1, 1},
                                                                         {1, 1, -1},
                                                                         {1, -1, 1},
                                                                         {-1, 1, 1}}};

/// Unit vectors at right angles, the first about along `v`.
std::array<Interval3, 3> frame_along(const Interval3& v) {
  const auto unit_of = [](const Guess3& x) { return direction(x).value_or(Guess3{1, 0, 0}); };
  const Guess3 first = unit_of(middle_of(v));
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(first[k]) < abs(first[least])) least = k;
  }
  Guess3 axis{0, 0, 0};
  axis[least] = 1;
  const Guess3 second = unit_of(cross(first, axis));
  return {thin(first), thin(second), thin(cross(first, second))};
}

/// A part of a cell, by corners, ways x from the first to the second and y from the first to the last.
struct Part {
  std::size_t count = 0;  // 3 or 4
  std::array<std::array<Interval, 2>, 4> at{};
  std::array<Interval3, 4> facet{}, off{};  // F and S - F there
};
/// How far a function may be from the line between its ends, from 0 to 1: at most, and in the mean.
struct Rise {
  Interval most = 0, mean = 0;
};
/// With a derivative from a to b: (b - a) / 4 and 9 / 64 (b - a).
Rise by_slope(const Interval& slope) {
  const Interval width = Interval(slope.sup()) - Interval(slope.inf());
  return {width / Interval(4), Interval(9) * width / Interval(64)};
}
/// With a second derivative of at most m: m / 8 and m / 12.
Rise by_bend(const Interval& second) {
  const Interval m(largest(second));
  return {m / Interval(8), m / Interval(12)};
}
Rise smaller(const Rise& a, const Rise& b) { return b.mean.sup() < a.mean.sup() ? b : a; }

struct Measure {
  Interval volume = 0;
  Interval along_x = 0, along_y = 0;  ///< the same per share of a way, where the part is not taken whole
  Interval far = 0;
};

Measure measure(const PlacedSurface& surface, const Part& part) {
  const std::size_t last = part.count - 1;
  std::array<Interval, 2> range = part.at[0];
  for (std::size_t i = 1; i <= last; ++i) {
    for (std::size_t k = 0; k < 2; ++k) range[k] = hull(range[k], part.at[i][k]);
  }
  const SurfaceJet<Interval> jet = surface.over(range[0], range[1]);
  const auto along = [&](std::size_t a, std::size_t b) {
    return sum(scaled(Interval(part.at[b][0] - part.at[a][0]), jet.along_u),
               scaled(Interval(part.at[b][1] - part.at[a][1]), jet.along_v));
  };
  const auto side = [&](std::size_t a, std::size_t b) { return difference(part.facet[b], part.facet[a]); };
  const bool triangle = part.count == 3;
  const Interval3 surface_x = along(0, 1), surface_y = along(0, last),
                  facet_x = triangle ? side(0, 1) : hull(side(0, 1), side(3, 2)),
                  facet_y = triangle ? side(0, 2) : hull(side(0, 3), side(1, 2));
  const Interval3 off_x = difference(surface_x, facet_x), off_y = difference(surface_y, facet_y);
  const Interval3 normal = cross(hull(surface_x, facet_x), hull(surface_y, facet_y));
  // Second derivatives along the ways of x and y, and of both; as of F, which is linear along each, so of S - F.
  const std::optional<SurfaceBend> bend = surface.bend_over(range[0], range[1]);
  const auto bent = [&](std::size_t a, std::size_t b) {
    const Interval au = part.at[a][0] - part.at[0][0], av = part.at[a][1] - part.at[0][1],
                   bu = part.at[b][0] - part.at[0][0], bv = part.at[b][1] - part.at[0][1];
    return sum(scaled(Interval(au * bu), bend->uu),
               sum(scaled(Interval(au * bv + av * bu), bend->uv), scaled(Interval(av * bv), bend->vv)));
  };
  Interval3 bent_xx, bent_xy, bent_yy;
  if (bend) bent_xx = bent(1, 1), bent_xy = bent(1, last), bent_yy = bent(last, last);
  Measure result;
  Interval length(0);
  for (const Interval3& axis : frame_along(normal)) {
    Interval mean(0), top(0);
    for (std::size_t i = 0; i <= last; ++i) {
      const double off = largest(dot(axis, part.off[i]));
      mean += Interval(off) / Interval(static_cast<double>(part.count));
      top = Interval(std::max(top.sup(), off));
    }
    const Interval n(largest(dot(axis, normal)));
    const Interval x = dot(axis, off_x), y = dot(axis, off_y);
    length += n;
    if (triangle) {  // to a point between corners 1 and 2, then on the way to it from corner 0
      Rise across = by_slope(y - x), to_it = by_slope(hull(x, y));
      if (bend) {
        const Interval xx = dot(axis, bent_xx), xy = dot(axis, bent_xy), yy = dot(axis, bent_yy);
        across = smaller(across, by_bend(xx + yy - Interval(2) * xy));
        to_it = smaller(to_it, by_bend(hull(hull(xx, yy), xy)));
      }
      result.volume += (mean + across.mean + to_it.mean) * n;
      result.far += top + across.most + to_it.most;
      continue;
    }
    Rise by_x = by_slope(x), by_y = by_slope(y);
    if (bend) {
      by_x = smaller(by_x, by_bend(dot(axis, bent_xx)));
      by_y = smaller(by_y, by_bend(dot(axis, bent_yy)));
    }
    result.volume += (mean + by_x.mean + by_y.mean) * n;
    result.along_x += (top + by_x.most + by_y.mean) * n;
    result.along_y += (top + by_x.mean + by_y.most) * n;
    result.far += top + by_x.most + by_y.most;
  }
  // The axes are at right angles as nearly as doubles can have it.
  const Interval rounding = Interval(1e-14) * result.far * length;
  result.volume += rounding;
  result.along_x += rounding;
  result.along_y += rounding;
  result.far *= Interval(1 + 1e-14);
  if (triangle) result.volume = result.volume / Interval(2);
  return result;
}

/// Into how many parts to cut a cell along x and y: one where it is straight.
std::array<int, 2> parts_of(const PlacedSurface& surface, const Part& part, int most_parts) {
  const enclosure::RoundNearest nearest;
  const auto between = [&](std::size_t i, std::size_t j) {
    const std::array<double, 2> a{part.at[i][0].inf(), part.at[i][1].inf()},
        b{part.at[j][0].inf(), part.at[j][1].inf()};
    const Vector3<double> x = surface.at(a[0], a[1]).point, y = surface.at(b[0], b[1]).point,
                          m = surface.at((a[0] + b[0]) / 2, (a[1] + b[1]) / 2).point;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) off += std::abs(m[k] - (x[k] + y[k]) / 2);
    return off;
  };
  const std::size_t last = part.count - 1;
  const Interval u = part.at[0][0], v = part.at[0][1];
  if (surface.bend_over(u, v)) most_parts = (most_parts + 1) / 2;
  if (part.count == 3) return {most_parts, most_parts};
  const double x = std::max(between(0, 1), between(last, 2)), y = std::max(between(0, last), between(1, 2));
  return {x * 20 < y ? 1 : most_parts, y * 20 < x ? 1 : most_parts};
}

}  // namespace

Slabs::Slabs() {
  low_.fill(kInfinity);
  high_.fill(-kInfinity);
}

Slabs Slabs::everything() {
  Slabs all;
  all.low_.fill(-kInfinity);
  all.high_.fill(kInfinity);
  return all;
}

void Slabs::extend(const std::array<Interval, 3>& p, double far) {
  for (std::size_t i = 0; i < kDirections; ++i) {
    Interval at(0), length(0);
    for (std::size_t k = 0; k < 3; ++k) {
      at += Interval(kDirection[i][k]) * p[k];
      length += Interval(std::abs(kDirection[i][k]));  // more than that of the vector
    }
    at += Interval(-far, far) * length;
    low_[i] = std::min(low_[i], at.inf());
    high_[i] = std::max(high_[i], at.sup());
  }
}

Slabs Slabs::hull(const Slabs& other) const {
  Slabs all;
  std::ranges::transform(low_, other.low_, all.low_.begin(), [](double x, double y) { return std::min(x, y); });
  std::ranges::transform(high_, other.high_, all.high_.begin(), [](double x, double y) { return std::max(x, y); });
  return all;
}

Slabs Slabs::common(const Slabs& other) const {
  Slabs both;
  std::ranges::transform(low_, other.low_, both.low_.begin(), [](double x, double y) { return std::max(x, y); });
  std::ranges::transform(high_, other.high_, both.high_.begin(),
                         [](double x, double y) { return std::min(x, y); });
  return both;
}

bool Slabs::meets(const Slabs& other) const {
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (std::max(low_[i], other.low_[i]) > std::min(high_[i], other.high_[i])) return false;
  }
  return true;
}

bool Slabs::inside(const Slabs& other) const {
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (low_[i] < other.low_[i] || high_[i] > other.high_[i]) return false;
  }
  return true;
}

SweptLeaf::SweptLeaf(const LeafInstance& placed) {
  const PreparedLeaf& leaf = *placed.leaf;
  if (leaf.unbounded()) {
    slabs_ = Slabs::everything();
    return;
  }
  const Transform& transform = *placed.transform;
  Soup soup;
  leaf.add_to(soup, transform);
  const std::shared_ptr<const LeafSurfaces> surfaces = leaf.surfaces() ? leaf.surfaces()() : nullptr;
  const std::shared_ptr<const LeafParameters> parameters =
      surfaces && surfaces->complete() ? leaf.parameters()() : nullptr;
  const enclosure::RoundOutward outward;
  if (const std::optional<double> bound = leaf.volume_bound(); bound != 0.0) {
    known_ = bound.has_value();
    slabs_ = Slabs::everything();
    const Interval size = enclose(transform.determinant());
    if (known_) volume_ = (Interval(*bound) * Interval(largest(size))).sup();
    return;
  }
  for (std::size_t p = 0; p < soup.point_count(); ++p) slabs_.extend(enclose3(exact_value(soup, PointId(p))), 0);
  if (!surfaces) return;
  if (!surfaces->complete()) {
    known_ = false;
    slabs_ = Slabs::everything();
    return;
  }
  std::map<std::uint32_t, const PlacedSurface*> by_patch;
  for (const auto& [patch, surface] : surfaces->patches()) {
    surfaces_.push_back(std::make_unique<const PlacedSurface>(surfaces, patch, transform));
    by_patch[patch] = surfaces_.back().get();
  }
  std::vector<Interval3> points;
  for (const RationalPoint& p : parameters->points())
    points.push_back(enclose3(transform.identity() ? p : transform.apply(p)));
  std::vector<Interval> values;
  for (const Rational& value : parameters->values()) values.push_back(enclose(value));
  std::vector<const PlacedSurface*> surface_of;
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    const auto surface = by_patch.find(soup.face(f).patch);
    if (surface == by_patch.end()) continue;
    for (const auto& corners : parameters->cells_by_number(f.index())) {
      add(points, values, corners);
      surface_of.resize(cells_.size(), surface->second);
    }
  }
  const int parts = soup.face_count() <= 500 ? 4 : 2;
  for_each_index(
      cells_.size(),
      [&](std::size_t i) {
        const enclosure::RoundOutward here;
        finish(*surface_of[i], parts, cells_[i]);
      },
      64);
  Interval all(0);
  for (const Cell& cell : cells_) {
    if (!std::isfinite(cell.volume)) known_ = false;
    slabs_ = slabs_.hull(cell.slabs);
    all += Interval(cell.volume);
  }
  volume_ = all.sup();
}

void SweptLeaf::add(const std::vector<Interval3>& points, const std::vector<Interval>& values,
                    std::span<const LeafParameters::Corner> corners) {
  Cell& cell = cells_.emplace_back();
  cell.corner_count = static_cast<std::uint8_t>(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    cell.corners[i] = points[corners[i].point];
    cell.at[i] = {values[corners[i].u], values[corners[i].v]};
  }
  const auto on_line = [&](std::size_t a, std::size_t b, std::size_t k) {
    return k == 0 ? corners[a].u == corners[b].u : corners[a].v == corners[b].v;
  };
  const auto rectangle = [&](std::size_t k) {  // sides 0 1 and 2 3 along the other parameter
    return on_line(0, 1, k) && on_line(2, 3, k) && on_line(1, 2, 1 - k) && on_line(3, 0, 1 - k);
  };
  if (corners.size() == 3 || rectangle(0) || rectangle(1)) return;
  cell.corner_count = 3;  // affine in two triangles (parameters.h)
  Cell other = cell;
  other.corners = {cell.corners[0], cell.corners[2], cell.corners[3]};
  other.at = {cell.at[0], cell.at[2], cell.at[3]};
  cells_.push_back(std::move(other));
}

void SweptLeaf::finish(const PlacedSurface& surface, int parts, Cell& cell) {
  Part whole{cell.corner_count, cell.at, cell.corners, {}};
  const bool triangle = cell.corner_count == 3;
  const auto [parts_x, parts_y] = parts_of(surface, whole, parts);
  const std::size_t last = cell.corner_count - 1u;
  const auto mixed = [](const auto& a, const auto& b, const Interval& share) {
    auto result = a;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = a[k] + share * (b[k] - a[k]);
    return result;
  };
  struct Node {
    std::array<Interval, 2> at;
    Interval3 facet, off;
  };
  std::vector<Node> nodes;
  for (int j = 0; j <= parts_y; ++j) {
    for (int i = 0; i <= parts_x; ++i) {
      const Interval x = Interval(i) / Interval(parts_x), y = Interval(j) / Interval(parts_y);
      Node node;
      const auto place = [&](const auto& corners) {
        if (!triangle) return mixed(mixed(corners[0], corners[1], x), mixed(corners[3], corners[2], x), y);
        auto result = mixed(corners[0], corners[1], x);
        for (std::size_t k = 0; k < result.size(); ++k) result[k] += y * (corners[2][k] - corners[0][k]);
        return result;
      };
      if (!triangle || i + j <= parts_x) {
        node.at = place(cell.at);
        node.facet = place(cell.corners);
        node.off = difference(surface.over(node.at[0], node.at[1]).point, node.facet);
      }
      nodes.push_back(node);
    }
  }
  const auto part_of_nodes = [&, parts_x = parts_x](std::initializer_list<std::array<int, 2>> corners) {
    Part part;
    for (const auto& [i, j] : corners) {
      const Node& node = nodes[static_cast<std::size_t>(j * (parts_x + 1) + i)];
      part.at[part.count] = node.at;
      part.facet[part.count] = node.facet;
      part.off[part.count++] = node.off;
    }
    return measure(surface, part);
  };
  Interval volume(0);
  std::vector<Interval> columns(static_cast<std::size_t>(parts_x), Interval(0)),
      rows(static_cast<std::size_t>(parts_y), Interval(0));
  for (int j = 0; j < parts_y; ++j) {
    for (int i = 0; i < parts_x; ++i) {
      const auto take = [&](const Measure& part) {
        volume += part.volume;
        cell.far = std::max(cell.far, part.far.sup());
        columns[static_cast<std::size_t>(i)] += part.along_x;
        rows[static_cast<std::size_t>(j)] += part.along_y;
      };
      if (!triangle) {
        take(part_of_nodes({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}));
      } else if (i + j < parts_x) {
        take(part_of_nodes({{i, j}, {i + 1, j}, {i, j + 1}}));
        if (i + j + 1 < parts_x) take(part_of_nodes({{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}));
      }
    }
  }
  cell.volume = volume.sup();
  const auto densest = [](const std::vector<Interval>& strips) {
    double most = 0;
    for (const Interval& strip : strips) most = std::max(most, strip.sup());
    return (Interval(most) * Interval(static_cast<double>(strips.size()))).sup();
  };
  cell.of_part = {densest(columns), densest(rows)};
  for (std::size_t i = 0; i <= last; ++i) cell.slabs.extend(cell.corners[i], cell.far);
}

double SweptLeaf::volume(const Slabs& within) const {
  if (cells_.empty() || slabs_.inside(within)) return volume_;
  constexpr int kParts = 16;
  const enclosure::RoundOutward outward;
  Interval all(0);
  for (const Cell& cell : cells_) {
    if (!cell.slabs.meets(within)) continue;
    if (cell.corner_count == 3 || cell.slabs.inside(within)) {
      all += Interval(cell.volume);
      continue;
    }
    // Parts along the longer way.
    const auto length = [&](std::size_t a, std::size_t b) {
      Upward sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum = sum + largest(cell.corners[b][k] - cell.corners[a][k]);
      return sum;
    };
    const bool x = std::max(length(0, 1), length(3, 2)) >= std::max(length(0, 3), length(1, 2));
    const auto at = [&](std::size_t a, std::size_t b, int i) {
      const Interval share = Interval(i) / Interval(kParts);
      return sum(cell.corners[a], scaled(share, difference(cell.corners[b], cell.corners[a])));
    };
    int parts = 0;
    for (int i = 0; i < kParts; ++i) {
      Slabs part = Slabs::nothing();
      for (const int end : {i, i + 1}) {
        part.extend(x ? at(0, 1, end) : at(0, 3, end), cell.far);
        part.extend(x ? at(3, 2, end) : at(1, 2, end), cell.far);
      }
      if (part.meets(within)) ++parts;
    }
    const Interval of_parts = Interval(cell.of_part[x ? 0 : 1]) * Interval(parts) / Interval(kParts);
    all += Interval(std::min(cell.volume, of_parts.sup()));
  }
  return all.sup();
}

}  // namespace cnrg
