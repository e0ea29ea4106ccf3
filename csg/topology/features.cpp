#include "csg/topology/features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "csg/evaluate/diagnostics.h"
#include "csg/result/flat_drawing.h"
#include "csg/result/part_text.h"
#include "csg/result/result_data.h"
#include "csg/text/digits.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

using Index = Parts::Index;

/// Degrees of the angle whose sine and cosine are as a root and a number, up to a common factor; kSharp for all
/// that are much larger.
double degrees(const Rational& squared_sine, const Rational& cosine) {
  const Rational squared_cosine = cosine * cosine;
  if (cosine <= 0 || squared_sine > 4 * squared_cosine) return kSharp;  // its tangent is the root of 3
  return rounded::arc_tangent(nearest_root(squared_sine / squared_cosine), 1) * 180 / std::numbers::pi;
}

class Finder {
 public:
  Finder(const Parts& parts, const std::optional<Rational>& below) : parts_(parts), below_(below) {}

  std::vector<Feature> run() {
    for (const Near kind : kNears) add_distances(kind);
    put(distances_, std::numeric_limits<std::size_t>::max());
    add_lengths();
    put(lengths_, below_ ? std::numeric_limits<std::size_t>::max() : kTold);
    for (const Parts::Triangle& t : parts_.triangles()) {
      const Index face = parts_.facets()[t.facet].face;
      for (std::size_t k = 0; k < 3; ++k)
        left_of_[{face, t.corners[k], t.corners[(k + 1) % 3]}] = t.corners[(k + 2) % 3];
    }
    add_dihedral_angles();
    put(dihedral_, kTold);
    add_face_angles();
    put(angles_, kTold);
    return std::move(out_);
  }

 private:
  const Parts& parts_;
  const std::optional<Rational>& below_;
  std::vector<Feature> out_, distances_, lengths_, dihedral_, angles_;
  std::map<std::array<Index, 3>, Index> left_of_;  // by face and a side: the corner of the triangle to its left

  const RationalPoint& x(Index p) const { return parts_.points()[p]; }
  RationalPoint direction(Index p, Index q) const { return whole(x(q) - x(p)); }

  void put(std::vector<Feature>& list, std::size_t most) {
    std::stable_sort(list.begin(), list.end(), [](const Feature& a, const Feature& b) {
      const int order = cmp(a.squared, b.squared);
      if (order != 0) return order < 0;
      return std::tie(a.value, a.cells) < std::tie(b.value, b.cells);
    });
    if (list.size() > most) list.resize(most);
    std::move(list.begin(), list.end(), std::back_inserter(out_));
  }

  void add_distances(Near kind) {
    const auto pairs = below_ ? near_pairs(parts_, kind, *below_, Ends::left_out)
                              : nearest_pairs(parts_, kind, kTold, Ends::left_out);
    for (const NearPair& pair : pairs) {
      const auto cells = cells_of(parts_, kind, pair.a, pair.b);
      distances_.push_back({Feature::Kind::distance,
                            nearest_root(pair.squared),
                            pair.squared,
                            {cells.begin(), cells.end()},
                            {pair.at_a, pair.at_b}});
    }
  }

  void add_lengths() {
    for (Index s = 0; s < parts_.segments().size(); ++s) {
      const auto& [a, b] = parts_.segments()[s].ends;
      const RationalPoint d = x(b) - x(a);
      const Rational square = dot(d, d);
      if (below_ && square >= *below_ * *below_) continue;
      lengths_.push_back(
          {Feature::Kind::length, nearest_root(square), square, {parts_.cell_of_segment(s)}, {x(a), x(b)}});
    }
  }

  /// The smallest at each edge.
  void add_dihedral_angles() {
    const FlatComplex& flat = parts_.flat();
    for (Index e = 0; e < flat.edges.size(); ++e) {
      const FlatComplex::Edge& edge = flat.edges[e];
      std::vector<Index> faces;
      for (const Index side : edge.around) faces.push_back(side / 2);
      sort_unique(faces);
      std::optional<Feature> least;
      for_each_segment(edge, [&](Index p, Index q) {
        const RationalPoint axis = direction(p, q);
        const std::vector<Triangle> around = triangles_around(p, q, axis, faces);
        for (std::size_t i = around.size() < 3 ? 1 : 0; i < around.size(); ++i) {
          const Triangle &one = around[i], &next = around[(i + 1) % around.size()];
          const double angle = between(axis, one.way, next.way);
          if (least && least->value <= angle) continue;
          least = Feature{Feature::Kind::dihedral_angle,
                          angle,
                          0,
                          {{1, e}, {2, std::min(one.face, next.face)}, {2, std::max(one.face, next.face)}},
                          {x(p), x(q)}};
        }
      });
      if (least && least->value < kSharp) dihedral_.push_back(std::move(*least));
    }
  }

