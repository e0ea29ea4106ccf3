// A material is given in the coordinates in which its node is placed: the transforms above the node move it, the
// node's own does not. Distances are measured to triangles, segments and points of a simplified value.
//
// A graded material whose stops name others needs these, too, and what they name: all of them are looked up when
// the outer one is first used, each target once.
#include "csg/evaluate/grades.h"

#include <algorithm>
#include <optional>

#include "csg/materials/distance_target.h"

namespace cnrg {

std::optional<DistanceTarget> distance_target(const Complex& complex, const KeptValue& value) {
  TargetBuilder builder(complex);
  for (const auto& face : value.simplified->faces) {
    for (const HalfFace cell : face.cells) builder.add(cell.face());
  }
  for (const auto& edge : value.simplified->edges) {
    for (const HalfEdge h : edge.chain) builder.add(h.edge());
  }
  for (const auto& vertex : value.simplified->vertices) builder.add(vertex.cell);
  return builder.take();
}

Grades::Grades(const Tree& tree, const Unfolding& unfolding, const std::function<Evaluation(NodeId)>& evaluate)
    : tree_(tree) {
  std::map<std::string, std::shared_ptr<const DistanceTarget>> targets;  // by name of the node
  for (const Instance& instance : unfolding.instances) {
    for (const std::string& name : materials_of(tree.nodes[instance.node])) {
      if (tree.material(name)->grade && graded_.count(name) == 0) add(name, targets, evaluate);
    }
  }
}

void Grades::add(const std::string& name, std::map<std::string, std::shared_ptr<const DistanceTarget>>& targets,
                 const std::function<Evaluation(NodeId)>& evaluate) {
  PlacedGrade& graded = graded_[name];
  for (const Material* material : tree_.graded_in(name)) {
    Grade grade = *material->grade;
    if (auto* distance = std::get_if<DistanceGrade>(&grade.along)) {
      auto& target = targets[distance->to];
      if (!target) target = target_of(*material, distance->to, evaluate);
      distance->target = target;
    }
    if (material->name == name) graded.grade = std::move(grade);
    else graded.nested.emplace(material->name, std::move(grade));
  }
}

std::shared_ptr<const DistanceTarget> Grades::target_of(const Material& material, const std::string& to,
                                                        const std::function<Evaluation(NodeId)>& evaluate) const {
  const NodeId node = tree_.find(to);
  const Evaluation evaluation = evaluate(node);
  std::optional<DistanceTarget> found = distance_target(*evaluation.complex, evaluation.value(node));
  const std::string what = "the material `" + material.name + "` is measured by the distance to `" + to + "`, ";
  if (!found) {
    throw TreeError(tree_.file, material.to_at,
                    what + "which is unbounded; cut it with a box, or use `linear` for the distance to a plane");
  }
  if (found->empty()) {
    throw TreeError(tree_.file, material.to_at, what + "which is empty; name a node with faces, wires or points");
  }
  return std::make_shared<const DistanceTarget>(std::move(*found));
}

RegionMaterial Grades::placed(const std::string& name, PlacedGrade grade) {
  auto& known = placed_[name];
  const auto it = std::find_if(known.begin(), known.end(), [&](const auto& p) { return *p == grade; });
  if (it != known.end()) return {name, *it};
  known.push_back(std::make_shared<const PlacedGrade>(std::move(grade)));
  return {name, known.back()};
}

RegionMaterial Grades::on(const Instance& instance, const std::string& name) {
  RegionMaterial out(name);
  if (const auto it = graded_.find(name); it != graded_.end()) {
    PlacedGrade grade = it->second;
    grade.placement = transform_above(tree_, instance);
    out = placed(name, std::move(grade));
  }
  const Material* declared = name.empty() ? nullptr : tree_.material(name);
  if (declared != nullptr && declared->dominance) out.set_dominance(*declared->dominance);
  return out;
}

RegionMaterial Grades::moved(const Instance& instance, const RegionMaterial& own) {
  if (own.grade() == nullptr) return own;
  PlacedGrade grade = *own.grade();
  grade.placement = *instance.transform * grade.placement;
  RegionMaterial out = placed(own.name(), std::move(grade));
  out.set_dominance(own.dominance());
  return out;
}

}  // namespace cnrg
