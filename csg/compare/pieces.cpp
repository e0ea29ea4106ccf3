// Pieces of all sets come from one pass; they are then the components of one selection, which is simplified once.
#include "csg/compare/pieces.h"

#include <algorithm>
#include <span>

#include "kernel/base/union_find.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/scratch.h"
#include "kernel/selection/simplify.h"

namespace cnrg {
namespace {

/// CellPlaces of the cells of all sets in one list.
class CellPlaces {
 public:
  CellPlaces(const Complex& complex, const std::vector<CellSet>& sets) : places_(complex) {
    const auto number = [&](auto& places, const auto& cells) {
      for (const auto cell : cells) places[cell] = ++count_;
    };
    for (const CellSet& set : sets) for_each_dimension(number, places_, set);
  }
  static constexpr std::uint32_t kNone = 0xffffffffu;  // of a cell of no set
  template <class IdT>
  std::uint32_t of(IdT cell) const {
    return list_for(places_, cell).get(cell) - 1;
  }
  std::size_t count() const { return count_; }

 private:
  template <class IdT>
  using Places = Scratch<IdT, std::uint32_t>;  // 1 + the place
  OfCells<Places> places_;
  std::uint32_t count_ = 0;
};

/// f(cell) for each larger cell whose boundary the cell lies in.
template <class IdT, class F>
void for_star(const Complex& complex, IdT cell, F visit) {
  if constexpr (std::is_same_v<IdT, VertexId>) std::ranges::for_each(complex.vertex_edges[cell], visit);
  if constexpr (!std::is_same_v<IdT, FaceId>) {
    std::vector<FaceId> faces;
    complex.star_faces(cell, faces);
    std::ranges::for_each(faces, visit);
  }
  std::vector<RegionId> regions;
  complex.star_regions(cell, regions);
  std::ranges::for_each(regions, visit);
}

/// Points in pieces, found by trial and decided by location, which is exact.
class PiecePoints {
 public:
  PiecePoints(const Complex& complex, const CellPlaces& places) : complex_(complex), places_(places) {}

  RationalPoint in(const SetPiece& piece, std::uint32_t number, const std::vector<std::uint32_t>& piece_of) {
    const auto holds = [&](const RationalPoint& p) {
      const Location at = locator().locate(p);
      const std::uint32_t place = at.dimension == 0   ? places_.of(at.vertex)
                                  : at.dimension == 1 ? places_.of(at.edge)
                                  : at.dimension == 2 ? places_.of(at.face)
                                                      : places_.of(at.region);
      return place != CellPlaces::kNone && piece_of[place] == number;
    };
    const CellSet& cells = piece.cells;
    if (piece.counts[3] != 0) {
      if (const auto middle = middle_of(cells.regions, holds)) return *middle;
      return inside(cells.regions.front(), holds);
    }
    if (piece.counts[2] != 0) {
      if (const auto middle = middle_of(cells.faces, holds)) return *middle;
      return interior_point(complex_, cells.faces.front()).rational();
    }
    if (piece.counts[1] != 0) {
      const EdgeId e = cells.edges.front();
      const auto& [a, b] = complex_.edge_ends[e];
      if (complex_.on_frame(a) || complex_.on_frame(b)) return interior_point(complex_, e).rational();
      const RationalPoint p = complex_.points.rational(a), q = complex_.points.rational(b);
      return {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    }
    return complex_.points.rational(cells.vertices.front());
  }

 private:
  const Locator& locator() {
    if (!locator_) locator_.emplace(complex_);
    return *locator_;
  }

  void corners(FaceId f, std::vector<VertexId>& out) const {
    for (const HalfEdge h : complex_.half_edges(f)) out.push_back(complex_.origin(h));
  }
  void corners(RegionId r, std::vector<VertexId>& out) const {
    for (const HalfFace h : complex_.region_faces[r]) corners(h.face(), out);
  }

  /// The middle of the piece's box or of that of one of its first cells, if the piece holds it.
  template <class IdT, class Holds>
  std::optional<RationalPoint> middle_of(const std::vector<IdT>& cells, const Holds& holds) {
    constexpr std::size_t kTried = 4;
    const auto middle = [&](std::span<const IdT> some) -> std::optional<RationalPoint> {
      std::vector<VertexId> all;
      for (const IdT cell : some) corners(cell, all);
      std::optional<RationalPoint> low, high;
      for (const VertexId v : all) {
        if (complex_.on_frame(v)) continue;
        const RationalPoint p = complex_.points.rational(v);
        if (!low) low = high = p;
        for (int k = 0; k < 3; ++k) (*low)[k] = std::min((*low)[k], p[k]), (*high)[k] = std::max((*high)[k], p[k]);
      }
      if (!low) return std::nullopt;
      RationalPoint p;
      for (int k = 0; k < 3; ++k) p[k] = ((*low)[k] + (*high)[k]) / 2;
      if (holds(p)) return shorter(p, holds);
      return std::nullopt;
    };
    if (auto p = middle(cells)) return p;
    for (std::size_t i = 0; i < std::min(kTried, cells.size()); ++i) {
      if (auto p = middle(std::span(&cells[i], 1))) return p;
    }
    return std::nullopt;
  }

  /// From a point of a face that bounds the 3-cell into it, as far as it takes.
  template <class Holds>
  RationalPoint inside(RegionId r, const Holds& holds) {
    const auto sides = complex_.region_faces[r];
    const auto seen = [&](HalfFace h) { return !complex_.on_frame(h.face()); };
    auto side = std::find_if(sides.begin(), sides.end(), seen);
    if (side == sides.end()) side = sides.begin();
    if (side == sides.end()) return beside_wires(holds);
    const RationalPoint from = interior_point(complex_, side->face()).rational();
    RationalPoint step = area_vector(complex_, side->face());
    if (side->side() != 0) {
      for (Rational& x : step) x = -x;
    }
    for (;;) {
      const RationalPoint p{from[0] + step[0], from[1] + step[1], from[2] + step[2]};
      if (holds(p)) return shorter(p, holds);
      for (Rational& x : step) x /= 2;
    }
  }

  /// In all of space but wires and points. A line meets the curve (t, t^2, t^3) in three points at most.
  template <class Holds>
  static RationalPoint beside_wires(const Holds& holds) {
    for (Rational t = 0;; t += 1) {
      RationalPoint p{t, t * t, t * t * t};
      if (holds(p)) return p;
    }
  }

  /// A point near p with short numbers, if the piece holds one; else p.
  template <class Holds>
  static RationalPoint shorter(const RationalPoint& p, const Holds& holds) {
    constexpr std::size_t kShort = 8;
    if (std::all_of(p.begin(), p.end(), [](const Rational& x) { return to_string(x).size() <= kShort; })) return p;
    for (int digits = 2; digits <= 12; ++digits) {
      RationalPoint q;
      for (int k = 0; k < 3; ++k) q[k] = *parse_rational(to_decimal(p[k], digits));
      if (holds(q)) return q;
    }
    return p;
  }

  const Complex& complex_;
  const CellPlaces& places_;
  std::optional<Locator> locator_;
};

class Pieces {
 public:
  Pieces(const Complex& complex, const std::vector<CellSet>& sets)
      : complex_(complex), sets_(sets), places_(complex, sets), bounds_(places_.count(), 0) {}