  /// A triangle with the side pq: its face, and the direction of its third corner.
  struct Triangle {
    Index face;
    RationalPoint way;
  };
  /// Counter-clockwise around the axis pq; a face that has the piece on both sides is there twice.
  std::vector<Triangle> triangles_around(Index p, Index q, const RationalPoint& axis,
                                         const std::vector<Index>& faces) const {
    std::vector<Triangle> out;
    for (const Index f : faces) {
      for (const auto& [a, b] : {std::pair(p, q), std::pair(q, p)}) {
        const auto found = left_of_.find({f, a, b});
        if (found != left_of_.end()) out.push_back({f, direction(p, found->second)});
      }
    }
    if (out.size() < 3) return out;
    const RationalPoint up = cross(axis, out[0].way), ahead = cross(up, axis);
    const auto part = [&](const Triangle& t) {  // below the plane of the first one, on it, above, opposite
      const int side = sgn(dot(up, t.way));
      return side != 0 || dot(ahead, t.way) > 0 ? 1 + side : 3;
    };
    std::sort(out.begin(), out.end(), [&](const Triangle& a, const Triangle& b) {
      const int of_a = part(a), of_b = part(b);
      return of_a != of_b ? of_a < of_b : dot(axis, cross(a.way, b.way)) > 0;
    });
    return out;
  }
  static double between(const RationalPoint& axis, const RationalPoint& u, const RationalPoint& v) {
    const Rational length = dot(axis, axis), volume = dot(axis, cross(u, v));
    return degrees(length * volume * volume, length * dot(u, v) - dot(u, axis) * dot(v, axis));
  }

  void add_face_angles() {
    const FlatComplex& flat = parts_.flat();
    for (Index f = 0; f < flat.faces.size(); ++f) {
      for (const FlatComplex::Loop& loop : flat.faces[f].loops) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const Index p = loop[k], next = loop[(k + 1) % loop.size()],
                      before = loop[(k + loop.size() - 1) % loop.size()];
          const RationalPoint u = direction(p, next), v = direction(p, before), normal = cross(u, v);
          const auto left = left_of_.find({f, p, next});
          require(left != left_of_.end(), "features: a side of a face has no triangle");
          const RationalPoint front = cross(u, direction(p, left->second));
          const Rational cosine = dot(u, v);
          const int turn = sgn(dot(normal, front));
          if (turn < 0 || (is_zero(normal) && cosine > 0)) continue;  // more than half a turn
          const double angle = degrees(dot(normal, normal), cosine);
          if (!(angle < kSharp)) continue;
          angles_.push_back({Feature::Kind::face_angle, angle, 0, {{2, f}, parts_.cell_of_point(p)}, {x(p)}});
        }
      }
    }
  }
};

std::string word(const Feature& feature) {
  constexpr std::array<const char*, 3> kDimensions{"vertex", "edge", "face"};
  switch (feature.kind) {
    case Feature::Kind::distance:
      return std::string(kDimensions[std::size_t(feature.cells[0].dimension)]) + "-" +
             kDimensions[std::size_t(feature.cells[1].dimension)];
    case Feature::Kind::length: return "length";
    case Feature::Kind::dihedral_angle: return "dihedral angle";
    default: return "face angle";
  }
}

/// All points in the closure of a cell, ascending.
std::vector<Index> closed_cells(const Parts& parts, const Parts::Cell& cell) {
  const FlatComplex& flat = parts.flat();
  std::vector<Index> out;
  if (cell.dimension == 0) out = {flat.vertices[cell.number].point};
  if (cell.dimension == 1)
    out.assign(flat.edges[cell.number].points.begin(), flat.edges[cell.number].points.end());
  if (cell.dimension == 2) {
    const std::vector<Parts::Facet>& facets = parts.facets();  // ascending by face
    auto facet = std::ranges::lower_bound(facets, cell.number, {}, &Parts::Facet::face);
    for (; facet != facets.end() && facet->face == cell.number; ++facet)
      out.insert(out.end(), facet->corners.begin(), facet->corners.end());
  }
  sort_unique(out);
  return out;
}
bool touching(const Parts& parts, const Parts::Cell& a, const Parts::Cell& b) {
  return !in_common(closed_cells(parts, a), closed_cells(parts, b)).empty();
}

}  // namespace

std::vector<Feature> features(const Result& result, const std::optional<Rational>& below) {
  if (below && *below <= 0) {
    throw InputError("features nearer than a distance are listed, which must be positive, and is " +
                     to_decimal(*below, 6));
  }
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  require_bounds(flat, "the result has no bounds", ": distances are told of such results only");
  return Finder(Parts(view, flat), below).run();
}

