#include "bench/cases/shapes.h"

#include <cmath>
#include <map>

#include "bench/cases/random.h"

namespace cnrg::bench {
namespace {

/// Points of an integer lattice, each once.
class LatticePoints {
 public:
  std::uint32_t number(const std::array<int, 3>& p) {
    return numbers_.try_emplace(p, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }
  std::vector<std::array<double, 3>> points() const {
    std::vector<std::array<double, 3>> points(numbers_.size());
    for (const auto& [p, number] : numbers_) {
      for (int k = 0; k < 3; ++k) points[number][k] = p[k];
    }
    return points;
  }

 private:
  std::map<std::array<int, 3>, std::uint32_t> numbers_;
};

/// The octahedron |x| + |y| + |z| = k, each side cut into k^2 triangles; the lower half may be left out.
TriangleMesh octahedron(int k, bool lower_half) {
  TriangleMesh mesh;
  LatticePoints lattice;
  const auto side = [&](int sx, int sy, int sz) {
    const auto at = [&](int a, int b) { return lattice.number({sx * a, sy * b, sz * (k - a - b)}); };
    const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      if (sx * sy * sz > 0) mesh.triangles.push_back({p, q, r});
      else mesh.triangles.push_back({p, r, q});
    };
    for (int a = 0; a < k; ++a) {
      for (int b = 0; a + b < k; ++b) {
        add(at(a, b), at(a + 1, b), at(a, b + 1));
        if (a + b + 2 <= k) add(at(a + 1, b), at(a + 1, b + 1), at(a, b + 1));
      }
    }
  };
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      side(sx, sy, 1);
      if (lower_half) side(sx, sy, -1);
    }
  }
  mesh.points = lattice.points();
  return mesh;
}

void scale_to(std::array<double, 3>& p, double radius) {
  const double factor = radius / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  for (double& x : p) x *= factor;
}

}  // namespace

TriangleMesh bumpy_sphere(std::size_t triangles, unsigned seed) {
  struct Wave {
    double x, y, z, phase;
  };
  Random random(seed);
  std::array<Wave, 5> waves;
  for (Wave& w : waves) w = {random.real(-6, 6), random.real(-6, 6), random.real(-6, 6), random.real(0, 6)};
  const int k = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 8))));
  TriangleMesh mesh = octahedron(k, true);
  for (auto& p : mesh.points) {
    scale_to(p, 1);
    double radius = 1;
    for (const Wave& w : waves) radius += 0.03 * std::sin(w.x * p[0] + w.y * p[1] + w.z * p[2] + w.phase);
    scale_to(p, radius);
  }
  return turned_at_random(mesh, seed + 1, {0, 0, 0});
}

TriangleMesh ringed_sphere(unsigned seed) {
  constexpr int kMeridians = 32, kRings = 16;
  TriangleMesh mesh;
  for (int r = 0; r < kRings; ++r) {
    const double polar = M_PI * (r + 0.5) / kRings;
    for (int m = 0; m < kMeridians; ++m) {
      const double around = 2 * M_PI * m / kMeridians;
      mesh.points.push_back(
          {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)});
    }
  }
  const auto at = [](int r, int m) { return static_cast<std::uint32_t>(r * kMeridians + m % kMeridians); };
  for (int r = 0; r + 1 < kRings; ++r) {
    for (int m = 0; m < kMeridians; ++m) {
      mesh.triangles.push_back({at(r, m), at(r + 1, m), at(r + 1, m + 1)});
      mesh.triangles.push_back({at(r, m), at(r + 1, m + 1), at(r, m + 1)});
    }
  }
  for (int m = 1; m + 1 < kMeridians; ++m) {
    mesh.triangles.push_back({at(0, 0), at(0, m), at(0, m + 1)});
    mesh.triangles.push_back({at(kRings - 1, 0), at(kRings - 1, m + 1), at(kRings - 1, m)});
  }
  return turned_at_random(mesh, seed, {0, 0, 0});
}

TriangleMesh dome(std::size_t k) {
  TriangleMesh mesh = octahedron(static_cast<int>(k), false);
  std::map<std::uint32_t, std::uint32_t> next;  // along the rim, clockwise as seen from above
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [side, count] : uses) {
    if (!uses.contains({side.second, side.first})) next[side.second] = side.first;
  }
  for (auto& p : mesh.points) scale_to(p, 1);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) mesh.faces.push_back(static_cast<std::uint32_t>(f));
  const auto base = static_cast<std::uint32_t>(mesh.triangles.size());
  const auto centre = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({0, 0, 0});
  for (const auto& [a, b] : next) {
    mesh.triangles.push_back({centre, a, b});
    mesh.faces.push_back(base);
  }
  return mesh;
}

TriangleMesh box_mesh(const IntegerBox& box) {
  TriangleMesh mesh = tiled_cube(1);
  for (auto& p : mesh.points) {
    for (int k = 0; k < 3; ++k) p[k] = p[k] == 0 ? box.min[k] : box.max[k];
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 2) {  // the two of a side share their first corner
    const auto &t = mesh.triangles[i], &u = mesh.triangles[i + 1];
    if (t[2] == u[1]) mesh.polygons.push_back({t[0], t[1], t[2], u[2]});
    else mesh.polygons.push_back({t[0], u[1], t[1], t[2]});
  }
  return mesh;
}

TriangleMesh prism_mesh(const std::vector<std::array<int, 2>>& base, int low, int high) {
  const auto n = static_cast<std::uint32_t>(base.size());
  TriangleMesh mesh;
  for (const int z : {low, high})
    for (const auto& [x, y] : base) mesh.points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  std::vector<std::vector<std::uint32_t>> polygons(2);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    polygons[0].push_back(n - 1 - i);
    polygons[1].push_back(n + i);
    polygons.push_back({i, next, n + next, n + i});
  }
  for (const std::vector<std::uint32_t>& p : polygons)
    for (std::size_t k = 2; k < p.size(); ++k) mesh.triangles.push_back({p[0], p[k - 1], p[k]});
  return mesh;
}

TriangleMesh tiled_cube(int n) {
  TriangleMesh mesh;
  LatticePoints lattice;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int end : {0, n}) {
      const auto at = [&](int i, int j) {
        std::array<int, 3> p{};
        p[axis] = end;
        p[(axis + 1) % 3] = i;
        p[(axis + 2) % 3] = j;
        return lattice.number(p);
      };
      const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (end == n) mesh.triangles.push_back({a, b, c});
        else mesh.triangles.push_back({a, c, b});
        mesh.faces.push_back(static_cast<std::uint32_t>(2 * axis + (end == n ? 1 : 0)));
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
          add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
    }
  }
  mesh.points = lattice.points();
  return mesh;
}

}  // namespace cnrg::bench
