// The neighbourhood of a vertex: a planar graph on a small sphere around it (Gursoz et al. 1991 call its faces
// zones; in a Nef polyhedron it is the sphere map, granados2003 2).
//
// Notation, all seen from outside of the sphere:
//   node    the germ of an edge that ends in the vertex
//   arc     the germ of a face: one corner of it. From the node of the half-edge that leaves the vertex (its tail)
//           to that of the one that arrives (its head), counter-clockwise as seen from the front of the face,
//           which lies to its left. The tip of a slit is an arc from a node to itself; a vertex in the interior of
//           a face has there an arc without nodes, a full circle.
//   dart    an end of an arc at a node; darts around a node are listed counter-clockwise
//   side    a side of an arc (0: the face's front), as code arc * 2 + side
//   circle  a closed walk of sides with one germ to the left, or a node without arcs (a wire) walked around
//   germ    a face of the graph, the germ of a region; it has as many boundary circles as connected parts of the
//           graph touch it: none for an isolated vertex, one for a disk, more where the graph is not connected
// A region, face or edge may be there several times.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/complex/complex.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

struct Neighbourhood {
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffffffffu;

  struct Dart {
    Index arc = 0;
    unsigned end = 0;  ///< 0: the arc's tail, 1: its head
    Index use = 0;     ///< index into the values of `Complex::edge_uses`
    /// The sector of the edge that follows counter-clockwise, up to the next dart: the use which it lies after
    /// in the radial order of the edge, and its germ.
    Index sector = 0, germ = 0;
  };
  struct Node {
    HalfEdge edge;               ///< leaves the vertex
    Index first = 0, count = 0;  ///< its darts; none for a wire
    Index germ = kNone;          ///< of a wire: what lies around it
    Index part = 0;              ///< the connected part of the graph, from 0
  };
  struct Arc {
    FaceId face;
    std::array<Index, 2> nodes{kNone, kNone};  ///< of the tail and the head; none for a full circle
    std::array<Index, 2> germs{};              ///< on the front and on the back
    Index use = kNone;  ///< of the half-edge that arrives: names the corner; none for a full circle
    Index part = 0;
    bool full_circle() const { return nodes[0] == kNone; }
  };
  struct Circle {
    Index germ = 0;
    Index first = 0, count = 0;  ///< its sides, in order; none around a wire
    Index node = kNone;          ///< the wire that it goes around
    Index part = 0;
  };
  struct Germ {
    RegionId region;
    std::int64_t circles = 0;
    /// The Euler characteristic of the open piece of the sphere.
    std::int64_t euler() const { return 2 - circles; }
  };

  VertexId vertex;
  std::vector<Node> nodes;  ///< ascending by edge
  std::vector<Dart> darts;  ///< by node
  std::vector<Arc> arcs;    ///< full circles last
  std::vector<Circle> circles;
  std::vector<Index> sides;  ///< by circle
  std::vector<Germ> germs;
  Index parts = 0;  ///< connected parts of the graph

  std::span<const Dart> around(const Node& node) const { return {darts.data() + node.first, node.count}; }
  std::span<const Index> sides_of(const Circle& c) const { return {sides.data() + c.first, c.count}; }
  /// V - E + F, which is 1 + parts on a sphere. A full circle adds nothing: it is as good as a node with an arc.
  std::int64_t euler() const;
};

/// Neighbourhoods on demand. Asking costs the size of the vertex' star; the first time that a face is met, the
/// length of its loops too. Not for several threads at once.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(const Complex& complex);
  const Complex& complex() const { return complex_; }
  /// Overwrites `out`. Throws InvariantError if the walk around a germ passes two regions.
  void at(VertexId v, Neighbourhood& out);
  Neighbourhood at(VertexId v);
  /// The index of a use among the values of `Complex::edge_uses`.
  std::uint32_t use_of(FaceId f, HalfEdge h) const;

 private:
  void link(FaceId f);
  const Complex& complex_;
  Marks<FaceId> linked_;
  using Use = Id<struct LinkedUseTag>;
  Scratch<Use, std::uint32_t> next_;  // the use that follows in the loop
};

}  // namespace cnrg
