// Gathers the pieces of all leaves on their carriers, links and cuts them, and tessellates anew; see the header.
#include "csg/carriers/nets.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "csg/carriers/classes.h"
#include "csg/carriers/common_steps.h"
#include "csg/carriers/cuts.h"
#include "csg/carriers/net_carriers.h"
#include "csg/carriers/placed_nets.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// Pairs of intervals that have more than a point in common; `visit(i, j)`.
template <class Visit>
void each_overlap(const std::vector<std::array<Rational, 2>>& intervals, Visit visit) {
  std::vector<std::size_t> order(intervals.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto low = [&](std::size_t i) -> const Rational& { return std::min(intervals[i][0], intervals[i][1]); };
  const auto high = [&](std::size_t i) -> const Rational& { return std::max(intervals[i][0], intervals[i][1]); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && low(order[j]) < high(order[i]); ++j) visit(order[i], order[j]);
  }
}

/// A strand on its carrier.
struct Run {
  std::size_t strand;
  std::array<Rational, 2> at;
};
/// A curve swept along a vector, on its carrier by its projection.
struct Wall {
  Run run;
  std::array<Rational, 2> heights;
  std::size_t number;  // of `walls_alike_`
};
/// A piece of a patch on its carrier: by the carrier's parameters.
struct Sheet {
  std::array<Run, 2> along;
};

class CommonNetsOfLeaves {
 public:
  explicit CommonNetsOfLeaves(const std::vector<LeafInstance>& instances) : instances_(instances) { gather(); }

