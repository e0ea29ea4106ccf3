// Finds the spaces in which leaves are round, and the contacts of leaves there.
#include "csg/carriers/round_spaces.h"

#include <algorithm>

#include "csg/carriers/bands.h"
#include "csg/carriers/boxes.h"
#include "csg/carriers/extruded_arcs.h"
#include "csg/geometry/placement.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Pair = std::array<Index, 2>;

Metric round_metric() {
  Metric metric{};
  metric[0] = metric[3] = metric[5] = fraction(1, 3);
  return metric;
}

/// A space with all that is round in it, before it is known what of this shares something.
struct Candidates {
  RoundSpace space;
  std::vector<Index> members;
  std::vector<RevolvedInstance> revolved;
  std::vector<Pair> pairs;
  std::vector<BesidePlanes> planes;
};

}  // namespace

// L L^T over its trace.
Metric metric_of(const Transform& transform) {
  const auto& rows = transform.linear;
  if (rows == Transform{}.linear) return round_metric();
  const Rational trace = dot(rows[0], rows[0]) + dot(rows[1], rows[1]) + dot(rows[2], rows[2]);
  Metric metric;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) metric[n++] = dot(rows[i], rows[j]) / trace;
  }
  return metric;
}

std::vector<RoundSpace> round_spaces(const std::vector<LeafInstance>& instances,
                                     const std::vector<RevolvedInstance>& revolved, const std::vector<Pair>& pairs,
                                     const std::vector<Pair>& near, const std::vector<Index>& anew,
                                     const ExtraOfInstances& extra) {
  std::set<Index> members, alone, banded;
  for (const RevolvedInstance& of : revolved) alone.insert(of.instance);
  members = alone;
  for (const Pair& pair : near) members.insert(pair.begin(), pair.end());
  for (Index i = 0; i < instances.size(); ++i) {
    if (dynamic_cast<const BandedForm*>(instances[i].leaf->form().get()) != nullptr) banded.insert(i);
  }
  members.insert(banded.begin(), banded.end());
  std::map<Metric, Candidates> by_metric;
  std::map<Index, Candidates*> space_of;
  std::set<Metric> revolved_metrics;
  for (const Index i : members) {
    if (dynamic_cast<const ExtrudeForm*>(instances[i].leaf->form().get()) == nullptr)
      revolved_metrics.insert(metric_of(instances[i].transform));
  }
  for (const Index i : members) {
    Metric metric = metric_of(instances[i].transform);
    const auto* extrusion = dynamic_cast<const ExtrudeForm*>(instances[i].leaf->form().get());
    // Its arcs may be circles in the tree, whatever it is stretched along its walls.
    if (extrusion != nullptr && !revolved_metrics.contains(metric) &&
        !arcs_of(*extrusion, instances[i].transform).empty())
      metric = round_metric();
    Candidates& of = by_metric[metric];
    of.members.push_back(i);
    space_of.emplace(i, &of);
  }
  for (auto& [metric, of] : by_metric) {
    if (metric == round_metric()) continue;
    const auto least = std::min_element(of.members.begin(), of.members.end(), [&](Index a, Index b) {
      return Placement(instances[a].transform) < Placement(instances[b].transform);
    });
    of.space.base = instances[*least].transform;
    of.space.to_space = of.space.base->inverse();
  }
  for (const RevolvedInstance& given : revolved) {
    Candidates& of = *space_of.at(given.instance);
    of.revolved.push_back(given);
    if (of.space.base->identity()) continue;
    RevolvedInstance& there = of.revolved.back();
    there.transform = of.space.relative(given.transform);
    there.box =
        box_of(dynamic_cast<const RevolvedForm&>(*instances[given.instance].leaf->form()), there.transform);
  }
  const auto in_one_space = [&](const Pair& pair) {
    const auto a = space_of.find(pair[0]), b = space_of.find(pair[1]);
    return a != space_of.end() && b != space_of.end() && a->second == b->second;
  };
  for (const Pair& pair : near) {
    if (in_one_space(pair)) space_of.at(pair[0])->space.near.push_back(pair);
  }
  for (const Pair& pair : pairs) {
    if (alone.contains(pair[0]) && alone.contains(pair[1]) && in_one_space(pair))
      space_of.at(pair[0])->pairs.push_back(pair);
  }
  // Planes of revolved leaves of the same space are among what pairs of them have.
  const bool one_space = by_metric.size() == 1;
  for (const BesidePlanes& beside : beside_planes(instances, revolved, one_space ? alone : std::set<Index>{})) {
    for (const Index i : beside.revolved) {
      Candidates& of = *space_of.at(i);
      if (alone.contains(beside.instance) && space_of.at(beside.instance) == &of) continue;
      if (of.planes.empty() || of.planes.back().instance != beside.instance)
        of.planes.push_back({beside.instance, {}});
      of.planes.back().revolved.push_back(i);
    }
  }
  std::vector<RoundSpace> result;
  for (auto& [metric, of] : by_metric) {
    RoundSpace& space = of.space;
    space.contacts = contacts(instances, space.to_space, of.revolved, of.pairs, of.planes);
    for (const Index i : anew) {
      if (space_of.at(i) == &of) space.contacts.marks[i].needed = true;
    }
    std::set<Index> concerned;
    for (const Pair& pair : space.near) concerned.insert(pair.begin(), pair.end());
    for (const Pair& pair : space.contacts.nested) concerned.insert(pair.begin(), pair.end());
    for (const Inside& pair : space.contacts.inside) concerned.insert({pair.inner, pair.outer});
    for (const auto& [i, marks] : space.contacts.marks) concerned.insert(i);
    for (const auto& [circle, all] : space.contacts.circles) {
      for (const HasCircle& one : all) concerned.insert(one.instance);
    }
    for (const Index i : of.members) {
      if (banded.contains(i) || extra.contains(i)) concerned.insert(i);
    }
    if (concerned.empty()) continue;
    space.instances.assign(concerned.begin(), concerned.end());
    result.push_back(std::move(space));
  }
  return result;
}

}  // namespace cnrg
