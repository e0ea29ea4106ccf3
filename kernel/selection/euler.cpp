// Euler-Poincare for closed sets of cells, each term counted on its own where incidence can tell it.
//
// Handles of a volume. Push its boundary a little into it: a closed surface, one piece per cavity and one outside.
// Its Euler characteristic is summed over what it is pushed from: each half-face (1 - rings), each sector between
// two half-faces around an edge (-1), a wire (0), and at each vertex the pieces of the volume's neighbourhood
// there, seen on a small sphere: a piece with k boundary circles counts 2 - k. Circles are found by following
// half-faces around the vertex. Where the faces at a vertex fall into several connected parts, their circles bound
// common pieces; that is told when one region only lies between these parts.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "kernel/base/error.h"
#include "kernel/base/union_find.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using Use = std::uint32_t;  // index into Complex::edge_uses.values()

long rings(const Complex& complex, FaceId f) {
  return static_cast<long>(complex.face_loops[f].size() - 1 + complex.face_vertices[f].size());
}

// The cells of all dimensions as 0 .. n-1, for union-find.
struct Numbering {
  explicit Numbering(const Complex& c)
      : edges(c.points.size()), faces(edges + c.edge_count()), regions(faces + c.face_count()),
        size(regions + c.region_count) {}
  std::uint32_t operator()(VertexId v) const { return v.value(); }
  std::uint32_t operator()(EdgeId e) const { return static_cast<std::uint32_t>(edges + e.index()); }
  std::uint32_t operator()(FaceId f) const { return static_cast<std::uint32_t>(faces + f.index()); }
  std::uint32_t operator()(RegionId r) const { return static_cast<std::uint32_t>(regions + r.index()); }
  std::size_t edges, faces, regions, size;
};

// Joins a face (and an edge) with its boundary.
void join_boundary(const Complex& complex, const Numbering& number, FaceId f, UnionFind& sets) {
  for (LoopId l : complex.face_loops[f]) {
    for (HalfEdge h : complex.loop[l]) {
      sets.unite(number(f), number(h.edge()));
      sets.unite(number(f), number(complex.origin(h)));
    }
  }
  for (VertexId v : complex.face_vertices[f]) sets.unite(number(f), number(v));
}
void join_boundary(const Complex& complex, const Numbering& number, EdgeId e, UnionFind& sets) {
  for (VertexId v : complex.edge_ends[e]) sets.unite(number(e), number(v));
}

long count_pieces(const Complex& complex, const CellSet& set) {
  const Numbering number(complex);
  UnionFind sets(number.size);
  for (EdgeId e : set.edges) join_boundary(complex, number, e, sets);
  for (FaceId f : set.faces) join_boundary(complex, number, f, sets);
  for (RegionId r : set.regions) {
    for (HalfFace h : complex.region_faces[r]) sets.unite(number(r), number(h.face()));
    for (EdgeId e : complex.region_wires[r]) sets.unite(number(r), number(e));
    for (VertexId v : complex.region_vertices[r]) sets.unite(number(r), number(v));
  }
  long count = 0;
  const auto add = [&](const auto& cells) {
    for (auto cell : cells) count += sets.find(number(cell)) == number(cell);
  };
  add(set.vertices), add(set.edges), add(set.faces), add(set.regions);
  return count;
}

// Bounded pieces of the complement of faces and regions: 3-cells joined across faces that are not in the set.
long count_cavities(const Complex& complex, const CellSet& set) {
  Marks<RegionId> held(complex.region_count);
  Marks<FaceId> wall(complex.face_count());
  for (RegionId r : set.regions) held[r] = 1;
  for (FaceId f : set.faces) wall[f] = 1;
  UnionFind sets(complex.region_count);
  for (FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto& [front, back] = complex.face_regions[f];
    if (!wall[f] && !held[front] && !held[back]) sets.unite(front.value(), back.value());
  }
  long count = 0;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    count += !held[r] && sets.find(r.value()) == r.value();
  }
  return count - 1;
}

long boundary_pieces(const Complex& complex, RegionId r) {
  CellSet boundary;
  for (HalfFace h : complex.region_faces[r]) boundary.faces.push_back(h.face());
  std::sort(boundary.faces.begin(), boundary.faces.end());
  boundary.faces.erase(std::unique(boundary.faces.begin(), boundary.faces.end()), boundary.faces.end());
  const auto wires = complex.region_wires[r];
  const auto vertices = complex.region_vertices[r];
  boundary.edges.assign(wires.begin(), wires.end());
  boundary.vertices.assign(vertices.begin(), vertices.end());
  return count_pieces(complex, closure(complex, boundary));
}

// The surfaces just inside of regions: their Euler characteristics.
class InnerSurfaces {
 public:
  explicit InnerSurfaces(const Complex& complex)
      : complex_(complex), next_(complex.edge_uses.value_count()), previous_(next_.size()) {
    for (FaceId f : IdRange<FaceId>(complex.face_count())) {
      for (LoopId l : complex.face_loops[f]) {
        const auto loop = complex.loop[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const Use u = find(f, loop[i]), w = find(f, loop[(i + 1) % loop.size()]);
          next_[u] = w;
          previous_[w] = u;
        }
      }
    }
  }

