// Gathers the pieces of all leaves on their carriers, links and cuts them, and tessellates anew; see the header.
#include "csg/carriers/nets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "csg/carriers/cuts.h"
#include "csg/carriers/net_carriers.h"
#include "csg/carriers/placed_nets.h"
#include "csg/curves/boundary_curves.h"
#include "kernel/base/leaf_words.h"
#include "kernel/base/union_find.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using RationalRange = std::array<Rational, 2>;  // in either order

using RationalRanges = std::array<RationalRange, 3>;

/// A box that holds the product of intervals, whatever doubles round.
Box interval_box(const RationalRanges& intervals) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::nextafter(to_double(intervals[k][0]), -std::numeric_limits<double>::infinity());
    box.hi[k] = std::nextafter(to_double(intervals[k][1]), std::numeric_limits<double>::infinity());
  }
  return box;
}

/// Calls `visit(a, b)` for items whose intervals meet: for all pairs but that, of items with equal intervals, one
/// stands for all. It is visited with each of the others, so that they all hang together.
template <class Item, class IntervalsOf, class Visit>
void each_meeting(const std::vector<Item>& items, IntervalsOf intervals_of, Visit visit) {
  std::map<RationalRanges, std::size_t> first;
  std::vector<std::size_t> different;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < items.size(); ++i) {
    RationalRanges intervals = intervals_of(items[i]);
    for (RationalRange& along : intervals) {
      if (along[1] < along[0]) std::swap(along[0], along[1]);
    }
    const auto [it, is_new] = first.try_emplace(std::move(intervals), i);
    if (!is_new) {
      visit(items[it->second], items[i]);
      continue;
    }
    different.push_back(i);
    boxes.push_back(interval_box(it->first));
  }
  if (boxes.size() < 2) return;
  const BoxTree tree(boxes);
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    tree.query([&](const Box& box) { return box.meets(boxes[j]); },
               [&](std::uint32_t i) {
                 if (i < j) visit(items[different[i]], items[different[j]]);
               });
  }
}

/// How many steps a curve has that several leaves have, each with a fineness of its own.
///
/// All that must have equal steps are tied into one class: a curve in many leaves, and the two rims of a wall of
/// an extrusion with those of other walls on the same surface. A class has as many steps as the most that any
/// curve in it needs for all that is asked of the class.
class CommonSteps {
 public:
  /// A leaf has the curve and asks for a fineness and further lines, at parameters between 0 and 1. Returns its
  /// number.
  std::uint32_t ask(const BezierCurve& curve, const Fineness& fineness, const std::vector<Rational>& lines) {
    const std::uint32_t i = number(curve, 0);
    if (!lines.empty()) {
      const bool reversed = canonical(curve).reversed;
      for (const Rational& t : lines) asked_[i].lines.insert(reversed ? Rational(1 - t) : t);
    }
    std::optional<Fineness>& all = asked_[i].fineness;
    if (all) all->join(fineness);
    else all = fineness;
    return i;
  }
  /// A number for what is no curve of a leaf: a projected one; those of different `kind`, from 1, are different.
  std::uint32_t number(const BezierCurve& curve, std::size_t kind) {
    BezierCurve least = canonical(curve).curve;
    const auto [it, is_new] = numbers_.try_emplace({kind, least.net}, std::uint32_t(classes_.size()));
    if (is_new) {
      asked_.push_back({std::move(least), std::nullopt, {}});
      classes_.add();
    }
    return it->second;
  }
  /// Both get the same even steps.
  void tie(std::uint32_t a, std::uint32_t b) { classes_.unite(a, b); }
  /// Steps of all curves that were asked for.
  AgreedSteps agree() {
    std::map<std::uint32_t, Fineness> joined;
    for (std::uint32_t i = 0; i < asked_.size(); ++i) {
      if (!asked_[i].fineness) continue;
      const auto [it, is_new] = joined.try_emplace(classes_.find(i), *asked_[i].fineness);
      if (!is_new) it->second.join(*asked_[i].fineness);
    }
    std::map<std::uint32_t, int> most;
    for (std::uint32_t i = 0; i < asked_.size(); ++i) {
      if (!asked_[i].fineness) continue;
      int& steps = most[classes_.find(i)];
      steps = std::max(steps, BoundaryCurves(joined.at(classes_.find(i))).steps(asked_[i].curve));
    }
    AgreedSteps result;
    for (std::uint32_t i = 0; i < asked_.size(); ++i) {
      if (asked_[i].fineness)
        result[asked_[i].curve.net] = {most.at(classes_.find(i)), rounded_lines(asked_[i].lines)};
    }
    return result;
  }

