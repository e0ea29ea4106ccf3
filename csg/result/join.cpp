#include "csg/result/join.h"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "csg/result/flat_drawing.h"
#include "csg/result/join_drawing.h"
#include "csg/result/part_text.h"
#include "csg/result/relabel.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/vanished.h"
#include "csg/text/digits.h"
#include "csg/text/table.h"
#include "kernel/base/limits.h"
#include "kernel/base/part_watch.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

using Index = Parts::Index;
constexpr int kMostRounds = 64;

/// Rounds of one attempt seldom have no end, and those of another one, where other things meet first, do not share
/// the reason.
struct Attempt {
  double factor;  ///< of the distance: what is nearer than this is joined
  int patience;   ///< rounds before corners take what is farther
};
/// No attempt is made after those before have looked at so many points, in all of their rounds.
constexpr std::size_t kMostWork = 20'000;
constexpr Attempt kAttempts[] = {{1, 8}, {1.25, 8}, {1.5, 8}, {2, 8}, {1, 4}, {1.25, 4}, {1.5, 4}};

/// Where things meet that never met before: where they are exactly, if that takes no more digits than what is
/// constructed once from doubles does; else at the nearest point of a grid that is far finer than the distance. A
/// foot on a facet whose corners are feet has some ten times their digits, so those of exact places would grow
/// tenfold in each round.
class JoinPlaces {
 public:
  explicit JoinPlaces(const Rational& within) : step_(1) {
    while (kFiner * step_ > within) step_ /= 2;
    while (2 * kFiner * step_ <= within) step_ *= 2;
  }
  /// All points of a result whose coordinates are to be kept.
  void keep(const std::vector<RationalPoint>& points) { kept_.insert(points.begin(), points.end()); }

  bool keeps(const RationalPoint& p) const { return kept_.contains(p); }

  RationalPoint near(const RationalPoint& p) const {
    if (std::all_of(p.begin(), p.end(), is_brief) || keeps(p)) return p;
    RationalPoint out = p;
    for (Rational& x : out) {
      if (is_brief(x)) continue;
      const Rational steps = x / step_ + Rational(1, 2);
      Integer whole;
      mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
      x = whole * step_;
    }
    return out;
  }

 private:
  static constexpr int kFiner = 1024;
  static constexpr std::size_t kMostBits = 1024;
  Rational step_;
  std::set<RationalPoint> kept_;

  static bool is_brief(const Rational& x) { return bits_of(x) <= kMostBits; }
};

/// What one round moves, and which of its pairs that joins, each with the place where.
struct Plan {
  JoinMoves moves;
  std::vector<std::pair<const NearPair*, RationalPoint>> joined;
};

