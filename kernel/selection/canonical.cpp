// Points are sorted by coordinates. From there on all is numbers: a cell's key lists the numbers of its points (a
// region's those of its faces), and cells are sorted by their keys, from vertices to regions.
#include "kernel/selection/canonical.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Numbers = ShortList<Index, 4>;

// The beginning of a key as one number: where it differs, it orders as the key does.
std::uint64_t head(Index key) { return key; }
template <class List>
requires requires(const List& list) { list.begin(); }
std::uint64_t head(const List& key) {
  const auto at = [&](std::size_t i) { return i < key.size() ? key[i] + std::uint64_t{1} : 0; };
  return at(0) << 32 | at(1);
}
std::uint64_t head(const auto& key) { return head(std::get<0>(key)); }

// Moves the items into the order of their keys, equal ones as they were; returns for each old index the new one.
template <class Key, class T>
std::vector<Index> order_by(const std::vector<Key>& keys, std::vector<T>& items) {
  std::vector<std::pair<std::uint64_t, Index>> order(items.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = {head(keys[i]), i};
  tbb::parallel_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    if (keys[a.second] < keys[b.second]) return true;
    return a.second < b.second && !(keys[b.second] < keys[a.second]);
  });
  std::vector<Index> map(items.size());
  std::vector<T> sorted;
  sorted.reserve(items.size());
  for (Index i = 0; i < order.size(); ++i) {
    map[order[i].second] = i;
    sorted.push_back(std::move(items[order[i].second]));
  }
  items = std::move(sorted);
  return map;
}

// From end to end; those of a closed chain once.
void for_each_vertex(const Complex& complex, const SimplifiedComplex::Edge& edge, auto visit) {
  for (const HalfEdge h : edge.chain) visit(complex.origin(h));
  if (!edge.closed) visit(complex.target(edge.chain.back()));
}

// The order of coordinates; most points differ in x as doubles.
void sort_by_coordinates(const PointTable& table, std::vector<VertexId>& points) {
  struct Bounds {
    double low, high;
    VertexId v;
  };
  std::vector<Bounds> bounds(points.size());
  for_each_index(points.size(), [&](std::size_t i) {
    const PointView view = table.view(points[i]);
    bounds[i] = {view.lo[0], view.hi[0], points[i]};
  });
  tbb::parallel_sort(bounds.begin(), bounds.end(), [&](const Bounds& a, const Bounds& b) {
    if (a.high < b.low) return true;
    if (b.high < a.low) return false;
    return compare_lex(table, a.v, b.v) < 0;
  });
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = bounds[i].v;
}

class Ordering {
 public:
  Ordering(const Complex& complex, SimplifiedComplex& s) : complex_(complex), s_(s), points_(complex, s) {}

  CanonicalPoints run() {
    std::array<std::vector<Index>, 4> maps;
    maps[0] = order_by(vertex_keys(), s_.vertices);
    maps[1] = order_by(edge_keys(), s_.edges);
    maps[2] = order_by(face_keys(), s_.faces);
    for (SimplifiedComplex::Region& region : s_.regions) {
      for (auto& shell : region.shells) {
        for (Index& side : shell) side = maps[2][side / 2] * 2 + side % 2;
        tbb::parallel_sort(shell.begin(), shell.end());
      }
      std::sort(region.shells.begin(), region.shells.end());
    }
    maps[3] = order_by(region_keys(), s_.regions);
    for (SimplifiedComplex::Face& face : s_.faces) {
      for (Index& region : face.regions) {
        if (region != SimplifiedComplex::kNowhere) region = maps[3][region];
      }
    }
    for (auto* places : {&s_.vertex_place, &s_.edge_place, &s_.face_place, &s_.region_place}) {
      for_each_of(*places, [&](SimplifiedComplex::Place& place) {
        if (place.index != SimplifiedComplex::kNowhere)
          place.index = maps[static_cast<std::size_t>(place.dimension)][place.index];
      });
    }
    s_.in_order = true;
    return std::move(points_);
  }

 private:
  void add(VertexId v, auto& out) const {
    if (points_.number(v) != CanonicalPoints::kNone) out.push_back(points_.number(v));
  }

  std::vector<Index> vertex_keys() const {
    std::vector<Index> keys;
    keys.reserve(s_.vertices.size());
    for (const auto& vertex : s_.vertices) keys.push_back(points_.number(vertex.cell));
    return keys;
  }

  // The points from the smaller end, or around from the smallest one.
  std::vector<Numbers> edge_keys() const {
    std::vector<Numbers> keys(s_.edges.size());
    for_each_index(keys.size(), [&](std::size_t i) {
      const auto& edge = s_.edges[i];
      Numbers& key = keys[i];
      for_each_vertex(complex_, edge, [&](VertexId v) { add(v, key); });
      if (edge.closed && !key.empty()) {
        std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
        if (key.size() > 2 && key.back() < key[1]) std::reverse(key.begin() + 1, key.end());
      } else if (std::lexicographical_compare(std::make_reverse_iterator(key.end()),
                                              std::make_reverse_iterator(key.begin()), key.begin(), key.end())) {
        std::reverse(key.begin(), key.end());
      }
    });
    return keys;
  }

