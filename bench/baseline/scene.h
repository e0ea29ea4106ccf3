// What the stages of the Boolean share: both operands in one half-edge structure, with coordinates.
//
// Notation. A and B are solids 0 and 1. IN and OUT are sides of the other operand. A null edge has no length; its
// first half starts at the vertex that keeps the OUT part of the neighbourhood. Null edges come in pairs, one of A
// and one of B, at each point where the intersection curve turns. With n the outward normals of the faces fA and
// fB whose intersection leaves such a point along nB x nA, that `forward` end is the first half of A's null edge
// (it lies in fA) with the second half of B's; the `backward` end, where the curve arrives, is the other two.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "bench/baseline/geometry.h"
#include "bench/baseline/mantyla.h"
#include "bench/baseline/topology.h"

namespace cnrg::bench::mantyla {

/// The side of the other operand.
enum class Side : std::uint8_t { in, out, on };

/// A vertex of solid `solid` that lies inside of a face of the other.
struct VertexFace {
  std::uint32_t solid;
  VertexId vertex;
  FaceId face;
};
/// A vertex of A and one of B at one place.
struct VertexVertex {
  VertexId a, b;
};

/// A direction from a contact in which the boundaries cross.
template <class N>
struct Ray {
  Vec<N> direction;
  bool forward = false;  ///< the end of a null edge that it will belong to
};

/// The neighbourhood of a contact on one solid is a clockwise list of its half-edges and of rays, which lie in the
/// corners between them.
struct StarItem {
  HalfEdgeId half_edge = kNo<HalfEdgeId>;  ///< none: a ray
  std::uint32_t ray = 0;                   ///< its place in the contact's list
};

/// A contact whose neighbourhoods cross.
template <class N>
struct Crossing {
  std::array<VertexId, 2> vertices{kNo<VertexId>, kNo<VertexId>};  ///< none: inside of `face`
  FaceId face = kNo<FaceId>;                                       ///< of the solid whose vertex is missing
  Vec<N> point;
  std::vector<Ray<N>> rays;
  std::array<std::vector<StarItem>, 2> stars;
};

template <class N>
struct NullPair {
  std::array<EdgeId, 2> edges;
  Vec<N> point;
  Vec<N> forward, backward;  ///< directions of its ends
};

/// A piece of the intersection curve, joined: its sides in the null faces, by solid.
struct Joint {
  std::uint32_t from, to;  ///< null pairs: forward end, backward end
  std::array<HalfEdgeId, 2> in, out;
};

/// A null face: a half-edge of each of its loops.
struct NullFace {
  HalfEdgeId in, out;
};

/// The boundary of an operand as it was given, for point location.
template <class N>
struct Boundary {
  std::vector<Plane<N>> planes;
  std::vector<std::vector<std::vector<Vec<N>>>> loops;  ///< by face
};

template <class N>
struct Scene {
  Operation operation;
  Departures departures;
  Metric<N> metric;
  Topology topology;
  std::vector<Vec<N>> points;      ///< by vertex
  std::vector<Plane<N>> surfaces;  ///< by Face::surface
  std::array<Boundary<N>, 2> boundaries;
  double extent = 1;  ///< the largest coordinate, at least 1e-300

  std::vector<VertexFace> vertex_faces;
  std::vector<VertexVertex> vertex_vertices;
  std::vector<Crossing<N>> crossings;
  std::vector<NullPair<N>> null_pairs;
  std::vector<Joint> joints;
  std::array<std::vector<NullFace>, 2> null_faces;  ///< by solid, in the order in which they closed
  std::vector<std::array<NullFace, 2>> curves;      ///< by solid: the null faces that are glued
  std::vector<bool> kept_faces;                     ///< by face: whether the result has it