  /// The characteristics of the regions' surfaces by region, or false where incidence does not tell.
  bool characteristics(const std::vector<RegionId>& regions, std::vector<long>& out) const {
    Scratch<RegionId, std::uint32_t> place(complex_.region_count);  // 1 + index
    for (std::size_t i = 0; i < regions.size(); ++i) place[regions[i]] = static_cast<std::uint32_t>(i + 1);
    out.assign(regions.size(), 0);
    const auto add = [&](RegionId r, long value) {
      if (place[r] != 0) out[place[r] - 1] += value;
    };
    for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
      for (RegionId r : complex_.face_regions[f]) add(r, 1 - rings(complex_, f));
    }
    for (Use u = 0; u < next_.size(); ++u) add(region(u, ahead(u)), -1);
    bool told = true;
    std::map<RegionId, long> pieces;
    for (VertexId v : complex_.vertices) {
      pieces.clear();
      const bool clear = at_vertex(v, pieces);
      for (const auto& [r, value] : pieces) {
        if (place[r] == 0) continue;
        told = told && clear;
        add(r, value);
      }
    }
    return told;
  }

 private:
  const FaceUse& use(Use u) const { return complex_.edge_uses.values()[u]; }
  RegionId region(Use u, unsigned side) const { return complex_.face_regions[use(u).face][side]; }
  /// The side of the use's face that looks counter-clockwise around its edge.
  unsigned ahead(Use u) const { return use(u).half_edge.direction(); }

  Use find(FaceId f, HalfEdge h) const {
    const Use first = complex_.edge_uses.offsets()[h.edge().index()];
    const Use end = complex_.edge_uses.offsets()[h.edge().index() + 1];
    for (Use u = first; u != end; ++u) {
      if (use(u) == FaceUse{f, h}) return u;
    }
    throw InvariantError("euler: a loop passes an edge that does not know its face");
  }

  // The sum of 2 - k over the pieces at v, by region.
  bool at_vertex(VertexId v, std::map<RegionId, long>& out) const {
    std::vector<Use> uses;
    const auto edges = complex_.vertex_edges[v];
    std::vector<std::uint32_t> part_of_use;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      for (Use u = complex_.edge_uses.offsets()[edges[i].index()];
           u != complex_.edge_uses.offsets()[edges[i].index() + 1]; ++u) {
        uses.push_back(u);
        part_of_use.push_back(i);
      }
    }
    const auto place = [&](Use u) {
      return static_cast<std::uint32_t>(std::lower_bound(uses.begin(), uses.end(), u) - uses.begin());
    };
    UnionFind parts(edges.size()), circles(uses.size() * 2);
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
      const Use other = complex_.target(use(uses[i]).half_edge) == v ? next_[uses[i]] : previous_[uses[i]];
      const std::uint32_t j = place(other);
      parts.unite(part_of_use[i], part_of_use[j]);
      for (unsigned side : {0u, 1u}) circles.unite(2 * i + side, 2 * j + side);
      // The use that follows around the same edge.
      const std::size_t e = edges[part_of_use[i]].index();
      const Use first = complex_.edge_uses.offsets()[e], end = complex_.edge_uses.offsets()[e + 1];
      const Use after = uses[i] + 1 == end ? first : uses[i] + 1;
      circles.unite(2 * i + ahead(uses[i]), 2 * place(after) + 1 - ahead(after));
    }
    // (region, part) of each circle.
    std::vector<std::pair<RegionId, std::uint32_t>> found;
    for (std::uint32_t code = 0; code < circles.size(); ++code) {
      if (circles.find(code) != code) continue;
      found.emplace_back(region(uses[code / 2], code & 1), parts.find(part_of_use[code / 2]));
    }
    std::uint32_t part_count = 0;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      part_count += parts.find(i) == i;
      if (complex_.edge_uses[edges[i]].empty()) found.emplace_back(complex_.some_region(edges[i]), i);
    }
    auto part = static_cast<std::uint32_t>(edges.size());
    for (FaceId f : complex_.vertex_faces[v]) {
      for (RegionId r : complex_.face_regions[f]) found.emplace_back(r, part);
      ++part, ++part_count;
    }
    if (part_count == 0) {
      out[complex_.some_region(v)] = 2;
      return true;
    }
    for (const auto& [r, p] : found) out[r] += 1;
    if (part_count == 1) return true;
    // The pieces between parts: a tree of parts, so that part_count - 1 circles are not the first of their piece.
    std::map<RegionId, std::set<std::uint32_t>> between;
    for (const auto& [r, p] : found) between[r].insert(p);
    std::erase_if(between, [](const auto& entry) { return entry.second.size() < 2; });
    if (between.size() != 1) return false;
    out[between.begin()->first] -= 2 * static_cast<long>(part_count - 1);
    return true;
  }

  const Complex& complex_;
  std::vector<Use> next_, previous_;
};

