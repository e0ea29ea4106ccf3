// Euler-Poincare for closed sets of cells. Each term but Ch is counted on its own; Ch follows from the formula.
//
// Handles of a volume. Push its boundary a little into it: a closed surface, one piece per cavity and one outside,
// whose Euler characteristic is summed over what it is pushed from (`inner_surfaces`).
#include <algorithm>
#include <iterator>

#include "kernel/base/union_find.h"
#include "kernel/selection/homology.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

// The cells of all dimensions as 0 .. n-1, for union-find.
struct Numbering {
  explicit Numbering(const Complex& c)
      : edges(c.points.size()),
        faces(edges + c.edge_count()),
        regions(faces + c.face_count()),
        size(regions + c.region_count) {}
  std::uint32_t operator()(VertexId v) const { return v.value(); }
  std::uint32_t operator()(EdgeId e) const { return static_cast<std::uint32_t>(edges + e.index()); }
  std::uint32_t operator()(FaceId f) const { return static_cast<std::uint32_t>(faces + f.index()); }
  std::uint32_t operator()(RegionId r) const { return static_cast<std::uint32_t>(regions + r.index()); }
  std::size_t edges, faces, regions, size;
};

std::int64_t count_pieces(const Complex& complex, const CellSet& set) {
  const Numbering number(complex);
  UnionFind sets(number.size);
  const auto join_boundaries = [&](const auto& cells) {
    for (auto cell : cells)
      for_each_bounding(complex, cell, [&](auto other) { sets.unite(number(cell), number(other)); });
  };
  join_boundaries(set.edges), join_boundaries(set.faces), join_boundaries(set.regions);
  std::int64_t count = 0;
  const auto add = [&](const auto& cells) {
    for (auto cell : cells) count += sets.find(number(cell)) == number(cell);
  };
  add(set.vertices), add(set.edges), add(set.faces), add(set.regions);
  return count;
}

// Bounded pieces of the complement of faces and regions: 3-cells joined across faces that are not in the set.
std::int64_t count_cavities(const Complex& complex, const CellSet& set) {
  Marks<RegionId> held(complex.region_count);
  Marks<FaceId> wall(complex.face_count());
  for (RegionId r : set.regions) held[r] = 1;
  for (FaceId f : set.faces) wall[f] = 1;
  UnionFind sets(complex.region_count);
  for (FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto& [front, back] = complex.face_regions[f];
    if (!wall[f] && !held[front] && !held[back]) sets.unite(front.value(), back.value());
  }
  std::int64_t count = 0;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    count += !held[r] && sets.find(r.value()) == r.value();
  }
  return count - 1;
}

std::int64_t boundary_pieces(const Complex& complex, RegionId r) {
  CellSet boundary;
  for_each_bounding(complex, r, [&](auto cell) { list_for(boundary, cell).push_back(cell); });
  sort_unique(boundary.faces);
  return count_pieces(complex, closure(complex, boundary));
}

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
      for (const HalfEdge h : complex.half_edges(hf.face())) {
        boundary.emplace_back(h.edge(), (h.direction() == 0) == (hf.side() == 0) ? 1 : -1);
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
    for (const HalfEdge h : complex.half_edges(f)) column.push_back(h.edge());
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

EulerTerms euler_terms(const Complex& complex, const CellSet& set) {
  EulerTerms t;
  t.v = static_cast<std::int64_t>(set.vertices.size());
  t.e = static_cast<std::int64_t>(set.edges.size());
  t.f = static_cast<std::int64_t>(set.faces.size());
  for (FaceId f : set.faces) t.r += ring_count(complex, f);
  t.volumes = static_cast<std::int64_t>(set.regions.size());
  t.pieces = count_pieces(complex, set);
  t.cavities = count_cavities(complex, set);
  if (!set.regions.empty()) {
    Neighbourhoods neighbourhoods(complex);
    const std::vector<std::int64_t> characteristic = inner_surfaces(complex, set.regions, neighbourhoods);
    for (std::size_t i = 0; i < set.regions.size(); ++i) {
      const std::int64_t surfaces = boundary_pieces(complex, set.regions[i]);
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
  const EulerTerms flat = euler_terms(complex, walls);
  if (flat.holes < 0) return "the walls have " + std::to_string(flat.holes) + " holes";
  if (set.faces.size() <= max_faces) {
    const auto cycles = static_cast<std::int64_t>(count_cycles(complex, set.faces));
    if (cycles != flat.cavities) {
      return "the faces have " + std::to_string(cycles) + " independent cycles and enclose " +
             std::to_string(flat.cavities) + " cavities";
    }
  }
  const EulerTerms full = euler_terms(complex, set);
  // Filling volumes closes holes of the walls, at most one per handle.
  if (full.volume_holes < 0) return "volumes with a negative number of handles";
  if (full.holes < 0 || full.holes > flat.holes || full.holes < flat.holes - full.volume_holes) {
    return "the volumes leave " + std::to_string(full.holes) + " holes of " + std::to_string(flat.holes);
  }
  return "";
}

}  // namespace cnrg
