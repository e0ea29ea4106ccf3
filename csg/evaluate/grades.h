// Graded materials of a tree, placed by the transforms of their nodes, with the targets of their distances.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
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

  /// The material of that name on a node of an instance, with its dominance; empty for no name.
  RegionMaterial on(const Instance& instance, const std::string& name);
  /// A material that a leaf brings along in its own coordinates, where the instance puts the leaf; its
  /// dominance is its own.
  RegionMaterial moved(const Instance& instance, const RegionMaterial& own);

 private:
  const Tree& tree_;
  std::map<std::string, PlacedGrade> graded_;  ///< by material, with their targets and not yet placed
  /// By material; equal placements are one object.
  std::map<std::string, std::vector<std::shared_ptr<const PlacedGrade>>> placed_;

  void add(const std::string& name, std::map<std::string, std::shared_ptr<const DistanceTarget>>& targets,
           const std::function<Evaluation(NodeId)>& evaluate);
  std::shared_ptr<const DistanceTarget> target_of(const Material& material, const std::string& to,
                                                  const std::function<Evaluation(NodeId)>& evaluate) const;
  RegionMaterial placed(const std::string& name, PlacedGrade grade);
};

}  // namespace cnrg
