#include "csg/output/snap_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/point_hash.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Xyz = std::array<double, 3>;
constexpr Index kNone = 0xffffffffu;

struct HashXyz {
  std::size_t operator()(const Xyz& p) const { return hash_of_point(p.data()); }
};

std::uint64_t key_of(Index a, Index b) { return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b); }

/// Lists of numbers, each stored once.
class Lists {
 public:
  Index intern(std::vector<Index> list) {
    const auto [it, fresh] = known_.try_emplace(std::move(list), Index(lists_.size()));
    if (fresh) lists_.push_back(&it->first);
    return it->second;
  }
  const std::vector<Index>& operator[](Index i) const { return *lists_[i]; }
  Index unite(Index a, Index b) {
    if (a == b) return a;
    std::vector<Index> both = (*this)[a];
    both.insert(both.end(), (*this)[b].begin(), (*this)[b].end());
    sort_unique(both);
    return intern(std::move(both));
  }

 private:
  std::map<std::vector<Index>, Index> known_;
  std::vector<const std::vector<Index>*> lists_;
};

/// At least the distance between a point of the table and one of doubles.
double distance(const PointTable& table, VertexId v, const Xyz& to) {
  const RationalPoint from = table.rational(v);
  Xyz d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = to_double(from[k] - from_double(to[k]));
  return std::hypot(d[0], d[1], d[2]) * (1 + 0x1p-50);
}

bool has_doubles(const PointTable& table, VertexId v) {
  if (table.is_double(v)) return true;
  const RationalPoint p = table.rational(v);
  return is_double(p[0]) && is_double(p[1]) && is_double(p[2]);
}

Xyz nearest(const PointTable& table, VertexId v) {
  Xyz p = table.nearest(v);
  for (double& c : p) {
    if (!std::isfinite(c)) {
      throw InputError("a coordinate of the result is beyond the range of doubles; write .json, which is exact");
    }
    c += 0.0;  // no -0
  }
  return p;
}

Xyz on_grid(Xyz p, double cell) {
  for (double& c : p) c = std::nearbyint(c / cell) * cell + 0.0;
  return p;
}

class Snapper {
 public:
  Snapper(const PointTable& table, const NumberedDrawing& drawing)
      : triangle_count_(drawing.triangles.size()), piece_count_(drawing.pieces.size()), at_(drawing.points.size()) {
    isolated_ = drawing.isolated;
    std::vector<Xyz> xyz;
    std::vector<double> moves(drawing.points.size(), 0);
    xyz.resize(drawing.points.size());
    for_each_index(xyz.size(), [&](std::size_t p) {
      const VertexId v = drawing.points[p];
      xyz[p] = nearest(table, v);
      if (!table.is_double(v)) moves[p] = distance(table, v, xyz[p]);
    });
    displacement_ = moves.empty() ? 0 : *std::max_element(moves.begin(), moves.end());
    double largest = 0;
    for (std::size_t p = 0; p < xyz.size(); ++p) {
      for (const double c : xyz[p]) largest = std::max(largest, std::abs(c));
      at_[p] = number(xyz[p]);
    }
    cell_ = std::ldexp(1.0, std::max(largest > 0 ? std::ilogb(largest) - 52 : 0, -1074));
    for (const auto& t : drawing.triangles) {
      triangles_.push_back({{at_[t.points[0]], at_[t.points[1]], at_[t.points[2]]}, lists_.intern({2 * t.face})});
    }
    for (const auto& piece : drawing.pieces) {
      add_piece(at_[piece.points[0]], at_[piece.points[1]], lists_.intern({piece.edge}));
    }
  }

  SnappedDrawing run() {
    for (int round = 1; round <= kSnapRounds; ++round) {
      drop_flat_triangles();
      keep_used_points();
      Complex complex = refine();
      std::vector<char> settled(complex.points.size(), 1);
      for_each_of(complex.vertices, [&](VertexId v) { settled[v.index()] = has_doubles(complex.points, v); });
      if (std::all_of(settled.begin(), settled.end(), [](char s) { return s != 0; })) {
        return finish(std::move(complex), round);
      }
      if (round > 3) cell_ *= 4;
      take(complex, settled);
    }
    throw InputError("rounding to doubles still makes facets cross after " + std::to_string(kSnapRounds) +
                     " rounds of --snap; move the model nearer to the origin, or write .json, which is exact");
  }

 private:
  struct Triangle {
    std::array<Index, 3> points;
    Index faces;                           // a list of faces and turns
  };

