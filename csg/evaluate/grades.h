// Graded materials of a tree: placed where their nodes stand, with what their distances are measured to.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/unfold.h"

namespace cnrg {

/// What a distance to a kept value is measured to: its faces (also those that bound a region), wires and points.
/// Nothing for an unbounded value.
std::optional<DistanceTarget> distance_target(const Complex& complex, const KeptValue& value);

class Grades {
 public:
  /// Evaluates the nodes that distances are measured to, each once, for all materials of nodes of the unfolding.
  /// TreeError, at the place of the mention, for one that is empty or unbounded.
  Grades(const Tree& tree, const Unfolding& unfolding, const std::function<Evaluation(NodeId)>& evaluate);

  /// The material of that name on a node of an instance; empty for no name.
  RegionMaterial on(const Instance& instance, const std::string& name);
  /// A material that a leaf brings along in its own coordinates, where the instance puts the leaf.
  RegionMaterial moved(const Instance& instance, const RegionMaterial& own);

 private:
  const Tree& tree_;
  std::map<std::string, Grade> grades_;  ///< by material, distances with their targets
  /// By material; equal placements are one object.
  std::map<std::string, std::vector<std::shared_ptr<const PlacedGrade>>> placed_;
  RegionMaterial placed(const std::string& name, Grade grade, Transform placement);
};

}  // namespace cnrg
