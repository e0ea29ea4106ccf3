// The grid of a patch, the ring that joins it to the sides, and the bisection of what is too coarse.
#include "csg/curves/patch_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>

#include "csg/curves/chord.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

/// Parameters in units of 1 / `whole`.
using Place = std::array<std::uint64_t, 2>;
using Corners = std::array<std::uint32_t, 3>;

/// The corner of a flat triangle that lies between the other two; its longest edge is opposite.
std::size_t middle_corner(const PatchMesh& mesh, const Corners& c) {
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalPoint &b = mesh.points[c[k]], &a = mesh.points[c[(k + 1) % 3]], &d = mesh.points[c[(k + 2) % 3]];
    if (dot(a - b, d - b) < 0) return k;
  }
  throw InvariantError("mesh_patch: a flat triangle without a middle corner");
}

/// Mends triangles without area (where a side has shrunk to a point, corners near it may lie on one line). Let
/// a b c be one with b between a and c, and d the corner of its neighbour at the edge a c: the two become a b d
/// and b c d, which cover the neighbour exactly.
void turn_flat_ones(PatchMesh& mesh) {
  const auto flat = [&](const Corners& c) {
    return collinear(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]);
  };
  std::multimap<Rational, std::size_t> left;  // by the square of the longest edge
  const auto note_flat = [&](std::size_t t) {
    const Corners& c = mesh.triangles[t];
    if (!flat(c)) return;
    const std::size_t k = middle_corner(mesh, c);
    const RationalPoint edge = mesh.points[c[(k + 2) % 3]] - mesh.points[c[(k + 1) % 3]];
    left.emplace(dot(edge, edge), t);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) note_flat(t);
  if (left.empty()) return;
  std::map<std::array<std::uint32_t, 2>, std::size_t> at_edge;  // directed
  const auto note = [&](std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) at_edge[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = t;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) note(t);
  // The triangle with the longest edge comes first. If its neighbour at that edge is flat, this is the neighbour's
  // longest edge too, and the two flat triangles made of them have shorter ones; if the neighbour is not flat,
  // neither are the two. So it ends. A flat triangle without a neighbour at its longest edge is dropped.
  std::vector<bool> gone(mesh.triangles.size(), false);
  while (!left.empty()) {
    const std::size_t t = std::prev(left.end())->second;
    left.erase(std::prev(left.end()));
    const Corners c = mesh.triangles[t];
    if (gone[t] || !flat(c)) continue;
    const std::size_t k = middle_corner(mesh, c);
    const std::uint32_t b = c[k], e = c[(k + 1) % 3], a = c[(k + 2) % 3];  // b between e and a
    const auto other = at_edge.find({a, e});
    if (other == at_edge.end() || gone[other->second]) {
      gone[t] = true;
      continue;
    }
    const std::size_t s = other->second;
    const Corners n = mesh.triangles[s];
    const std::size_t at_d = n[0] != a && n[0] != e ? 0 : n[1] != a && n[1] != e ? 1 : 2;
    const std::uint32_t d = n[at_d];
    at_edge.erase({a, e});
    at_edge.erase({e, a});
    if (d == b) {  // two flat ones back to back
      gone[s] = gone[t] = true;
      continue;
    }
    mesh.triangles[t] = {a, b, d};
    mesh.triangles[s] = {b, e, d};
    // The neighbour runs a e d; b is the flat one's.
    const Corners of_n = mesh.places[s];
    const std::uint32_t place_b = mesh.places[t][k];
    mesh.places[t] = {of_n[(at_d + 1) % 3], place_b, of_n[at_d]};
    mesh.places[s] = {place_b, of_n[(at_d + 2) % 3], of_n[at_d]};
    for (std::size_t x : {t, s}) {
      note(x);
      note_flat(x);
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (gone[t]) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    mesh.places[kept++] = mesh.places[t];
  }
  mesh.triangles.resize(kept);
  mesh.places.resize(kept);
}

/// True for a part of a cylinder, of any section, whose rulings are lines along v: all ways from the first row to
/// the second run along one vector.
bool has_parallel_rulings(const BezierPatch& patch) {
  if (patch.net.size() != 2) return false;
  const ControlRow &first = patch.net[0], &second = patch.net[1];
  const Rational share = second[0][3] / first[0][3];
  RationalPoint along{0, 0, 0};
  for (std::size_t i = 0; i < first.size(); ++i) {
    const RationalPoint way = project(second[i]) - project(first[i]);
    if (is_zero(along)) along = way;
    if (second[i][3] != share * first[i][3] || !is_zero(cross(along, way)) || dot(along, way) < 0) return false;
  }
  return !is_zero(along);
}

