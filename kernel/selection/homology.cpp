// Why the alternating count of cells is not it: for a set that is not closed it is the Euler characteristic with
// compact support (an open edge has -1, but it is a ball up to homotopy), and cells need not be balls.
//
// Euler characteristic. Cut small open neighbourhoods of the missing vertices off the set, then of the missing
// edges, then of the missing faces. What remains is a compact set K that the set shrinks to. It is made up of the
// rests of the cells, so chi(K) = sum of w(c), the Euler characteristic with compact support of the rest of c.
// Take c with a collar inside of all its boundary, a compact manifold M. Of the boundary of M the rest of c lacks
// what lies along cells that are there, so w(c) = chi(M) - chi(what lies along cells that are there), and this is
// again a sum over rests, once for each germ of c along a cell:
//   w(v) = 1
//   w(e) = 1 - (ends that are there)
//   w(f) = 1 - rings - sum of w(e) over the steps of its loops - (corners at vertices that are there)
//   w(R) = chi(surfaces just inside) / 2 - sum of w(f) over its half-faces - sum of w(e) over its sectors
//          - sum of 2 - k over its germs with k circles at vertices that are there
// A vertex inside of a face (a circle), and a wire in a region (a tube), add nothing. For R0 without a frame, the
// sphere at infinity is one more surface, missing.
//
// Cavities. The boundary of a small neighbourhood of K is a closed surface; of a connected K it has one piece for
// each piece of the complement on the sphere with the point at infinity. In the barycentric subdivision that
// surface runs between cells of the set and cells that are not: it has a point on each incident pair of a cell
// inside and a cell outside, and an edge on each incident triple of three dimensions that has two such pairs. The
// neighbourhoods of vertices name these pairs and triples one by one, also where cells are no balls: an edge end,
// a corner, a germ, a use, a sector, a half-face. So b2 = pieces of the surface - b0.
//
// Loops then follow: b1 = b0 + b2 - chi.
#include "kernel/selection/homology.h"

#include <algorithm>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/by_dimension.h"

namespace cnrg {

/// The cells of a set, numbered from 1 as they are listed; 0: not in the set.
struct BettiCounter::Members {
  explicit Members(const Complex& complex) : numbers_(complex) {}
  template <class IdT>
  std::uint32_t operator()(IdT cell) const {
    return list_for(numbers_, cell).get(cell);
  }

  void enter(const CellSet& set) {
    std::uint32_t count = 0;
    number(set, [&] { return ++count; });
  }
  void clear(const CellSet& set) {
    number(set, [] { return 0u; });
  }

 private:
  template <class Next>
  void number(const CellSet& set, Next next) {
    const auto number_list = [&](const auto& cells, auto& numbers) {
      for (const auto cell : cells) numbers[cell] = next();
    };
    for_each_dimension(number_list, set, numbers_);
  }

  template <class IdT>
  using Numbers = Scratch<IdT, std::uint32_t>;
  OfCells<Numbers> numbers_;
};

namespace {

/// The regions, faces and edges with their boundary, also where that lies on the frame.
CellSet full_closure(const Complex& complex, const CellSet& set) {
  CellSet out = set;
  const auto add = [&](auto cell) { list_for(out, cell).push_back(cell); };
  for (RegionId r : set.regions) for_each_bounding(complex, r, add);
  sort_unique(out.faces);
  for (FaceId f : out.faces) {
    for (const HalfEdge h : complex.half_edges(f)) add(h.edge());
    for (VertexId v : complex.face_vertices[f]) add(v);
  }
  sort_unique(out.edges);
  for (EdgeId e : out.edges) for_each_bounding(complex, e, add);
  sort_unique(out.vertices);
  return out;
}

/// The region of the sector that follows a use in radial order.
RegionId sector_region(const Complex& complex, const FaceUse& use) {
  return complex.face_regions[use.face][use.half_edge.direction()];
}

template <class Members>
std::int64_t count_joined(const Complex& complex, const CellSet& set, const Members& in) {
  UnionFind sets(set.size() + 1);
  auto pieces = static_cast<std::int64_t>(set.size());
  const auto join = [&](std::uint32_t cell, const auto& others) {
    for (auto other : others) {
      if (in(other) != 0) pieces -= sets.unite(cell, in(other));
    }
  };
  std::vector<FaceId> faces;
  std::vector<RegionId> regions;
  for (VertexId v : set.vertices) {
    complex.star_faces(v, faces), complex.star_regions(v, regions);
    join(in(v), complex.vertex_edges[v]), join(in(v), faces), join(in(v), regions);
  }
  for (EdgeId e : set.edges) {
    complex.star_faces(e, faces), complex.star_regions(e, regions);
    join(in(e), faces), join(in(e), regions);
  }
  for (FaceId f : set.faces) join(in(f), complex.face_regions[f]);
  return pieces;
}

/// The surface between the set and its complement: incident pairs, joined along incident triples.
class Frontier {
 public:
  enum class Kind : std::uint64_t { edge_end, corner, germ, use, sector, half_face, tube, circle };
  using Pair = std::uint64_t;
  static Pair pair(Kind kind, std::uint64_t first, std::uint64_t second = 0) {
    return static_cast<std::uint64_t>(kind) << 60 | first << 28 | second;
  }

