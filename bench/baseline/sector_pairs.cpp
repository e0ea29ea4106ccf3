// A vertex of A and one of B by pairs of their sectors (mantyla1988, section 15.6.2): each pair that has a line in
// common, or is coplanar, keeps the sides of both sectors' ends. Coplanar pairs and edges on the other boundary
// overwrite the sides of neighbouring pairs, until each pair that is left is a crossing.
#include "bench/baseline/sectors.h"

namespace cnrg::bench::mantyla {
namespace {

/// A sector of each solid. `sides`: by solid, of the ends `from` and `to`.
template <class N>
struct SectorPair {
  std::array<std::size_t, 2> sector;
  std::array<std::array<Side, 2>, 2> sides;
  Vec<N> direction{N(0), N(0), N(0)};
  bool crosses = true;

  /// Both ends on one side: no crossing.
  void settle(int solid) {
    if (sides[solid][0] == sides[solid][1] && sides[solid][0] != Side::on) crosses = false;
  }
};

template <class N>
class PairClassifier {
 public:
  PairClassifier(const Scene<N>& scene, const VertexVertex& contact)
      : scene_(scene), sectors_{neighbourhood(scene, contact.a), neighbourhood(scene, contact.b)} {
    crossing_.vertices = {contact.a, contact.b};
    crossing_.point = scene.point(contact.a);
  }

  Crossing<N> run() {
    find_pairs();
    for (std::size_t k = 0; k < pairs_.size(); ++k) reclassify_coplanar(k);
    for (std::size_t k = 0; k < pairs_.size(); ++k) reclassify_edges_on_edges(k);
    for (std::size_t k = 0; k < pairs_.size(); ++k) reclassify_edges_in_sectors(k);
    collect();
    return std::move(crossing_);
  }

 private:
  /// In a sector, its ends included.
  bool within(const Vec<N>& p, const Sector<N>& s) const {
    return same_direction(scene_.metric, p, s.from) || same_direction(scene_.metric, p, s.to) ||
           strictly_within(scene_.metric, p, s);
  }

  /// The line of two sectors; null for coplanar ones. Whether they have it in common. Coplanar ones always do, as
  /// in the archive: where they are apart, their neighbours have no line in common that could be overwritten.
  bool meet(const Sector<N>& a, const Sector<N>& b, Vec<N>& direction) const {
    const Vec<N> line = cross(a.normal, b.normal);
    if (scene_.metric.null_unit(line)) return true;
    for (const int turned : {1, -1}) {
      direction = Metric<N>::direction(line * N(turned));
      if (within(direction, a) && within(direction, b)) return true;
    }
    return false;
  }

  Side side(const Vec<N>& normal, const Vec<N>& end) const {
    const int sign = scene_.metric.unit_sign(dot(normal, end));
    return sign > 0 ? Side::out : sign < 0 ? Side::in : Side::on;
  }

  void find_pairs() {
    for (std::size_t i = 0; i < sectors_[0].size(); ++i)
      for (std::size_t j = 0; j < sectors_[1].size(); ++j) {
        const Sector<N>&a = sectors_[0][i], &b = sectors_[1][j];
        SectorPair<N> pair{
            {i, j},
            {{{side(b.normal, a.from), side(b.normal, a.to)}, {side(a.normal, b.from), side(a.normal, b.to)}}}};
        if (meet(a, b, pair.direction)) pairs_.push_back(pair);
      }
  }

  std::size_t before(int solid, std::size_t k) const {
    return (k + sectors_[solid].size() - 1) % sectors_[solid].size();
  }

