#include "csg/weld/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "csg/text/table.h"
#include "csg/weld/near_sets.h"
#include "csg/weld/order.h"
#include "csg/weld/planes.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace welding {
namespace {

Rational square_distance(const RationalPoint& a, const RationalPoint& b) {
  const RationalPoint by = a - b;
  return dot(by, by);
}

/// Twice the area vector of a facet: of its outer loop less those of its holes, whatever their direction.
RationalPoint area(const WeldModel::Facet& facet, const std::vector<RationalPoint>& points) {
  RationalPoint total{0, 0, 0}, outer{0, 0, 0};
  for (std::size_t i = 0; i < facet.loops.size(); ++i) {
    const auto& loop = facet.loops[i];
    RationalPoint sum{0, 0, 0};
    for (std::size_t k = 1; k + 1 < loop.size(); ++k)
      sum = sum + cross(points[loop[k]] - points[loop[0]], points[loop[k + 1]] - points[loop[0]]);
    if (i == 0) outer = sum;
    total = i > 0 && dot(sum, outer) > 0 ? total - sum : total + sum;
  }
  return total;
}

std::vector<RationalPoint> areas(const WeldModel& model, const std::vector<RationalPoint>& points) {
  std::vector<RationalPoint> list;
  for (const WeldModel::Facet& facet : model.facets) list.push_back(area(facet, points));
  return list;
}

int sign_of_volume(const WeldModel& model, const WeldModel::Solid& solid,
                   const std::vector<RationalPoint>& points) {
  std::vector<Rational> parts;
  for (const auto& [f, outward] : solid.facets) {
    const WeldModel::Facet& facet = model.facets[f];
    const Rational part = dot(area(facet, points), points[facet.loops[0][0]]);
    parts.push_back(outward ? part : Rational(-part));
  }
  return sgn(sum(std::move(parts)));
}

[[noreturn]] void refuse(const WeldModel& model, const LeafWords& what, const Rational& d) {
  if (!model.only_planes) refuse_weld(model.subject, what, d);
  throw LeafError(model.subject + "fit: " + what + " if corners within " + to_decimal(d, 6) +
                  " of a plane moved onto it: give a smaller length");
}

class Welder {
 public:
  Welder(const WeldModel& model, const Rational& d) : model_(model), d_(d), square_(d * d), d_up_(rounded_up(d)) {}

  Weld run() {
    require(d_ > 0, "weld: the length is not above 0");
    number_points();
    if (model_.only_planes) keep_points();
    else join_points();
    planes_ = find_planes(model_, number_, points_, near_, spot_of_, d_);
    find_incidences();
    find_active();
    solve();
    finish();
    result_.only_planes = model_.only_planes;
    return std::move(result_);
  }

 private:
  // --- points

