#include "tests/oracles/betti.h"

#include <algorithm>

#include "kernel/base/union_find.h"
#include "tests/operators/pieces.h"
#include "tests/oracles/elimination.h"

namespace cnrg::elimination {

using namespace pieces;

namespace {

CellSet random_cells(const Complex& complex, scenes::Random& random, int percent) {
  const CellSet all = all_cells(complex);
  CellSet out;
  const auto pick = [&](const auto& from, auto& to) {
    for (auto c : from) {
      if (random.below(100) < percent) to.push_back(c);
    }
  };
  pick(all.vertices, out.vertices), pick(all.edges, out.edges);
  pick(all.faces, out.faces), pick(all.regions, out.regions);
  return out;
}

}  // namespace

CellSet random_set(const Complex& complex, scenes::Random& random) {
  CellSet set = random_cells(complex, random, 10 + random.below(81));
  switch (random.below(6)) {
    case 0: return closure(complex, set);
    case 1: return interior(complex, star(complex, set));
    case 2: return boundary(complex, set);
    case 3: return subtract(all_cells(complex), set);
    default: return set;
  }
}

long complement_pieces(const Complex& complex, const CellSet& set) {
  const std::size_t edges = complex.points.size(), faces = edges + complex.edge_count();
  const std::size_t regions = faces + complex.face_count(), infinity = regions + complex.region_count;
  std::vector<char> out(infinity + 1, 1);
  for (std::size_t p = 0; p < complex.points.size(); ++p) out[p] = 0;  // not every point is a vertex
  for (VertexId v : complex.vertices) out[v.index()] = 1;
  for (VertexId v : set.vertices) out[v.index()] = 0;
  for (EdgeId e : set.edges) out[edges + e.index()] = 0;
  for (FaceId f : set.faces) out[faces + f.index()] = 0;
  for (RegionId r : set.regions) out[regions + r.index()] = 0;
  UnionFind sets(out.size());
  const auto join = [&](std::size_t a, std::size_t b) {
    if (out[a] && out[b]) sets.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  };
  std::vector<FaceId> f;
  std::vector<RegionId> r;
  for (VertexId v : complex.vertices) {
    complex.star_faces(v, f), complex.star_regions(v, r);
    for (EdgeId e : complex.vertex_edges[v]) join(v.index(), edges + e.index());
    for (FaceId x : f) join(v.index(), faces + x.index());
    for (RegionId x : r) join(v.index(), regions + x.index());
  }
  for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    complex.star_faces(e, f), complex.star_regions(e, r);
    for (FaceId x : f) join(edges + e.index(), faces + x.index());
    for (RegionId x : r) join(edges + e.index(), regions + x.index());
  }
  for (FaceId x : IdRange<FaceId>(complex.face_count())) {
    for (RegionId y : complex.face_regions[x]) join(faces + x.index(), regions + y.index());
  }
  join(infinity, regions);
  long count = 0;
  for (std::size_t i = 0; i < out.size(); ++i) count += out[i] && sets.find(static_cast<std::uint32_t>(i)) == i;
  return count;
}

/// The set as cells of a grid: coordinates 1 .. 2n - 1, odd ones are open unit intervals.
Numbers eliminate(const Complex& complex, const CellSet& set, int n, Numbers& over_q) {
  const Locator locator(complex);
  const auto has = [&](const Location& at) {
    const auto in = [](const auto& list, auto id) { return std::binary_search(list.begin(), list.end(), id); };
    switch (at.dimension) {
      case 0: return in(set.vertices, at.vertex);
      case 1: return in(set.edges, at.edge);
      case 2: return in(set.faces, at.face);
      default: return in(set.regions, at.region);
    }
  };
  const int m = 2 * n + 1;
  std::vector<std::uint32_t> number(static_cast<std::size_t>(m * m * m), 0);  // 1 + place
  std::vector<std::array<int, 3>> cells;
  const auto at = [&](const std::array<int, 3>& c) -> std::uint32_t& {
    return number[static_cast<std::size_t>(c[0] + m * (c[1] + m * c[2]))];
  };
  std::array<int, 3> c;
  for (c[0] = 1; c[0] < m - 1; ++c[0]) {
    for (c[1] = 1; c[1] < m - 1; ++c[1]) {
      for (c[2] = 1; c[2] < m - 1; ++c[2]) {
        if (!has(locator.locate({Rational(c[0], 2), Rational(c[1], 2), Rational(c[2], 2)}))) continue;
        cells.push_back(c);
        at(c) = static_cast<std::uint32_t>(cells.size());
      }
    }
  }
  std::vector<std::vector<std::uint32_t>> above(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // Even coordinates may stay or grow to either side.
    for (int code = 1; code < 27; ++code) {
      std::array<int, 3> d = cells[i];
      bool possible = true;
      for (int k = 0, rest = code; k < 3; ++k, rest /= 3) {
        const int step = rest % 3 == 2 ? -1 : rest % 3;
        possible = possible && (step == 0 || d[static_cast<std::size_t>(k)] % 2 == 0);
        d[static_cast<std::size_t>(k)] += step;
      }
      if (possible && at(d) != 0) above[i].push_back(at(d) - 1);
    }
    std::sort(above[i].begin(), above[i].end());
  }
  const auto simplices = elimination::order_complex(above);
  over_q = elimination::betti<elimination::Fraction>(simplices);
  return elimination::betti<elimination::Bit>(simplices);
}

std::shared_ptr<const Complex> random_grid(scenes::Random& random, int n) {
  const auto coordinate = [&] { return random.between(1, n - 1); };
  const auto at = [&] { return Point{coordinate(), coordinate(), coordinate()}; };
  std::vector<Piece> leaves(1);
  for (int i = random.below(9); i > 0; --i) {
    Point low = at(), high = at();
    const auto axis = static_cast<std::size_t>(random.below(3));
    for (std::size_t k = 0; k < 3; ++k) {
      if (low[k] > high[k]) std::swap(low[k], high[k]);
      if (low[k] == high[k]) high[k] < n - 1 ? ++high[k] : --low[k];
    }
    if (random.one_in(3)) {
      for (const Rectangle& r : box(low, high, 0).faces) leaves.push_back({{r}, {}, {}});
      continue;
    }
    high[axis] = low[axis];
    leaves.push_back(sheet(low, high));
  }
  for (int i = random.below(6); i > 0; --i) {
    const Point a = at();
    Point b = a;
    const auto axis = static_cast<std::size_t>(random.below(3));
    b[axis] = random.between(1, n - 1);
    if (a != b) leaves.push_back(wire(a, b));
  }
  for (int i = random.below(4); i > 0; --i) leaves.push_back(point(at()));
  return complex_of(leaves);
}

}  // namespace cnrg::elimination
