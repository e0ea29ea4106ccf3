#include "csg/result/join.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "csg/geometry/exact_vectors.h"
#include "csg/result/join_drawing.h"
#include "csg/result/part_text.h"
#include "csg/result/relabel.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "kernel/exact/distance.h"

namespace cnrg {
namespace {

using Index = Parts::Index;
constexpr Index kNone = Parts::kNone;

/// What one round moves, and which of its pairs that joins.
struct Plan {
  Moves moves;
  std::vector<const NearPair*> joined;
};

class Planner {
 public:
  Planner(const Parts& parts, const std::set<RationalPoint>& given) : parts_(parts), given_(given) {
    rank_all();
    plan_.moves.to = parts.points();
    moved_.assign(parts.points().size(), 0);
  }

  Plan meet_points(const std::vector<NearPair>& pairs) {
    const std::size_t n = parts_.points().size();
    std::vector<std::vector<const NearPair*>> near(n);
    std::vector<Index> order;
    for (const NearPair& pair : pairs) {
      for (const Index p : {pair.a, pair.b}) {
        if (near[p].empty()) order.push_back(p);
        near[p].push_back(&pair);
      }
    }
    std::sort(order.begin(), order.end(), [&](Index p, Index q) { return preference(p) < preference(q); });
    std::vector<char> stays(n, 0), taken(n, 0);
    for (const Index p : order) {
      if (taken[p]) continue;
      stays[p] = 1;
      for (const NearPair* const pair : near[p]) taken[other(*pair, p)] = 1;
    }
    for (const Index p : order) {
      if (stays[p]) continue;
      for (const NearPair* const pair : near[p]) {  // the nearest first
        const Index q = other(*pair, p);
        if (!stays[q]) continue;
        plan_.moves.to[p] = parts_.points()[q];
        plan_.joined.push_back(pair);
        break;
      }
    }
    return std::move(plan_);
  }

  /// Points with segments, points with facets, segments with segments.
  Plan meet(const std::vector<NearPair>& pairs) {
    std::vector<const NearPair*> order;
    for (const NearPair& pair : pairs) order.push_back(&pair);
    // A point that goes somewhere goes to what holds most.
    std::stable_sort(order.begin(), order.end(), [&](const NearPair* x, const NearPair* y) {
      return rank_of_target(*x) > rank_of_target(*y);
    });
    for (const NearPair* const pair : order) {
      if (pair->kind == Near::segments) meet_segments(*pair);
      else meet_point(*pair);
    }
    return std::move(plan_);
  }

 private:
  const Parts& parts_;
  const std::set<RationalPoint>& given_;
  std::vector<int> face_rank_, point_rank_, segment_rank_;
  Plan plan_;
  std::vector<char> moved_;
  std::set<std::pair<std::pair<Near, Index>, RationalPoint>> jointed_;

  static Index other(const NearPair& pair, Index p) { return pair.a == p ? pair.b : pair.a; }

  /// 2: on the boundary of a region; 1: on a sheet; 0: on a wire, or by itself.
  void rank_all() {
    const FlatComplex& flat = parts_.flat();
    for (const FlatComplex::Face& f : flat.faces) face_rank_.push_back(f.regions[0] == f.regions[1] ? 1 : 2);
    point_rank_.assign(parts_.points().size(), 0);
    for (const Parts::Facet& facet : parts_.facets()) {
      for (const Index p : facet.corners) point_rank_[p] = std::max(point_rank_[p], face_rank_[facet.face]);
    }
    for (const Parts::Segment& s : parts_.segments()) {
      int rank = s.edge == kNone ? face_rank_[s.face] : 0;
      if (s.edge != kNone) {
        for (const Index side : flat.edges[s.edge].around) rank = std::max(rank, face_rank_[side / 2]);
      }
      segment_rank_.push_back(rank);
    }
  }

  std::tuple<int, bool, Index> preference(Index p) const {
    return {-point_rank_[p], !given_.contains(parts_.points()[p]), p};
  }

