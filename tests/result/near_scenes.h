// Random results of boxes, sheets, wires and points: for what is near in them and how it is joined.
#pragma once

#include <random>

#include "tests/formats/cases.h"

namespace cnrg::test {

/// Whole numbers below `n`, in every run and on every system the same.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  int operator()(int n) { return int(random_() % std::uint64_t(n)); }
  /// From -1 to 1 in steps of 1/64.
  Rational unit() {
    Rational r(operator()(129) - 64, 64);
    r.canonicalize();
    return r;
  }

 private:
  std::mt19937_64 random_;
};

/// A leaf with corners on a lattice.
struct LatticeLeaf {
  enum class Kind { box, rectangle, wire, point, triangle, tetrahedron } kind = Kind::box;
  std::vector<std::array<int, 3>> corners;  ///< of a box and a rectangle two
};

inline std::string to_text(const std::vector<LatticeLeaf>& scene) {
  const char* const names[] = {"box", "rectangle", "wire", "point", "triangle", "tetrahedron"};
  std::string text;
  for (const LatticeLeaf& leaf : scene) {
    text += names[int(leaf.kind)];
    for (const auto& c : leaf.corners)
      text += " (" + std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]) + ")";
    text += "\n";
  }
  return text;
}

/// `oblique`: with triangles, tetrahedra and wires in any direction; else all is along the axes.
inline std::vector<LatticeLeaf> lattice_scene(Dice& dice, int size, bool oblique) {
  using Kind = LatticeLeaf::Kind;
  std::vector<LatticeLeaf> out;
  const int n = 2 + dice(4);
  const auto corner = [&] { return std::array{dice(size), dice(size), dice(size)}; };
  while (int(out.size()) < n) {
    const Kind kinds[] = {Kind::box,   Kind::box,      Kind::rectangle,  Kind::wire,
                          Kind::point, Kind::triangle, Kind::tetrahedron};
    LatticeLeaf leaf{kinds[out.empty() ? 0 : dice(oblique ? 7 : 5)], {}};  // one box at least
    const auto distinct = [&](int count) {
      do {
        leaf.corners.clear();
        for (int i = 0; i < count; ++i) leaf.corners.push_back(corner());
        // no two equal
      } while ([&] {
        auto sorted = leaf.corners;
        std::sort(sorted.begin(), sorted.end());
        return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
      }());
    };
    const auto boxed = [&](int flat) {
      std::array<int, 3> low, high;
      for (int k = 0; k < 3; ++k) {
        do {
          low[k] = dice(size), high[k] = dice(size);
          if (low[k] > high[k]) std::swap(low[k], high[k]);
        } while (k != flat && low[k] == high[k]);
        if (k == flat) high[k] = low[k];
      }
      leaf.corners = {low, high};
    };
    const auto determinant = [&] {
      const auto& c = leaf.corners;
      int m[3][3];
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) m[i][k] = c[i + 1][k] - c[0][k];
      return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    const auto flat = [&] {  // a triangle without area
      const auto& c = leaf.corners;
      std::array<int, 3> u, v;
      for (int k = 0; k < 3; ++k) u[k] = c[1][k] - c[0][k], v[k] = c[2][k] - c[0][k];
      return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
    };
    switch (leaf.kind) {
      case Kind::box: boxed(-1); break;
      case Kind::rectangle: boxed(dice(3)); break;
      case Kind::point: leaf.corners = {corner()}; break;
      case Kind::wire:
        distinct(2);
        if (!oblique) {  // along one axis
          const int axis = dice(3);
          leaf.corners[1] = leaf.corners[0];
          leaf.corners[1][axis] = (leaf.corners[0][axis] + 1 + dice(size - 1)) % size;
        }
        break;
      case Kind::triangle:
        do distinct(3);
        while (flat());
        break;
      case Kind::tetrahedron:
        do distinct(4);
        while (determinant() == 0);
        if (determinant() < 0) std::swap(leaf.corners[2], leaf.corners[3]);
        break;
    }
    out.push_back(std::move(leaf));
  }
  // First what has no thickness: where the first one dominates, solids would swallow it or not, as the jitter has
  // it.
  const auto solid = [](const LatticeLeaf& leaf) {
    return leaf.kind == Kind::box || leaf.kind == Kind::tetrahedron;
  };
  std::stable_partition(out.begin(), out.end(), [&](const LatticeLeaf& leaf) { return !solid(leaf); });
  return out;
}

/// The union of the leaves, each coordinate off by `jitter` at most; planes of boxes and rectangles stay planes.
inline Case lattice_case(const std::vector<LatticeLeaf>& scene, Dice dice, const Rational& jitter) {
  using Kind = LatticeLeaf::Kind;
  Soup soup;
  Names names;
  const auto off = [&](const std::array<int, 3>& c) {
    RationalPoint p;
    for (int k = 0; k < 3; ++k) p[k] = c[k] + jitter * dice.unit();
    return p;
  };
  for (const LatticeLeaf& leaf : scene) {
    const std::string name = "n" + std::to_string(names.size());
    names.push_back({});
    std::vector<RationalPoint> p;
    for (const auto& c : leaf.corners) p.push_back(off(c));
    switch (leaf.kind) {
      case Kind::box: add_box(soup, p[0], p[1]); break;
      case Kind::rectangle: {
        int flat = 0;
        while (leaf.corners[0][flat] != leaf.corners[1][flat]) ++flat;
        const int u = (flat + 1) % 3, v = (flat + 2) % 3;
        std::vector<RationalPoint> loop(4, p[0]);
        loop[1][u] = loop[2][u] = p[1][u];
        loop[2][v] = loop[3][v] = p[1][v];
        add_sheet(soup, loop);
        break;
      }
      case Kind::wire: add_wire(soup, p[0], p[1]); break;
      case Kind::point: add_point(soup, p[0]); break;
      case Kind::triangle: add_sheet(soup, p); break;
      case Kind::tetrahedron: {
        const LeafId id = soup.add_leaf(Fill::winding);
        PointId at[4];
        for (int i = 0; i < 4; ++i) at[i] = soup.add_point(p[i]);
        const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        for (std::uint32_t f = 0; f < 4; ++f)
          soup.add_triangle(id, at[faces[f][0]], at[faces[f][1]], at[faces[f][2]], f, f);
        break;
      }
    }
    if (leaf.kind == Kind::box || leaf.kind == Kind::tetrahedron) names.back() = {{name, "m" + name, {}}};
  }
  Case c(soup, names);
  c.show(c.unite(Dominance::left));
  return c;
}

}  // namespace cnrg::test