  std::vector<LeafInstance> run() {
    for (PlacedNets& leaf : leaves_) place(leaf);
    link();
    if (cuts_.concerned().empty()) return instances_;
    cuts_.spread();
    for (const PlacedNets& leaf : leaves_) {
      if (cuts_.concerned().contains(leaf.owner)) ask(leaf);
    }
    steps_ = std::make_shared<const AgreedSteps>(common_steps_.agree());
    std::vector<LeafInstance> result = instances_;
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
    std::vector<PlacedNets> all;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
      const LeafInstance& instance = instances_[i];
      if (!PlacedNets::has_nets(instance) || instance.transform.determinant() == 0) continue;
      std::array<Rational, 12> entries;
      for (std::size_t k = 0; k < 12; ++k) {
        entries[k] = k < 9 ? instance.transform.linear[k / 3][k % 3] : instance.transform.offset[k - 9];
      }
      const auto [it, is_new] = known.try_emplace({instance.leaf.get(), std::move(entries)}, all.size());
      if (is_new) all.emplace_back(instance, i);
      all[it->second].instances.push_back(i);
    }
    std::vector<bool> touches(all.size(), false);
    std::vector<std::size_t> order(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) order[i] = i;
    // Along the axis along which they are spread most.
    std::size_t axis = 0;
    Rational most = -1;
    for (std::size_t k = 0; k < 3 && !all.empty(); ++k) {
      const auto by = [k](const PlacedNets& a, const PlacedNets& b) { return a.low[k] < b.low[k]; };
      const auto [first, last] = std::minmax_element(all.begin(), all.end(), by);
      const Rational spread = last->low[k] - first->low[k];
      if (spread > most) most = spread, axis = k;
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return all[a].low[axis] < all[b].low[axis]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const PlacedNets& a = all[order[i]];
      for (std::size_t j = i + 1; j < order.size() && all[order[j]].low[axis] <= a.high[axis]; ++j) {
        if (!a.touches(all[order[j]])) continue;
        touches[order[i]] = touches[order[j]] = true;
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (touches[i]) leaves_.push_back(std::move(all[i]));
    }
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
      std::vector<std::array<Rational, 2>> intervals;
      for (const Run& run : runs) intervals.push_back(run.at);
      each_overlap(intervals, [&](std::size_t i, std::size_t j) {
        cuts_.link(runs[i].strand, runs[i].at, runs[j].strand, runs[j].at);
      });
    }
    // Walls need the same rulings where they overlap or stand on each other.
    for (const std::vector<Wall>& walls : walls_) {
      std::vector<std::array<Rational, 2>> intervals;
      for (const Wall& wall : walls) intervals.push_back(wall.run.at);
      each_overlap(intervals, [&](std::size_t i, std::size_t j) {
        const Wall &a = walls[i], &b = walls[j];
        if (a.heights[1] < b.heights[0] || b.heights[1] < a.heights[0]) return;
        cuts_.link(a.run.strand, a.run.at, b.run.strand, b.run.at);
        walls_alike_.join(a.number, b.number);
      });
    }
    for (const std::vector<Sheet>& sheets : sheets_) {
      std::vector<std::array<Rational, 2>> intervals;
      for (const Sheet& sheet : sheets) intervals.push_back(sheet.along[0].at);
      each_overlap(intervals, [&](std::size_t i, std::size_t j) {
        const auto &a = sheets[i].along, &b = sheets[j].along;
        if (!cuts_.link(a[1].strand, a[1].at, b[1].strand, b[1].at)) return;
        cuts_.link(a[0].strand, a[0].at, b[0].strand, b[0].at);
      });
    }
  }

  /// What the cut pieces of a leaf ask for.
  void ask(const PlacedNets& leaf) {
    for (const PlacedPiece& piece : leaf.pieces) {
      for (const NetPiece& part : piece.parts(cuts_)) {
        const auto [it, is_new] = finest_.try_emplace(canonical(part.patch).patch.net, leaf.fineness());
        if (!is_new) it->second.join(leaf.fineness());
        for (std::size_t k = 0; k < 4; ++k) common_steps_.ask(part.patch.side(k), leaf.fineness());
        for (std::size_t d = 0; d < 2; ++d) {
          const BezierPatch way = d == 0 ? part.patch : transposed(part.patch);
          if (const std::optional<Sweep> sweep = sweep_of(way))
            tie({way.net[0]}, *sweep, piece.strand[d], leaf.fineness());
        }
      }
    }
    for (const PlacedCurve& curve : leaf.curves) {
      for (const CurvePiece& part : curve.parts(cuts_)) {
        if (leaf.sweep()) tie(part.curve, *leaf.sweep(), curve.strand, leaf.fineness());
        else common_steps_.ask(part.curve, leaf.fineness());
      }
    }
  }

  /// The rims of a wall have the steps of all walls on the same surface.
  void tie(const BezierCurve& rim, const Sweep& sweep, std::size_t strand, const Fineness& fineness) {
    const std::size_t near = common_steps_.ask(rim, fineness);
    common_steps_.tie(near, common_steps_.ask({sweep.far_rim(rim.net)}, fineness));
    const auto wall = wall_of_.find(strand);
    if (wall == wall_of_.end()) return;  // flat
    const std::size_t kind = 1 + walls_alike_.first_of(wall->second);
    common_steps_.tie(near, common_steps_.number({sweep.projected(rim.net)}, kind));
  }

  std::shared_ptr<const PreparedLeaf> tessellate_anew(const PlacedNets& leaf) const {
    try {
      return leaf.tessellated(cuts_, finest_, steps_);
    } catch (const InputError& e) {
      throw InputError("leaf " + std::to_string(leaf.owner) + ": " + e.what());
    }
  }

  const std::vector<LeafInstance>& instances_;
  std::vector<PlacedNets> leaves_;
  CurveCarriers curves_;
  SurfaceCarriers surfaces_;
  std::vector<std::vector<Run>> runs_;          // by carrier
  std::vector<std::vector<Wall>> walls_;        // by carrier
  std::vector<std::vector<Sheet>> sheets_;      // by carrier
  Classes walls_alike_;                         // walls that need the same rulings
  std::map<std::size_t, std::size_t> wall_of_;  // by strand
  Cuts cuts_;
  FinestPatches finest_;
  CommonSteps common_steps_;
  std::shared_ptr<const AgreedSteps> steps_;
};

}  // namespace

std::vector<LeafInstance> with_common_nets(const std::vector<LeafInstance>& instances) {
  return CommonNetsOfLeaves(instances).run();
}

}  // namespace cnrg