  std::vector<std::pair<Numbers, Numbers>> face_keys() const {
    std::vector<std::pair<Numbers, Numbers>> keys(s_.faces.size());
    for_each_index(keys.size(), [&](std::size_t i) {
      const auto& face = s_.faces[i];
      auto& [boundary, inside] = keys[i];
      for (const auto& loop : face.loops) {
        for (const HalfEdge h : loop) add(complex_.origin(h), boundary);
      }
      std::sort(boundary.begin(), boundary.end());
      if (is_flat(complex_, face)) return;
      std::vector<Index> numbers;
      for (const HalfFace cell : face.cells) {
        for (const auto& walk : facet_walks(complex_, s_, cell.face())) {
          for (const VertexId v : walk) add(v, numbers);
        }
      }
      sort_unique(numbers);
      inside = Numbers(numbers.begin(), numbers.end());
    });
    return keys;
  }

  std::vector<std::tuple<std::vector<Index>, bool, Component>> region_keys() const {
    std::vector<std::tuple<std::vector<Index>, bool, Component>> keys;
    for (const auto& region : s_.regions) {
      auto& [faces, unbounded, component] = keys.emplace_back();
      for (const auto& shell : region.shells) {
        for (const Index side : shell) faces.push_back(side / 2);
      }
      sort_unique(faces);
      unbounded = !region.bounded;
      component = region.component;
    }
    return keys;
  }

  const Complex& complex_;
  SimplifiedComplex& s_;
  CanonicalPoints points_;
};

}  // namespace

bool is_flat(const Complex& complex, const SimplifiedComplex::Face& face) {
  const SheetId sheet = complex.face_sheet[face.cells[0].face()];
  return std::all_of(face.cells.begin(), face.cells.end(),
                     [&](HalfFace f) { return complex.face_sheet[f.face()] == sheet; });
}

std::vector<VertexId> chain_vertices(const Complex& complex, const SimplifiedComplex::Edge& edge) {
  std::vector<VertexId> out;
  for_each_vertex(complex, edge, [&](VertexId v) { out.push_back(v); });
  return out;
}

std::vector<std::vector<VertexId>> facet_walks(const Complex& complex, const SimplifiedComplex& simplified,
                                               FaceId f) {
  std::vector<std::vector<VertexId>> walks;
  std::vector<EdgeId> vanished, slits;
  for (const LoopId id : complex.face_loops[f]) {
    vanished.clear(), slits.clear();
    for (const HalfEdge h : complex.loop[id]) {
      if (simplified.edge_place[h.edge().index()].dimension != 1) vanished.push_back(h.edge());
    }
    std::sort(vanished.begin(), vanished.end());
    for (std::size_t i = 1; i < vanished.size(); ++i) {
      if (vanished[i] == vanished[i - 1]) slits.push_back(vanished[i]);
    }
    std::vector<std::pair<EdgeId, std::vector<VertexId>>> open(1);
    const auto close = [&] {
      if (!open.back().second.empty()) walks.push_back(std::move(open.back().second));
      open.pop_back();
    };
    for (const HalfEdge h : complex.loop[id]) {
      if (!std::binary_search(slits.begin(), slits.end(), h.edge())) {
        open.back().second.push_back(complex.origin(h));
      } else if (open.size() > 1 && open.back().first == h.edge()) {
        close();
      } else {
        open.push_back({h.edge(), {}});
      }
    }
    while (!open.empty()) close();
  }
  return walks;
}

CanonicalPoints::CanonicalPoints(const Complex& complex, const SimplifiedComplex& s)
    : number_(complex.points.size(), kNone) {
  std::vector<char> by_curved(s.edges.size(), 0), dropped(complex.points.size(), 0);
  for (const auto& face : s.faces) {
    if (is_flat(complex, face)) continue;
    for (const auto& loop : face.loops) {
      for (const HalfEdge h : loop) {
        const SimplifiedComplex::Place place = s.edge_place[h.edge().index()];
        if (place.dimension == 1) by_curved[place.index] = 1;  // the others are on the frame
      }
    }
  }
  for (std::size_t i = 0; i < s.edges.size(); ++i) {
    const auto& edge = s.edges[i];
    if (by_curved[i] || edge.chain.size() < 2) continue;
    const auto v = chain_vertices(complex, edge);
    const std::size_t n = v.size(), ends = edge.closed ? 0 : 1;
    for (std::size_t k = ends; k + ends < n; ++k) {
      if (collinear(complex.points, v[(k + n - 1) % n], v[k], v[(k + 1) % n])) dropped[v[k].index()] = 1;
    }
  }
  for (const auto& vertex : s.vertices) dropped[vertex.cell.index()] = 0;

  const auto use = [&](VertexId v) {
    if (dropped[v.index()] || number_[v] == 0) return;
    number_[v] = 0;
    points_.push_back(v);
  };
  for (const auto& vertex : s.vertices) use(vertex.cell);
  for (const auto& edge : s.edges) {
    for_each_vertex(complex, edge, use);
  }
  for (const auto& face : s.faces) {
    for (const VertexId v : face.isolated) use(v);
    for (const auto& loop : face.loops) {
      for (const HalfEdge h : loop) use(complex.origin(h));
    }
    if (is_flat(complex, face)) continue;
    for (const HalfFace cell : face.cells) {
      for (const auto& walk : facet_walks(complex, s, cell.face())) {
        for (const VertexId v : walk) use(v);
      }
    }
  }
  sort_by_coordinates(complex.points, points_);
  for (Index i = 0; i < points_.size(); ++i) number_[points_[i]] = i;
}

CanonicalPoints put_in_order(const Complex& complex, SimplifiedComplex& simplified) {
  return Ordering(complex, simplified).run();
}

}  // namespace cnrg