class Planner {
 public:
  /// What is nearer than `corner` (its square; 0: nothing) to a corner of what it meets goes to that corner.
  /// `reversed`: of points the last in the order of preference stay.
  Planner(const Parts& parts, const JoinPlaces& places, Rational corner, bool reversed)
      : parts_(parts), places_(places), corner_(std::move(corner)), reversed_(reversed) {
    list_facets();
    for (const RationalPoint& p : parts.points()) plan_.moves.to.push_back(places.near(p));
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
    // Those that hold most, then those of the result, then those with fewest digits, then by coordinates.
    std::vector<std::tuple<Rank, bool, std::size_t, Index>> preferred;
    for (const Index p : order) {
      const auto [walls, all] = rank_of_point(p);
      const RationalPoint& at = parts_.points()[p];
      preferred.push_back({{-walls, -all}, !places_.keeps(at), bits_of(at), p});
    }
    std::sort(preferred.begin(), preferred.end());
    if (reversed_) std::reverse(preferred.begin(), preferred.end());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::get<Index>(preferred[i]);
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
        plan_.moves.to[p] = plan_.moves.to[q];
        plan_.joined.emplace_back(pair, plan_.moves.to[q]);
        break;
      }
    }
    return std::move(plan_);
  }

  /// Points with segments, points with facets, segments with segments.
  Plan meet(const std::vector<NearPair>& pairs) {
    std::vector<std::pair<Rank, const NearPair*>> order;
    for (const NearPair& pair : pairs) order.emplace_back(rank_of_target(pair), &pair);
    // A point that goes somewhere goes to what holds most.
    std::stable_sort(order.begin(), order.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
    for (const auto& [rank, pair] : order) {
      if (pair->kind == Near::segments) meet_segments(*pair);
      else meet_point(*pair);
    }
    return std::move(plan_);
  }

 private:
  const Parts& parts_;
  const JoinPlaces& places_;
  std::vector<std::vector<Index>> facets_of_;  // of each point, ascending
  std::vector<RationalPoint> normals_;         // of each facet
  const Rational corner_;
  const bool reversed_;
  Plan plan_;
  std::vector<char> moved_;
  std::set<std::pair<std::pair<Near, Index>, RationalPoint>> jointed_;

  static Index other(const NearPair& pair, Index p) { return pair.a == p ? pair.b : pair.a; }

  /// Of how many planes with independent normals a point or part is: first those of walls and boundaries of
  /// regions, then those of sheets, too. Wires hold nothing.
  using Rank = std::pair<int, int>;

  void list_facets() {
    facets_of_.resize(parts_.points().size());
    normals_.resize(parts_.facets().size());
    for (const Parts::Triangle& t : parts_.triangles()) {
      const auto& x = parts_.points();
      if (is_zero(normals_[t.facet]))
        normals_[t.facet] = cross(x[t.corners[1]] - x[t.corners[0]], x[t.corners[2]] - x[t.corners[0]]);
    }
    for (Index f = 0; f < parts_.facets().size(); ++f) {
      for (const Index p : parts_.facets()[f].corners) facets_of_[p].push_back(f);
    }
  }

  bool is_wall(Index facet) const {
    const auto& [front, back] = parts_.flat().faces[parts_.facets()[facet].face].regions;
    return front != back;
  }

  Rank rank(const std::vector<Index>& facets) const {
    const auto independent = [&](bool walls) {
      std::vector<const RationalPoint*> basis;
      for (const Index f : facets) {
        if (basis.size() == 3 || (walls && !is_wall(f))) continue;
        const RationalPoint& n = normals_[f];
        if (basis.empty() || (basis.size() == 1 && !is_zero(cross(*basis[0], n))) ||
            (basis.size() == 2 && dot(cross(*basis[0], *basis[1]), n) != 0))
          basis.push_back(&n);
      }
      return int(basis.size());
    };
    return {independent(true), independent(false)};
  }
  Rank rank_of_point(Index p) const { return rank(facets_of_[p]); }
  Rank rank_of_segment(Index s) const {
    const auto& [a, b] = parts_.segments()[s].ends;
    return rank(in_common(facets_of_[a], facets_of_[b]));
  }
  Rank rank_of_part(const NearPair& pair) const {
    return pair.kind == Near::point_facet ? rank({pair.b}) : rank_of_segment(pair.b);
  }
  Rank rank_of_target(const NearPair& pair) const {
    return std::max(pair.kind == Near::segments ? rank_of_segment(pair.a) : rank_of_point(pair.a),
                    rank_of_part(pair));
  }

  /// False if the part has a joint there already: the pair will be met in the next round.
  bool add_joint(Near on, Index part, const RationalPoint& at, const RationalPoint& to) {
    if (!jointed_.insert({{on, part}, at}).second) return false;
    plan_.moves.joints.push_back({on, part, at, to});
    return true;
  }

  /// The nearest of some points that is nearer to `at` than `corner_`.
  std::optional<Index> corner_near(const RationalPoint& at, std::span<const Index> corners) const {
    std::optional<Index> nearest;
    Rational least = corner_;
    for (const Index c : corners) {
      const RationalPoint d = parts_.points()[c] - at;
      const Rational square = dot(d, d);
      if (square >= least || moved_[c]) continue;
      least = square;
      nearest = c;
    }
    return nearest;
  }
  std::span<const Index> corners_of(const NearPair& pair) const {
    if (pair.kind == Near::point_facet) return parts_.facets()[pair.b].corners;
    return parts_.segments()[pair.b].ends;
  }
  /// Two points, of which one goes to the other and neither goes anywhere else in this round.
  void meet_corner(const NearPair& pair, Index p, Index c) {
    if (moved_[p] || moved_[c] || p == c) return;
    const bool goes = rank_of_point(p) <= rank_of_point(c);
    const RationalPoint to = plan_.moves.to[goes ? c : p];
    plan_.moves.to[goes ? p : c] = to;
    moved_[p] = moved_[c] = 1;
    plan_.joined.emplace_back(&pair, to);
  }

  void meet_point(const NearPair& pair) {
    const Index p = pair.a;
    if (moved_[p]) return;
    if (const auto corner = corner_near(parts_.points()[p], corners_of(pair)))
      return meet_corner(pair, p, *corner);
    const bool goes = rank_of_point(p) <= rank_of_part(pair);
    const RationalPoint to = goes ? places_.near(pair.at_b) : plan_.moves.to[p];
    if (!add_joint(pair.kind, pair.b, pair.at_b, to)) return;
    plan_.joined.emplace_back(&pair, to);
    moved_[p] = goes;
    plan_.moves.to[p] = to;
  }

  void meet_segments(const NearPair& pair) {
    constexpr Near kOn = Near::point_segment;
    if (jointed_.contains({{kOn, pair.a}, pair.at_a}) || jointed_.contains({{kOn, pair.b}, pair.at_b})) return;
    const auto first = corner_near(pair.at_a, parts_.segments()[pair.a].ends);
    const auto second = corner_near(pair.at_b, parts_.segments()[pair.b].ends);
    if (first && second) return meet_corner(pair, *first, *second);
    const RationalPoint to =
        places_.near(rank_of_segment(pair.a) >= rank_of_segment(pair.b) ? pair.at_a : pair.at_b);
    add_joint(kOn, pair.a, pair.at_a, to);
    add_joint(kOn, pair.b, pair.at_b, to);
    plan_.joined.emplace_back(&pair, to);
  }
};

