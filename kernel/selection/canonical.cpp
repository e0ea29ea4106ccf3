// Points are sorted by coordinates. From there on all is numbers: a cell's key lists the numbers of its points (a
// region's those of its faces), and cells are sorted by their keys, from vertices to regions.
#include "kernel/selection/canonical.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
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

void sort_along(const LeafAxes& axes, const PointTable& table, std::vector<VertexId>& points) {
  std::vector<std::pair<RationalPoint, VertexId>> placed;
  placed.reserve(points.size());
  for (const VertexId v : points) {
    const RationalPoint p = table.rational(v);
    placed.push_back({{dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)}, v});
  }
  std::sort(placed.begin(), placed.end());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = placed[i].second;
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

enum class Inside : std::uint8_t {
  no,    // on the border of the simplified face
  bend,  // between two of its facets
  yes,   // of one
};

// Where an edge on the border of a cell lies in the simplified face.
Inside inside_of(const Complex& complex, const SimplifiedComplex& s, FaceId cell, EdgeId e) {
  if (s.edge_place[e.index()].dimension != 2) return Inside::no;
  const Index face = s.face_place[cell.index()].index;
  for (const FaceUse& use : complex.edge_uses[e]) {
    const SimplifiedComplex::Place place = s.face_place[use.face.index()];
    if (place.dimension == 2 && place.index == face && complex.face_sheet[use.face] != complex.face_sheet[cell])
      return Inside::bend;
  }
  return std::binary_search(s.facet_edges.begin(), s.facet_edges.end(), e) ? Inside::bend : Inside::yes;
}

// The edges between facets that end in a vertex: how many, and where the first two come from.
struct Bends {
  std::uint8_t count = 0;  // 3: or more
  std::array<VertexId, 2> ends{};
  void add(VertexId from) {
    const auto known = ends.begin() + std::min<int>(count, 2);
    if (count < 3 && std::find(ends.begin(), known, from) == known) {
      if (count < 2) ends[count] = from;
      ++count;
    }
  }
};

// By vertex; empty where all faces are flat.
IdVector<VertexId, Bends> bends_of(const Complex& complex, const SimplifiedComplex& s) {
  IdVector<VertexId, Bends> bends;
  for (const auto& face : s.faces) {
    if (is_flat(complex, face)) continue;
    if (bends.empty()) bends.assign(complex.points.size(), {});
    for (const HalfFace cell : face.cells) {
      for (const HalfEdge h : complex.half_edges(cell.face())) {
        if (inside_of(complex, s, cell.face(), h.edge()) != Inside::bend) continue;
        bends[complex.origin(h)].add(complex.target(h));
        bends[complex.target(h)].add(complex.origin(h));
      }
    }
  }
  return bends;
}

// Cells that meet in an edge within a facet are one. Around these a walk goes on in the next cell wherever it
// comes to such an edge.
class FacetMerger {
 public:
  FacetMerger(const Complex& complex, const SimplifiedComplex& s, const SimplifiedComplex::Face& face)
      : complex_(complex), s_(s), face_(face) {}

  std::vector<SimplifiedFacet> run() {
    for (Index k = 0; k < face_.cells.size(); ++k) add_steps(k);
    join_cells();
    std::vector<Index> facet_of(face_.cells.size(), SimplifiedComplex::kNowhere);
    for (Index k = 0; k < face_.cells.size(); ++k) {
      Index& facet = facet_of[root(k)];
      if (facet == SimplifiedComplex::kNowhere) {
        facet = Index(facets_.size());
        facets_.emplace_back();
      }
      facets_[facet].cells.push_back(face_.cells[k]);
    }
    for (Index i = 0; i < steps_.size(); ++i) {
      if (!steps_[i].inside && !steps_[i].walked) facets_[facet_of[root(steps_[i].cell)]].walks.push_back(walk(i));
    }
    if (!face_.isolated.empty()) add_isolated(facet_of);
    return std::move(facets_);
  }

 private:
  // Along an edge with the cell to the left, as seen from the front of the face.
  struct Step {
    HalfEdge h;
    Index cell, next;
    bool inside, walked = false;
  };

  void add_steps(Index k) {
    const HalfFace cell = face_.cells[k];
    for (const LoopId id : complex_.face_loops[cell.face()]) {
      const auto loop = complex_.loop[id];
      const auto first = Index(steps_.size()), n = Index(loop.size());
      for (Index i = 0; i < n; ++i) {
        const HalfEdge h = cell.side() == 0 ? loop[i] : loop[n - 1 - i].twin();
        const bool inside = inside_of(complex_, s_, cell.face(), h.edge()) == Inside::yes;
        if (inside) inner_.emplace_back(h, first + i);
        steps_.push_back({h, k, first + (i + 1) % n, inside});
      }
    }
  }

  void join_cells() {
    parent_.resize(face_.cells.size());
    std::iota(parent_.begin(), parent_.end(), Index{0});
    std::sort(inner_.begin(), inner_.end());
    for (const auto& [h, i] : inner_) {
      const Index a = root(steps_[i].cell), b = root(steps_[other_side(h)].cell);
      parent_[std::max(a, b)] = std::min(a, b);
    }
  }

