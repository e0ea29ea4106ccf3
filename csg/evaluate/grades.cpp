// A material is given in the coordinates in which its node is placed: the transforms above the node move it, the
// node's own does not. Distances are measured to triangles, segments and points of a simplified value.
#include "csg/evaluate/grades.h"

#include <algorithm>
#include <optional>

#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

class TargetBuilder {
 public:
  TargetBuilder(const Complex& complex, const SimplifiedComplex& simplified)
      : complex_(complex), simplified_(simplified) {}

  std::optional<DistanceTarget> run() {
    std::vector<char> on_face(complex_.edge_count(), 0);
    std::vector<std::vector<VertexId>> walks;
    for (const auto& face : simplified_.faces) {
      for (const HalfFace cell : face.cells) {
        walks.clear();
        for (const LoopId l : complex_.face_loops[cell.face()]) {
          auto& walk = walks.emplace_back();
          for (const HalfEdge h : complex_.loop[l]) {
            walk.push_back(complex_.origin(h));
            on_face[h.edge().index()] = 1;
          }
        }
        const Projection axes = projection_of(complex_.points, complex_.plane(cell.face()));
        for (const auto& t : triangulate(complex_.points, axes, walks)) {
          target_.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
        }
      }
    }
    for (const auto& edge : simplified_.edges) {
      for (const HalfEdge h : edge.chain) {
        if (on_face[h.edge().index()]) continue;
        const auto& [a, b] = complex_.edge_ends[h.edge()];
        target_.segments.push_back({number(a), number(b)});
      }
    }
    for (const auto& vertex : simplified_.vertices) {
      if (numbers_.count(vertex.cell) == 0) target_.vertices.push_back({number(vertex.cell)});
    }
    if (unbounded_) return std::nullopt;
    return std::move(target_);
  }

 private:
  std::uint32_t number(VertexId v) {
    unbounded_ = unbounded_ || complex_.on_frame(v);
    const auto [it, fresh] = numbers_.try_emplace(v, static_cast<std::uint32_t>(target_.points.size()));
    if (fresh) target_.points.push_back(complex_.points.rational(v));
    return it->second;
  }

  const Complex& complex_;
  const SimplifiedComplex& simplified_;
  DistanceTarget target_;
  std::map<VertexId, std::uint32_t> numbers_;
  bool unbounded_ = false;
};

}  // namespace

std::optional<DistanceTarget> distance_target(const Complex& complex, const KeptValue& value) {
  return TargetBuilder(complex, *value.simplified).run();
}

Grades::Grades(const Tree& tree, const Unfolding& unfolding, const std::function<Evaluation(NodeId)>& evaluate)
    : tree_(tree) {
  std::map<std::string, std::shared_ptr<const DistanceTarget>> targets;  // by name of the node
  for (const Instance& instance : unfolding.instances) {
    for (const std::string& name : materials_of(tree.nodes[instance.node])) {
      const Material& material = *tree.material(name);
      if (!material.grade || grades_.count(name) != 0) continue;
      Grade& grade = grades_.emplace(name, *material.grade).first->second;
      auto* distance = std::get_if<DistanceGrade>(&grade.along);
      if (distance == nullptr) continue;
      auto& target = targets[distance->to];
      if (!target) {
        const NodeId node = tree.find(distance->to);
        const Evaluation evaluation = evaluate(node);
        std::optional<DistanceTarget> found = distance_target(*evaluation.complex, evaluation.value(node));
        const std::string what =
            "the material `" + name + "` is measured by the distance to `" + distance->to + "`, ";
        if (!found) {
          throw TreeError(
              tree.file, material.to_at,
              what + "which is unbounded; cut it with a box, or use `linear` for the distance to a plane");
        }
        if (found->empty()) {
          throw TreeError(tree.file, material.to_at,
                          what + "which is empty; name a node with faces, wires or points");
        }
        target = std::make_shared<const DistanceTarget>(std::move(*found));
      }
      distance->target = target;
    }
  }
}

RegionMaterial Grades::placed(const std::string& name, Grade grade, Transform placement) {
  auto& known = placed_[name];
  PlacedGrade one{std::move(grade), std::move(placement)};
  const auto it = std::find_if(known.begin(), known.end(), [&](const auto& p) { return *p == one; });
  if (it != known.end()) return {name, *it};
  known.push_back(std::make_shared<const PlacedGrade>(std::move(one)));
  return {name, known.back()};
}

RegionMaterial Grades::on(const Instance& instance, const std::string& name) {
  const auto it = grades_.find(name);
  if (it == grades_.end()) return name;
  const std::optional<Transform>& own = tree_.nodes[instance.node].transform;
  return placed(name, it->second, own ? *instance.transform * own->inverse() : *instance.transform);
}

RegionMaterial Grades::moved(const Instance& instance, const RegionMaterial& own) {
  if (own.grade() == nullptr) return own;
  return placed(own.name(), own.grade()->grade, *instance.transform * own.grade()->placement);
}

}  // namespace cnrg
