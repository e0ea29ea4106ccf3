#include "csg/mesh/coarsen.h"

#include <algorithm>
#include <utility>

#include "csg/mesh/planar_facets.h"
#include "csg/mesh/refine_surface.h"
#include "csg/result/flat_drawing.h"
#include "csg/result/join_drawing.h"
#include "csg/result/relabel.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/vanished.h"
#include "csg/text/digits.h"
#include "csg/text/table.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = DoubleVector;
using Corners = std::array<Index, 3>;

constexpr double kShortSide = 0.8, kLongSide = 1.4;  // of the length that is wanted
constexpr double kLeastShape = 15;                   // the smallest angle, in degrees
constexpr double kMostTurn = 0.5;                    // the cosine of what a triangle of a curved face may turn by
constexpr int kMostCuts = 8;                         // of a triangle, one within the other
constexpr int kHalvings = 3, kMostTries = 9;         // of the distance; before all stays as it is

bool has(const Corners& triangle, Index p) { return std::ranges::find(triangle, p) != triangle.end(); }
Corners replaced(Corners triangle, Index p, Index q) {
  std::ranges::replace(triangle, p, q);
  return triangle;
}

/// The triangles that were given, and what is near to them.
class GivenTriangles {
 public:
  explicit GivenTriangles(double within) : within_(within) {}

  Index add(const std::array<Vector, 3>& corners) {
    triangles_.push_back(corners);
    return Index(triangles_.size() - 1);
  }
  /// Whether a triangle is near to some of them; `near`: those that it may be near to of these.
  bool is_near(const std::array<Vector, 3>& triangle, std::vector<Index> of, std::vector<Index>& near) const {
    sort_unique(of);
    const Box box = box_around(triangle, within_);
    std::ranges::copy_if(of, std::back_inserter(near),
                         [&](Index o) { return box_around(triangles_[o], 0).meets(box); });
    return is_near(triangle, near, 0);
  }

 private:
  const double within_;
  std::vector<std::array<Vector, 3>> triangles_;

  static Box box_around(const std::array<Vector, 3>& corners, double more) {
    Box box;
    for (const auto& [x, y, z] : corners)
      box.extend({x - more, y - more, z - more}, {x + more, y + more, z + more});
    return box;
  }
  bool is_near(const std::array<Vector, 3>& piece, const std::vector<Index>& of, int cuts) const {
    const double square = within_ * within_ * (1 - 0x1p-20);  // squares are rounded
    std::array<bool, 3> near{};
    for (const Index o : of) {
      bool all = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const bool is = squared_distance(piece[k], triangles_[o]) <= square;
        near[k] = near[k] || is, all = all && is;
      }
      if (all) return true;
    }
    if (near != std::array{true, true, true} || cuts == kMostCuts) return false;
    const auto side = [&](std::size_t k) { return distance(piece[k], piece[(k + 1) % 3]); };
    const std::size_t longest = std::ranges::max({0u, 1u, 2u}, {}, side);
    const Vector &a = piece[longest], &b = piece[(longest + 1) % 3], &c = piece[(longest + 2) % 3];
    const Vector middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    return is_near({a, middle, c}, of, cuts + 1) && is_near({middle, b, c}, of, cuts + 1);
  }
};

class FacetCollapser {
 public:
  /// `wanted`: of each point, how long sides are to be there.
  FacetCollapser(const FlatComplex& flat, const std::vector<Vector>& xyz, const std::vector<double>& wanted,
                 double within, const std::vector<char>& kept)
      : xyz_(xyz),
        given_(within),
        triangles_of_(xyz.size()),
        along_(xyz.size()),
        wanted_(wanted),
        movable_(xyz.size(), Movable::no) {
    for (Index p = 0; p < xyz.size(); ++p) to_.push_back(p);
    for (Index f = 0; f < flat.faces.size(); ++f)
      for (const Corners& points : flat.faces[f].triangles) add(points, f, is_curved(flat.faces[f]));
    find_movable(flat, kept);
  }

  /// Where each point goes.
  std::vector<Index> run(const Watch& watch) {
    for (bool changed = true; changed;) {
      changed = collapse_once();
      watch.check();
      changed = flip_once() || changed;
    }
    for (Index& p : to_)
      while (to_[p] != p) p = to_[p];
    return to_;
  }
  std::vector<NumberedDrawing::Triangle> triangles() const {
    std::vector<NumberedDrawing::Triangle> out;
    for (const Triangle& t : triangles_)
      if (t.there) out.push_back({t.points, t.face});
    return out;
  }

