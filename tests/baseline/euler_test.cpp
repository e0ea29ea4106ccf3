// Euler operators: each keeps the structure valid and changes the terms of the Euler-Poincare formula as its name
// says, and a random sequence is undone to nothing.
#include <map>
#include <optional>

#include "bench/baseline/topology.h"
#include "bench/cases/random.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::bench::baseline_test {
namespace {

using namespace mantyla;

/// Changes of v, e, f, r.
struct Change {
  long v, e, f, r;
};

class RandomModel {
 public:
  explicit RandomModel(unsigned seed) : random_(seed) {}

  void step() {
    const EulerCounts before = topology_.validate();
    const std::optional<Change> change = operate();
    if (change) check(before, *change);
  }

  void undo() {
    while (!log_.empty()) {
      const EulerCounts before = topology_.validate();
      const Entry entry = log_.back();
      log_.pop_back();
      const Change c = undo(entry);
      check(before, c);
    }
    const EulerCounts counts = topology_.validate();
    CHECK(counts.vertices == 0);
    CHECK(counts.edges == 0);
    CHECK(counts.faces == 0);
  }

  std::map<std::string, int> used;

 private:
  enum class Kind { mvfs, mev, mef, kemr, mekr, kfmrh, mfkrh, ringmv };
  /// Half-edges that find the place again.
  struct Entry {
    Kind kind;
    HalfEdgeId a, b, c, d;
    bool turned = false;
  };

  void check(const EulerCounts& before, const Change& change) {
    const EulerCounts after = topology_.validate();
    CHECK(static_cast<long>(after.vertices) == static_cast<long>(before.vertices) + change.v);
    CHECK(static_cast<long>(after.edges) == static_cast<long>(before.edges) + change.e);
    CHECK(static_cast<long>(after.faces) == static_cast<long>(before.faces) + change.f);
    CHECK(static_cast<long>(after.rings) == static_cast<long>(before.rings) + change.r);
    const auto left =
        static_cast<long>(after.vertices + after.faces) - static_cast<long>(after.edges + after.rings);
    CHECK(left == 2 * (static_cast<long>(after.shells) - after.genus));
  }

  template <class Id>
  std::optional<Id> any(std::size_t ids) {
    for (int tries = 0; tries < 50 && ids > 0; ++tries) {
      const auto id = static_cast<Id>(random_.integer(0, static_cast<int>(ids) - 1));
      if (topology_.alive(id)) return id;
    }
    return std::nullopt;
  }

  HalfEdgeId of(const std::vector<HalfEdgeId>& all) {
    return all[static_cast<std::size_t>(random_.integer(0, static_cast<int>(all.size()) - 1))];
  }
  HalfEdgeId outer_start(FaceId face) const { return topology_.loop(topology_.face(face).loops.front()).start; }
  HalfEdgeId now(HalfEdgeId h) const {
    for (auto found = renamed_.find(h); found != renamed_.end(); found = renamed_.find(h)) h = found->second;
    return h;
  }
  void rename(HalfEdgeId from, HalfEdgeId to) {
    if (from != to) renamed_[from] = to;
  }

  std::optional<Change> operate() {
    constexpr auto none = kNo<HalfEdgeId>;
    const std::optional<HalfEdgeId> h = any<HalfEdgeId>(topology_.half_edge_ids());
    const int choice = random_.integer(0, 19);
    if (!h || choice == 0) {
      ++used["mvfs"];
      log_.push_back({Kind::mvfs, topology_.mvfs(0, 0).half_edge, none, none, none});
      return Change{1, 0, 1, 0};
    }
    if (choice < 7) {
      ++used["mev"];
      const EdgeId e = topology_.mev(*h, of(topology_.star(topology_.origin(*h))));
      log_.push_back({Kind::mev, topology_.edge(e).first, none, none, none});
      return Change{1, 1, 0, 0};
    }
    if (choice < 11) {
      ++used["mef"];
      const EdgeId e = topology_.mef(*h, of(topology_.cycle(topology_.loop(*h))));
      log_.push_back({Kind::mef, topology_.edge(e).first, none, none, none});
      return Change{0, 1, 1, 0};
    }
    if (choice < 14) {
      if (topology_.lone(*h)) return std::nullopt;
      const HalfEdgeId other = topology_.mate(*h);
      if (topology_.loop(*h) != topology_.loop(other) || topology_.origin(*h) == topology_.origin(other))
        return std::nullopt;
      ++used["kemr"];
      const LoopId old_loop = topology_.loop(*h);
      const LoopId ring = topology_.kemr(*h);
      log_.push_back({Kind::kemr, topology_.loop(old_loop).start, topology_.loop(ring).start, *h, other});
      return Change{0, -1, 0, 1};
    }
    const std::optional<FaceId> face = any<FaceId>(topology_.face_ids());
    const auto& loops = topology_.face(*face).loops;
    if (choice < 16) {
      if (loops.size() < 2) return std::nullopt;
      HalfEdgeId from = of(topology_.cycle(loops.front())), to = of(topology_.cycle(loops.back()));
      if (random_.integer(0, 1)) std::swap(from, to);
      if (topology_.origin(from) == topology_.origin(to)) return std::nullopt;
      ++used["mekr"];
      const bool turned = topology_.is_outer(topology_.loop(to));
      const Edge edge = topology_.edge(topology_.mekr(from, to));
      log_.push_back({Kind::mekr, edge.first, edge.second, none, none, turned});
      return Change{0, 1, 0, -1};
    }
    if (choice < 18) {
      const std::optional<FaceId> other = any<FaceId>(topology_.face_ids());
      if (*other == *face || loops.size() != 1) return std::nullopt;
      ++used["kfmrh"];
      const HalfEdgeId start = outer_start(*face);
      topology_.kfmrh(*other, *face);
      log_.push_back({Kind::kfmrh, start, none, none, none});
      return Change{0, 0, -1, 1};
    }
    if (loops.size() < 2) return std::nullopt;
    const HalfEdgeId ring = topology_.loop(loops.back()).start, outer = outer_start(*face);
    if (choice == 18) {
      ++used["mfkrh"];
      topology_.mfkrh(loops.back());
      log_.push_back({Kind::mfkrh, ring, outer, none, none});
      return Change{0, 0, 1, -1};
    }
    ++used["ringmv"];
    topology_.ringmv(loops.back(), *any<FaceId>(topology_.face_ids()));
    log_.push_back({Kind::ringmv, ring, outer, none, none});
    return Change{0, 0, 0, 0};
  }