  void add(Pair pair) { pairs_.push_back(pair); }
  /// Three cells of ascending dimension, which of them are in the set, and the pairs ab, ac, bc.
  void add(bool a, bool b, bool c, Pair ab, Pair ac, Pair bc) {
    if (a == b && b == c) return;
    const Pair first = a == b ? ac : ab, second = a == c ? bc : (a == b ? bc : ac);
    pairs_.push_back(first), pairs_.push_back(second);
    joints_.emplace_back(first, second);
  }
  std::int64_t pieces() {
    sort_unique(pairs_);
    UnionFind sets(pairs_.size());
    const auto place = [&](Pair p) {
      return static_cast<std::uint32_t>(std::lower_bound(pairs_.begin(), pairs_.end(), p) - pairs_.begin());
    };
    auto count = static_cast<std::int64_t>(pairs_.size());
    for (const auto& [p, q] : joints_) count -= sets.unite(place(p), place(q));
    return count;
  }

 private:
  std::vector<Pair> pairs_;
  std::vector<std::pair<Pair, Pair>> joints_;
};

template <class Members>
class Counting {
 public:
  Counting(const CellSet& set, const Members& members, Neighbourhoods& neighbourhoods)
      : complex_(neighbourhoods.complex()),
        set_(set),
        neighbourhoods_(neighbourhoods),
        in_(members),
        closure_(full_closure(complex_, set)) {}

  BettiNumbers run() {
    BettiNumbers out;
    if (set_.empty()) return out;
    for (VertexId v : closure_.vertices) at_vertex(v);
    for (EdgeId e : closure_.edges) at_edge(e);
    for (FaceId f : closure_.faces) at_face(f);
    const bool infinity = !complex_.frame.valid() && in_(RegionId(0)) != 0;
    if (infinity) surfaces_ += 2;
    require(surfaces_ % 2 == 0, "homology: the surfaces inside of regions have an odd Euler characteristic");
    const std::int64_t euler = sum_ + surfaces_ / 2;
    const std::int64_t b0 = count_joined(complex_, set_, in_);
    const std::int64_t b2 = frontier_.pieces() + (infinity ? 1 : 0) - b0;
    out.z2 = {b0, b0 + b2 - euler, b2};
    require(b2 >= 0 && out.z2[1] >= 0, "homology: a negative Betti number");
    out.q = out.z2;
    return out;
  }

 private:
  using Kind = Frontier::Kind;
  bool has(auto cell) const { return in_(cell) != 0; }

  std::int64_t weight(EdgeId e) const {
    if (!has(e)) return 0;
    return 1 - (has(complex_.edge_ends[e][0]) ? 1 : 0) - (has(complex_.edge_ends[e][1]) ? 1 : 0);
  }
  std::int64_t weight(FaceId f) const {
    if (!has(f)) return 0;
    std::int64_t w = 1 - ring_count(complex_, f);
    for (const HalfEdge h : complex_.half_edges(f)) w -= weight(h.edge()) + (has(complex_.target(h)) ? 1 : 0);
    return w;
  }

  void at_vertex(VertexId v) {
    neighbourhoods_.at(v, around_);
    const bool in = has(v);
    if (in) sum_ += 1;
    const auto germ = [&](std::uint32_t i) { return Frontier::pair(Kind::germ, v.value(), i); };
    for (const auto& g : around_.germs) {
      if (!has(g.region)) continue;
      surfaces_ += g.euler();
      if (in) sum_ -= g.euler();
    }
    if (around_.circles.empty() && in != has(around_.germs[0].region)) frontier_.add(germ(0));
    for (const auto& node : around_.nodes) {
      const EdgeId e = node.edge.edge();
      const auto end = Frontier::pair(Kind::edge_end, node.edge.code());
      if (node.count == 0) {
        frontier_.add(in, has(e), has(around_.germs[node.germ].region), end, germ(node.germ),
                      Frontier::pair(Kind::tube, e.value()));
      }
      for (const auto& dart : around_.around(node)) {
        const auto& arc = around_.arcs[dart.arc];
        frontier_.add(in, has(e), has(arc.face), end, Frontier::pair(Kind::corner, arc.use),
                      Frontier::pair(Kind::use, dart.use));
        frontier_.add(in, has(e), has(around_.germs[dart.germ].region), end, germ(dart.germ),
                      Frontier::pair(Kind::sector, dart.sector));
      }
    }
    for (std::uint32_t k = 0; k < around_.arcs.size(); ++k) {
      const auto& arc = around_.arcs[k];
      const auto corner =
          arc.full_circle() ? Frontier::pair(Kind::circle, v.value(), k) : Frontier::pair(Kind::corner, arc.use);
      for (unsigned side : {0u, 1u}) {
        frontier_.add(in, has(arc.face), has(around_.germs[arc.germs[side]].region), corner, germ(arc.germs[side]),
                      Frontier::pair(Kind::half_face, HalfFace(arc.face, side).code()));
      }
    }
  }