  const std::size_t triangle_count_, piece_count_;  // of the drawing
  Lists lists_;
  std::vector<Xyz> xyz_;
  std::unordered_map<Xyz, Index, HashXyz> number_;
  std::vector<Triangle> triangles_;
  std::map<std::array<Index, 2>, Index> pieces_;   // between two points: a list of edges
  std::vector<Index> at_;                  // of each point of the drawing, or kNone
  std::vector<Index> isolated_;            // points of the drawing
  double cell_ = 0, displacement_ = 0;

  Index number(const Xyz& p) {
    const auto [it, fresh] = number_.try_emplace(p, Index(xyz_.size()));
    if (fresh) xyz_.push_back(p);
    return it->second;
  }

  void add_piece(Index a, Index b, Index edges) {
    if (a == b) return;
    const auto [it, fresh] = pieces_.try_emplace({std::min(a, b), std::max(a, b)}, edges);
    if (!fresh) it->second = lists_.unite(it->second, edges);
  }

  void drop_flat_triangles() {
    PointTable table;
    for (const Xyz& p : xyz_) table.add(p[0], p[1], p[2]);
    std::vector<char> flat(triangles_.size(), 0);
    for_each_index(triangles_.size(), [&](std::size_t i) {
      const auto& [a, b, c] = triangles_[i].points;
      flat[i] = a == b || b == c || c == a || collinear(table, VertexId(a), VertexId(b), VertexId(c));
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      if (!flat[i]) triangles_[kept++] = triangles_[i];
    }
    triangles_.resize(kept);
  }

  /// Numbers the points again: those that something has, so that a point of the soup is the vertex of its number.
  void keep_used_points() {
    std::vector<Index> number(xyz_.size(), kNone);
    for (const auto& t : triangles_) for (const Index p : t.points) number[p] = 0;
    for (const auto& [ends, edges] : pieces_) for (const Index p : ends) number[p] = 0;
    for (const Index p : isolated_) number[at_[p]] = 0;
    Index n = 0;
    for (Index p = 0; p < number.size(); ++p) {
      if (number[p] == kNone) continue;
      xyz_[n] = xyz_[p];
      number[p] = n++;
    }
    xyz_.resize(n);
    for (auto& t : triangles_) for (Index& p : t.points) p = number[p];
    std::map<std::array<Index, 2>, Index> pieces;
    for (const auto& [ends, edges] : pieces_) pieces[{number[ends[0]], number[ends[1]]}] = edges;
    pieces_ = std::move(pieces);
    for (Index& p : at_) p = p == kNone ? kNone : number[p];
  }

  /// The refinement of a drawing that has not been cut yet is that drawing.
  bool is_plain(const Complex& complex) const {
    std::vector<std::uint64_t> edges;
    for (const auto& t : triangles_) {
      for (std::size_t k = 0; k < 3; ++k) edges.push_back(key_of(t.points[k], t.points[(k + 1) % 3]));
    }
    for (const auto& [ends, list] : pieces_) edges.push_back(key_of(ends[0], ends[1]));
    sort_unique(edges);
    return xyz_.size() == at_.size() && triangles_.size() == triangle_count_ && pieces_.size() == piece_count_ &&
           complex.vertex_count() == xyz_.size() && complex.edge_count() == edges.size() &&
           complex.face_count() == triangles_.size();
  }

  Complex refine() const {
    Soup soup;
    const LeafId leaf = soup.add_leaf(Fill::none);
    for (const Xyz& p : xyz_) soup.add_point(p[0], p[1], p[2]);
    std::unordered_set<std::uint64_t> sides;
    Index number = 0;
    for (const auto& t : triangles_) {
      const auto& [a, b, c] = t.points;
      soup.add_triangle(leaf, PointId(a), PointId(b), PointId(c), number, number);
      ++number;
      sides.insert({key_of(a, b), key_of(b, c), key_of(c, a)});
    }
    std::vector<char> held(xyz_.size(), 0);
    for (const auto& t : triangles_) for (const Index p : t.points) held[p] = 1;
    for (const auto& [ends, edges] : pieces_) {
      if (sides.contains(key_of(ends[0], ends[1]))) continue;
      soup.add_wire(leaf, PointId(ends[0]), PointId(ends[1]), number++);
      held[ends[0]] = held[ends[1]] = 1;
    }
    for (const Index p : isolated_) {
      if (!held[at_[p]]) soup.add_isolated(leaf, PointId(at_[p]));
    }
    return build_complex(soup);
  }

  /// The faces of the drawing on a face of the complex.
  Index faces_on(const Complex& complex, FaceId f) {
    const auto covers = complex.cover(f);
    if (covers.size() == 1 && covers[0].same) return triangles_[covers[0].source.index()].faces;
    std::vector<Index> all;
    for (const Cover& cover : covers) {
      for (const Index code : lists_[triangles_[cover.source.index()].faces]) {
        all.push_back(code ^ (cover.same ? 0u : 1u));
      }
    }
    std::sort(all.begin(), all.end());
    return lists_.intern(std::move(all));
  }

  /// The edges of the drawing on an edge of the complex.
  Index edges_on(const Complex& complex, EdgeId e) {
    Index edges = lists_.intern({});
    for (const SegmentId s : complex.edge_segments[e]) {
      const auto& [a, b] = complex.segment_ends[s];
      const auto piece = pieces_.find({std::min(a, b).value(), std::max(a, b).value()});
      if (piece != pieces_.end()) edges = lists_.unite(edges, piece->second);
    }
    return edges;
  }

  static void triangulate_face(const Complex& complex, FaceId f, std::vector<std::array<VertexId, 3>>& out) {
    std::vector<std::vector<VertexId>> walks;
    for (const LoopId l : complex.face_loops[f]) {
      auto& walk = walks.emplace_back();
      for (const HalfEdge h : complex.loop[l]) walk.push_back(complex.origin(h));
    }
    const auto isolated = complex.face_vertices[f];
    if (walks.size() == 1 && walks[0].size() == 3 && isolated.empty()) {
      out.push_back({walks[0][0], walks[0][1], walks[0][2]});
      return;
    }
    out = triangulate(complex.points, complex.sheet_projection[complex.face_sheet[f]], walks, isolated);
  }

  /// The refined drawing, with its new vertices and what shares their cells on the grid.
  void take(const Complex& complex, const std::vector<char>& settled) {
    const std::vector<VertexId>& vertices = complex.vertices;
    std::vector<Xyz> here(complex.points.size()), there(complex.points.size());
    for_each_of(vertices, [&](VertexId v) {
      here[v.index()] = nearest(complex.points, v);
      there[v.index()] = on_grid(here[v.index()], cell_);
    });
    std::unordered_set<Xyz, HashXyz> hot;
    for (const VertexId v : vertices) {
      if (!settled[v.index()]) hot.insert(there[v.index()]);
    }
    std::vector<double> moves(complex.points.size(), 0);
    for_each_of(vertices, [&](VertexId v) {
      if (!hot.contains(there[v.index()])) there[v.index()] = here[v.index()];
      if (!settled[v.index()] || there[v.index()] != here[v.index()]) {
        moves[v.index()] = distance(complex.points, v, there[v.index()]);
      }
    });
    displacement_ += *std::max_element(moves.begin(), moves.end());

    std::vector<std::vector<std::array<VertexId, 3>>> made(complex.face_count());
    for_each_index(made.size(), [&](std::size_t f) { triangulate_face(complex, FaceId(f), made[f]); }, 64);
    std::vector<Index> faces, edges;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) faces.push_back(faces_on(complex, f));
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) edges.push_back(edges_on(complex, e));

