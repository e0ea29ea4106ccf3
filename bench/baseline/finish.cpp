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

  std::vector<FaceId> run() {
    find_curves();
    part_null_faces();
    choose_shells();
    if (scene_.operation == Operation::subtract) {
      topology_.revert(1);
      for (std::size_t s = scene_.boundaries[0].planes.size(); s < scene_.surfaces.size(); ++s) {
        scene_.surfaces[s].normal = scene_.surfaces[s].normal * N(-1);
        scene_.surfaces[s].offset = -scene_.surfaces[s].offset;
      }
    }
    for (const std::uint32_t j : curves_) glue(side(scene_.joints[j], 0), side(scene_.joints[j], 1));
    std::vector<FaceId> result;
    for (std::size_t f = 0; f < topology_.face_ids(); ++f) {
      const auto id = static_cast<FaceId>(f);
      if (topology_.alive(id) && f < kept_.size() && kept_[f]) result.push_back(id);
    }
    return result;
  }

 private:
  HalfEdgeId side(const Joint& joint, int solid) const {
    return scene_.kept(solid) == Side::out ? joint.out[solid] : joint.in[solid];
  }

  /// One joint of each closed curve.
  void find_curves() {
    std::map<std::uint32_t, std::uint32_t> after;  // by null pair: the joint that starts there
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) after[scene_.joints[j].from] = j;
    std::vector<bool> seen(scene_.joints.size(), false);
    for (std::uint32_t j = 0; j < scene_.joints.size(); ++j) {
      if (seen[j]) continue;
      curves_.push_back(j);
      for (std::uint32_t k = j; !seen[k]; k = after.at(scene_.joints[k].to)) seen[k] = true;
    }
  }

  void part_null_faces() {
    for (const std::uint32_t j : curves_)
      for (int solid = 0; solid < 2; ++solid) {
        const Joint& joint = scene_.joints[j];
        const LoopId in = topology_.loop(joint.in[solid]), out = topology_.loop(joint.out[solid]);
        const FaceId face = topology_.loop(out).face;
        if (in == out || topology_.loop(in).face != face || topology_.face(face).loops.size() != 2)
          fail_finishing("a null face without two loops");
        topology_.mfkrh(topology_.is_outer(in) ? out : in);
      }
  }

  /// Marks the faces of all shells on the kept side of the other operand.
  void choose_shells() {
    const std::vector<std::uint32_t> shells = topology_.shells();
    std::map<std::uint32_t, Side> sides;  // by shell
    const auto shell = [&](HalfEdgeId h) { return shells[static_cast<std::size_t>(topology_.face(h))]; };
    const auto note = [&](HalfEdgeId h, Side side) {
      if (sides.emplace(shell(h), side).first->second != side)
        fail_finishing("the intersection curve does not part a solid: a shell is on both sides of the other");
    };
    for (const Joint& joint : scene_.joints)
      for (int solid = 0; solid < 2; ++solid) {
        note(joint.in[solid], Side::in);
        note(joint.out[solid], Side::out);
      }
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
  void glue(HalfEdgeId a, HalfEdgeId b) {
    const FaceId face_a = topology_.face(a), face_b = topology_.face(b);
    if (topology_.cycle(topology_.loop(a)).size() != topology_.cycle(topology_.loop(b)).size())
      fail_finishing("null faces with different numbers of edges");
    topology_.kfmrh(face_a, face_b);
    HalfEdgeId other = topology_.next(b);
    check_same(topology_.origin(a), topology_.origin(other));
    topology_.kev(topology_.edge(topology_.mekr(a, other)).second);
    other = b;
    for (std::size_t steps = 0; topology_.next(a) != other; ++steps) {
      if (steps > topology_.half_edge_ids()) fail_finishing("gluing comes to no end");
      const HalfEdgeId next_a = topology_.next(a), next_b = topology_.prev(other);
      check_same(topology_.target(a), topology_.origin(other));
      if (topology_.target(a) == topology_.origin(other)) fail_finishing("gluing pinches a vertex");
      const EdgeId between = topology_.mef(next_a, other);
      const FaceId rest = topology_.face(topology_.edge(between).first);
      kept_.resize(topology_.face_ids(), false);
      kept_[static_cast<std::size_t>(rest)] = true;
      topology_.kev(topology_.edge(between).first);
      topology_.kef(other);
      a = next_a;
      other = next_b;
    }
    if (topology_.next(other) != a) fail_finishing("gluing does not close");
    topology_.kef(other);
  }

  void check_same(VertexId v, VertexId w) const {
    if (!scene_.metric.equal(scene_.point(v), scene_.point(w)))
      fail_finishing("gluing of vertices at different places");
  }

  Scene<N>& scene_;
  Topology& topology_;
  std::vector<std::uint32_t> curves_;
  std::vector<bool> kept_;  // by face
};

}  // namespace

template <class N>
std::vector<FaceId> finish(Scene<N>& scene) {
  return Finish<N>(scene).run();
}

template std::vector<FaceId> finish(Scene<double>&);
template std::vector<FaceId> finish(Scene<Rational>&);

}  // namespace cnrg::bench::mantyla
