#include "csg/mesh/quality.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <string_view>

#include "csg/mesh/near_cells.h"
#include "csg/mesh/reach.h"
#include "csg/mesh/size_field.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/tetrahedra/shapes.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = DoubleVector;

/// Opposite to each edge, the other two.
constexpr std::size_t kOthers[6][2] = {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}};

/// Degrees between the two faces at an edge.
double dihedral(const std::array<Vector, 4>& p, std::size_t edge) {
  const auto& [i, j] = kEdges[edge];
  const auto& [k, l] = kOthers[edge];
  const Vector e = minus(p[j], p[i]);
  const Vector m = cross(e, minus(p[k], p[i])), n = cross(e, minus(p[l], p[i]));
  return std::atan2(length(cross(m, n)), dot(m, n)) * 180 / std::numbers::pi;
}

std::string short_text(double x) { return decimal(x, "%.3g"); }

/// Less than this part of the longest edge is short.
constexpr double kShort = 0.15;
/// Faces that meet below so many degrees leave no room for good shapes.
constexpr double kSharp = 15;

class Explainer {
 public:
  Explainer(const Mesh& mesh, const std::vector<std::string>& leaves)
      : mesh_(mesh), leaves_(leaves), cells_(mesh) {
    for (const auto& t : mesh.triangles) {
      for (const Index p : t.points)
        if (cells_.cell_of_point(p).dimension < 2) faces_at_.emplace_back(p, t.entity);
    }
    sort_unique(faces_at_);
    set_lines();
  }