class Mesher {
 public:
  Mesher(const CanonicalPatch& canonical, const Fineness& fineness, BoundaryCurves& boundary,
         const PatchLines& lines)
      : canonical_(canonical),
        patch_(canonical.patch),
        fineness_(fineness),
        chord_(patch_),
        refines_(fineness.by_chord() && !has_parallel_rulings(patch_) &&
                 !has_parallel_rulings(transposed(patch_))) {
    for (std::size_t k = 0; k < 4; ++k) {
      const BezierCurve side = patch_.side(k);
      if (side.is_point()) continue;
      side_[k] = static_cast<std::uint32_t>(boundary.steps(side));
      inside_[k] = boundary.inside(side);
    }
    for (std::size_t d = 0; d < 2; ++d) {
      std::set<Rational> there;
      for (const Rational& t : lines[canonical.transposed ? 1 - d : d])
        there.insert((d == 0 ? canonical.backward_u : canonical.backward_v) ? Rational(1 - t) : t);
      lines_[d] = rounded_lines(there);
    }
  }

  PatchMesh run() {
    choose_grid();
    add_ring();
    add_inside();
    if (refines_) bisect_coarse();
    return result();
  }

 private:
  void choose_grid() {
    const auto direction = [&](std::size_t degree, std::size_t a, std::size_t b) {
      const std::uint32_t least = std::max({side_[a], side_[b], 1u});
      if (degree == 1) return least;
      return std::max(least,
                      static_cast<std::uint32_t>(fineness_.by_chord() ? fineness_.least() : fineness_.segments()));
    };
    grid_ = {direction(patch_.degree_u(), 0, 2), direction(patch_.degree_v(), 1, 3)};
    do {
      if (grid_[0] > Fineness::kMostSegments || grid_[1] > Fineness::kMostSegments) fineness_.fail_too_fine();
      fineness_.check_facets(2.0 * grid_[0] * grid_[1]);
    } while (refines_ && !grid_is_fine());
    // A side that is one point has the steps of the grid: its triangles vanish.
    for (std::size_t k = 0; k < 4; ++k) {
      if (side_[k] == 0) side_[k] = grid_[k % 2];
    }
    // The ring needs a grid with two steps where a side has them.
    for (std::size_t k = 0; k < 4; ++k) {
      if (grid_[k % 2] > 1) continue;
      for (const Rational& t : inside_[k]) lines_[k % 2].insert(k < 2 ? t : Rational(1 - t));
    }
    choose_unit();
    for (std::size_t d = 0; d < 2; ++d) {
      at_[d] = places_of(CurveSteps{static_cast<int>(grid_[d]), lines_[d]}.inside());
    }
    fineness_.check_facets(2.0 * cells(0) * cells(1));
  }

  /// With both ends.
  std::vector<std::uint64_t> places_of(const std::vector<Rational>& inside) const {
    std::vector<std::uint64_t> result{0};
    const Rational whole = to_integer(whole_);
    for (const Rational& t : inside) result.push_back(to_machine<std::uint64_t>(Rational(t * whole).get_num()));
    result.push_back(whole_);
    return result;
  }
  std::uint32_t cells(std::size_t d) const { return static_cast<std::uint32_t>(at_[d].size() - 1); }

  /// With a chord all steps are powers of two, and bisection needs more of them. Without, sides may have steps
  /// that other patches ask for: all must be whole numbers of units.
  void choose_unit() {
    whole_ = fineness_.by_chord() ? std::uint64_t{1} << 24 : 1;
    for (const std::uint32_t steps : {grid_[0], grid_[1], side_[0], side_[1], side_[2], side_[3]}) {
      whole_ = std::lcm(whole_, std::uint64_t{steps});
      if (whole_ > std::uint64_t{1} << 40) fineness_.fail_unlike();
    }
    const bool even = std::all_of(inside_.begin(), inside_.end(), [&](const std::vector<Rational>& inside) {
      return std::all_of(inside.begin(), inside.end(),
                         [&](const Rational& t) { return Rational(t * to_integer(whole_)).get_den() == 1; });
    });
    if (even && lines_[0].empty() && lines_[1].empty()) return;
    // Lines are multiples of 2^-40; between them is room for twelve bisections.
    const std::uint64_t fine = std::uint64_t{1} << (fineness_.by_chord() ? 52 : 40);
    const std::uint64_t odd = whole_ / std::gcd(whole_, fine);
    if (odd >= (std::uint64_t{1} << 60) / fine) fineness_.fail_unlike();
    whole_ = odd * fine;
  }

