// Small leaves for tests: boxes with split walls, rectangles, wires and points on integer coordinates.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg::pieces {

using Point = std::array<int, 3>;

/// An axis-parallel rectangle from `low` to `high` (equal along its normal) with the regions on the side of the
/// positive axis and of the negative one.
struct Rectangle {
  Point low, high;
  std::uint32_t front = 0, back = 0;
};

/// One leaf: rectangles, wires, isolated vertices.
struct Piece {
  std::vector<Rectangle> faces;
  std::vector<std::array<Point, 2>> wires;
  std::vector<Point> points;
};

/// A box; the rectangles across `axis` are cut into `cuts` x `cuts` pieces.
inline Piece box(Point low, Point high, std::uint32_t region = 1, int cut_axis = -1, int cuts = 2) {
  Piece out;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int n = axis == cut_axis ? cuts : 1;
    for (int at : {low[axis], high[axis]}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          Rectangle r;
          r.low[axis] = r.high[axis] = at;
          r.low[u] = low[u] + (high[u] - low[u]) * i / n;
          r.high[u] = low[u] + (high[u] - low[u]) * (i + 1) / n;
          r.low[v] = low[v] + (high[v] - low[v]) * j / n;
          r.high[v] = low[v] + (high[v] - low[v]) * (j + 1) / n;
          r.front = at == low[axis] ? region : 0;
          r.back = at == low[axis] ? 0 : region;
          out.faces.push_back(r);
        }
      }
    }
  }
  return out;
}

/// A box of two regions, parted at x = `middle` by a wall of `cuts` x `cuts` pieces.
inline Piece parted_box(Point low, Point high, int middle, int cuts = 2) {
  Piece out = box(low, {middle, high[1], high[2]}, 1, 0, cuts);
  const Piece right = box({middle, low[1], low[2]}, high, 2, 0, cuts);
  for (Rectangle& r : out.faces) {
    if (r.low[0] == middle && r.high[0] == middle) r.front = 2;
  }
  for (const Rectangle& r : right.faces) {
    if (!(r.low[0] == middle && r.high[0] == middle)) out.faces.push_back(r);
  }
  return out;
}

/// A sheet inside a region of its leaf, or outside of all (0).
inline Piece sheet(Point low, Point high, std::uint32_t region = 0) {
  return {{{low, high, region, region}}, {}, {}};
}
inline Piece wire(Point a, Point b) { return {{}, {{{a, b}}}, {}}; }
inline Piece point(Point p) { return {{}, {}, {p}}; }
inline Piece operator+(Piece a, const Piece& b) {
  a.faces.insert(a.faces.end(), b.faces.begin(), b.faces.end());
  a.wires.insert(a.wires.end(), b.wires.begin(), b.wires.end());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  return a;
}

/// The complex of some leaves, each with Fill::sides.
inline std::shared_ptr<const Complex> complex_of(const std::vector<Piece>& leaves) {
  Soup soup;
  std::map<Point, PointId> ids;
  const auto id = [&](Point p) {
    const auto [it, fresh] = ids.try_emplace(p);
    if (fresh) it->second = soup.add_point(p[0], p[1], p[2]);
    return it->second;
  };
  for (const Piece& piece : leaves) {
    const LeafId leaf = soup.add_leaf(Fill::sides);
    std::uint32_t number = 0;
    for (const Rectangle& r : piece.faces) {
      const int axis = r.low[0] == r.high[0] ? 0 : (r.low[1] == r.high[1] ? 1 : 2);
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Point a = r.low, b = a, c = r.high, d = a;
      b[u] = r.high[u], d[v] = r.high[v];
      const std::vector<std::vector<PointId>> loops{{id(a), id(b), id(c), id(d)}};
      soup.add_face(leaf, loops, number, number, r.front, r.back);
      ++number;
    }
    number = 0;
    for (const auto& [a, b] : piece.wires) soup.add_wire(leaf, id(a), id(b), number++);
    for (Point p : piece.points) soup.add_isolated(leaf, id(p));
  }
  RefineOptions options;
  options.threads = 1;
  return build_complex(soup, options);
}

}  // namespace cnrg::pieces
