// Finishing (mantyla1988, section 15.8): null faces come apart into an OUT and an IN face, and with them the
// operands into shells that lie on one side. Those of the kept sides are glued along their null faces.
#include <map>

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

[[noreturn]] void fail_finishing(const std::string& what) { throw Failure(Stage::finishing, what); }

template <class N>
class Finish {
 public:
  explicit Finish(Scene<N>& scene) : scene_(scene), topology_(scene.topology) {}

  void part() {
    if (scene_.departures.curves) find_curves();
    else pair_null_faces();
    for (const Curve& curve : curves_) at(curve, [&] { part_null_faces(curve); });
    choose_shells();
  }

  std::vector<FaceId> glue() {
    if (scene_.operation == Operation::subtract) {
      topology_.revert(1);
      for (std::size_t s = scene_.boundaries[0].planes.size(); s < scene_.surfaces.size(); ++s) {
        scene_.surfaces[s].normal = scene_.surfaces[s].normal * N(-1);
        scene_.surfaces[s].offset = -scene_.surfaces[s].offset;
      }
    }
    for (const Curve& curve : curves_) at(curve, [&] { zip(side(curve, 0), start_of(curve)); });
    std::vector<FaceId> result;
    for (std::size_t f = 0; f < topology_.face_ids(); ++f) {
      const auto id = static_cast<FaceId>(f);
      if (topology_.alive(id) && f < kept_.size() && kept_[f]) result.push_back(id);
    }
    return result;
  }

 private:
  using Curve = std::array<NullFace, 2>;  ///< by solid

  /// Runs a step that fails where the curve begins.
  template <class Step>
  void at(const Curve& curve, Step&& step) {
    staged(Stage::finishing, step, [&] { return places_of(scene_, curve[0].in); });
  }

  HalfEdgeId side(const Curve& curve, int solid) const {
    return scene_.kept(solid) == Side::out ? curve[solid].out : curve[solid].in;
  }