  /// False if more than a quarter of the cells are above the chord; the grid then gets twice the steps in the
  /// direction that adds more to the bound in most of those seen. A quarter or less is left to `bisect_coarse`.
  bool grid_is_fine() {
    const double hu = 1.0 / grid_[0], hv = 1.0 / grid_[1];
    const double cells = static_cast<double>(grid_[0]) * grid_[1];
    double coarse = 0, along_u = 0;
    for (std::uint32_t j = 0; j < grid_[1] && 4 * coarse <= cells; ++j) {
      for (std::uint32_t i = 0; i < grid_[0] && 4 * coarse <= cells; ++i) {
        const ChordTerms terms = chord_.terms({i * hu, j * hv}, {(i + 1) * hu, (j + 1) * hv});
        if (terms.sum() <= fineness_.chord()) continue;
        const bool twist = terms.uv >= terms.uu && terms.uv >= terms.vv;
        if (twist ? grid_[0] <= grid_[1] : terms.uu > terms.vv) ++along_u;
        ++coarse;
      }
    }
    cells_are_fine_ = coarse == 0;
    if (4 * coarse <= cells) return true;
    grid_[2 * along_u >= coarse ? 0 : 1] *= 2;
    return false;
  }

  std::uint32_t vertex(const Place& place) {
    const auto [it, is_new] = number_.try_emplace(place, static_cast<std::uint32_t>(places_.size()));
    if (is_new) places_.push_back(place);
    return it->second;
  }
  std::uint32_t at_step(std::uint32_t i, std::uint32_t j) { return vertex({at_[0][i], at_[1][j]}); }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.push_back({a, b, c}); }

  /// Triangles between two rows of vertices that run alike, `lower` on the right of `upper`; `along` tells where
  /// on the way a vertex is.
  template <class Along>
  void zip(const std::vector<std::uint32_t>& lower, const std::vector<std::uint32_t>& upper, Along along) {
    std::size_t i = 0, j = 0;
    while (i + 1 < lower.size() || j + 1 < upper.size()) {
      const bool low =
          j + 1 == upper.size() ||
          (i + 1 < lower.size() && along(lower[i]) + along(lower[i + 1]) <= along(upper[j]) + along(upper[j + 1]));
      if (low) {
        add_triangle(lower[i], lower[i + 1], upper[j]);
        ++i;
      } else {
        add_triangle(lower[i], upper[j + 1], upper[j]);
        ++j;
      }
    }
  }

  /// Vertices of side k, along growing parameters.
  std::vector<std::uint32_t> side_row(std::size_t k) {
    std::vector<std::uint32_t> row;
    const std::uint64_t across = k == 1 || k == 2 ? whole_ : 0;
    std::vector<std::uint64_t> places = at_[k % 2];
    if (!patch_.side(k).is_point()) {
      places = places_of(inside_[k]);
      if (k >= 2) {
        std::reverse(places.begin(), places.end());
        for (std::uint64_t& t : places) t = whole_ - t;
      }
    }
    row.reserve(places.size());
    for (const std::uint64_t t : places) row.push_back(k % 2 == 0 ? vertex({t, across}) : vertex({across, t}));
    return row;
  }

  void add_ring() {
    const auto along_u = [&](std::uint32_t v) { return static_cast<std::int64_t>(places_[v][0]); };
    const auto along_v = [&](std::uint32_t v) { return static_cast<std::int64_t>(places_[v][1]); };
    const auto back_u = [&](std::uint32_t v) { return -along_u(v); };
    const auto back_v = [&](std::uint32_t v) { return -along_v(v); };
    std::vector<std::uint32_t> rows[4];
    for (std::size_t k = 0; k < 4; ++k) rows[k] = side_row(k);
    if (cells(1) == 1) return zip(rows[0], rows[2], along_u);
    if (cells(0) == 1) return zip(rows[1], rows[3], along_v);
    std::reverse(rows[2].begin(), rows[2].end());
    std::reverse(rows[3].begin(), rows[3].end());
    std::vector<std::uint32_t> inner[4];
    for (std::uint32_t i = 1; i < cells(0); ++i) {
      inner[0].push_back(at_step(i, 1));
      inner[2].push_back(at_step(cells(0) - i, cells(1) - 1));
    }
    for (std::uint32_t j = 1; j < cells(1); ++j) {
      inner[1].push_back(at_step(cells(0) - 1, j));
      inner[3].push_back(at_step(1, cells(1) - j));
    }
    zip(rows[0], inner[0], along_u);
    zip(rows[1], inner[1], along_v);
    zip(rows[2], inner[2], back_u);
    zip(rows[3], inner[3], back_v);
  }

  void add_inside() {
    for (std::uint32_t j = 1; j + 1 < cells(1); ++j) {
      for (std::uint32_t i = 1; i + 1 < cells(0); ++i) {
        const std::uint32_t a = at_step(i, j), b = at_step(i + 1, j), c = at_step(i + 1, j + 1),
                            d = at_step(i, j + 1);
        add_triangle(a, b, c);
        add_triangle(a, c, d);
      }
    }
  }

  void hang(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t edge = edge_key(triangles_[t][k], triangles_[t][(k + 1) % 3]);
      auto& pair = at_edge_.try_emplace(edge, std::array{kNone, kNone}).first->second;
      (pair[0] == kNone ? pair[0] : pair[1]) = t;
    }
  }
  void unhang(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      auto& pair = at_edge_.at(edge_key(triangles_[t][k], triangles_[t][(k + 1) % 3]));
      (pair[0] == t ? pair[0] : pair[1]) = kNone;
    }
  }

  /// Triangles are cut until all are near enough to the patch.
  void bisect_coarse() {
    for (std::size_t t = 0; t < triangles_.size(); ++t) hang(t);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      while (const std::optional<std::size_t> worst = worst_edge(triangles_[t])) bisect(t, *worst);
    }
  }

  /// The edge of a triangle to cut, or nothing if the triangle is near enough to the patch. A triangle in a cell
  /// that is near enough is so itself, and so is every piece of one that is.
  std::optional<std::size_t> worst_edge(const Corners& corners) const {
    Place low = places_[corners[0]], high = low;
    for (std::uint32_t v : corners) {
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], places_[v][k]);
        high[k] = std::max(high[k], places_[v][k]);
      }
    }
    const double extent[2] = {static_cast<double>(high[0] - low[0]), static_cast<double>(high[1] - low[1])};
    bool in_cell = true;
    for (std::size_t d = 0; d < 2; ++d) {
      const std::uint64_t cell = whole_ / grid_[d];
      in_cell = in_cell && high[d] <= (low[d] / cell + 1) * cell;
    }
    if (in_cell && cells_are_fine_) return std::nullopt;
    const double unit = 1.0 / static_cast<double>(whole_);
    const ChordTerms terms = chord_.terms(in_doubles(low, unit), in_doubles(high, unit));
    if (terms.sum() <= fineness_.chord()) return std::nullopt;
    std::optional<std::size_t> worst;
    double most = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Place &a = places_[corners[k]], &b = places_[corners[(k + 1) % 3]];
      bool on_side = false;
      double part[2];
      for (std::size_t d = 0; d < 2; ++d) {
        on_side = on_side || (a[d] == b[d] && (a[d] == 0 || a[d] == whole_));
        part[d] = std::abs(static_cast<double>(a[d]) - static_cast<double>(b[d])) / extent[d];
      }
      const double length =
          terms.uu * part[0] * part[0] + 2 * terms.uv * part[0] * part[1] + terms.vv * part[1] * part[1];
      if (on_side || length <= most) continue;
      worst = k;
      most = length;
    }
    return worst;
  }

  static std::array<double, 2> in_doubles(const Place& place, double unit) {
    return {static_cast<double>(place[0]) * unit, static_cast<double>(place[1]) * unit};
  }

  void bisect(std::size_t t, std::size_t k) {
    const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
    Place middle;
    for (std::size_t d = 0; d < 2; ++d) {
      const std::uint64_t sum = places_[a][d] + places_[b][d];
      if (sum % 2 == 1) fineness_.fail_too_fine();
      middle[d] = sum / 2;
    }
    const std::uint32_t m = vertex(middle);
    const std::array<std::size_t, 2> both = at_edge_.at(edge_key(a, b));
    for (std::size_t s : both) {
      require(s != kNone, "mesh_patch: an edge inside of a patch has one triangle");
      fineness_.check_facets(static_cast<double>(triangles_.size()));
      unhang(s);
      Corners first = triangles_[s], second = first;
      std::replace(first.begin(), first.end(), b, m);
      std::replace(second.begin(), second.end(), a, m);
      triangles_[s] = first;
      triangles_.push_back(second);
      hang(s);
      hang(triangles_.size() - 1);
    }
  }

  PatchMesh result() const {
    PatchMesh mesh;
    std::map<RationalPoint, std::uint32_t> number;
    std::vector<std::uint32_t> point_of;
    for (const Place& place : places_) {
      Rational u(to_integer(place[0]), to_integer(whole_)), v(to_integer(place[1]), to_integer(whole_));
      u.canonicalize();
      v.canonicalize();
      const auto [it, is_new] =
          number.try_emplace(patch_.at(u, v), static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.push_back(it->first);
      point_of.push_back(it->second);
      mesh.parameters.push_back(canonical_.given(u, v));
    }
    for (const Corners& c : triangles_) {
      const Corners p{point_of[c[0]], point_of[c[1]], point_of[c[2]]};
      if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
      mesh.triangles.push_back(p);
      mesh.places.push_back(c);
    }
    turn_flat_ones(mesh);
    return mesh;
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const CanonicalPatch& canonical_;
  const BezierPatch& patch_;
  const Fineness& fineness_;
  PatchChord chord_;
  bool refines_;  // by the bound of the chord
  std::uint64_t whole_ = 1;
  std::array<std::uint32_t, 4> side_{0, 0, 0, 0};  // steps of each side; 0: a point
  std::array<std::uint32_t, 2> grid_{1, 1};        // even steps
  std::array<std::vector<Rational>, 4> inside_;    // of each side, as it runs
  std::array<std::set<Rational>, 2> lines_;
  std::array<std::vector<std::uint64_t>, 2> at_;  // where the lines of the grid are
  bool cells_are_fine_ = true;
  std::map<Place, std::uint32_t> number_;
  std::vector<Place> places_;
  std::vector<Corners> triangles_;
  std::unordered_map<std::uint64_t, std::array<std::size_t, 2>> at_edge_;
};

}  // namespace