  /// Different points in lexicographic order, with numbers of theirs.
  void number_points() {
    const std::size_t count = model_.points.size();
    std::vector<Vector> near;
    for (const RationalPoint& p : model_.points) near.push_back(to_doubles(p));
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    // Rounding keeps the order of numbers, so doubles decide unless they are equal.
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return near[a][0] != near[b][0] ? near[a][0] < near[b][0] : model_.points[a] < model_.points[b];
    });
    number_.resize(count);
    for (const Index p : order) {
      if (points_.empty() || points_.back() != model_.points[p]) {
        points_.push_back(model_.points[p]);
        near_.push_back(near[p]);
      }
      number_[p] = static_cast<Index>(points_.size() - 1);
    }
  }
  /// Each point by itself.
  void keep_points() {
    spot_of_.resize(points_.size());
    std::iota(spot_of_.begin(), spot_of_.end(), Index{0});
    for (const Index p : spot_of_) spots_.push_back({p});
  }
  /// Clusters of points: from the nearest pair on, as long as all of one are within d of each other.
  void join_points() {
    std::vector<Box> boxes(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) boxes[i].extend(near_[i], near_[i]);
    const BoxTree tree(boxes);
    std::vector<Pair> near, left;
    for (Index a = 0; a < points_.size(); ++a) {
      const Box around = grown(boxes[a], d_up_);
      tree.query([&](const Box& box) { return box.meets(around); },
                 [&](Index b) {
                   if (b > a) near.push_back({a, b});
                 });
    }
    const auto apart = [&](Index a, Index b) { return square_distance(points_[a], points_[b]); };
    UnionFind sets = join(points_.size(), near, square_, apart, left);
    result_.left = left.size();
    if (!left.empty())
      result_.example = "the points " + describe(points_[left[0][0]]) + " and " + describe(points_[left[0][1]]);
    spot_of_.resize(points_.size());
    for (Index i = 0; i < points_.size(); ++i) {
      const Index first = sets.find(i);
      if (first == i) spots_.emplace_back();
      spot_of_[i] = first == i ? static_cast<Index>(spots_.size() - 1) : spot_of_[first];
      spots_[spot_of_[i]].push_back(i);
    }
  }

  /// A spot of one point is that point; of several, the middle of their box, in doubles.
  RationalPoint middle(const std::vector<Index>& members) const {
    RationalPoint low = points_[members[0]], high = low;
    for (const Index p : members) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], points_[p][k]);
        high[k] = std::max(high[k], points_[p][k]);
      }
    }
    if (low == high) return low;
    RationalPoint result = Rational(1, 2) * (low + high);
    for (Rational& x : result) x = from_double(to_double(x));
    const bool fits = std::all_of(members.begin(), members.end(),
                                  [&](Index p) { return square_distance(result, points_[p]) <= square_; });
    return fits ? result : points_[members[0]];
  }

  // --- who lies on what

  void find_incidences() {
    on_.resize(spots_.size());
    for (Index c = 0; c < planes_.carriers.size(); ++c) {
      for (const Index p : planes_.carriers[c].corners) on_[spot_of_[p]].push_back(c);
    }
    std::vector<Box> boxes;
    for (const Part& part : planes_.parts) boxes.push_back(part.box);
    const BoxTree tree(boxes);
    foreign_.resize(spots_.size());
    for (Index s = 0; s < spots_.size(); ++s) {
      std::vector<Index>& on = on_[s];
      sort_unique(on);
      if (model_.only_planes) continue;
      for (const Index p : spots_[s]) {
        Box at;
        at.extend(near_[p], near_[p]);
        const Box around = grown(at, d_up_);
        tree.query([&](const Box& box) { return box.meets(around); },
                   [&](Index part) { note_foreign(s, p, part); });
      }
      std::vector<Index>& more = foreign_[s];
      sort_unique(more);
      on.insert(on.end(), more.begin(), more.end());
      std::sort(on.begin(), on.end());
    }
  }

  /// A point near a face that it is no corner of.
  void note_foreign(Index spot, Index p, Index part) {
    const Index carrier = planes_.carrier_of[part];
    if (std::binary_search(on_[spot].begin(), on_[spot].end(), carrier)) return;
    const Plane& plane = planes_.carriers[carrier].plane;
    const Rational off = dot(plane.normal, points_[p]) - plane.offset;
    if (off * off > square_ * dot(plane.normal, plane.normal)) return;
    for (const Index facet : planes_.parts[part].facets) {
      if (!is_in(numbered_loops(model_, facet, number_), near_, planes_.parts[part].area, near_[p], d_up_))
        continue;
      foreign_[spot].push_back(carrier);
      return;
    }
  }

  /// What is near to something, and all that hangs on it by incidences. All else stays.
  void find_active() {
    const std::size_t spots = spots_.size();
    UnionFind sets(spots + planes_.carriers.size());
    const auto matters = [&](Index c) { return planes_.carriers[c].parts.size() > 1 || points_on_[c] > 3; };
    points_on_.assign(planes_.carriers.size(), 0);
    for (const auto& on : on_) {
      for (const Index c : on) ++points_on_[c];
    }
    for (Index s = 0; s < spots; ++s) {
      std::erase_if(on_[s], [&](Index c) { return !matters(c); });
      for (const Index c : on_[s]) sets.unite(s, static_cast<Index>(spots + c));
    }
    // Where triangles alone change their points, these points say all.
    std::vector<bool> active(spots + planes_.carriers.size(), false), on_planes = active;
    for (Index s = 0; s < spots; ++s) {
      bool near = spots_[s].size() > 1;
      for (const Index c : foreign_[s]) {
        const Plane& plane = planes_.carriers[c].plane;
        near = near || !planes_.carriers[c].exact || dot(plane.normal, points_[spots_[s][0]]) != plane.offset;
      }
      if (near) active[sets.find(s)] = true;
      if (!foreign_[s].empty()) on_planes[sets.find(s)] = true;
    }
    for (Index c = 0; c < planes_.carriers.size(); ++c) {
      const Carrier& carrier = planes_.carriers[c];
      const Index set = sets.find(static_cast<Index>(spots + c));
      if ((carrier.overlap || model_.only_planes) && !carrier.exact) active[set] = true;
      const bool polygons = std::any_of(carrier.parts.begin(), carrier.parts.end(),
                                        [&](Index p) { return planes_.parts[p].corners.size() > 3; });
      if (matters(c) && (carrier.overlap || polygons || model_.only_planes)) on_planes[set] = true;
    }
    for (Index s = 0; s < spots; ++s) {
      is_active_.push_back(active[sets.find(s)]);
      if (!on_planes[sets.find(s)]) on_[s].clear();
    }
    for (Index c = 0; c < planes_.carriers.size(); ++c) {
      const Index set = sets.find(static_cast<Index>(spots + c));
      carrier_active_.push_back(matters(c) && active[set] && on_planes[set]);
    }
  }

  // --- places

  void solve() {
    Incidence incidence;
    std::vector<Index> point(spots_.size()), plane(planes_.carriers.size());
    for (Index c = 0; c < planes_.carriers.size(); ++c) {
      if (!carrier_active_[c]) continue;
      plane[c] = static_cast<Index>(incidence.planes.size());
      auto& through = incidence.planes.emplace_back();
      through.plane = planes_.carriers[c].plane;
      through.parts = planes_.carriers[c].parts.size();
      for (const Index p : planes_.carriers[c].corners) through.corners.push_back(&points_[p]);
      if (through.parts > 1 && !planes_.carriers[c].exact) ++result_.joined_planes;
    }
    for (Index s = 0; s < spots_.size(); ++s) {
      if (!is_active_[s]) continue;
      point[s] = static_cast<Index>(incidence.points.size());
      auto& at = incidence.points.emplace_back();
      at.at = middle(spots_[s]);
      for (const Index p : spots_[s]) at.members.push_back(&points_[p]);
      for (const Index c : on_[s]) {
        at.planes.push_back(plane[c]);
        incidence.planes[plane[c]].points.push_back(point[s]);
      }
      result_.joined_points += spots_[s].size() - 1;
    }
    result_.off = place(incidence, d_);
    place_.resize(spots_.size());
    for (Index s = 0; s < spots_.size(); ++s)
      place_[s] = is_active_[s] ? incidence.points[point[s]].at : points_[spots_[s][0]];
  }

  void finish() {
    Rational farthest = 0;
    for (Index p = 0; p < points_.size(); ++p) {
      const Rational by = square_distance(points_[p], place_[spot_of_[p]]);
      if (by == 0) continue;
      ++result_.moved;
      farthest = std::max(farthest, by);
    }
    require(farthest <= square_, "weld: a point is moved too far");
    if (farthest > 0) {
      result_.farthest = std::min(std::sqrt(to_double(farthest)), to_double(d_));
    }
    result_.points.reserve(model_.points.size());
    for (const Index p : number_) result_.points.push_back(place_[spot_of_[p]]);
    for (const auto& [a, b] : planes_.left) {
      if (result_.left++ > 0) continue;
      result_.example =
          model_.face_name(planes_.parts[a].face) + " and " + model_.face_name(planes_.parts[b].face);
    }
    if (result_.changed()) check();
  }

  // --- what is refused

  void check() const {
    const std::vector<RationalPoint> before = areas(model_, model_.points), after = areas(model_, result_.points);
    std::vector<char> had(model_.faces.size(), 0), has(model_.faces.size(), 0);
    for (std::size_t f = 0; f < before.size(); ++f) {
      const Index face = model_.facets[f].face;
      if (!is_zero(before[f])) had[face] = 1;
      // A facet of a flat face that is turned over counts for nothing.
      if (model_.faces[face].curved ? !is_zero(after[f]) : dot(before[f], after[f]) > 0) has[face] = 1;
    }
    for (Index face = 0; face < had.size(); ++face) {
      if (had[face] != 0 && has[face] == 0 && !model_.faces[face].may_vanish)
        refuse(model_, model_.face_name(face) + " would vanish", d_);
    }
    for (const WeldModel::Solid& solid : model_.solids) check_solid(model_, solid, result_.points, d_);
  }

  const WeldModel& model_;
  const Rational d_, square_;
  double d_up_;
  std::vector<Index> number_;              // of the model's points: that of a different point
  std::vector<RationalPoint> points_;      // different ones
  std::vector<Vector> near_;               // the same in doubles
  std::vector<Index> spot_of_;             // of different points
  std::vector<std::vector<Index>> spots_;  // points that are joined
  Planes planes_;
  std::vector<std::vector<Index>> on_;       // the carriers on which a spot lies
  std::vector<std::vector<Index>> foreign_;  // of these, those that it is no corner on
  std::vector<std::size_t> points_on_;       // of carriers
  std::vector<bool> is_active_, carrier_active_;
  std::vector<RationalPoint> place_;  // of spots
  Weld result_;
};

}  // namespace
}  // namespace welding