 private:
  struct Asked {
    BezierCurve curve;  // canonical
    std::optional<Fineness> fineness;
    std::set<Rational> lines{};
  };
  std::map<std::pair<std::size_t, ControlRow>, std::uint32_t> numbers_;
  std::vector<Asked> asked_;
  UnionFind classes_;
};

/// A strand on its carrier.
struct Run {
  std::size_t strand;
  RationalRange at;
};
/// A curve swept along a vector, on its carrier by its projection.
struct Wall {
  Run run;
  RationalRange heights;
  std::uint32_t number;  // of `walls_alike_`
};
/// A piece of a patch on its carrier: by the carrier's parameters.
struct Sheet {
  std::array<Run, 2> along;
};

class CommonNetsOfLeaves {
 public:
  CommonNetsOfLeaves(const std::vector<LeafInstance>& instances, const ExtraOfInstances& extra)
      : instances_(instances), extra_(extra) {
    gather();
  }

  std::vector<LeafInstance> run(std::set<std::uint32_t>* drawn) {
    for (PlacedNets& leaf : leaves_) place(leaf);
    link();
    std::vector<LeafInstance> result = instances_;
    const std::set<std::size_t> shared = cuts_.concerned();
    for (PlacedNets& leaf : leaves_) add_lines(leaf, shared.contains(leaf.owner), result, drawn);
    if (cuts_.concerned().empty()) return result;
    cuts_.spread();
    for (const PlacedNets& leaf : leaves_) {
      if (cuts_.concerned().contains(leaf.owner)) ask(leaf);
    }
    steps_ = std::make_shared<const AgreedSteps>(common_steps_.agree());
    for (const PlacedNets& leaf : leaves_) {
      if (!cuts_.concerned().contains(leaf.owner)) continue;
      const std::shared_ptr<const PreparedLeaf> made = tessellate_anew(leaf);
      for (const std::size_t i : leaf.instances) result[i] = {made, {}};
    }
    return result;
  }

