#include "tests/baseline/shapes.h"

#include <utility>

namespace cnrg::bench::baseline_test {

Model prism(const Polygon& outer, const std::vector<Polygon>& holes, long low, long high) {
  Model model;
  std::vector<Polygon> loops = {outer};
  loops.insert(loops.end(), holes.begin(), holes.end());
  Model::Face top, bottom;
  for (const Polygon& loop : loops) {
    const auto first = static_cast<std::uint32_t>(model.points.size());
    const auto n = static_cast<std::uint32_t>(loop.size());
    std::vector<std::uint32_t> up, down;
    for (std::uint32_t k = 0; k < n; ++k) {
      model.points.push_back({loop[k][0], loop[k][1], low});
      model.points.push_back({loop[k][0], loop[k][1], high});
      up.push_back(first + 2 * k + 1);
      down.push_back(first + 2 * (n - 1 - k));
      const std::uint32_t a = first + 2 * k, b = first + 2 * ((k + 1) % n);
      model.faces.push_back({{{a, b, b + 1, a + 1}}, true});
    }
    top.loops.push_back(up);
    bottom.loops.push_back(down);
  }
  model.faces.push_back(top);
  model.faces.push_back(bottom);
  return model;
}

Model box(const std::array<long, 3>& low, const std::array<long, 3>& high) {
  return prism({{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}, {}, low[2], high[2]);
}

Model tetrahedron() {
  Model model;
  model.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  model.faces = {{{{0, 1, 2}}, true}, {{{0, 2, 3}}, true}, {{{0, 3, 1}}, true}, {{{1, 3, 2}}, true}};
  return model;
}

Model octahedron() {
  Model model;
  model.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t k = 0; k < 8; ++k) {
    const std::uint32_t x = k & 1, y = 2 + (k >> 1 & 1), z = 4 + (k >> 2);
    const bool even = ((k & 1) + (k >> 1 & 1) + (k >> 2)) % 2 == 0;
    model.faces.push_back(
        {{even ? std::vector<std::uint32_t>{x, y, z} : std::vector<std::uint32_t>{x, z, y}}, true});
  }
  return model;
}

Polygon ell() { return {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}; }
Polygon letter_u() { return {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}; }
Polygon plus() {
  return {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
}

Model frame() {
  return prism({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}}, -1, 1);
}
Model ladder() {
  return prism({{0, 0}, {5, 0}, {5, 3}, {0, 3}},
               {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{3, 1}, {3, 2}, {4, 2}, {4, 1}}}, 0, 1);
}

Model placed(Model model, const std::array<Rational, 4>& q, const Rational& scale, const RationalPoint& move) {
  const auto& [w, x, y, z] = q;
  const Rational by = scale / (w * w + x * x + y * y + z * z);
  const std::array<RationalPoint, 3> m = {
      {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
       {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
       {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  for (RationalPoint& p : model.points) {
    RationalPoint to;
    for (int k = 0; k < 3; ++k) to[k] = (m[k][0] * p[0] + m[k][1] * p[1] + m[k][2] * p[2]) * by + move[k];
    p = to;
  }
  return model;
}

Model at(Model model, long x, long y, long z) { return placed(std::move(model), {1, 0, 0, 0}, 1, {x, y, z}); }

Model with_axis(Model model, int k) {
  for (RationalPoint& p : model.points) {
    RationalPoint to;
    for (int c = 0; c < 3; ++c) to[(c + k) % 3] = p[c];
    p = to;
  }
  return model;
}

Model rounded(Model model) {
  for (RationalPoint& p : model.points)
    for (Rational& x : p) x = from_double(to_double(x));
  return model;
}

Model fanned(const Model& model) {
  Model result;
  result.points = model.points;
  for (const Model::Face& face : model.faces)
    for (std::size_t k = 2; k < face.loops[0].size(); ++k)
      result.faces.push_back({{{face.loops[0][0], face.loops[0][k - 1], face.loops[0][k]}}, true});
  return result;
}

Model random_solid(Random& random) {
  Model model;
  switch (random.integer(0, 8)) {
    case 0: model = tetrahedron(); break;
    case 1: model = octahedron(); break;
    case 2: model = box({-1, -1, -1}, {1, 2, 1}); break;
    case 3: model = prism(ell(), {}, 0, 2); break;
    case 4: model = prism(letter_u(), {}, 0, 2); break;
    case 5: model = prism(plus(), {}, -1, 1); break;
    case 6: model = frame(); break;
    case 7: model = ladder(); break;
    default:
      model = prism({{3, 0}, {2, 2}, {0, 3}, {-2, 2}, {-3, 0}, {-2, -2}, {0, -3}, {2, -2}}, {}, -2, 2);
      break;
  }
  std::array<Rational, 4> q;
  do
    for (Rational& x : q) x = random.integer(-9, 9);
  while (q == std::array<Rational, 4>{0, 0, 0, 0});
  RationalPoint move;
  for (Rational& x : move) x = Rational(random.integer(-997, 997), 811);
  for (Rational& x : move) x.canonicalize();
  Rational scale(random.integer(700, 1900), 1009);
  scale.canonicalize();
  return placed(std::move(model), q, scale, move);
}

Model random_grid_solid(Random& random) {
  Model model;
  switch (random.integer(0, 9)) {
    case 8: model = octahedron(); break;
    case 9: model = tetrahedron(); break;
    case 0: model = prism(ell(), {}, 0, random.integer(1, 2)); break;
    case 1: model = prism(letter_u(), {}, 0, random.integer(1, 2)); break;
    case 2: model = prism(plus(), {}, 0, random.integer(1, 3)); break;
    case 3: model = frame(); break;
    case 4:
      model = fanned(box({0, 0, 0}, {random.integer(1, 3), random.integer(1, 3), random.integer(1, 3)}));
      break;
    case 5: model = prism({{0, 0}, {2, 0}, {0, 2}}, {}, 0, random.integer(1, 3)); break;
    default: model = box({0, 0, 0}, {random.integer(1, 3), random.integer(1, 3), random.integer(1, 3)}); break;
  }
  model = with_axis(std::move(model), random.integer(0, 2));
  const std::array<Rational, 4> turns[] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 0, 1},
                                           {0, 1, 0, 0}, {1, 0, 1, 0}, {0, 0, 1, 1}};
  return placed(std::move(model), turns[random.integer(0, 5)], 1,
                {random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2)});
}

}  // namespace cnrg::bench::baseline_test