  MeshQuality::Bad explain(const Mesh::Simplex<4>& t) const {
    std::array<Vector, 4> p;
    MeshQuality::Bad bad{};
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = mesh_.points[t.points[k]];
      for (std::size_t i = 0; i < 3; ++i) bad.at[i] += p[k][i] / 4;
    }
    bad.measures = measures_of(p);
    bad.why = why(t, p);
    for (const Index v : t.points) name(cell_of(v), bad.nodes);
    for (std::size_t k = 0; k < 4; ++k)
      if (const auto f = cells_.face(t, k)) name(face_cell(*f), bad.nodes);
    return bad;
  }
  /// What it is flat for, if that is a gap between two cells of the model: there is one that is narrow beside its
  /// longest edge, and narrower than where two faces meet in it.
  std::optional<NearCells::Gap> gap(const Mesh::Simplex<4>& t) const {
    std::array<Vector, 4> p;
    double longest = 0;
    for (std::size_t k = 0; k < 4; ++k) p[k] = mesh_.points[t.points[k]];
    for (const auto& [i, j] : kEdges) longest = std::max(longest, length(minus(p[i], p[j])));
    double most = kShort * longest;
    if (const auto edge = sharpest(t, p))
      most = std::min(most, std::sin(edge->degrees * std::numbers::pi / 180) * longest);
    return cells_.narrowest(t, most);
  }
  /// Does the model meet in it at less than MeshQuality::kForced: two faces at an edge, two edges or an edge and a
  /// face at a corner?
  bool is_forced(const Mesh::Simplex<4>& t) const {
    std::array<Vector, 4> p;
    std::array<bool, 4> on_face;  // by the opposite corner
    for (std::size_t k = 0; k < 4; ++k)
      p[k] = mesh_.points[t.points[k]], on_face[k] = cells_.face(t, k).has_value();
    for (std::size_t e = 0; e < 6; ++e) {
      const auto& [k, l] = kOthers[e];
      if (on_face[k] && on_face[l] && dihedral(p, e) < MeshQuality::kForced) return true;
    }
    const double sine = std::sin(MeshQuality::kForced * std::numbers::pi / 180);
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t a = 0; a < 4; ++a) {
        if (a == v || !is_line(t.points[v], t.points[a])) continue;
        const Vector d = minus(p[a], p[v]);
        for (std::size_t b = a + 1; b < 4; ++b) {
          if (b == v || !is_line(t.points[v], t.points[b])) continue;
          const Vector e = minus(p[b], p[v]);
          if (dot(d, e) > 0 && length(cross(d, e)) < sine * length(d) * length(e)) return true;
        }
        if (!on_face[a]) continue;
        const Vector &o = p[(a + 1) % 4], n = cross(minus(p[(a + 2) % 4], o), minus(p[(a + 3) % 4], o));
        if (std::fabs(dot(d, n)) < sine * length(d) * length(n)) return true;
      }
    }
    return false;
  }
  /// Of a triangle on a face.
  std::vector<std::string> nodes_of(const Mesh::Simplex<3>& t) const {
    std::vector<std::string> out;
    name(face_cell(t.entity), out);
    for (const Index v : t.points) name(cell_of(v), out);
    return out;
  }

 private:
  struct Cell : MeshCell {
    Index point;  // of the mesh, on a cell of dimension 0 or 1
  };
  const Mesh& mesh_;
  const std::vector<std::string>& leaves_;
  NearCells cells_;
  std::vector<std::pair<Index, Index>> faces_at_;  // by points on edges and vertices
  std::vector<std::array<Index, 2>> lines_;        // of segments, and between facets; sorted

  Cell cell_of(Index point) const { return {cells_.cell_of_point(point), point}; }
  static Cell face_cell(Index face) { return {{2, face}, 0}; }
  /// With one of its points, for the faces that meet there.
  Cell with_point(const MeshCell& cell, const Mesh::Simplex<4>& t) const {
    for (const Index p : t.points)
      if (cells_.cell_of_point(p) == cell) return {cell, p};
    return {cell, cells_.point_of(cell)};
  }

  struct Shortest {
    double length = HUGE_VAL, longest = 0;  // of all six
    std::array<Cell, 2> cells{};            // of its ends
    bool is_short() const { return length < kShort * longest; }
  };
  Shortest shortest_edge(const Mesh::Simplex<4>& t) const {
    Shortest out;
    for (const auto& [i, j] : kEdges) {
      const Index a = t.points[i], b = t.points[j];
      const double l = length(minus(mesh_.points[a], mesh_.points[b]));
      out.longest = std::max(out.longest, l);
      if (l < out.length) out.length = l, out.cells = {cell_of(a), cell_of(b)};
    }
    return out;
  }

  /// Two faces of the model that meet in a tetrahedron at less than kSharp.
  struct Sharp {
    double degrees;
    Index f, g;
  };
  std::optional<Sharp> sharpest(const Mesh::Simplex<4>& t, const std::array<Vector, 4>& p) const {
    std::optional<Sharp> out;
    for (std::size_t e = 0; e < 6; ++e) {
      const double angle = dihedral(p, e);
      if (angle > (out ? out->degrees : kSharp)) continue;
      const auto f = cells_.face(t, kOthers[e][0]), g = cells_.face(t, kOthers[e][1]);
      if (f && g) out = Sharp{angle, *f, *g};
    }
    return out;
  }

  bool is_line(Index a, Index b) const {
    return std::binary_search(lines_.begin(), lines_.end(), sorted(std::array{a, b}));
  }
  /// Segments, and sides of triangles of one face that are in two planes.
  void set_lines() {
    constexpr double kOnePlane = 1e-9;  // the sine between normals that rounding makes at most
    for (const auto& s : mesh_.segments) lines_.push_back(sorted(s.points));
    struct Side {
      std::array<Index, 2> ends;
      std::size_t triangle;
    };
    std::vector<Side> sides;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& t = mesh_.triangles[i].points;
      for (std::size_t k = 0; k < 3; ++k) sides.push_back({sorted(std::array{t[k], t[(k + 1) % 3]}), i});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.ends < b.ends; });
    const auto normal = [&](const Side& side) {
      const auto& t = mesh_.triangles[side.triangle].points;
      return cross(minus(mesh_.points[t[1]], mesh_.points[t[0]]), minus(mesh_.points[t[2]], mesh_.points[t[0]]));
    };
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      if (sides[i].ends != sides[i + 1].ends) continue;
      const Vector m = normal(sides[i]), n = normal(sides[i + 1]);
      if (!(length(cross(m, n)) <= kOnePlane * length(m) * length(n))) lines_.push_back(sides[i].ends);
    }
    sort_unique(lines_);
  }

  static void add(const std::string& leaf, std::vector<std::string>& out) {
    std::string text = shown(leaf);
    if (std::find(out.begin(), out.end(), text) == out.end()) out.push_back(std::move(text));
  }

  /// A face knows all leaves that it came from, by groups `from LEAF`; an edge or a vertex one, and the faces that
  /// meet there the others.
  void name(const Cell& cell, std::vector<std::string>& out) const {
    if (cell.dimension == 3) return;
    if (cell.dimension == 2) return name_face(cell.entity, out);
    const std::int32_t leaf = mesh_.entities[std::size_t(cell.dimension)][cell.entity].tags.leaf;
    if (leaf >= 0 && std::size_t(leaf) < leaves_.size()) add(leaves_[std::size_t(leaf)], out);
    auto at = std::lower_bound(faces_at_.begin(), faces_at_.end(), std::pair(cell.point, Index{0}));
    for (; at != faces_at_.end() && at->first == cell.point; ++at) name_face(at->second, out);
  }
  void name_face(Index entity, std::vector<std::string>& out) const {
    const std::size_t first = mesh_.groups[2].size() - mesh_.sources;
    for (const Index g : mesh_.entities[2][entity].groups) {
      if (g > first) add(mesh_.groups[2][g - 1].substr(std::string_view("from ").size()), out);
    }
  }

  std::string words(const Cell& cell) const {
    static constexpr char kLetter[] = "vefr";
    std::string text = kLetter[cell.dimension] + std::to_string(cell.entity);
    std::vector<std::string> names;
    name(cell, names);
    for (std::size_t i = 0; i < names.size(); ++i) {
      text += (i == 0 ? " of `" : i + 1 < names.size() ? ", `" : " and `") + names[i] + "`";
    }
    return text;
  }

  std::string why(const Mesh::Simplex<4>& t, const std::array<Vector, 4>& p) const {
    if (const auto near = gap(t)) {
      // A vertex is all in one place; others may be nearer elsewhere.
      return words(with_point(near->a, t)) + " and " + words(with_point(near->b, t)) + " are " +
             short_text(near->width) + " apart" + (near->a.dimension == 0 ? "" : " here");
    }
    if (const auto edge = sharpest(t, p))
      return words(face_cell(edge->f)) + " and " + words(face_cell(edge->g)) + " meet at " +
             short_text(edge->degrees) + " degrees";
    const Shortest s = shortest_edge(t);
    const auto& [a, b] = s.cells;
    if (s.is_short() && a.dimension < 3 && b.dimension < 3) {
      const std::string apart = short_text(s.length) + " apart";
      return MeshCell(a) == MeshCell(b) ? "points of " + words(a) + " are " + apart
                                        : words(a) + " and " + words(b) + ", which touch, have points " + apart;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const auto f = cells_.face(t, k);
      const Cell corner = cell_of(t.points[k]);
      if (!f || corner.dimension == 3) continue;
      const Vector &o = p[(k + 1) % 4], n = cross(minus(p[(k + 2) % 4], o), minus(p[(k + 3) % 4], o));
      const double height = std::fabs(dot(minus(p[k], o), n)) / length(n);
      if (height < kShort * s.longest)
        return words(corner) + " is " + short_text(height) + " from the plane of " + words(face_cell(*f));
    }
    const std::string near = between(p, kShort * s.longest);
    return near.empty() ? "no local move makes it better" : near;
  }

  /// The two faces that are nearest to its middle, where both together are nearer than `most` and do not meet
  /// there.
  std::string between(const std::array<Vector, 4>& p, double most) const {
    Vector middle{};
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (p[0][k] + p[1][k] + p[2][k] + p[3][k]) / 4;
    struct Near {
      double distance = HUGE_VAL;
      std::size_t triangle = 0;
    };
    std::map<Index, Near> faces;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      std::array<Vector, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh_.points[mesh_.triangles[i].points[k]];
      const double distance = std::sqrt(squared_distance(middle, corners));
      if (distance >= most) continue;
      Near& near = faces[mesh_.triangles[i].entity];
      if (distance < near.distance) near = {distance, i};
    }
    if (faces.size() < 2) return {};
    std::vector<std::pair<double, Index>> order;
    for (const auto& [face, near] : faces) order.emplace_back(near.distance, face);
    std::partial_sort(order.begin(), order.begin() + 2, order.end());
    const double apart = order[0].first + order[1].first;
    const auto& a = mesh_.triangles[faces[order[0].second].triangle].points;
    const auto& b = mesh_.triangles[faces[order[1].second].triangle].points;
    if (apart >= most || std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end()) return {};
    return words(face_cell(order[0].second)) + " and " + words(face_cell(order[1].second)) + " are within " +
           short_text(apart) + " of each other";
  }
};

}  // namespace