 private:
  /// Leaves with nets, each once per transform, that may touch another by their boxes.
  void gather() {
    std::map<std::pair<const PreparedLeaf*, std::array<Rational, 12>>, std::size_t> known;
    std::map<const PreparedLeaf*, PlacedNets::Extent> extents;
    std::vector<PlacedNets> all;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
      const LeafInstance& instance = instances_[i];
      if (!PlacedNets::has_nets(instance) || instance.transform->determinant() == 0) continue;
      std::array<Rational, 12> entries;
      for (std::size_t k = 0; k < 12; ++k) {
        entries[k] = k < 9 ? instance.transform->linear[k / 3][k % 3] : instance.transform->offset[k - 9];
      }
      const auto [it, is_new] = known.try_emplace({instance.leaf.get(), std::move(entries)}, all.size());
      if (is_new) {
        const auto extent = extents.try_emplace(instance.leaf.get());
        if (extent.second) extent.first->second = PlacedNets::extent_of(*instance.leaf);
        all.emplace_back(instance, extent.first->second, i);
      }
      all[it->second].instances.push_back(i);
    }
    std::set<std::size_t> touching;  // by owner
    each_meeting(
        all, [](const PlacedNets& leaf) { return leaf.extent; },
        [&](const PlacedNets& a, const PlacedNets& b) {
          touching.insert({a.owner, b.owner});
        });
    for (PlacedNets& leaf : all) {
      const bool has_lines = std::any_of(leaf.instances.begin(), leaf.instances.end(), [&](std::size_t i) {
        return extra_.contains(static_cast<std::uint32_t>(i));
      });
      if (has_lines || touching.contains(leaf.owner)) leaves_.push_back(std::move(leaf));
    }
  }

  /// One that shares nothing is drawn in its own coordinates, by its own fineness, as without lines.
  void add_lines(PlacedNets& leaf, bool shared, std::vector<LeafInstance>& result,
                 std::set<std::uint32_t>* drawn) {
    const LeafInstance& given = instances_[leaf.owner];
    std::vector<ExtraLines> lines;
    for (const std::size_t i : leaf.instances) {
      const auto extra = extra_.find(static_cast<std::uint32_t>(i));
      if (extra == extra_.end()) continue;
      lines.push_back(extra->second);
      if (drawn != nullptr) drawn->insert(extra->first);
    }
    if (lines.empty()) return;
    if (shared || given.transform->identity()) {
      for (const ExtraLines& of : lines) leaf.add_lines(of, cuts_);
      return;
    }
    std::vector<LeafInstance> alone(lines.size(), {given.leaf, {}});
    ExtraOfInstances extra;
    for (std::uint32_t i = 0; i < lines.size(); ++i) extra[i] = std::move(lines[i]);
    alone = with_common_nets(alone, extra);
    for (const std::size_t i : leaf.instances) result[i].leaf = alone[0].leaf;
  }

  /// Makes the strands of a leaf and finds what they lie on.
  void place(PlacedNets& leaf) {
    leaf.place();
    for (PlacedPiece& piece : leaf.pieces) {
      for (std::size_t d = 0; d < 2; ++d) piece.strand[d] = cuts_.add_strand(leaf.owner);
      for (std::size_t k = 0; k < 4; ++k) {
        ControlRow side = piece.patch.side(k).net;
        if (k >= 2) std::reverse(side.begin(), side.end());  // as the parameter grows
        run_on(side, piece.strand[k % 2]);
      }
      for (std::size_t d = 0; d < 2; ++d) {
        const BezierPatch way = d == 0 ? piece.patch : transposed(piece.patch);
        if (const std::optional<Sweep> sweep = sweep_of(way)) add_wall(way.net[0], *sweep, piece.strand[d]);
      }
      const std::optional<OnSurface> on = surfaces_.place(piece.patch);
      if (!on) continue;
      sheets_.resize(std::max(sheets_.size(), on->carrier + 1));
      Sheet sheet;
      for (std::size_t d = 0; d < 2; ++d) sheet.along[on->axis[d]] = {piece.strand[d], on->at[d]};
      sheets_[on->carrier].push_back(std::move(sheet));
    }
    for (PlacedCurve& curve : leaf.curves) {
      curve.strand = cuts_.add_strand(leaf.owner);
      run_on(curve.net, curve.strand);
      if (!leaf.sweep()) continue;
      run_on(leaf.sweep()->far_rim(curve.net), curve.strand);
      add_wall(curve.net, *leaf.sweep(), curve.strand);
    }
  }

  void run_on(const ControlRow& net, std::size_t strand) {
    if (BezierCurve{net}.is_point()) return;  // a pole, where anything may end
    const std::optional<OnCurve> on = curves_.place(reduced(net));
    if (!on) return;
    runs_.resize(std::max(runs_.size(), on->carrier + 1));
    runs_[on->carrier].push_back({strand, on->at});
  }

  /// Each strand has one wall at most.
  void add_wall(const ControlRow& net, const Sweep& sweep, std::size_t strand) {
    const std::optional<OnCurve> on = curves_.place(reduced(sweep.projected(net)), sweep.direction);
    if (!on) return;
    walls_.resize(std::max(walls_.size(), on->carrier + 1));
    walls_[on->carrier].push_back({{strand, on->at}, sweep.heights(net), walls_alike_.add()});
    wall_of_[strand] = walls_[on->carrier].back().number;
  }

  void link() {
    for (const std::vector<Run>& runs : runs_) {
      each_meeting(
          runs, [](const Run& run) { return RationalRanges{run.at}; },
          [&](const Run& a, const Run& b) { cuts_.link(a.strand, a.at, b.strand, b.at); });
    }
    // Walls need the same rulings where they overlap or stand on each other.
    for (const std::vector<Wall>& walls : walls_) {
      each_meeting(
          walls,
          [](const Wall& wall) {
            return RationalRanges{wall.run.at, wall.heights};
          },
          [&](const Wall& a, const Wall& b) {
            if (a.heights[1] < b.heights[0] || b.heights[1] < a.heights[0]) return;
            cuts_.link(a.run.strand, a.run.at, b.run.strand, b.run.at);
            walls_alike_.unite(a.number, b.number);
          });
    }
    for (const std::vector<Sheet>& sheets : sheets_) {
      each_meeting(
          sheets,
          [](const Sheet& sheet) {
            return RationalRanges{sheet.along[0].at, sheet.along[1].at};
          },
          [&](const Sheet& a, const Sheet& b) {
            for (std::size_t d = 0; d < 2; ++d) {
              if (!Cuts::overlap(a.along[d].at, b.along[d].at)) return;
            }
            for (std::size_t d = 0; d < 2; ++d)
              cuts_.link(a.along[d].strand, a.along[d].at, b.along[d].strand, b.along[d].at);
          });
    }
  }

  /// What the cut pieces of a leaf ask for.
  void ask(const PlacedNets& leaf) {
    for (const PlacedPiece& piece : leaf.pieces) {
      for (const CutPiece& part : piece.parts(cuts_)) {
        const auto [it, is_new] = finest_.try_emplace(canonical(part.patch).patch.net, leaf.fineness());
        if (!is_new) it->second.join(leaf.fineness());
        for (std::size_t k = 0; k < 4; ++k) {
          std::vector<Rational> lines = part.lines[k % 2];
          if (k >= 2) {  // it runs backward
            for (Rational& t : lines) t = 1 - t;
          }
          common_steps_.ask(part.patch.side(k), leaf.fineness(), lines);
        }
        for (std::size_t d = 0; d < 2; ++d) {
          const BezierPatch way = d == 0 ? part.patch : transposed(part.patch);
          if (const std::optional<Sweep> sweep = sweep_of(way))
            tie({way.net[0]}, *sweep, piece.strand[d], leaf.fineness(), part.lines[d]);
        }
      }
    }
    for (const PlacedCurve& curve : leaf.curves) {
      for (const CutCurve& part : curve.parts(cuts_)) {
        if (leaf.sweep()) tie(part.curve, *leaf.sweep(), curve.strand, leaf.fineness(), part.lines);
        else common_steps_.ask(part.curve, leaf.fineness(), part.lines);
      }
    }
  }

  /// The rims of a wall have the steps of all walls on the same surface.
  void tie(const BezierCurve& rim, const Sweep& sweep, std::size_t strand, const Fineness& fineness,
           const std::vector<Rational>& lines) {
    const std::uint32_t near = common_steps_.ask(rim, fineness, lines);
    common_steps_.tie(near, common_steps_.ask({sweep.far_rim(rim.net)}, fineness, lines));
    const auto wall = wall_of_.find(strand);
    if (wall == wall_of_.end()) return;  // flat
    const std::size_t kind = 1 + walls_alike_.find(wall->second);
    common_steps_.tie(near, common_steps_.number({sweep.projected(rim.net)}, kind));
  }

  std::shared_ptr<const PreparedLeaf> tessellate_anew(const PlacedNets& leaf) const {
    try {
      return leaf.tessellated(cuts_, finest_, steps_);
    } catch (const InputError& e) {
      throw LeafError(LeafWords(LeafPlace{static_cast<std::uint32_t>(leaf.owner)}) + ": " + e.what());
    }
  }

  const std::vector<LeafInstance>& instances_;
  const ExtraOfInstances& extra_;
  std::vector<PlacedNets> leaves_;
  CurveCarriers curves_;
  SurfaceCarriers surfaces_;
  std::vector<std::vector<Run>> runs_;            // by carrier
  std::vector<std::vector<Wall>> walls_;          // by carrier
  std::vector<std::vector<Sheet>> sheets_;        // by carrier
  UnionFind walls_alike_;                         // walls that need the same rulings
  std::map<std::size_t, std::uint32_t> wall_of_;  // by strand
  Cuts cuts_;
  FinestPatches finest_;
  CommonSteps common_steps_;
  std::shared_ptr<const AgreedSteps> steps_;
};

}  // namespace

std::vector<LeafInstance> with_common_nets(const std::vector<LeafInstance>& instances,
                                           const ExtraOfInstances& extra, std::set<std::uint32_t>* drawn) {
  return CommonNetsOfLeaves(instances, extra).run(drawn);
}

}  // namespace cnrg