  void at_edge(EdgeId e) {
    const std::int64_t w = weight(e);
    sum_ += w;
    const auto uses = complex_.edge_uses[e];
    const std::uint32_t first = complex_.edge_uses.offsets()[e.index()];
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
      const std::uint32_t before = i == 0 ? static_cast<std::uint32_t>(uses.size()) - 1 : i - 1;
      const unsigned ahead = uses[i].half_edge.direction();
      if (has(sector_region(complex_, uses[i]))) surfaces_ -= 1, sum_ -= w;
      for (unsigned side : {0u, 1u}) {
        frontier_.add(has(e), has(uses[i].face), has(complex_.face_regions[uses[i].face][side]),
                      Frontier::pair(Kind::use, first + i),
                      Frontier::pair(Kind::sector, first + (side == ahead ? i : before)),
                      Frontier::pair(Kind::half_face, HalfFace(uses[i].face, side).code()));
      }
    }
  }

  void at_face(FaceId f) {
    const std::int64_t w = weight(f);
    sum_ += w;
    for (RegionId r : complex_.face_regions[f]) {
      if (has(r)) surfaces_ += 1 - ring_count(complex_, f), sum_ -= w;
    }
  }

  const Complex& complex_;
  const CellSet& set_;
  Neighbourhoods& neighbourhoods_;
  const Members& in_;
  const CellSet closure_;
  Neighbourhood around_;
  Frontier frontier_;
  std::int64_t surfaces_ = 0;  // twice the first terms of w(R)
  std::int64_t sum_ = 0;       // all other terms
};

}  // namespace

BettiCounter::BettiCounter(Neighbourhoods& neighbourhoods)
    : neighbourhoods_(neighbourhoods), members_(std::make_unique<Members>(neighbourhoods.complex())) {}
BettiCounter::~BettiCounter() = default;

BettiNumbers BettiCounter::of(const CellSet& set) {
  members_->enter(set);
  const BettiNumbers out = Counting(set, *members_, neighbourhoods_).run();
  members_->clear(set);
  return out;
}

BettiNumbers betti_numbers(const Complex& complex, const CellSet& set) {
  Neighbourhoods neighbourhoods(complex);
  return BettiCounter(neighbourhoods).of(set);
}

std::vector<BettiNumbers> betti_numbers(const Selection& selection, const std::vector<Component>& components,
                                        BettiCounter& counter) {
  std::vector<CellSet> sets(components.size());
  const auto deal = [&](const auto& cells) {
    for (const auto& [cell, c] : cells) {
      const auto at = std::lower_bound(components.begin(), components.end(), c);
      require(at != components.end() && *at == c, "homology: a component that is not listed");
      list_for(sets[static_cast<std::size_t>(at - components.begin())], cell).push_back(cell);
    }
  };
  for_each_dimension(deal, selection);
  std::vector<BettiNumbers> out{counter.of(support(selection))};
  for (const CellSet& set : sets) out.push_back(counter.of(set));
  return out;
}

std::vector<std::int64_t> inner_surfaces(const Complex& complex, const std::vector<RegionId>& regions,
                                         Neighbourhoods& neighbourhoods) {
  Scratch<RegionId, std::uint32_t> place(complex.region_count);  // 1 + index
  for (std::size_t i = 0; i < regions.size(); ++i) place[regions[i]] = static_cast<std::uint32_t>(i + 1);
  std::vector<std::int64_t> out(regions.size(), 0);
  const auto add = [&](RegionId r, std::int64_t value) {
    if (place[r] != 0) out[place[r] - 1] += value;
  };
  CellSet set;
  set.regions = regions;
  const CellSet boundary = full_closure(complex, set);
  for (FaceId f : boundary.faces) {
    for (RegionId r : complex.face_regions[f]) add(r, 1 - ring_count(complex, f));
  }
  for (EdgeId e : boundary.edges) {
    for (const FaceUse& use : complex.edge_uses[e]) add(sector_region(complex, use), -1);
  }
  Neighbourhood around;
  for (VertexId v : boundary.vertices) {
    neighbourhoods.at(v, around);
    for (const auto& germ : around.germs) add(germ.region, germ.euler());
  }
  return out;
}

}  // namespace cnrg