namespace {

/// Where doubles lose the determinant: exactly, and rounded in the end, so that no tetrahedron of a mesh, all of
/// which are turned right, is told to be flat.
TetrahedronMeasures exact_measures_of(const std::array<Vector, 4>& p) {
  const RationalPoint a = from_doubles(p[0]), u = from_doubles(p[1]) - a, v = from_doubles(p[2]) - a,
                      w = from_doubles(p[3]) - a;
  const RationalPoint vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const RationalPoint center = dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv;
  const double det = std::fabs(to_double(dot(u, vw)));
  TetrahedronMeasures out;
  double squares = 0, shortest = std::numeric_limits<double>::infinity();
  out.dihedral = 180;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [i, j] = kEdges[e];
    const auto& [k, l] = kOthers[e];
    const Vector along = minus(p[j], p[i]);
    squares += dot(along, along), shortest = std::min(shortest, dot(along, along));
    const RationalPoint o = from_doubles(p[i]), to = from_doubles(p[j]) - o;
    const double cosine = to_double(dot(cross(to, from_doubles(p[k]) - o), cross(to, from_doubles(p[l]) - o)));
    out.dihedral = std::min(out.dihedral, std::atan2(length(along) * det, cosine) * 180 / std::numbers::pi);
  }
  const double side = std::cbrt(det / 2);  // its square does not vanish as that of the determinant may
  out.shape = 12 * side * side / squares;
  out.radius_edge = std::sqrt(to_double(dot(center, center)) / shortest) / (2 * det);
  out.volume = det / 6;
  return out;
}

}  // namespace