    xyz_.clear();
    number_.clear();
    triangles_.clear();
    pieces_.clear();
    std::vector<Index> to(complex.points.size(), kNone);
    for (const VertexId v : vertices) to[v.index()] = number(there[v.index()]);
    for (std::size_t f = 0; f < made.size(); ++f) {
      for (const auto& [a, b, c] : made[f]) {
        triangles_.push_back({{to[a.index()], to[b.index()], to[c.index()]}, faces[f]});
      }
    }
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
      if (lists_[edges[e.index()]].empty()) continue;
      const auto& [a, b] = complex.edge_ends[e];
      add_piece(to[a.index()], to[b.index()], edges[e.index()]);
    }
    for (Index& p : at_) p = p == kNone ? kNone : to[p];
  }

  SnappedDrawing finish(Complex refined, int rounds) {
    SnappedDrawing result;
    result.complex = std::move(refined);
    const Complex& complex = result.complex;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
      result.faces.push_back(lists_[faces_on(complex, f)]);
    }
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
      result.edges.push_back(lists_[edges_on(complex, e)]);
    }
    for (const Index p : at_) result.points.push_back(p == kNone ? VertexId::none() : VertexId(p));
    result.rounds = rounds;
    result.plain = rounds == 1 && is_plain(complex);
    result.displacement = displacement_;
    return result;
  }
};

}  // namespace

SnappedDrawing snap(const PointTable& points, const NumberedDrawing& drawing) {
  return Snapper(points, drawing).run();
}

}  // namespace cnrg