  std::vector<std::vector<SetPiece>> run() {
    join();
    measure();
    count();
    PiecePoints points(complex_, places_);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      pieces_[i].at = points.in(pieces_[i], static_cast<std::uint32_t>(i), piece_of_);
    }
    return in_order();
  }

 private:
  void join() {
    std::vector<std::uint32_t> set_of;  // by place
    for (std::size_t i = 0; i < sets_.size(); ++i)
      set_of.resize(set_of.size() + sets_[i].size(), static_cast<std::uint32_t>(i));
    UnionFind parts(places_.count());
    const auto link = [&](const auto& cells) {
      for (const auto cell : cells) {
        const std::uint32_t place = places_.of(cell);
        for_star(complex_, cell, [&](auto larger) {
          const std::uint32_t other = places_.of(larger);
          if (other == CellPlaces::kNone || set_of[other] != set_of[place]) return;
          parts.unite(place, other);
          bounds_[place] = 1;
        });
      }
    };
    for (const CellSet& set : sets_) link(set.vertices), link(set.edges), link(set.faces);
    piece_of_.assign(places_.count(), CellPlaces::kNone);
    const auto gather = [&](std::size_t set, const auto& cells, auto member) {
      for (const auto cell : cells) {
        const std::uint32_t place = places_.of(cell), root = parts.find(place);
        if (root == place) {  // the smallest of its part
          piece_of_[root] = static_cast<std::uint32_t>(pieces_.size());
          pieces_.emplace_back();
          set_of_piece_.push_back(set);
        }
        piece_of_[place] = piece_of_[root];
        (pieces_[piece_of_[root]].cells.*member).push_back(cell);
      }
    };
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      gather(i, sets_[i].vertices, &CellSet::vertices), gather(i, sets_[i].edges, &CellSet::edges);
      gather(i, sets_[i].faces, &CellSet::faces), gather(i, sets_[i].regions, &CellSet::regions);
    }
  }

  bool bounds(auto cell) const { return bounds_[places_.of(cell)] != 0; }

