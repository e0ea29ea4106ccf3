// Drawings are made between the stages, and of what is there where one fails.
#include "bench/baseline/steps.h"

#include <algorithm>
#include <set>

#include "bench/baseline/draw.h"

namespace cnrg::bench::mantyla {
namespace {

/// None of a face that cannot be cut, such as one without area.
std::vector<Model::Face> cut_into_triangles(const std::vector<RationalPoint>& points, const Model::Face& face) {
  Model model;
  model.points = points;
  model.faces = {face};
  try {
    model = triangulated(model);
  } catch (const Failure&) {
    return {};
  }
  std::erase_if(model.faces, [&](const Model::Face& triangle) {
    const auto& p = triangle.loops[0];
    return p.size() != 3 || points[p[0]] == points[p[1]] || points[p[1]] == points[p[2]] ||
           points[p[2]] == points[p[0]];
  });
  for (Model::Face& triangle : model.faces) triangle.solid = false;
  return model.faces;
}

constexpr double kGap = 1.0 / 12;  ///< of a drawn edge, at a contact

template <class N>
class Recorder {
 public:
  Recorder(const Scene<N>& scene, Steps& steps)
      : scene_(scene), topology_(scene.topology), steps_(steps), given_(scene.topology.vertex_ids()) {}

  /// What a stage found; called where it failed, too.
  void record(Stage stage) {
    if (stage == Stage::reduction) reduced();
    if (stage == Stage::classification) classified();
    if (stage == Stage::null_edges) add("null edges", null_edges());
    if (stage == Stage::connecting) add("loops", loops());
    if (stage == Stage::finishing && !parted_) {
      steps_.steps.push_back({"pieces", pieces(), false});
      parted_ = true;
    }
  }

 private:
  void add(const std::string& name, std::vector<Drawing> drawings) {
    steps_.steps.push_back({name, std::move(drawings), true});
  }

  bool is_given(VertexId v) const { return static_cast<std::size_t>(v) < given_; }

  void reduced() {
    Drawings contacts;
    std::set<VertexId> parted;
    const auto letter = [](std::size_t solid) { return std::string(solid == 0 ? "A" : "B"); };
    for (const auto& [solid, vertex, face] : scene_.vertex_faces) {
      parted.insert(vertex);
      contacts
          .of((is_given(vertex) ? "vertex of " : "edge of ") + letter(solid) + " in a face of " +
              letter(1 - solid))
          .point(exact(scene_.point(vertex)));
    }
    for (const auto& [a, b] : scene_.vertex_vertices) {
      parted.insert({a, b});
      const char *of_a = is_given(a) ? "vertex" : "edge", *of_b = is_given(b) ? "vertex" : "edge";
      contacts.of(std::string(of_a) + " of A at " + of_b + " of B").point(exact(scene_.point(a)));
    }
    steps_.counts.contacts = scene_.vertex_faces.size() + scene_.vertex_vertices.size();
    draw_edges(parted);
    add("reduction", contacts.take());
  }

  void draw_edges(const std::set<VertexId>& parted) {
    std::array<Sketch, 2> sketches;
    for (std::size_t e = 0; e < topology_.edge_ids(); ++e) {
      const auto id = static_cast<EdgeId>(e);
      if (!topology_.alive(id)) continue;
      const HalfEdgeId h = topology_.edge(id).first;
      const VertexId v = topology_.origin(h), w = topology_.target(h);
      const Vec<N> way = scene_.point(w) - scene_.point(v), back = scene_.point(v) - scene_.point(w);
      const double gap = distance(scene_.point(v), scene_.point(w)) * kGap;
      if (gap == 0) continue;
      sketches[topology_.face(topology_.face(h)).solid].line(
          parted.contains(v) ? along(scene_.point(v), way, gap) : exact(scene_.point(v)),
          parted.contains(w) ? along(scene_.point(w), back, gap) : exact(scene_.point(w)));
    }
    for (int solid = 0; solid < 2; ++solid)
      steps_.edges[solid] = {solid == 0 ? "A" : "B", std::move(sketches[solid].model())};
  }

  void classified() {
    steps_.counts.crossings = scene_.crossings.size();
    auto [a, b] = draw_sectors(scene_);
    add("sectors of A", std::move(a));
    add("sectors of B", std::move(b));
  }

  /// Without length: a point for each, and which way its ends go on.
  std::vector<Drawing> null_edges() {
    steps_.counts.null_pairs = scene_.null_pairs.size();
    std::map<RationalPoint, std::size_t> at;
    for (const NullPair<N>& pair : scene_.null_pairs) ++at[exact(pair.point)];
    Drawings drawings;
    for (const auto& [p, count] : at)
      drawings.of(count == 1 ? "pair of null edges" : std::to_string(count) + " pairs of null edges").point(p);
    for (const NullPair<N>& pair : scene_.null_pairs) {
      arrow(drawings.of("end ahead"), pair.point, pair.forward);
      arrow(drawings.of("end behind"), pair.point, pair.backward);
    }
    return drawings.take();
  }

