// Nets made, cut and written in other ways by formulas of the tests' own, and the facets of leaves as sets.
//
// What is under test cuts nets by de Casteljau and compares coefficients of powers; here pieces are blossoms.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <vector>

#include "csg/carriers/nets.h"
#include "csg/leaves/parameters.h"
#include "tests/leaves/soup_checks.h"
#include "tests/scenes/seeds.h"

namespace cnrg::test {

/// Homogeneous control points, [row along v][entry along u].
using Point4 = std::array<Rational, 4>;
using Row4 = std::vector<Point4>;
using Net4 = std::vector<Row4>;

inline Rational ratio(long a, long b) { return Rational(a) / Rational(b); }
inline int pick(std::mt19937& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

/// The blossom of a row at as many arguments as its degree.
inline Point4 blossom(Row4 row, const std::vector<Rational>& at) {
  for (const Rational& t : at) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) row[i][k] = (1 - t) * row[i][k] + t * row[i + 1][k];
    }
    row.pop_back();
  }
  return row[0];
}

/// The control points of the row from t = a to t = b; b < a runs backward.
inline Row4 piece_of(const Row4& row, const Rational& a, const Rational& b) {
  Row4 result;
  const std::size_t n = row.size() - 1;
  for (std::size_t i = 0; i <= n; ++i) {
    std::vector<Rational> at(n, a);
    std::fill(at.begin(), at.begin() + static_cast<long>(i), b);
    result.push_back(blossom(row, at));
  }
  return result;
}

inline Net4 turned(const Net4& net) {
  Net4 result(net[0].size(), Row4(net.size()));
  for (std::size_t j = 0; j < net.size(); ++j) {
    for (std::size_t i = 0; i < net[j].size(); ++i) result[i][j] = net[j][i];
  }
  return result;
}

using Rectangle = std::array<std::array<Rational, 2>, 2>;  // along u, along v

inline Net4 piece_of(const Net4& net, const Rectangle& r) {
  Net4 result;
  for (const Row4& row : net) result.push_back(piece_of(row, r[0][0], r[0][1]));
  result = turned(result);
  for (Row4& row : result) row = piece_of(row, r[1][0], r[1][1]);
  return turned(result);
}

/// One degree more.
inline Row4 raised(const Row4& row) {
  const long n = static_cast<long>(row.size());
  Row4 result;
  for (long i = 0; i <= n; ++i) {
    Point4 p{0, 0, 0, 0};
    for (std::size_t k = 0; k < 4; ++k) {
      if (i > 0) p[k] += ratio(i, n) * row[static_cast<std::size_t>(i - 1)][k];
      if (i < n) p[k] += ratio(n - i, n) * row[static_cast<std::size_t>(i)][k];
    }
    result.push_back(p);
  }
  return result;
}
inline Net4 raised(Net4 net, int along_u, int along_v) {
  for (; along_u > 0; --along_u) {
    for (Row4& row : net) row = raised(row);
  }
  net = turned(net);
  for (; along_v > 0; --along_v) {
    for (Row4& row : net) row = raised(row);
  }
  return turned(net);
}

/// One of the eight ways to write a net.
inline Net4 written(Net4 net, int way) {
  if (way & 1) std::reverse(net.begin(), net.end());
  if (way & 2) {
    for (Row4& row : net) std::reverse(row.begin(), row.end());
  }
  return way & 4 ? turned(net) : net;
}

inline RationalPoint point_of(const Point4& h) { return {h[0] / h[3], h[1] / h[3], h[2] / h[3]}; }
inline RationalPoint at(const Net4& net, const Rational& u, const Rational& v) {
  Row4 column;
  for (const Row4& row : net) column.push_back(blossom(row, std::vector<Rational>(row.size() - 1, u)));
  return point_of(blossom(column, std::vector<Rational>(column.size() - 1, v)));
}