  const Vec<N>& point(VertexId v) const {
    require(static_cast<std::size_t>(v) < points.size(), "a vertex that is killed");
    return points[static_cast<std::size_t>(v)];
  }
  const Plane<N>& plane(FaceId f) const { return surfaces.at(topology.face(f).surface); }
  /// After mev: gives its new vertex a place.
  void place(VertexId v, const Vec<N>& p) {
    if (points.size() <= static_cast<std::size_t>(v)) points.resize(static_cast<std::size_t>(v) + 1);
    points[static_cast<std::size_t>(v)] = p;
  }
  /// The side that the result keeps of a solid.
  Side kept(int solid) const {
    if (operation == Operation::unite) return Side::out;
    return operation == Operation::subtract && solid == 0 ? Side::out : Side::in;
  }
  /// The side of a sector in the plane of one of the other solid, normals alike or opposed (mantyla1988, table of
  /// section 15.6): of two alike A's stays, opposed ones vanish but from a difference, where A's stays.
  Side coplanar_side(int solid, bool alike) const {
    const bool unite = operation == Operation::unite;
    if (alike && solid == 0) return unite ? Side::out : Side::in;
    return unite ? Side::in : Side::out;
  }
  /// The side of an edge on the other boundary between an IN and an OUT sector. It only has to be the same at both
  /// ends: A grows in a union, shrinks otherwise.
  Side edge_side(int solid) const {
    return (operation == Operation::unite) == (solid == 0) ? Side::out : Side::in;
  }
  /// Of an edge that lies in a face, and of one that lies in a sector at a vertex of the other solid.
  Side edge_in_face(int solid) const { return departures.sides ? edge_side(solid) : Side::in; }
  Side edge_in_sector(int solid) const { return edge_side(departures.single ? solid : 0); }
};

/// Runs a part of a stage: what the structure or an array refuses fails in it. `places()` is where, if the failure
/// does not know it.
template <class Step, class Places>
auto staged(Stage stage, Step&& step, Places&& places) {
  try {
    return step();
  } catch (const Failure& failure) {
    if (!failure.places().empty()) throw;
    throw Failure(failure.stage(), failure.what(), places());
  } catch (const std::logic_error& error) {
    throw Failure(stage, error.what(), places());
  }
}
template <class Step>
auto staged(Stage stage, Step&& step) {
  return staged(stage, step, [] { return Failure::Places(); });
}

/// A state that no right result has.
inline void check(const Departures& departures, bool holds, Stage stage, const char* what) {
  if (!holds && departures.checks) throw Failure(stage, what);
}

/// The place where a half-edge starts, for a failure.
template <class N>
Failure::Places places_of(const Scene<N>& scene, HalfEdgeId half_edge) {
  return {exact(scene.point(scene.topology.origin(half_edge)))};
}

/// The stages in order. Each throws Failure; TopologyError of the structure counts for the stage that runs.
template <class N>
Scene<N> read_operands(const Model& a, const Model& b, Operation operation, const N& epsilon,
                       const Departures& departures);
template <class N>
void reduce(Scene<N>& scene);
template <class N>
void classify(Scene<N>& scene);
template <class N>
void insert_null_edges(Scene<N>& scene);
template <class N>
void connect(Scene<N>& scene);
/// Takes the operands apart, along `curves`, and chooses `kept_faces`.
template <class N>
void part(Scene<N>& scene);
/// Gives the faces of the result.
template <class N>
std::vector<FaceId> glue(Scene<N>& scene);
template <class N>
Model write_result(const Scene<N>& scene, const std::vector<FaceId>& faces);

/// The stages after the first one. `after` sees the scene after each of them but the last; after finishing the
/// operands are parted, not yet glued.
template <class N>
Model run_stages(Scene<N>& scene, const std::function<void(Stage)>& after = {});

/// All stages; faces of doubles stay as they are and may be rounded out of their planes.
template <class N>
Model evaluate(const Model& a, const Model& b, Operation operation, const N& epsilon,
               const Departures& departures = {});

/// Where a face of a model lies against the given boundary of the other solid. `Side::on`: in a face of it, whose
/// normal goes to `normal`. Throws Failure (finishing) when no ray decides.
template <class N>
Side locate_point(const Metric<N>& metric, const Boundary<N>& boundary, const Vec<N>& p, Vec<N>& normal);
/// A point inside of a face with area.
template <class N>
Vec<N> inner_point(const Vec<N>& normal, const std::vector<std::vector<Vec<N>>>& loops);
/// Twice the area of a loop as seen against the normal, as a product of lengths; negative: clockwise.
template <class N>
N signed_area(const Scene<N>& scene, const Vec<N>& normal, LoopId loop);

}  // namespace cnrg::bench::mantyla