TetrahedronMeasures measures_of(const std::array<std::array<double, 3>, 4>& p) {
  constexpr double kLost = 1e-6;  // of the product of three edges; doubles are off by 1e-15 of it
  const Vector u = minus(p[1], p[0]), v = minus(p[2], p[0]), w = minus(p[3], p[0]);
  if (!(std::fabs(dot(u, cross(v, w))) > kLost * length(u) * length(v) * length(w))) return exact_measures_of(p);
  TetrahedronMeasures out;
  out.shape = shape_of(p[0], p[1], p[2], p[3]);
  out.dihedral = 180;
  for (std::size_t e = 0; e < 6; ++e) out.dihedral = std::min(out.dihedral, dihedral(p, e));
  out.radius_edge = radius_edge_of(p[0], p[1], p[2], p[3]);
  out.volume = std::fabs(dot(minus(p[1], p[0]), cross(minus(p[2], p[0]), minus(p[3], p[0])))) / 6;
  return out;
}

MeshQuality quality_of(const Mesh& mesh, const std::vector<std::string>& leaves, double radius_edge,
                       double volume) {
  constexpr double kDigits = 1e-9;  // of the bound, which TetGen computes with in another way
  MeshQuality out;
  out.regions.resize(mesh.entities[3].size());
  std::vector<double> all, of_region;
  std::vector<std::pair<double, std::size_t>> bad;
  const auto median = [](std::vector<double>& shapes) {
    if (shapes.empty()) return 1.0;
    const auto middle = shapes.begin() + std::ptrdiff_t(shapes.size() / 2);
    std::nth_element(shapes.begin(), middle, shapes.end());
    return *middle;
  };
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const auto& t = mesh.tetrahedra[i];
    std::array<Vector, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = mesh.points[t.points[k]];
    const TetrahedronMeasures m = measures_of(p);
    auto& region = out.regions[t.entity];
    region.worst = std::min(region.worst, m.shape);
    out.largest_radius_edge = std::max(out.largest_radius_edge, m.radius_edge);
    out.smallest_dihedral = std::min(out.smallest_dihedral, m.dihedral);
    region.beyond += radius_edge > 0 && m.radius_edge > radius_edge;
    out.larger += volume > 0 && m.volume > volume * (1 + kDigits);
    out.largest = std::max(out.largest, m.volume);
    ++out.shapes[std::min<std::size_t>(std::size_t(m.shape * 20), 19)];
    ++out.dihedrals[std::min<std::size_t>(std::size_t(m.dihedral / 5), 17)];
    ++out.ratios[std::size_t(std::clamp((m.radius_edge - 0.6) * 5, 0.0, double(out.ratios.size() - 1)))];
    if (m.shape < MeshQuality::kBad) {
      ++region.bad;
      bad.emplace_back(m.shape, i);
    }
    all.push_back(m.shape), of_region.push_back(m.shape);
    if (i + 1 < mesh.tetrahedra.size() && mesh.tetrahedra[i + 1].entity == t.entity) continue;
    region.median = median(of_region);
    of_region.clear();
  }
  for (const auto& region : out.regions) {
    out.worst = std::min(out.worst, region.worst);
    out.beyond += region.beyond;
  }
  out.median = median(all);
  out.bad = bad.size();
  out.extent = Reach(mesh.points).longest_side();
  if (bad.empty()) return out;
  const std::size_t shown = std::min(bad.size(), MeshQuality::kShown);
  std::partial_sort(bad.begin(), bad.begin() + std::ptrdiff_t(shown), bad.end());
  const Explainer explainer(mesh, leaves);
  for (const auto& [shape, i] : bad) {
    out.forced += explainer.is_forced(mesh.tetrahedra[i]);
    if (const auto gap = explainer.gap(mesh.tetrahedra[i])) {
      if (++out.near == 1 || gap->width < out.narrowest) out.narrowest = gap->width;
    }
  }
  for (std::size_t i = 0; i < shown; ++i) {
    out.worst_ones.push_back(explainer.explain(mesh.tetrahedra[bad[i].second]));
    out.worst_ones.back().tetrahedron = bad[i].second;
  }
  return out;
}