namespace {

/// Did both cells come from the same leaves?
bool are_of_same_leaves(const FlatComplex& flat, const std::array<Parts::Cell, 2>& cells) {
  return std::ranges::equal(origin_of(flat, cells[0]).leaves, origin_of(flat, cells[1]).leaves);
}

enum class Pairs : bool { all, of_different_leaves };

/// `joins` is followed by a distance.
std::string nearly_touching(const ResultView& view, const FlatComplex& flat, const std::string& joins, Pairs which,
                            const Watch& watch) {
  constexpr double kUndrawn = 1e-6;
  constexpr std::size_t kMostTold = 10'000;  // of parts: exact distances of more take seconds
  const Parts parts(view, flat);
  const double reach = parts.diagonal() * kUndrawn;
  if (!(reach > 0) || !std::isfinite(reach)) return {};
  const double step = std::pow(10, std::floor(std::log10(reach)));  // one digit, rounded up
  const std::string remedy = "; `cnrg check --features` lists what is near, and " + joins +
                             decimal(std::ceil(reach / step) * step, "%.3g") + " joins it";
  std::set<std::array<Parts::Cell, 2>> told;
  std::map<std::array<Parts::Cell, 2>, bool> left_out;
  Rational least;
  for (const Near kind : kNears) {
    const auto pairs = near_pairs_if_few(parts, kind, from_double(reach), kMostTold, Ends::left_out, watch);
    if (!pairs) {
      return "more than " + std::to_string(kMostTold) +
             " pairs of parts do not touch and are nearer than a millionth of the model" + remedy;
    }
    for (const NearPair& pair : *pairs) {
      auto cells = cells_of(parts, kind, pair.a, pair.b);
      if (cells[1] < cells[0]) std::swap(cells[0], cells[1]);
      const auto [known, fresh] = left_out.try_emplace(cells, false);
      if (fresh) {
        known->second = (which == Pairs::of_different_leaves && are_of_same_leaves(flat, cells)) ||
                        touching(parts, cells[0], cells[1]);
      }
      if (known->second) continue;
      if (told.empty() || pair.squared < least) least = pair.squared;
      told.insert(cells);
    }
  }
  if (told.empty()) return {};
  return counted(told.size(), "pair of cells does", "pairs of cells do") + " not touch and " +
         (told.size() == 1 ? "is" : "are") + " nearer than a millionth of the model, " +
         (told.size() == 1 ? "" : "the nearest ") + decimal(nearest_root(least), "%.3g") + " apart" + remedy;
}

/// Do the walls between its components alone have more facets, since they lie in more planes?
bool has_more_walls(const Result& result, std::size_t most) {
  const Complex& complex = result.complex();
  IdVector<RegionId, Component> component(complex.region_count, 0);
  for (const auto& [region, of] : result.selection().regions) component[region] = of;
  std::vector<PlaneId> planes;
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto [front, back] = complex.face_regions[f];
    if (component[front] != component[back]) planes.push_back(complex.plane(f));
  }
  sort_unique(planes);
  return planes.size() > most;
}

std::string nearly_touching_notice(const Result& result, const Watch& watch) {
  constexpr std::size_t kMostFacets = 20'000;
  if (has_more_walls(result, kMostFacets)) return {};
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  std::size_t facets = 0;
  for (const auto& face : flat.faces) facets += face.triangles.size();
  if (facets > kMostFacets || reaches_frame(flat)) return {};
  return nearly_touching(view, flat, "`weld` or --join ", Pairs::of_different_leaves, watch);
}

}  // namespace

std::string nearly_touching_text(const Result& result, const Watch& watch) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  require_bounds(flat, "the result has no bounds", ": distances are told of such results only");
  return nearly_touching(view, flat, "--join ", Pairs::all, watch);
}

std::vector<Diagnostic> near_and_lost(const Tree& tree, const Evaluation& evaluation, NodeId node,
                                      const Watch& watch) {
  std::vector<Diagnostic> all = lost_names(tree, evaluation, node);
  const std::string text = nearly_touching_notice(evaluation.result(node), watch);
  if (!text.empty()) {
    const Node& shown = tree.nodes[node];
    all.push_back({tree.file, shown.operator_at, Diagnostic::Level::notice, "`" + shown.name + "`: " + text});
  }
  return all;
}

std::string features_text(const Result& result, const std::vector<Feature>& features) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  Table table({"<feature", "<value", "<cells", "<at", "<from"});
  for (const Feature& feature : features) {
    std::string value, cells, at, from;
    const bool angle = feature.kind >= Feature::Kind::dihedral_angle;
    if (angle) value = to_decimal(from_double(feature.value), 6) + " degrees";
    else value = double_text(feature.value);
    for (const Parts::Cell& cell : feature.cells) {
      cells += (cells.empty() ? "" : " ") + name_of(cell);
      from += (from.empty() ? "" : " | ") + names_of_leaves(view, origin_of(flat, cell));
    }
    for (const RationalPoint& p : feature.at) at += (at.empty() ? "" : " ") + coordinates(p);
    table.add_row({word(feature), value, cells, at, from});
  }
  return table.text();
}

}  // namespace cnrg