  int rank_of_part(const NearPair& pair) const {
    return pair.kind == Near::point_facet ? face_rank_[parts_.facets()[pair.b].face] : segment_rank_[pair.b];
  }
  int rank_of_target(const NearPair& pair) const {
    return pair.kind == Near::segments ? std::max(segment_rank_[pair.a], segment_rank_[pair.b])
                                       : std::max(point_rank_[pair.a], rank_of_part(pair));
  }

  /// False if the part has a joint there already: the pair will be met in the next round.
  bool add_joint(Near on, Index part, const RationalPoint& at, const RationalPoint& to) {
    if (!jointed_.insert({{on, part}, at}).second) return false;
    plan_.moves.joints.push_back({on, part, at, to});
    return true;
  }

  void meet_point(const NearPair& pair) {
    const Index p = pair.a;
    if (moved_[p]) return;
    const bool goes = point_rank_[p] < rank_of_part(pair);
    if (!add_joint(pair.kind, pair.b, pair.at_b, goes ? pair.at_b : parts_.points()[p])) return;
    plan_.joined.push_back(&pair);
    moved_[p] = goes;
    if (goes) plan_.moves.to[p] = pair.at_b;
  }

  void meet_segments(const NearPair& pair) {
    const bool first_stays = segment_rank_[pair.a] >= segment_rank_[pair.b];
    const auto joint = [&](bool first) {
      return std::pair(std::pair(Near::point_segment, first ? pair.a : pair.b), first ? pair.at_a : pair.at_b);
    };
    if (jointed_.contains(joint(true)) || jointed_.contains(joint(false))) return;
    const RationalPoint& to = first_stays ? pair.at_a : pair.at_b;
    add_joint(Near::point_segment, pair.a, pair.at_a, to);
    add_joint(Near::point_segment, pair.b, pair.at_b, to);
    plan_.joined.push_back(&pair);
  }
};

std::size_t active_regions(const FlatComplex& flat) {
  std::size_t n = 0;
  for (Index r = 0; r < flat.regions.size(); ++r) n += flat.active(r);
  return n;
}

/// `rock, r3, at (1, 2, 3)`: its name or its leaves, its number where that is still the one of the result that was
/// given, the first of its points.
std::string text_of_region(const ResultView& view, const FlatComplex& flat, Index r, bool numbered) {
  std::string text = attributes_of(view, flat.regions[r].component).name;
  if (text.empty()) text = "a region of " + names_of_leaves(view, flat.regions[r].origin);
  if (numbered) text += ", r" + std::to_string(r);
  Index first = kNone;
  for (const auto& shell : flat.regions[r].shells) {
    for (const Index side : shell) {
      for (const auto& t : flat.faces[side / 2].triangles) first = std::min({first, t[0], t[1], t[2]});
    }
  }
  if (first != kNone) text += ", at " + coordinates(view.complex->points.rational(flat.points[first]));
  return text;
}

void require_distance(const Rational& within, const Parts& parts) {
  if (within <= 0) {
    throw InputError("the distance within which features are joined must be positive, and is " +
                     to_decimal(within, 6));
  }
  const RationalPoint* low = nullptr;
  std::optional<RationalPoint> lo, hi;
  for (const RationalPoint& p : parts.points()) {
    if (low == nullptr) lo = hi = p;
    low = &p;
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] < (*lo)[k]) (*lo)[k] = p[k];
      if (p[k] > (*hi)[k]) (*hi)[k] = p[k];
    }
  }
  if (low == nullptr) return;
  const RationalPoint d = *hi - *lo;
  const Rational size = std::max({d[0], d[1], d[2]});
  if (size > 0 && within >= size) {
    throw InputError("features nearer than " + to_decimal(within, 6) +
                     " would be joined, but the whole result is " + to_decimal(size, 6) +
                     " long; give a smaller distance");
  }
}

class Joiner {
 public:
  Joiner(const Result& result, const Rational& within, JoinReport& report)
      : within_(within), report_(report), data_(std::make_shared<Result::Data>(result.data())) {}