  bool reaches_frame(FaceId f) const {
    std::vector<EdgeId> edges;
    complex_.closure_edges(f, edges);
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return complex_.on_frame(e); });
  }
  bool reaches_frame(EdgeId e) const {
    const auto& [a, b] = complex_.edge_ends[e];
    return complex_.on_frame(a) || complex_.on_frame(b);
  }

  void measure() {
    for (SetPiece& piece : pieces_) {
      const CellSet& cells = piece.cells;
      if (!cells.regions.empty()) piece.size.volume = volume(complex_, cells.regions);
      for (const FaceId f : cells.faces) {
        if (bounds(f)) continue;
        if (reaches_frame(f)) piece.size.area.unbounded = true;
        else piece.size.area.sum.add_root(squared_area(complex_, f));
      }
      for (const EdgeId e : cells.edges) {
        if (bounds(e)) continue;
        if (reaches_frame(e)) piece.size.length.unbounded = true;
        else piece.size.length.sum.add_root(squared_length(complex_, e));
      }
      for (const VertexId v : cells.vertices) piece.size.points += bounds(v) ? 0 : 1;
    }
  }

  /// Simplified cells, those that bound no larger cell of their piece.
  void count() {
    Selection selection;
    const auto list = [&](const auto& cells, auto& out) {
      for (const auto cell : cells) out.emplace_back(cell, piece_of_[places_.of(cell)] + 1);
    };
    for (const CellSet& set : sets_) for_each_dimension(list, set, selection);
    for_each_dimension([](auto& cells) { std::sort(cells.begin(), cells.end()); }, selection);
    const SimplifiedComplex simple = simplify(complex_, selection, {});
    const auto add = [&](Component component, int dimension, bool counts) {
      if (component != 0 && counts) ++pieces_[component - 1].counts[static_cast<std::size_t>(dimension)];
    };
    for (const auto& vertex : simple.vertices) {
      if (vertex.component != 0) add(vertex.component, 0, !bounds(vertex.cell));
    }
    for (const auto& edge : simple.edges) {
      if (edge.component == 0) continue;
      add(edge.component, 1,
          std::any_of(edge.chain.begin(), edge.chain.end(), [&](HalfEdge h) { return !bounds(h.edge()); }));
    }
    for (const auto& face : simple.faces) {
      if (face.component == 0) continue;
      add(face.component, 2,
          std::any_of(face.cells.begin(), face.cells.end(), [&](HalfFace h) { return !bounds(h.face()); }));
    }
    for (const auto& region : simple.regions) add(region.component, 3, true);
  }

  std::vector<std::vector<SetPiece>> in_order() {
    struct Key {
      bool bounded;
      Rational volume;
      bool area_bounded;
      Rational area;
      bool length_bounded;
      Rational length;
      std::size_t points;
      std::size_t index;
    };
    std::vector<Key> keys;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Size& size = pieces_[i].size;
      keys.push_back({size.volume.has_value(), size.volume.value_or(0), !size.area.unbounded,
                      size.area.sum.value(), !size.length.unbounded, size.length.sum.value(), size.points, i});
    }
    const auto before = [&](const Key& a, const Key& b) {
      if (a.bounded != b.bounded) return b.bounded;
      if (a.volume != b.volume) return a.volume > b.volume;
      if (a.area_bounded != b.area_bounded) return b.area_bounded;
      if (a.area != b.area) return a.area > b.area;
      if (a.length_bounded != b.length_bounded) return b.length_bounded;
      if (a.length != b.length) return a.length > b.length;
      if (a.points != b.points) return a.points > b.points;
      return pieces_[a.index].at < pieces_[b.index].at;
    };
    std::sort(keys.begin(), keys.end(), before);
    std::vector<std::vector<SetPiece>> out(sets_.size());
    for (const Key& key : keys) out[set_of_piece_[key.index]].push_back(std::move(pieces_[key.index]));
    return out;
  }

  const Complex& complex_;
  const std::vector<CellSet>& sets_;
  CellPlaces places_;
  std::vector<char> bounds_;             // by place: a larger cell of the set has the cell on its boundary
  std::vector<std::uint32_t> piece_of_;  // by place
  std::vector<SetPiece> pieces_;
  std::vector<std::size_t> set_of_piece_;
};

}  // namespace

void Size::add(const Size& other) {
  if (volume && other.volume) *volume += *other.volume;
  else volume.reset();
  area.sum.add(other.area.sum), area.unbounded = area.unbounded || other.area.unbounded;
  length.sum.add(other.length.sum), length.unbounded = length.unbounded || other.length.unbounded;
  points += other.points;
}

std::vector<std::vector<SetPiece>> pieces_of(const Complex& complex, const std::vector<CellSet>& sets) {
  return Pieces(complex, sets).run();
}

}  // namespace cnrg