 private:
  enum class Movable : std::uint8_t { no, in_face, on_edge };
  struct Triangle {
    Corners points;
    Index face;
    bool curved, there = true;
    std::vector<Index> over;  // of a curved face: given triangles that are near
  };
  const std::vector<Vector>& xyz_;
  GivenTriangles given_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index>> triangles_of_;
  std::vector<std::vector<Index>> along_;  // of each point the neighbours on edges
  std::vector<Index> to_;
  const std::vector<double>& wanted_;
  std::vector<Movable> movable_;

  void add(const Corners& points, Index face, bool curved) {
    const Index t = Index(triangles_.size());
    triangles_.push_back({points, face, curved, true, {given_.add(corners(points))}});
    for (const Index p : points) {
      triangles_of_[p].push_back(t);
      if (curved) movable_[p] = Movable::in_face;
    }
  }

  void find_movable(const FlatComplex& flat, const std::vector<char>& kept) {
    for (const FlatComplex::Edge& edge : flat.edges) {
      const bool bounds = std::ranges::any_of(edge.around, [&](Index s) { return is_curved(flat.faces[s >> 1]); });
      for (const Index p : edge.points) movable_[p] = bounds ? Movable::on_edge : Movable::no;
      for_each_segment(edge, [&](Index a, Index b) { along_[a].push_back(b), along_[b].push_back(a); });
    }
    // Sides longer than wanted will be split: strips along a cylinder stay flat.
    for (const Triangle& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k)
        if (distance(xyz_[t.points[k]], xyz_[t.points[(k + 1) % 3]]) > kLongSide * wanted_[t.points[k]])
          for (const Index p : t.points) movable_[p] = t.curved ? Movable::no : movable_[p];
    for (const auto& vertex : flat.vertices) movable_[vertex.point] = Movable::no;
    for (Index p = 0; p < xyz_.size(); ++p)
      if (kept[p]) movable_[p] = Movable::no;
  }

  bool is_along(Index p, Index q) const { return std::ranges::find(along_[p], q) != along_[p].end(); }

  bool collapse_once() {
    std::vector<std::pair<double, std::array<Index, 2>>> sides;
    for (const Triangle& t : triangles_) {
      for (std::size_t k = 0; t.there && t.curved && k < 6; ++k) {
        const Index p = t.points[k % 3], q = t.points[(k + (k < 3 ? 1 : 2)) % 3];
        if (movable_[p] == Movable::no || (movable_[p] == Movable::on_edge && !is_along(p, q))) continue;
        const double size = distance(xyz_[p], xyz_[q]);
        if (size < kShortSide * wanted_[p]) sides.push_back({size, {p, q}});
      }
    }
    std::sort(sides.begin(), sides.end());
    bool collapsed = false;
    for (const auto& [size, side] : sides) {
      const auto& [p, q] = side;
      if (to_[p] == p && to_[q] == q && collapse(p, q)) collapsed = true;
    }
    return collapsed;
  }

  std::vector<Index> neighbours(Index p) const {
    std::vector<Index> out = along_[p];
    for (const Index t : triangles_of_[p])
      std::ranges::remove_copy(triangles_[t].points, std::back_inserter(out), p);
    sort_unique(out);
    return out;
  }

