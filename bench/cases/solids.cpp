#include "bench/cases/solids.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bench/cases/shapes.h"
#include "kernel/exact/integers.h"

namespace cnrg::bench {
namespace {

RationalPoint difference(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Rational determinant(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

void turn_over(Model& model) {
  for (Model::Face& face : model.faces)
    for (auto& loop : face.loops) std::reverse(loop.begin(), loop.end());
}

void add_face(Model& model, std::vector<std::uint32_t> loop) { model.faces.push_back({{std::move(loop)}, true}); }

std::uint32_t add_point(Model& model, RationalPoint p) {
  model.points.push_back(std::move(p));
  return static_cast<std::uint32_t>(model.points.size() - 1);
}

/// Points 0 to n - 1 are the bottom, n to 2 n - 1 the top; both counter-clockwise from above.
void add_sides(Model& model, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) add_face(model, {i, (i + 1) % n, n + (i + 1) % n, n + i});
}

void add_points(Model& model, const Polygon& polygon, const Rational& z) {
  for (const auto& [x, y] : polygon) model.points.push_back({x, y, z});
}

/// n, n - 1, ... or first, first + 1, ...
std::vector<std::uint32_t> count(std::uint32_t first, std::uint32_t n, bool down) {
  std::vector<std::uint32_t> numbers(n);
  for (std::uint32_t i = 0; i < n; ++i) numbers[i] = first + (down ? n - 1 - i : i);
  return numbers;
}

using GridPoint = std::array<std::int64_t, 3>;

/// Positive when the triangle is seen counter-clockwise from p.
std::int64_t side(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& p) {
  std::array<GridPoint, 3> d;
  for (int k = 0; k < 3; ++k) d[0][k] = b[k] - a[k], d[1][k] = c[k] - a[k], d[2][k] = p[k] - a[k];
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) + d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The hull with point i, if it lies outside. One in the plane of a triangle is left out: no four points of a hull
/// that share a triangle are in a plane.
void grow_hull(Triangles& hull, const std::vector<GridPoint>& points, std::uint32_t i) {
  Triangles hidden;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : hull) {
    const std::int64_t s = side(points[t[0]], points[t[1]], points[t[2]], points[i]);
    if (s == 0) return;
    if (s < 0) hidden.push_back(t);
    else
      for (int k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [a, b] : sides) {
    if (!std::binary_search(sides.begin(), sides.end(), std::pair(b, a))) hidden.push_back({a, b, i});
  }
  hull = std::move(hidden);
}

Triangles convex_hull(const std::vector<GridPoint>& points) {
  std::uint32_t last = 3;
  while (last < points.size() && side(points[0], points[1], points[2], points[last]) == 0) ++last;
  if (last == points.size()) throw std::logic_error("points of a hull are in a plane");
  Triangles hull{{0, 1, 2}, {0, 2, last}, {0, last, 1}, {1, last, 2}};
  if (side(points[0], points[1], points[2], points[last]) > 0)
    for (auto& t : hull) std::swap(t[1], t[2]);
  for (std::uint32_t i = 3; i < points.size(); ++i)
    if (i != last) grow_hull(hull, points, i);
  return hull;
}

}  // namespace

RationalPoint AffineMap::operator()(const RationalPoint& p) const {
  RationalPoint q = move;
  for (int k = 0; k < 3; ++k) q[k] += rows[k][0] * p[0] + rows[k][1] * p[1] + rows[k][2] * p[2];
  return q;
}

AffineMap rotation(const std::array<Rational, 4>& quaternion) {
  const auto& [w, x, y, z] = quaternion;
  const Rational square = w * w + x * x + y * y + z * z;
  const std::array<std::array<Rational, 3>, 3> rows{
      {{w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w)},
       {2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w)},
       {2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z}}};
  AffineMap map;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) map.rows[i][k] = rows[i][k] / square;
  return map;
}

AffineMap random_rotation(Random& random) {
  std::array<Rational, 4> q;
  q[0] = random.integer(1, 4);
  for (int k = 1; k < 4; ++k) q[k] = random.integer(1, 4) * (random.integer(0, 1) == 0 ? 1 : -1);
  return rotation(q);
}

AffineMap translation(const RationalPoint& move) {
  AffineMap map;
  map.move = move;
  return map;
}

AffineMap shear(const Rational& a, const Rational& b) {
  AffineMap map;
  map.rows[0][2] = a;
  map.rows[1][2] = b;
  return map;
}

Model mapped(Model model, const AffineMap& map) {
  for (RationalPoint& p : model.points) p = map(p);
  if (determinant(map.rows[0], map.rows[1], map.rows[2]) < 0) turn_over(model);
  return model;
}

Rational power_of_tenth(int k) { return Rational(Integer(1), power_of_ten(static_cast<std::size_t>(k))); }