  /// True if anything was joined.
  bool run() {
    flat_ = flatten(data_->view());
    require_bounds(flat_, "features can be joined only of a result that has bounds", "");
    report_.regions_before = report_.regions_after = active_regions(flat_);
    {
      const Parts parts(data_->view(), flat_);
      require_distance(within_, parts);
      const PointTable& table = data_->complex->points;
      for (std::size_t p = 0; p < parts.points().size(); ++p) {
        if (!table.is_constructed(flat_.points[p])) given_.insert(parts.points()[p]);
      }
    }
    while (join_once()) {
      flat_ = flatten(data_->view());
      report_.regions_after = active_regions(flat_);
    }
    return report_.rounds > 0;
  }

  std::shared_ptr<const Result::Data> data() const { return data_; }

 private:
  const Rational within_;
  JoinReport& report_;
  std::shared_ptr<Result::Data> data_;
  FlatComplex flat_;
  std::set<RationalPoint> given_;  // points of the input

  bool join_once() {
    const ResultView view = data_->view();
    const Parts parts(view, flat_);
    std::vector<NearPair> pairs = near_pairs(parts, Near::points, within_);
    const bool points = !pairs.empty();
    if (!points) pairs = near_pairs(parts, Near::point_segment, within_);
    if (pairs.empty()) {
      pairs = near_pairs(parts, Near::point_facet, within_);
      std::vector<NearPair> more = near_pairs(parts, Near::segments, within_);
      std::move(more.begin(), more.end(), std::back_inserter(pairs));
      std::stable_sort(pairs.begin(), pairs.end(),
                       [](const NearPair& x, const NearPair& y) { return x.squared < y.squared; });
    }
    if (pairs.empty()) return false;
    if (report_.rounds == kMostJoinRounds) {
      report_.remaining = pairs.size();
      report_.nearest = nearest_root(pairs.front().squared);
      return false;
    }
    Planner planner(parts, given_);
    const Plan plan = points ? planner.meet_points(pairs) : planner.meet(pairs);
    const bool first = report_.rounds++ == 0;
    for (const NearPair* const pair : plan.joined) {
      report_.merged.push_back(text_of(view, parts, pair->kind, pair->a, pair->b, first) + ", at " +
                               coordinates(pair->at_b) + ": " + distance_text(pair->squared) + " apart");
    }
    const auto made = std::make_shared<Relabelled>(*relabel(view, flat_, move(parts, plan.moves), false));
    report_.displacement += made->report.displacement;
    report_.lost_faces += made->lost_faces.size();
    report_.lost_wires += made->lost_wires.size();
    for (const Index r : made->lost_regions) report_.lost_regions.push_back(text_of_region(view, flat_, r, first));
    data_->complex = made->complex;
    data_->value = std::shared_ptr<const NodeValue>(made, &made->value);
    data_->simplified = std::shared_ptr<const SimplifiedComplex>(made, &made->simplified);
    data_->parameters = nullptr;
    data_->of_group = made->of_group;
    return true;
  }
};

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

}  // namespace

Result join(const Result& result, const Rational& within, JoinReport* report) {
  JoinReport own;
  Joiner joiner(result, within, report != nullptr ? *report : own);
  return joiner.run() ? Result(joiner.data()) : result;
}

std::string JoinReport::text(const Rational& within) const {
  const std::string d = to_decimal(within, 6);
  if (rounds == 0) return "nothing is nearer than " + d + " that does not touch; nothing was joined";
  std::string far;
  append(far, displacement);
  std::string text = "joined " + counted(merged.size(), "pair", "pairs") + " nearer than " + d + ", in " +
                     counted(std::size_t(rounds), "round", "rounds") + "; nothing moved by more than " + far;
  if (lost_faces > 0) text += "; " + counted(lost_faces, "face", "faces") + " vanished";
  if (lost_wires > 0) text += "; " + counted(lost_wires, "wire", "wires") + " vanished";
  if (!lost_regions.empty()) text += "; " + counted(lost_regions.size(), "region", "regions") + " vanished";
  if (regions_before != regions_after) {
    text += "; there were " + counted(regions_before, "region", "regions") + " and are " +
            std::to_string(regions_after);
  }
  return text;
}

}  // namespace cnrg