std::size_t active_regions(const FlatComplex& flat) {
  std::size_t n = 0;
  for (Index r = 0; r < flat.regions.size(); ++r) n += flat.active(r);
  return n;
}

void require_smaller_than_result(const Rational& within, const Parts& parts) {
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

/// One attempt: rounds that join what is nearer than `reach`, so that nothing is left that is nearer than
/// `within`.
class Joiner {
 public:
  Joiner(const Result& result, const Rational& within, const Rational& reach, int patience, Joins joins,
         const Watch& watch)
      : watch_(watch),
        joins_(joins),
        within_(within),
        reach_(reach),
        patience_(patience),
        data_(std::make_shared<Result::Data>(result.data())),
        flat_(flatten(data_->view())),
        places_(within) {
    require_bounds(flat_, "features can be joined only of a result that has bounds", "");
    report_.reach = reach;
    report_.regions_before = report_.regions_after = active_regions(flat_);
    const Parts parts(data_->view(), flat_);
    require_smaller_than_result(within_, parts);
    places_.keep(parts.points());
    most_points_ = 2 * parts.points().size() + kFewPoints;
  }

  void run() {
    while (join_once()) {
      report_.regions_after = active_regions(flat_);
      work_ += flat_.points.size();
    }
    report_.lost_regions = lost_.lines(components_with_regions(flat_));
  }

  const JoinReport& report() const { return report_; }
  std::size_t work() const { return work_; }    ///< points, counted in each round
  bool is_harmful() const { return harmful_; }  ///< and has ended for that
  std::shared_ptr<const Result::Data> data() const { return data_; }

 private:
  static constexpr std::size_t kFewPoints = 256;
  const Watch& watch_;
  const Joins joins_;
  const Rational within_, reach_;
  const int patience_;  // rounds
  JoinReport report_;
  std::shared_ptr<Result::Data> data_;
  FlatComplex flat_;
  JoinPlaces places_;
  std::size_t most_points_ = 0, work_ = 0;
  bool harmful_ = false;
  LostRegions lost_;

  /// Thin triangles with sides longer than the distance and heights below it would be bent back and forth: when
  /// rounds become many, what is somewhat farther from corners goes there. 0: nothing does.
  Rational corner_reach() const {
    return report_.rounds < patience_ ? Rational(0) : Rational((report_.rounds < 2 * patience_ ? 2 : 4) * within_);
  }
  /// Another round might move something farther than a result is allowed to be moved.
  bool is_exhausted() const {
    const double next = to_double(std::max<Rational>(reach_, corner_reach()));
    return report_.rounds >= kMostRounds ||
           report_.displacement + next * (1 + 0x1p-50) > kMostJoinMoves * to_double(within_);
  }

  std::vector<NearPair> pairs_of_a_round(const Parts& parts, const Watch& watch) const {
    const auto near = [&](Near kind) { return near_pairs(parts, kind, reach_, Ends::paired, watch); };
    std::vector<NearPair> pairs = near(Near::points);
    if (pairs.empty()) pairs = near(Near::point_segment);
    if (!pairs.empty()) return pairs;
    pairs = near(Near::point_facet);
    std::vector<NearPair> more = near(Near::segments);
    std::move(more.begin(), more.end(), std::back_inserter(pairs));
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const NearPair& x, const NearPair& y) { return x.squared < y.squared; });
    return pairs;
  }

  /// The end: what is nearer than asked for all the same, of the first kind that there is, as in a round.
  void give_up(const Parts& parts) {
    for (const Near kind : kNears) {
      const std::vector<NearPair> pairs = near_pairs(parts, kind, within_, Ends::paired, watch_);
      if (pairs.empty()) continue;
      report_.remaining = pairs.size();
      report_.nearest = nearest_root(pairs.front().squared);
      return;
    }
  }

  bool join_once() {
    const Watch watch = part_of(watch_, "join, round " + std::to_string(report_.rounds + 1));
    watch.begin("parts");
    const ResultView view = data_->view();
    const Parts parts(view, flat_);
    watch.check();
    const std::vector<NearPair> pairs = pairs_of_a_round(parts, watch);
    if (pairs.empty()) return false;
    harmful_ = joins_ == Joins::harmless && pairs.size() > kFewPairs;
    if (harmful_) return false;
    if (is_exhausted()) {
      give_up(parts);
      return false;
    }
    // What crosses again where it crossed before, after its points have gone to a corner, is broken by letting the
    // corner go.
    const bool reversed = report_.rounds >= 2 * patience_ && report_.rounds / patience_ % 2 == 1;
    const Rational reach = corner_reach();
    watch.begin("meet");
    Planner planner(parts, places_, reach * reach, reversed);
    watch.check();
    const bool points = pairs.front().kind == Near::points;
    const Plan plan = points ? planner.meet_points(pairs) : planner.meet(pairs);
    watch.begin("move");
    const auto made =
        std::make_shared<const Relabelled>(*relabel(view, flat_, move(parts, plan.moves, watch), false, watch));
    Result::Data next = relabelled(*data_, made);
    watch.check();
    FlatComplex flat = flatten(next.view());
    watch.check();
    most_points_ += plan.moves.joints.size();  // of two surfaces in one place the edges cross in as many
    if (flat.points.size() > most_points_) {   // what moves crosses more than it joins
      give_up(parts);
      return false;
    }
    const bool lost =
        !made->lost_regions.empty() || !made->lost_wires.empty() || active_regions(flat) != report_.regions_before;
    harmful_ = joins_ == Joins::harmless && lost;
    if (harmful_) return false;
    const bool first = report_.rounds++ == 0;
    for (const auto& [pair, place] : plan.joined) {
      report_.merged.push_back(text_of(view, parts, pair->kind, pair->a, pair->b, first) + ", at " +
                               coordinates(place) + ": " + distance_text(pair->squared) + " apart");
    }
    report_.displacement += made->report.displacement;
    report_.lost_faces += made->lost_faces.size();
    report_.lost_wires += made->lost_wires.size();
    for (const Index r : made->lost_regions) lost_.add(view, flat_, r, first);
    *data_ = std::move(next);
    flat_ = std::move(flat);
    return true;
  }
};

}  // namespace