void check_solid(const WeldModel& model, const WeldModel::Solid& solid, const std::vector<RationalPoint>& after,
                 const Rational& d) {
  const int was = welding::sign_of_volume(model, solid, model.points);
  const int is = was == 0 ? 0 : welding::sign_of_volume(model, solid, after);
  if (was != is)
    welding::refuse(model, solid.name + (is == 0 ? " would have no volume" : " would be turned inside out"), d);
}

void refuse_weld(const std::string& subject, const LeafWords& what, const Rational& d) {
  throw LeafError(subject + "weld: " + what + " if all that is within " + to_decimal(d, 6) +
                  " of each other were joined: give a smaller length");
}

Weld weld(const WeldModel& model, const Rational& d) { return welding::Welder(model, d).run(); }

LeafWords Weld::notice(const Rational& d) const {
  std::string words;
  if (changed()) {
    words = "moved " + counted(moved, "point", "points") + ", by " + decimal(farthest, "%.3g") + " at most";
    const std::string planes = "; " + counted(joined_planes, "plane", "planes");
    if (!only_planes)
      words += planes + " and " + counted(joined_points, "point", "points") + " joined with others";
    else if (joined_planes > 0) words += planes + " of several faces";
  }
  if (off > 0) {
    words += "; " + counted(off, "corner stays", "corners stay") +
             " off a plane, where more of them meet than can, and facets there are triangles";
  }
  if (left > 0) {
    words += (words.empty() ? "" : "; ") + counted(left, "pair is", "pairs are") +
             " near but not joined, since all that is joined has to lie within the length, such as ";
  }
  if (words.empty()) return {};
  return LeafWords((only_planes ? "fit " : "weld ") + to_decimal(d, 6) + ": " + words) + example;
}

}  // namespace cnrg