  /// A narrow triangle beside a point, its tip ahead.
  void arrow(Sketch& sketch, const Vec<N>& p, const Vec<N>& direction) const {
    const double length = scene_.extent / 8;
    const int axis = dominant_axis(direction);
    Vec<N> other = {N(0), N(0), N(0)};
    other[(axis + 1) % 3] = 1;
    const Vec<N> across = cross(direction, other);
    const auto corner = [&](double width) {
      RationalPoint at = along(p, direction, length / 3);
      const RationalPoint aside = along({N(0), N(0), N(0)}, across, std::fabs(width));
      for (int k = 0; k < 3; ++k) at[k] += width < 0 ? Rational(-aside[k]) : aside[k];
      return at;
    };
    sketch.triangle(corner(-length / 4), corner(length / 4), along(p, direction, length));
  }

  /// Joined null edges, curve by curve.
  std::vector<Drawing> loops() {
    std::map<std::uint32_t, std::uint32_t> next, left;  // by null pair
    std::set<std::uint32_t> targets;
    for (const Joint& joint : scene_.joints) {
      next[joint.from] = joint.to;
      targets.insert(joint.to);
    }
    left = next;
    Drawings drawings;
    const auto draw = [&](std::uint32_t first, const std::string& name) {
      Sketch& sketch = drawings.of(name);
      std::uint32_t k = first;
      for (auto joint = left.find(k); joint != left.end(); joint = left.find(k)) {
        const RationalPoint from = exact(scene_.null_pairs[k].point),
                            to = exact(scene_.null_pairs[joint->second].point);
        if (from != to) sketch.line(from, to);
        k = joint->second;
        left.erase(joint);
      }
    };
    for (const auto& [from, to] : next)
      if (!targets.contains(from)) draw(from, "open chain");
    std::size_t& count = steps_.counts.loops;
    while (!left.empty()) draw(left.begin()->first, "loop " + std::to_string(++count));
    for (const NullPair<N>& pair : scene_.null_pairs)
      if (scene_.joints.empty()) drawings.of("loose null edge").point(exact(pair.point));
    return drawings.take();
  }

  std::vector<Drawing> pieces() {
    std::map<std::string, Model> models;
    for (std::size_t f = 0; f < topology_.face_ids(); ++f) {
      const auto id = static_cast<FaceId>(f);
      if (!topology_.alive(id)) continue;
      const bool kept = f < scene_.kept_faces.size() && scene_.kept_faces[f];
      add_face(id,
               models[std::string(topology_.face(id).solid == 0 ? "A" : "B") + (kept ? ", kept" : ", dropped")]);
    }
    std::vector<Drawing> drawings;
    for (const char* const name : {"A, kept", "B, kept", "A, dropped", "B, dropped"})
      if (const auto found = models.find(name); found != models.end() && !found->second.faces.empty())
        drawings.push_back({name, std::move(found->second)});
    return drawings;
  }

  /// In triangles, for rounded points are in no plane. Faces that cannot be cut are left out, such as null faces.
  void add_face(FaceId id, Model& model) const {
    Model::Face face;
    std::vector<RationalPoint> points;
    for (const LoopId loop : topology_.face(id).loops) {
      auto& corners = face.loops.emplace_back();
      for (const HalfEdgeId h : topology_.cycle(loop)) {
        const RationalPoint p = exact(scene_.point(topology_.origin(h)));
        if (!corners.empty() && points.back() == p) continue;
        corners.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(p);
      }
    }
    if (face.loops[0].size() < 3) return;
    std::erase_if(face.loops, [](const auto& corners) { return corners.size() < 3; });
    const auto first = static_cast<std::uint32_t>(model.points.size());
    for (const Model::Face& triangle : cut_into_triangles(points, face)) {
      Model::Face& added = model.faces.emplace_back(triangle);
      for (std::uint32_t& p : added.loops[0]) p += first;
    }
    model.points.insert(model.points.end(), points.begin(), points.end());
  }

  const Scene<N>& scene_;
  const Topology& topology_;
  Steps& steps_;
  std::size_t given_;  ///< vertices of the operands themselves come before this one
  bool parted_ = false;
};

template <class N>
void run(const Model& a, const Model& b, Operation operation, const N& epsilon, const Departures& departures,
         Steps& steps) {
  auto scene = staged(Stage::input, [&] { return read_operands(a, b, operation, epsilon, departures); });
  Recorder<N> recorder(scene, steps);
  try {
    steps.result = run_stages<N>(scene, [&](Stage stage) { recorder.record(stage); });
    if constexpr (std::is_floating_point_v<N>) steps.result = triangulated(steps.result);
  } catch (const Failure& failure) {
    recorder.record(failure.stage());
    throw;
  }
}

}  // namespace

Steps steps_of(const Model& a, const Model& b, Operation operation, const Variant& variant) {
  Steps steps;
  try {
    if (variant.fractions) run<Rational>(a, b, operation, 0, variant.departures, steps);
    else run<double>(a, b, operation, variant.epsilon, variant.departures, steps);
  } catch (const Failure& failure) {
    steps.failure = failure;
  }
  return steps;
}

}  // namespace cnrg::bench::mantyla