std::string forced_text(const MeshQuality& quality) {
  if (quality.forced == 0) return {};
  return counted(quality.forced, "of them is", "of them are") +
         " where faces or edges of the model meet at less than " + short_text(MeshQuality::kForced) +
         " degrees: no tetrahedron there has a shape of 0.1";
}

std::string joining_text(const MeshQuality& quality) {
  constexpr double kMany = 0.01;
  constexpr double kDrawn = 1e-4;  // of the extent: a narrower gap nobody drew
  const auto all = std::accumulate(quality.shapes.begin(), quality.shapes.end(), std::size_t{0});
  if (quality.near == 0) return {};
  if (double(quality.near) <= kMany * double(all) && quality.narrowest > kDrawn * quality.extent) return {};
  return "in " + std::to_string(quality.near) + " of them two cells of the model nearly touch, the nearest " +
         short_text(quality.narrowest) + " apart; `cnrg check --features` lists what is near, and --join joins it";
}

std::string larger_text(const MeshQuality& quality) {
  if (quality.larger == 0) return {};
  return counted(quality.larger, "tetrahedron is", "tetrahedra are") + " larger than --max-volume, the largest " +
         short_text(quality.largest);
}

PlaceText::PlaceText(const Mesh& mesh) {
  const Reach all(mesh.points);
  const double largest = all.largest, extent = all.longest_side();
  constexpr int kMost = std::numeric_limits<double>::max_digits10;
  if (extent > 0) digits_ = std::min(kMost, digits_ + std::max(0, int(std::ceil(std::log10(largest / extent)))));
}

std::string PlaceText::operator()(const std::array<double, 3>& at) const {
  std::string text;
  for (const double x : at) {
    char buffer[32];
    if (!text.empty()) text += " ";
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, digits_).ptr);
  }
  return text;
}

TriangleQuality triangle_quality_of(const Mesh& mesh, const std::vector<std::string>& leaves) {
  TriangleQuality out;
  std::vector<std::pair<double, std::size_t>> angles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    double least = 180;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = mesh.triangles[i].points;
      const Vector &p = mesh.points[t[k]], &q = mesh.points[t[(k + 1) % 3]], &r = mesh.points[t[(k + 2) % 3]];
      const Vector a = minus(q, p), b = minus(r, p);
      least = std::min(least, std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi);
    }
    ++out.angles[std::min<std::size_t>(std::size_t(least / 5), out.angles.size() - 1)];
    angles.emplace_back(least, i);
  }
  const std::size_t shown = std::min(angles.size(), MeshQuality::kShown);
  std::partial_sort(angles.begin(), angles.begin() + std::ptrdiff_t(shown), angles.end());
  const Explainer explainer(mesh, leaves);
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [angle, number] = angles[i];
    const Mesh::Simplex<3>& t = mesh.triangles[number];
    TriangleQuality::Bad bad{{}, angle, explainer.nodes_of(t), number};
    for (const Index p : t.points)
      for (std::size_t k = 0; k < 3; ++k) bad.at[k] += mesh.points[p][k] / 3;
    out.worst_ones.push_back(std::move(bad));
  }
  return out;
}

}  // namespace cnrg