PatchMesh mesh_patch(const BezierPatch& patch, const Fineness& fineness, BoundaryCurves& boundary,
                     const PatchLines& lines) {
  const CanonicalPatch c = canonical(patch);
  PatchMesh mesh = Mesher(c, fineness, boundary, lines).run();
  if (c.mirrored) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    for (auto& t : mesh.places) std::swap(t[1], t[2]);
  }
  return mesh;
}

std::vector<PatchCorner> cell_of(const PatchMesh& mesh, std::size_t t, const BezierPatch& patch) {
  std::vector<PatchCorner> cell;
  for (std::size_t k = 0; k < 3; ++k) {
    cell.push_back({mesh.points[mesh.triangles[t][k]], mesh.parameters[mesh.places[t][k]]});
  }
  // Sides v = 0, u = 1, v = 1, u = 0: the parameter that is fixed, and its value.
  constexpr std::array<std::pair<std::size_t, int>, 4> kSides{{{1, 0}, {0, 1}, {1, 1}, {0, 0}}};
  std::optional<std::size_t> pole;
  std::size_t along = 0;
  for (std::size_t side = 0; side < 4; ++side) {
    const auto [fixed, value] = kSides[side];
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell[k].at[fixed] != value || !patch.side(side).is_point()) continue;
      if (pole) return cell;
      pole = k;
      along = 1 - fixed;
    }
  }
  if (!pole) return cell;
  const PatchCorner &a = cell[*pole], &b = cell[(*pole + 1) % 3], &c = cell[(*pole + 2) % 3];
  PatchCorner before = a, after = a;
  before.at[along] = c.at[along];
  after.at[along] = b.at[along];
  return {before, after, b, c};
}

}  // namespace cnrg