  /// False, and no change, if p must not go to q.
  bool collapse(Index p, Index q) {
    std::vector<Index> opposite, both;
    std::ranges::set_intersection(neighbours(p), neighbours(q), std::back_inserter(both));
    for (const Index t : triangles_of_[p]) {
      if (!has(triangles_[t].points, q)) continue;
      for (const Index x : triangles_[t].points)
        if (x != p && x != q) opposite.push_back(x);
    }
    sort_unique(opposite);
    const auto ends_edges = [&](Index x) { return is_along(p, x) && is_along(q, x); };
    if (both != opposite || std::ranges::any_of(both, ends_edges)) return false;
    // What is much shorter than wanted may leave worse shapes.
    const double share = distance(xyz_[p], xyz_[q]) / (kShortSide * wanted_[p]);
    const double least = kLeastShape * std::min(1.0, 2 * share);
    std::vector<std::vector<Index>> over;
    for (const Index t : triangles_of_[p]) {
      if (has(triangles_[t].points, q)) continue;
      over.emplace_back();
      if (!may_turn(t, p, q, least)) return false;
      if (triangles_[t].curved && !given_.is_near(corners(replaced(triangles_[t].points, p, q)),
                                                  over_around(p, q, triangles_[t].face), over.back()))
        return false;
    }
    std::size_t i = 0;
    for (const Index t : std::exchange(triangles_of_[p], {})) {
      Triangle& triangle = triangles_[t];
      if (has(triangle.points, q)) {
        triangle.there = false;
        for (const Index x : triangle.points) std::erase(triangles_of_[x], t);
        continue;
      }
      triangle.points = replaced(triangle.points, p, q);
      triangle.over = std::move(over[i++]);
      triangles_of_[q].push_back(t);
    }
    for (const Index x : std::exchange(along_[p], {})) {
      std::erase(along_[x], p);
      if (x != q) along_[x].push_back(q), along_[q].push_back(x);
    }
    to_[p] = q;
    return true;
  }
  /// What triangles of a face that have one of two points are near to.
  std::vector<Index> over_around(Index p, Index q, Index face) const {
    std::vector<Index> out;
    for (const Index end : {p, q}) {
      for (const Index t : triangles_of_[end]) {
        const Triangle& triangle = triangles_[t];
        if (triangle.face == face) out.insert(out.end(), triangle.over.begin(), triangle.over.end());
      }
    }
    return out;
  }

  std::array<Vector, 3> corners(const Corners& points) const {
    return {xyz_[points[0]], xyz_[points[1]], xyz_[points[2]]};
  }
  double shape(const Corners& points) const { return smallest_angle(corners(points)).first; }
  Vector normal(const Corners& points) const {
    const auto [a, b, c] = corners(points);
    return cross(minus(b, a), minus(c, a));
  }
  /// The cosine of the angle between the planes of two triangles.
  double turn(const Corners& s, const Corners& t) const {
    const Vector m = normal(s), n = normal(t);
    return dot(m, n) / std::sqrt(dot(m, m) * dot(n, n));
  }

  bool may_turn(Index t, Index p, Index q, double least) const {
    const Corners before = triangles_[t].points, after = replaced(before, p, q);
    const double cosine = turn(before, after);
    if (!triangles_[t].curved) return cosine > 0;
    if (!(cosine > kMostTurn) || shape(after) < least) return false;
    return std::ranges::all_of(after, [&](Index x) {
      const double size = distance(xyz_[x], xyz_[q]);
      return x == q || size < kLongSide * wanted_[p] || size < distance(xyz_[x], xyz_[p]);
    });
  }

  /// Sides between two triangles of a curved face go where the worse of the two is better.
  bool flip_once() {
    bool flipped = false;
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3 && triangles_[t].there && triangles_[t].curved; ++k) {
        const auto& points = triangles_[t].points;
        if (flip(t, points[k], points[(k + 1) % 3], points[(k + 2) % 3])) flipped = true;
      }
    }
    return flipped;
  }
  /// From a to b with c to the left.
  bool flip(Index t, Index a, Index b, Index c) {
    if (is_along(a, b)) return false;
    const auto other =
        std::ranges::find_if(triangles_of_[a], [&](Index s) { return s != t && has(triangles_[s].points, b); });
    if (other == triangles_of_[a].end()) return false;
    const Index s = *other;
    const Index d = *std::ranges::find_if(triangles_[s].points, [&](Index x) { return x != a && x != b; });
    if (std::ranges::any_of(triangles_of_[c], [&](Index x) { return has(triangles_[x].points, d); })) return false;
    const Corners first{a, d, c}, second{d, b, c};
    const auto worse = [&](const Corners& x, const Corners& y) { return std::min(shape(x), shape(y)); };
    const double better = worse(first, second);
    if (better < 1.01 * worse(triangles_[t].points, triangles_[s].points) || better < kLeastShape) return false;
    for (const Corners& x : {first, second})
      for (const Index y : {s, t})
        if (!(turn(x, triangles_[y].points) > kMostTurn)) return false;
    const std::vector<Index> of = over_around(a, b, triangles_[t].face);
    std::vector<Index> over, over_second;
    if (!given_.is_near(corners(first), of, over) || !given_.is_near(corners(second), of, over_second))
      return false;
    triangles_[t].points = first, triangles_[t].over = std::move(over);
    triangles_[s].points = second, triangles_[s].over = std::move(over_second);
    std::erase(triangles_of_[b], t), std::erase(triangles_of_[a], s);
    triangles_of_[d].push_back(t), triangles_of_[c].push_back(s);
    return true;
  }
};