  /// By one joint of each closed curve.
  void find_curves() {
    const auto& joints = scene_.joints;
    std::map<std::uint32_t, std::uint32_t> after;  // by null pair: the joint that starts there
    for (std::uint32_t j = 0; j < joints.size(); ++j) after[joints[j].from] = j;
    std::vector<bool> seen(joints.size(), false);
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
      if (seen[j]) continue;
      std::uint32_t k = j;
      while (k < joints.size() && !seen[k]) {
        seen[k] = true;
        const auto next = after.find(joints[k].to);
        k = next == after.end() ? static_cast<std::uint32_t>(joints.size()) : next->second;
      }
      if (k == j)
        curves_.push_back({NullFace{joints[j].in[0], joints[j].out[0]}, {joints[j].in[1], joints[j].out[1]}});
    }
  }

  /// In the order in which they closed.
  void pair_null_faces() {
    const auto& [a, b] = scene_.null_faces;
    if (a.size() != b.size())
      fail_finishing(std::to_string(a.size()) + " null faces of A and " + std::to_string(b.size()) + " of B");
    for (std::size_t k = 0; k < a.size(); ++k) curves_.push_back({a[k], b[k]});
  }

  /// The half-edge of B's null face that is glued to that of A's.
  HalfEdgeId start_of(const Curve& curve) const {
    const HalfEdgeId a = side(curve, 0), b = side(curve, 1);
    if (scene_.departures.curves) return b;
    for (const HalfEdgeId h : topology_.cycle(topology_.loop(b)))
      if (scene_.metric.equal(scene_.point(topology_.origin(h)), scene_.point(topology_.origin(a))))
        return topology_.prev(h);
    fail_finishing("null faces without a common vertex");
  }

  void part_null_faces(const Curve& curve) {
    for (int solid = 0; solid < 2; ++solid) {
      const LoopId in = topology_.loop(curve[solid].in), out = topology_.loop(curve[solid].out);
      const FaceId face = topology_.loop(out).face;
      if (in == out || topology_.loop(in).face != face || topology_.face(face).loops.size() != 2)
        fail_finishing("a null face without two loops");
      topology_.mfkrh(topology_.is_outer(in) ? out : in);
    }
  }

  /// By shell: the side of its null faces; the kept one where it has both.
  std::map<std::uint32_t, Side> sides_by_curves(const std::vector<std::uint32_t>& shells) const {
    std::map<std::uint32_t, Side> sides;
    const auto note = [&](HalfEdgeId h, Side side, int solid) {
      const auto [found, fresh] = sides.emplace(shells[static_cast<std::size_t>(topology_.face(h))], side);
      check(scene_.departures, found->second == side, Stage::finishing,
            "the intersection curve does not part a solid: a shell is on both sides of the other");
      if (side == scene_.kept(solid)) found->second = side;
    };
    const auto note_both = [&](HalfEdgeId in, HalfEdgeId out, int solid) {
      staged(
          Stage::finishing,
          [&] {
            note(in, Side::in, solid);
            note(out, Side::out, solid);
          },
          [&] { return places_of(scene_, in); });
    };
    for (int solid = 0; solid < 2; ++solid) {
      if (scene_.departures.curves)
        for (const Joint& joint : scene_.joints) note_both(joint.in[solid], joint.out[solid], solid);
      else
        for (const Curve& curve : curves_) note_both(curve[solid].in, curve[solid].out, solid);
    }
    return sides;
  }

  /// Marks the faces of all shells on the kept side of the other operand.
  void choose_shells() {
    if (!scene_.departures.shells && scene_.null_pairs.empty())
      fail_finishing("no intersection of the boundaries");
    const std::vector<std::uint32_t> shells = topology_.shells();
    const std::map<std::uint32_t, Side> sides = sides_by_curves(shells);
    kept_.assign(topology_.face_ids(), false);
    std::map<std::uint32_t, std::vector<FaceId>> apart;  // shells without a curve
    for (std::size_t f = 0; f < topology_.face_ids(); ++f) {
      const auto id = static_cast<FaceId>(f);
      if (!topology_.alive(id)) continue;
      const Face& face = topology_.face(id);
      const auto found = sides.find(shells[f]);
      if (found == sides.end()) apart[shells[f]].push_back(id);
      else kept_[f] = found->second == scene_.kept(static_cast<int>(face.solid));
    }
    if (!scene_.departures.shells) return;
    for (const auto& [s, faces] : apart) {
      const bool keep = side_of_shell(faces) == scene_.kept(static_cast<int>(topology_.face(faces.front()).solid));
      for (const FaceId f : faces) kept_[static_cast<std::size_t>(f)] = keep;
    }
  }

  /// Without a curve all faces are on one side: the first that tells, by a point inside of it. One in a face of
  /// the other boundary goes by the table of coplanar sectors; one on an edge that its face meets tells nothing.
  Side side_of_shell(const std::vector<FaceId>& faces) const {
    for (const FaceId face : faces) {
      const auto solid = static_cast<int>(topology_.face(face).solid);
      std::vector<std::vector<Vec<N>>> loops;
      for (const LoopId loop : topology_.face(face).loops) {
        loops.emplace_back();
        for (const HalfEdgeId h : topology_.cycle(loop)) loops.back().push_back(scene_.point(topology_.origin(h)));
      }
      const Vec<N>& own = scene_.plane(face).normal;
      Vec<N> normal;
      const Side found =
          locate_point(scene_.metric, scene_.boundaries[1 - solid], inner_point(own, loops), normal);
      if (found != Side::on) return found;
      if (scene_.metric.null_unit(cross(own, normal))) return scene_.coplanar_side(solid, dot(own, normal) > 0);
    }
    fail_finishing("no face says on which side its shell lies");
  }

  /// Zips two null faces: their loops, as runs of edges, are opposite. The edges of B go.
  void zip(HalfEdgeId a, HalfEdgeId b) {
    const FaceId face_a = topology_.face(a), face_b = topology_.face(b);
    check_glue(topology_.cycle(topology_.loop(a)).size() == topology_.cycle(topology_.loop(b)).size(),
               "null faces with different numbers of edges");
    topology_.kfmrh(face_a, face_b);
    HalfEdgeId other = topology_.next(b);
    check_same(topology_.origin(a), topology_.origin(other));
    topology_.kev(topology_.edge(topology_.mekr(a, other)).second);
    other = b;
    for (std::size_t steps = 0; topology_.next(a) != other; ++steps) {
      if (steps > topology_.half_edge_ids()) fail_finishing("gluing comes to no end");
      const HalfEdgeId next_a = topology_.next(a), next_b = topology_.prev(other);
      check_same(topology_.target(a), topology_.origin(other));
      check_glue(topology_.target(a) != topology_.origin(other), "gluing pinches a vertex");
      const EdgeId between = topology_.mef(next_a, other);
      const FaceId rest = topology_.face(topology_.edge(between).first);
      kept_.resize(topology_.face_ids(), false);
      kept_[static_cast<std::size_t>(rest)] = true;
      topology_.kev(topology_.edge(between).first);
      topology_.kef(other);
      a = next_a;
      other = next_b;
    }
    check_glue(topology_.next(other) == a, "gluing does not close");
    topology_.kef(other);
  }

  void check_same(VertexId v, VertexId w) const {
    check_glue(scene_.metric.equal(scene_.point(v), scene_.point(w)), "gluing of vertices at different places");
  }
  void check_glue(bool holds, const char* what) const { check(scene_.departures, holds, Stage::finishing, what); }

  Scene<N>& scene_;
  Topology& topology_;
  std::vector<Curve>& curves_ = scene_.curves;
  std::vector<bool>& kept_ = scene_.kept_faces;
};

}  // namespace

template <class N>
void part(Scene<N>& scene) {
  Finish<N>(scene).part();
}
template <class N>
std::vector<FaceId> glue(Scene<N>& scene) {
  return Finish<N>(scene).glue();
}

template void part(Scene<double>&);
template void part(Scene<Rational>&);
template std::vector<FaceId> glue(Scene<double>&);
template std::vector<FaceId> glue(Scene<Rational>&);

}  // namespace cnrg::bench::mantyla