/// For a shape; `back`: applied to the points, so that the inverse as transform brings them where they were.
inline CurveNet curve_net(const Row4& row, const Transform& back = {}, const Rational& factor = 1) {
  CurveNet result;
  for (const Point4& h : row) {
    result.points.push_back(back.apply(point_of(h)));
    result.weights.push_back(h[3] * factor);
  }
  return result;
}
inline PatchNet patch_net(const Net4& net, const Transform& back = {}, const Rational& factor = 1) {
  PatchNet result;
  for (const Row4& row : net) {
    const CurveNet one = curve_net(row, back, factor);
    result.points.push_back(one.points);
    result.weights.push_back(one.weights);
  }
  return result;
}

/// x and y are u and v, z is a polynomial: facets' projections have an area that is known.
inline Net4 random_graph(std::mt19937& random, int m, int n) {
  Net4 net;
  for (long j = 0; j <= n; ++j) {
    net.emplace_back();
    for (long i = 0; i <= m; ++i)
      net.back().push_back({ratio(i, m), ratio(j, n), ratio(pick(random, -6, 6), 4), 1});
  }
  return net;
}
inline Net4 random_rational(std::mt19937& random, int m, int n) {
  Net4 net;
  for (long j = 0; j <= n; ++j) {
    net.emplace_back();
    for (long i = 0; i <= m; ++i) {
      const Rational w = ratio(pick(random, 2, 6), 3);
      net.back().push_back({w * (ratio(i, m) + ratio(pick(random, -1, 1), 9)), w * ratio(j, n),
                            w * ratio(pick(random, -6, 6), 4), w});
    }
  }
  return net;
}

inline std::array<Rational, 2> random_interval(std::mt19937& random) {
  const int whole = pick(random, 2, 7), a = pick(random, 0, whole - 1);
  return {ratio(a, whole), ratio(pick(random, a + 1, whole), whole)};
}

inline Transform random_transform(std::mt19937& random) {
  switch (pick(random, 0, 3)) {
    case 0: return {};
    case 1:
      return Transform::rotation({1, pick(random, -2, 2), 3}, pick(random, 1, 359), {1, 0, pick(random, 0, 2)});
    case 2: return Transform::reflection({1, 1, pick(random, -1, 2)}, {0, 0, 1});
    default: {
      Transform shear = Transform::scaling({ratio(pick(random, 1, 5), 3), 2, -1});
      shear.linear[0][1] = ratio(pick(random, -3, 3), 2);
      return shear;
    }
  }
}

inline Tessellation random_fineness(std::mt19937& random) {
  if (pick(random, 0, 1) == 0) return {std::nullopt, pick(random, 1, 7)};
  return {ratio(1, pick(random, 3, 25)), std::nullopt};
}

/// The shape as it was, with its points moved by the inverse of the transform.
inline LeafInstance placed(const Shape& shape, const Transform& transform = {}) {
  return {prepare(shape), transform};
}

/// Corners of facets, each set ascending: sides do not matter.
using Facets = std::multiset<std::vector<RationalPoint>>;
inline Facets facets(const LeafInstance& instance) {
  const Soup soup = make_soup({instance});
  Facets result;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    std::vector<RationalPoint> corners = loops(soup, f)[0];
    std::sort(corners.begin(), corners.end());
    result.insert(std::move(corners));
  }
  return result;
}
inline bool contains(const Facets& all, const Facets& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}
/// Twice the area of triangles as seen along z.
inline Rational double_area(const Facets& facets) {
  Rational sum = 0;
  for (const auto& f : facets) sum += abs(cross(f[1] - f[0], f[2] - f[0])[2]);
  return sum;
}

/// Straight pieces of wires.
using Segments = std::set<std::array<RationalPoint, 2>>;
inline Segments wires(const LeafInstance& instance) {
  const Soup soup = make_soup({instance});
  Segments result;
  for (const Soup::Wire& wire : soup.wires()) {
    const RationalPoint a = value(soup, wire.a), b = value(soup, wire.b);
    result.insert({std::min(a, b), std::max(a, b)});
  }
  return result;
}
/// Edges that one facet has.
inline Segments border(const LeafInstance& instance) {
  const Soup soup = make_soup({instance});
  Segments result;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    const std::vector<RationalPoint> corners = loops(soup, f)[0];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const RationalPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const std::array<RationalPoint, 2> edge{std::min(a, b), std::max(a, b)};
      if (!result.erase(edge)) result.insert(edge);
    }
  }
  return result;
}

}  // namespace cnrg::test