std::size_t curved_triangles(const FlatComplex& flat) {
  std::size_t n = 0;
  for (const auto& face : flat.faces) n += is_curved(face) ? face.triangles.size() : 0;
  return n;
}

/// Of points on the boundary of active regions; no bound elsewhere.
std::vector<double> wanted_lengths(const FlatComplex& flat, const std::vector<Vector>& xyz,
                                   const MeshSizes& sizes) {
  std::vector<double> wanted(xyz.size(), kInfinity);
  std::vector<Index> last(xyz.size(), kNone);  // region that was looked at: triangles share points
  for (const auto& face : flat.faces)
    for (const Index region : face.regions)
      for (const Corners& points : face.triangles)
        for (const Index p : points)
          if (flat.active(region) && std::exchange(last[p], region) != region)
            wanted[p] = std::min(wanted[p], sizes.at(xyz[p], region));
  return wanted;
}

std::array<std::size_t, 4> cells(const FlatComplex& flat) {
  return {flat.vertices.size(), flat.edges.size(), flat.faces.size(), flat.regions.size()};
}

}  // namespace

Result coarsen(const Result& result, double within, SizeOptions sizes, CoarsenReport& report, const Watch& watch) {
  const Result::Data& given = result.data();
  const ResultView view = given.view();
  const FlatComplex flat = flatten(view);
  require_bounds(flat, "facets become fewer only in a result that has bounds", "");
  const RoundedPoints rounded = round_points(view, flat);
  sizes.said = true;
  const std::vector<double> wanted = wanted_lengths(flat, rounded.xyz, mesh_sizes(view, flat, rounded, sizes));
  const Parts parts(view, flat);
  report.before = report.after = curved_triangles(flat);
  std::vector<char> kept(flat.points.size(), 0);
  for (int tries = 0; tries < kMostTries; ++tries) {
    watch.begin("coarsen");
    FacetCollapser collapser(flat, rounded.xyz, wanted, within, kept);
    const std::vector<Index> to = collapser.run(watch);
    JoinMoves moves;
    moves.triangles = collapser.triangles();
    double farthest = 0;
    for (Index p = 0; p < to.size(); ++p) {
      moves.to.push_back(parts.points()[to[p]]);
      farthest = std::max(farthest, distance(rounded.xyz[p], rounded.xyz[to[p]]));
    }
    report.crossed = tries > 0 && farthest == 0;
    if (farthest == 0) return result;
    Result::Data next = relabelled(
        given, std::make_shared<const Relabelled>(*relabel(view, flat, move(parts, moves, watch), false, watch)));
    const FlatComplex after = flatten(next.view());
    if (cells(after) == cells(flat)) {
      report.after = curved_triangles(after);
      return Result(settled(std::move(next)));
    }
    // All points are held nearer in the next try; after some, those around new ones, where parts have crossed,
    // stay.
    if (tries < kHalvings) {
      within /= 2;
      continue;
    }
    std::ranges::sort(moves.to);
    for (const VertexId v : after.points) {
      if (std::ranges::binary_search(moves.to, next.complex->points.rational(v))) continue;
      const Vector x = nearest_doubles(next.complex->points, v);
      for (Index p = 0; p < to.size(); ++p) {
        const bool around =
            std::min(distance(rounded.xyz[p], x), distance(rounded.xyz[to[p]], x)) <= std::ldexp(farthest, tries);
        kept[p] = kept[p] || (to[p] != p && around);
      }
    }
  }
  report.crossed = true;
  return result;
}

std::string CoarsenReport::text(double within) const {
  if (crossed)
    return "curved faces keep their facets, since larger ones within " + double_text(within) + " would cross";
  return "curved faces: " + grouped(before) + " triangles before, " + grouped(after) + " now, within " +
         double_text(within) + " of them";
}

}  // namespace cnrg
