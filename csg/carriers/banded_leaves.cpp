#include "csg/carriers/banded_leaves.h"

#include <algorithm>

namespace cnrg {
namespace {

using Index = std::uint32_t;

/// Of ascending lists.
bool share(const std::vector<Index>& x, const std::vector<Index>& y) {
  return std::any_of(x.begin(), x.end(), [&](Index i) { return std::binary_search(y.begin(), y.end(), i); });
}

/// Of straight pieces: true if they have more than ends in common.
bool lie_on_each_other(const MeridianPiece& p, const MeridianPiece& q) {
  if (p.kind != MeridianPiece::Kind::line || q.kind != MeridianPiece::Kind::line) return false;
  const auto slope = [](const MeridianPiece& x) { return MeridianPoint{x.to.r - x.from.r, x.to.t - x.from.t}; };
  const MeridianPoint a = slope(p), b = slope(q);
  return a.r * b.t == a.t * b.r && std::max(std::min(p.from.t, p.to.t), std::min(q.from.t, q.to.t)) <
                                       std::min(std::max(p.from.t, p.to.t), std::max(q.from.t, q.to.t));
}

LeafWords name_of(const BandedLeaves::Side& side) {
  LeafPlace place{side.instance};
  if (side.band != nullptr) place.faces.push_back(side.band->face);
  return place;
}

constexpr const char* kRemedy = "; where they overlap a little, give `weld`";

}  // namespace

void BandedLeaves::add(Index instance, std::shared_ptr<const BandedForm> form) {
  forms_.emplace(instance, std::move(form));
}

bool BandedLeaves::join(const Side& a, const Side& b) {
  const RationalPoint& axis = a.placed.axis.direction;
  if (a.band != nullptr && b.band != nullptr && !meet(a.sector, b.sector, axis)) return false;
  bool reason = true;
  if (a.instance == b.instance) {
    reason = !share(a.band->solids, b.band->solids);
    if (reason && share(a.band->edges, b.band->edges)) {
      reason = overlap(a.sector, b.sector, axis) && lie_on_each_other(a.placed.lines[0][0], b.placed.lines[0][0]);
    }
  }
  bool can = true;
  for (const Side* side : {&a, &b}) {
    if (side->band == nullptr || forms_.at(side->instance)->obstacle.empty()) continue;
    can = false;
    if (reason && told_.insert(side->instance).second) tell(*side, side == &a ? b : a);
  }
  if (!can) return false;
  for (const Side* side : {&a, &b}) {
    if (reason && side->band != nullptr) anew_.insert(side->instance);
  }
  return true;
}

void BandedLeaves::tell(const Side& side, const Side& other) {
  notices_.push_back(name_of(side) + " touches " + name_of(other) +
                     " on a curved surface, but is not drawn on common lines with it: " +
                     forms_.at(side.instance)->obstacle + kRemedy);
}

void BandedLeaves::set_grid(Index instance, std::size_t band, BandGrid grid) {
  std::vector<BandGrid>& grids = grids_[instance];
  grids.resize(bands(instance).size());
  grids[band] = std::move(grid);
}

std::set<Index> BandedLeaves::draw(std::vector<LeafInstance>& instances) const {
  std::set<Index> too_coarse;
  for (const auto& [i, grids] : grids_) {
    BandedForm::Drawn drawn = forms_.at(i)->draw(grids, forms_.at(i)->slack);
    if (drawn.leaf != nullptr) {
      drawn.leaf->set_surfaces(instances[i].leaf->surfaces());
      instances[i].leaf = std::move(drawn.leaf);
      continue;
    }
    if (drawn.finer) too_coarse.insert(i);
    notices_.push_back(LeafWords(LeafPlace{i}) +
                       " touches others, or its own parts each other, on a curved surface, but is not drawn on "
                       "common lines: " +
                       drawn.obstacle + kRemedy);
  }
  return too_coarse;
}

}  // namespace cnrg