Model box_between(const RationalPoint& min, const RationalPoint& max) {
  const auto& [x0, y0, z0] = min;
  const auto& [x1, y1, z1] = max;
  const Polygon section{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return frustum(section, z0, section, z1);
}

Model tetrahedron(const std::array<RationalPoint, 4>& corners) {
  Model model;
  model.points.assign(corners.begin(), corners.end());
  for (std::vector<std::uint32_t> loop : {std::vector<std::uint32_t>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    add_face(model, std::move(loop));
  const Rational turn = determinant(difference(corners[1], corners[0]), difference(corners[2], corners[0]),
                                    difference(corners[3], corners[0]));
  if (turn == 0) throw std::logic_error("the corners of a tetrahedron are in a plane");
  if (turn < 0) turn_over(model);
  return model;
}

Polygon random_polygon(std::size_t corners, Random& random) {
  if (corners < 3) throw std::logic_error("a polygon has at least three corners");
  // A corner stands out by about 5 / corners^2 of the radius, some by a fifth of that: many units.
  const auto unit = static_cast<std::int64_t>(std::bit_ceil(128 * corners * corners));
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double jitter = i == 0 ? 0 : random.real(-0.15, 0.15);
    const double angle = 2 * M_PI * (static_cast<double>(i) + jitter) / static_cast<double>(corners);
    polygon.push_back({fraction(std::llround(std::cos(angle) * static_cast<double>(unit)), unit),
                       fraction(std::llround(std::sin(angle) * static_cast<double>(unit)), unit)});
  }
  return polygon;
}

Polygon scaled(const Polygon& polygon, const Rational& factor, const std::array<Rational, 2>& move) {
  Polygon result = polygon;
  for (auto& [x, y] : result) {
    x = x * factor + move[0];
    y = y * factor + move[1];
  }
  return result;
}

Model frustum(const Polygon& bottom, const Rational& low, const Polygon& top, const Rational& high) {
  Model model;
  const auto n = static_cast<std::uint32_t>(bottom.size());
  add_points(model, bottom, low);
  add_points(model, top, high);
  add_face(model, count(0, n, true));
  add_face(model, count(n, n, false));
  add_sides(model, n);
  return model;
}

Model pyramid(const Polygon& base, const Rational& height, const RationalPoint& apex) {
  Model model;
  const auto n = static_cast<std::uint32_t>(base.size());
  add_points(model, base, height);
  const std::uint32_t top = add_point(model, apex);
  add_face(model, count(0, n, true));
  for (std::uint32_t i = 0; i < n; ++i) add_face(model, {i, (i + 1) % n, top});
  if (apex[2] < height) turn_over(model);
  return model;
}

Model star_prism(std::size_t arms, Random& random) {
  Polygon star = random_polygon(2 * arms, random);
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Rational reach = fraction(i % 2 == 0 ? random.integer(13, 16) : random.integer(7, 10), 16);
    for (Rational& x : star[i]) x *= reach;
  }
  const auto n = static_cast<std::uint32_t>(star.size());
  const Rational height = fraction(random.integer(20, 28), 32);
  Model model;
  add_points(model, star, -height);
  add_points(model, star, height);
  add_sides(model, n);
  const std::uint32_t low = add_point(model, {0, 0, -height - fraction(random.integer(1, 4), 32)});
  const std::uint32_t high = add_point(model, {0, 0, height + fraction(random.integer(1, 4), 32)});
  for (std::uint32_t i = 0; i < n; ++i) {
    add_face(model, {(i + 1) % n, i, low});
    add_face(model, {n + i, n + (i + 1) % n, high});
  }
  return model;
}

Model ring(std::size_t segments, std::size_t corners, Random& random) {
  // The section: distance from the axis and height, counter-clockwise in this order.
  const auto near = [&](int x) { return fraction(8 * x + random.integer(-3, 3), 128); };
  Polygon section;
  if (corners == 3) section = {{near(7), near(-5)}, {near(16), near(0)}, {near(8), near(5)}};
  else section = {{near(7), near(-5)}, {near(15), near(-5)}, {near(16), near(5)}, {near(8), near(5)}};
  const Polygon around = random_polygon(segments, random);
  const auto n = static_cast<std::uint32_t>(segments), m = static_cast<std::uint32_t>(section.size());
  Model model;
  for (const auto& [x, y] : around)
    for (const auto& [distance, height] : section) add_point(model, {x * distance, y * distance, height});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t here = i * m, there = (i + 1) % n * m;
    for (std::uint32_t j = 0; j < m; ++j)
      add_face(model, {here + j, there + j, there + (j + 1) % m, here + (j + 1) % m});
  }
  return model;
}

Model random_hull(std::size_t faces, Random& random) {
  constexpr int kUnit = 2048;
  std::vector<GridPoint> points;
  while (points.size() < faces / 2 + 2) {
    GridPoint p;
    for (auto& x : p) x = random.integer(-kUnit, kUnit);
    const double length = std::sqrt(static_cast<double>(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
    if (length < kUnit / 4 || length > kUnit) continue;
    for (auto& x : p) x = std::llround(static_cast<double>(x) / length * kUnit);
    points.push_back(p);
  }
  const Triangles hull = convex_hull(points);
  Model model;
  std::vector<std::uint32_t> number(points.size(), static_cast<std::uint32_t>(points.size()));
  for (const auto& t : hull) {
    std::vector<std::uint32_t> loop;
    for (const std::uint32_t i : t) {
      const auto& [x, y, z] = points[i];
      if (number[i] == points.size())
        number[i] = add_point(model, {fraction(x, kUnit), fraction(y, kUnit), fraction(z, kUnit)});
      loop.push_back(number[i]);
    }
    add_face(model, std::move(loop));
  }
  return model;
}

Model rough_sphere(std::size_t faces, unsigned seed) {
  TriangleMesh mesh = bumpy_sphere(faces, seed);
  for (auto& p : mesh.points)
    for (double& x : p) x = std::ldexp(std::nearbyint(std::ldexp(x, 16)), -16);
  return model_of(mesh);
}

Model sheet_of(const std::vector<RationalPoint>& corners) {
  Model model;
  model.points = corners;
  model.faces.push_back({{count(0, static_cast<std::uint32_t>(corners.size()), false)}, false});
  return model;
}

Model wire_of(const std::vector<RationalPoint>& points) {
  Model model;
  model.points = points;
  for (std::uint32_t i = 1; i < points.size(); ++i) model.wires.push_back({i - 1, i});
  return model;
}

}  // namespace cnrg::bench