Result join(const Result& result, const Rational& within, JoinReport* report, const Watch& watch, Joins joins) {
  if (within <= 0) {
    throw InputError("the distance within which features are joined must be positive, and is " +
                     to_decimal(within, 6));
  }
  JoinReport best;
  std::shared_ptr<const Result::Data> data;
  std::size_t work = 0;
  for (const auto& [factor, patience] : kAttempts) {
    Joiner joiner(result, within, from_double(factor) * within, patience, joins, watch);
    joiner.run();
    if (joiner.is_harmful()) {
      if (report != nullptr) *report = {}, report->refused = true;
      return result;
    }
    if (data == nullptr || joiner.report().remaining < best.remaining) {
      best = joiner.report();
      data = joiner.data();
    }
    work += joiner.work();
    if (best.remaining == 0 || work > kMostWork) break;
  }
  watch.check();
  if (report != nullptr) *report = best;
  return best.rounds > 0 ? Result(settled(*data)) : result;
}

std::string JoinReport::text(const Rational& within) const {
  const std::string d = to_decimal(within, 6);
  if (rounds == 0) return "nothing is nearer than " + d + " that does not touch; nothing was joined";
  std::string text = "joined " + counted(merged.size(), "pair", "pairs") + " nearer than " + to_decimal(reach, 6) +
                     ", in " + counted(std::size_t(rounds), "round", "rounds") + "; nothing moved by more than " +
                     double_text(displacement) + vanished_text(lost_faces, lost_wires, lost_regions.size());
  if (regions_before != regions_after) {
    text += "; there were " + counted(regions_before, "region", "regions") + " and are " +
            std::to_string(regions_after);
  }
  return text;
}

std::vector<std::string> JoinReport::warnings(const Rational& within) const {
  const std::string d = to_decimal(within, 6);
  std::vector<std::string> out = vanished_warnings(lost_regions, d);
  if (remaining > 0) {
    out.push_back(counted(remaining, "pair is", "pairs are") + " still nearer than " + d + " after " +
                  counted(std::size_t(rounds), "round", "rounds") + ", the nearest " + double_text(nearest) +
                  " apart; give another distance");
  }
  return out;
}

}  // namespace cnrg