  Index root(Index k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }

  Index other_side(HalfEdge h) const {
    const auto found = std::lower_bound(inner_.begin(), inner_.end(), std::pair(h.twin(), Index{0}));
    require(found != inner_.end() && found->first == h.twin(), "an edge within a facet has one side only");
    return found->second;
  }

  std::vector<HalfEdge> walk(Index first) {
    std::vector<HalfEdge> out;
    Index i = first;
    do {
      steps_[i].walked = true;
      out.push_back(steps_[i].h);
      i = steps_[i].next;
      while (steps_[i].inside) i = steps_[other_side(steps_[i].h)].next;
    } while (i != first);
    return out;
  }

  // A vertex of the result that no walk passes is in the interior of the facet of any cell around it.
  void add_isolated(const std::vector<Index>& facet_of) {
    std::vector<VertexId> passed;
    for (const SimplifiedFacet& facet : facets_) {
      for (const auto& walk : facet.walks) {
        for (const HalfEdge h : walk) passed.push_back(complex_.origin(h));
      }
    }
    sort_unique(passed);
    const auto add = [&](VertexId v, Index k) {
      if (s_.vertex_place[v.index()].dimension == 0 && !std::binary_search(passed.begin(), passed.end(), v))
        facets_[facet_of[root(k)]].isolated.push_back(v);
    };
    for (const Step& step : steps_) add(complex_.origin(step.h), step.cell);
    for (Index k = 0; k < face_.cells.size(); ++k) {
      for (const VertexId v : complex_.face_vertices[face_.cells[k].face()]) add(v, k);
    }
    for (SimplifiedFacet& facet : facets_) sort_unique(facet.isolated);
  }

  const Complex& complex_;
  const SimplifiedComplex& s_;
  const SimplifiedComplex::Face& face_;
  std::vector<Step> steps_;
  std::vector<std::pair<HalfEdge, Index>> inner_;  // sorted
  std::vector<Index> parent_;                      // of cells
  std::vector<SimplifiedFacet> facets_;
};

class Ordering {
 public:
  Ordering(const Complex& complex, SimplifiedComplex& s, const LeafAxes* axes)
      : complex_(complex), s_(s), points_(complex, s, axes) {}

  CanonicalPoints run() {
    std::array<std::vector<Index>, 4> maps;
    maps[0] = order_by(vertex_keys(), s_.vertices);
    maps[1] = order_by(edge_keys(), s_.edges);
    maps[2] = order_by(face_keys(), s_.faces);
    std::vector<std::vector<Index>*> shell_of(2 * s_.faces.size(), nullptr);  // by side
    for (auto& region : s_.regions) {
      for (auto& shell : region.shells) {
        for (const Index side : shell) shell_of[maps[2][side / 2] * 2 + side % 2] = &shell;
        shell.clear();
      }
    }
    for (Index side = 0; side < shell_of.size(); ++side) {
      if (shell_of[side] != nullptr) shell_of[side]->push_back(side);
    }
    for (auto& region : s_.regions) std::sort(region.shells.begin(), region.shells.end());
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
        for (const HalfEdge h : complex_.half_edges(cell.face())) add(complex_.origin(h), numbers);
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
      if (region.shells.size() > 1) std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
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

std::vector<SimplifiedFacet> facets_of(const Complex& complex, const SimplifiedComplex& simplified,
                                       std::uint32_t face) {
  return FacetMerger(complex, simplified, simplified.faces[face]).run();
}

CanonicalPoints::CanonicalPoints(const Complex& complex, const SimplifiedComplex& s, const LeafAxes* axes)
    : number_(complex.points.size(), kNone) {
  const IdVector<VertexId, Bends> bends = bends_of(complex, s);
  std::vector<char> dropped(complex.points.size(), 0);
  for (const auto& edge : s.edges) {
    if (edge.chain.size() < 2) continue;
    const auto v = chain_vertices(complex, edge);
    const std::size_t n = v.size(), ends = edge.closed ? 0 : 1;
    for (std::size_t k = ends; k + ends < n; ++k) {
      if (!bends.empty() && bends[v[k]].count > 0) continue;
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
  }
  for (const VertexId v : IdRange<VertexId>(bends.size())) {
    const auto& [count, ends] = bends[v];
    if (count > 2 || (count == 2 && !collinear(complex.points, ends[0], v, ends[1]))) use(v);
  }
  if (axes != nullptr) sort_along(*axes, complex.points, points_);
  else sort_by_coordinates(complex.points, points_);
  number();
}

CanonicalPoints::CanonicalPoints(const Complex& complex, std::vector<VertexId> points)
    : points_(std::move(points)), number_(complex.points.size(), kNone) {
  number();
}

void CanonicalPoints::number() {
  for (Index i = 0; i < points_.size(); ++i) number_[points_[i]] = i;
}

CanonicalPoints put_in_order(const Complex& complex, SimplifiedComplex& simplified, const LeafAxes* axes) {
  CanonicalPoints points = Ordering(complex, simplified, axes).run();
  simplified.points = axes == nullptr ? points.points() : std::vector<VertexId>();
  return points;
}

}  // namespace cnrg