  Change undo(const Entry& entry) {
    const HalfEdgeId a = now(entry.a);
    switch (entry.kind) {
      case Kind::mvfs: topology_.kvfs(topology_.face(a)); return {-1, 0, -1, 0};
      case Kind::mev: topology_.kev(a); return {-1, -1, 0, 0};
      case Kind::mef: topology_.kef(a); return {0, -1, -1, 0};
      case Kind::kemr: {
        const Edge edge = topology_.edge(topology_.mekr(a, now(entry.b)));
        rename(entry.c, edge.first);
        rename(entry.d, edge.second);
        return {0, 1, 0, -1};
      }
      case Kind::mekr: topology_.kemr(entry.turned ? now(entry.b) : a); return {0, -1, 0, 1};
      case Kind::kfmrh: topology_.mfkrh(topology_.loop(a)); return {0, 0, 1, -1};
      case Kind::mfkrh: topology_.kfmrh(topology_.face(now(entry.b)), topology_.face(a)); return {0, 0, -1, 1};
      case Kind::ringmv: topology_.ringmv(topology_.loop(a), topology_.face(now(entry.b))); return {0, 0, 0, 0};
    }
    return {};
  }

  Random random_;
  Topology topology_;
  std::vector<Entry> log_;
  std::map<HalfEdgeId, HalfEdgeId> renamed_;
};

}  // namespace

TEST_CASE("random Euler operators are undone to nothing") {
  const auto [first, last] = scenes::seeds(40);
  std::map<std::string, int> used;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("seed " << seed);
    RandomModel model(static_cast<unsigned>(seed));
    for (int k = 0; k < 150; ++k) model.step();
    model.undo();
    for (const auto& [name, count] : model.used) used[name] += count;
  }
  for (const char* name : {"mvfs", "mev", "mef", "kemr", "mekr", "kfmrh", "mfkrh", "ringmv"}) {
    INFO(name);
    CHECK(used[name] > 50);
  }
}

TEST_CASE("general mev splits a vertex and kev joins it again") {
  Topology topology;
  // A tetrahedron: the vertex 0 has three edges; two of them go to the new vertex.
  topology.assemble({{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}, 4, 0, 0);
  const std::vector<HalfEdgeId> star = topology.star(static_cast<VertexId>(0));
  REQUIRE(star.size() == 3);
  const EdgeId edge = topology.mev(star[0], star[2]);
  const HalfEdgeId first = topology.edge(edge).first, second = topology.edge(edge).second;
  CHECK(topology.star(topology.origin(first)) == std::vector<HalfEdgeId>{first, star[0], star[1]});
  CHECK(topology.star(topology.origin(second)) == std::vector<HalfEdgeId>{second, star[2]});
  CHECK(topology.validate().vertices == 5);
  topology.kev(first);
  CHECK(topology.validate().vertices == 4);
  CHECK(topology.star(topology.origin(star[0])).size() == 3);
}

TEST_CASE("a torus from Euler operators has genus 1") {
  // A box's top and bottom, joined by a tunnel: kfmrh of a face of the same shell makes a hole.
  Topology topology;
  topology.assemble({{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}, 4, 0, 0);
  CHECK(topology.validate().genus == 0);
  topology.kfmrh(static_cast<FaceId>(0), static_cast<FaceId>(1));
  const EulerCounts counts = topology.validate();
  CHECK(counts.genus == 1);
  CHECK(counts.shells == 1);
  topology.mfkrh(topology.face(static_cast<FaceId>(0)).loops.back());
  CHECK(topology.validate().genus == 0);
}

TEST_CASE("operators refuse what they cannot do and change nothing") {
  Topology topology;
  topology.assemble({{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}, 4, 0, 0);
  const HalfEdgeId h = topology.edge(static_cast<EdgeId>(0)).first;
  CHECK_THROWS_AS(topology.mef(h, topology.mate(h)), TopologyError);
  CHECK_THROWS_AS(topology.mev(h, topology.next(h)), TopologyError);
  CHECK_THROWS_AS(topology.kemr(h), TopologyError);
  CHECK_THROWS_AS(topology.mekr(h, topology.next(h)), TopologyError);
  CHECK_THROWS_AS(topology.kvfs(static_cast<FaceId>(0)), TopologyError);
  CHECK_THROWS_AS(topology.mfkrh(static_cast<LoopId>(0)), TopologyError);
  CHECK_THROWS_AS(topology.kev(static_cast<HalfEdgeId>(1000)), TopologyError);
  const EulerCounts counts = topology.validate();
  CHECK(counts.vertices == 4);
  CHECK(counts.edges == 6);
  CHECK(counts.faces == 4);
}

}  // namespace cnrg::bench::baseline_test