// d d over the integers: loops closed, each edge met by the half-faces of a region as often either way.
std::string check_boundaries(const Complex& complex, const CellSet& set) {
  for (FaceId f : set.faces) {
    for (LoopId l : complex.face_loops[f]) {
      const auto loop = complex.loop[l];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (complex.target(loop[i]) != complex.origin(loop[(i + 1) % loop.size()])) {
          return "d d != 0 on face " + std::to_string(f.value());
        }
      }
    }
  }
  std::vector<std::pair<EdgeId, int>> boundary;
  for (RegionId r : set.regions) {
    boundary.clear();
    for (HalfFace hf : complex.region_faces[r]) {
      for (LoopId l : complex.face_loops[hf.face()]) {
        for (HalfEdge h : complex.loop[l]) {
          boundary.emplace_back(h.edge(), (h.direction() == 0) == (hf.side() == 0) ? 1 : -1);
        }
      }
    }
    std::sort(boundary.begin(), boundary.end());
    for (std::size_t i = 0; i < boundary.size();) {
      int total = 0;
      std::size_t j = i;
      for (; j < boundary.size() && boundary[j].first == boundary[i].first; ++j) total += boundary[j].second;
      if (total != 0) return "d d != 0 on region " + std::to_string(r.value());
      i = j;
    }
  }
  return "";
}

// The dimension of the kernel of d on faces over Z/2: columns are reduced from the left by their largest edge.
std::size_t count_cycles(const Complex& complex, const std::vector<FaceId>& faces) {
  std::vector<std::vector<EdgeId>> columns;
  Scratch<EdgeId, std::uint32_t> pivot(complex.edge_count());  // 1 + column
  std::size_t cycles = 0;
  std::vector<EdgeId> difference;
  for (FaceId f : faces) {
    std::vector<EdgeId> column;
    for (LoopId l : complex.face_loops[f]) {
      for (HalfEdge h : complex.loop[l]) column.push_back(h.edge());
    }
    std::sort(column.begin(), column.end());
    // An edge that is walked twice is no boundary mod 2.
    std::vector<EdgeId> odd;
    for (EdgeId e : column) {
      if (!odd.empty() && odd.back() == e) odd.pop_back();
      else odd.push_back(e);
    }
    column = std::move(odd);
    while (!column.empty() && pivot[column.back()] != 0) {
      const auto& other = columns[pivot[column.back()] - 1];
      difference.clear();
      std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                    std::back_inserter(difference));
      column.swap(difference);
    }
    if (column.empty()) {
      ++cycles;
      continue;
    }
    columns.push_back(std::move(column));
    pivot[columns.back().back()] = static_cast<std::uint32_t>(columns.size());
  }
  return cycles;
}

}  // namespace

std::optional<EulerTerms> euler_terms(const Complex& complex, const CellSet& set) {
  EulerTerms t;
  t.v = static_cast<long>(set.vertices.size());
  t.e = static_cast<long>(set.edges.size());
  t.f = static_cast<long>(set.faces.size());
  for (FaceId f : set.faces) t.r += rings(complex, f);
  t.volumes = static_cast<long>(set.regions.size());
  t.pieces = count_pieces(complex, set);
  t.cavities = count_cavities(complex, set);
  if (!set.regions.empty()) {
    std::vector<long> characteristic;
    if (!InnerSurfaces(complex).characteristics(set.regions, characteristic)) return std::nullopt;
    for (std::size_t i = 0; i < set.regions.size(); ++i) {
      const long surfaces = boundary_pieces(complex, set.regions[i]);
      t.volume_cavities += surfaces - 1;
      t.volume_holes += surfaces - characteristic[i] / 2;
    }
  }
  t.holes = t.pieces + t.cavities - t.left();
  return t;
}

std::string check_euler(const Complex& complex, const CellSet& set, std::size_t max_faces) {
  if (closure(complex, set) != set) return "the set is not closed";
  std::string out = check_boundaries(complex, set);
  if (!out.empty()) return out;
  // The walls alone: every term is counted on its own, up to the cycles of faces.
  const CellSet walls{set.vertices, set.edges, set.faces, {}};
  const EulerTerms flat = *euler_terms(complex, walls);
  if (flat.holes < 0) return "the walls have " + std::to_string(flat.holes) + " holes";
  if (set.faces.size() <= max_faces) {
    const auto cycles = static_cast<long>(count_cycles(complex, set.faces));
    if (cycles != flat.cavities) {
      return "the faces have " + std::to_string(cycles) + " independent cycles and enclose " +
             std::to_string(flat.cavities) + " cavities";
    }
  }
  const auto full = euler_terms(complex, set);
  if (!full) return "";
  // Filling volumes closes holes of the walls, at most one per handle.
  if (full->volume_holes < 0) return "volumes with a negative number of handles";
  if (full->holes < 0 || full->holes > flat.holes || full->holes < flat.holes - full->volume_holes) {
    return "the volumes leave " + std::to_string(full->holes) + " holes of " + std::to_string(flat.holes);
  }
  return "";
}

}  // namespace cnrg