  /// Coplanar sectors take the sides of the table, and so do the ends of their neighbours.
  void reclassify_coplanar(std::size_t k) {
    const SectorPair<N> found = pairs_[k];
    for (const auto& ends : found.sides)
      if (ends[0] != Side::on || ends[1] != Side::on) return;
    const bool alike = dot(sectors_[0][found.sector[0]].normal, sectors_[1][found.sector[1]].normal) > 0;
    const std::array<Side, 2> sides = {scene_.coplanar_side(0, alike), scene_.coplanar_side(1, alike)};
    for (SectorPair<N>& pair : pairs_)
      for (int solid = 0; solid < 2; ++solid) {
        const std::size_t here = found.sector[solid], other = pair.sector[solid];
        if (pair.sector[1 - solid] == found.sector[1 - solid]) {
          if (other == before(solid, here) && pair.sides[solid][0] != Side::on)
            pair.sides[solid][1] = sides[solid];
          if (before(solid, other) == here && pair.sides[solid][1] != Side::on)
            pair.sides[solid][0] = sides[solid];
        }
        pair.settle(solid);
      }
    pairs_[k].sides = {{{sides[0], sides[0]}, {sides[1], sides[1]}}};
    pairs_[k].crosses = false;
  }

  /// An edge of A along one of B: in all pairs that end at both.
  void reclassify_edges_on_edges(std::size_t k) {
    const SectorPair<N> found = pairs_[k];
    if (!found.crosses || found.sides[0][0] != Side::on || found.sides[1][0] != Side::on) return;
    for (SectorPair<N>& pair : pairs_) {
      if (!pair.crosses) continue;
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          if (!ends_at(pair, 0, a, found.sector[0]) || !ends_at(pair, 1, b, found.sector[1])) continue;
          pair.sides[0][a] = scene_.edge_side(0);
          pair.sides[1][b] = scene_.edge_side(1);
        }
      for (int solid = 0; solid < 2; ++solid) pair.settle(solid);
    }
  }

  /// An edge of one solid inside of a sector of the other.
  void reclassify_edges_in_sectors(std::size_t k) {
    const SectorPair<N> found = pairs_[k];
    if (!found.crosses) return;
    const int solid = found.sides[0][0] == Side::on ? 0 : 1;
    if (found.sides[solid][0] != Side::on) return;
    for (SectorPair<N>& pair : pairs_) {
      if (!pair.crosses) continue;
      for (int end = 0; end < 2; ++end)
        if (pair.sector[1 - solid] == found.sector[1 - solid] && ends_at(pair, solid, end, found.sector[solid]))
          pair.sides[solid][end] = scene_.edge_in_sector(solid);
      pair.settle(solid);
    }
  }

  /// Whether an end of the pair's sector is where `sector` begins.
  bool ends_at(const SectorPair<N>& pair, int solid, int end, std::size_t sector) const {
    return pair.sector[solid] == (end == 0 ? sector : before(solid, sector));
  }

  void collect() {
    std::array<std::vector<Place>, 2> places;
    for (const SectorPair<N>& pair : pairs_) {
      if (!pair.crosses) continue;
      const bool forward = pair.sides[0][0] == Side::out;
      check(scene_.departures, forward == (pair.sides[1][0] == Side::in), Stage::classification,
            "both neighbourhoods enter each other in one direction");
      crossing_.rays.push_back({pair.direction, forward});
      for (int solid = 0; solid < 2; ++solid) places[solid].push_back({pair.sector[solid], Within::inside});
    }
    for (int solid = 0; solid < 2; ++solid)
      crossing_.stars[solid] = star_of(sectors_[solid], places[solid], crossing_.rays);
  }

  const Scene<N>& scene_;
  std::array<std::vector<Sector<N>>, 2> sectors_;
  std::vector<SectorPair<N>> pairs_;
  Crossing<N> crossing_;
};

}  // namespace

template <class N>
Crossing<N> compare_pairs(const Scene<N>& scene, const VertexVertex& contact) {
  return PairClassifier<N>(scene, contact).run();
}

template Crossing<double> compare_pairs(const Scene<double>&, const VertexVertex&);
template Crossing<Rational> compare_pairs(const Scene<Rational>&, const VertexVertex&);

}  // namespace cnrg::bench::mantyla
