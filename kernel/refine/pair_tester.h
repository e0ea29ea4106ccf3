// Decides for two inputs, by exact signs, where they meet; notes it as symbols (contacts.h).
#pragma once

#include <algorithm>
#include <deque>
#include <unordered_map>
#include <vector>

#include "kernel/base/union_find.h"
#include "kernel/refine/contacts.h"
#include "kernel/refine/input.h"

namespace cnrg {

// Which corners and sides a face has, looked up.

/// Is a corner or a side one of a face's? Looked up where there are many, so that a disc with a wall at each of
/// its sides does not cost the square of their number.
class FaceBoundaries {
 public:
  explicit FaceBoundaries(const RefineInput& in) : in_(in) {
    for (const SourceId f : IdRange<SourceId>(in.corners.size())) {
      if (in.corners[f].size() <= kFew) continue;
      Sorted& sorted = large_[f.value()];
      sorted.corners.assign(in.corners[f].begin(), in.corners[f].end());
      sorted.sides.assign(in.sides[f].begin(), in.sides[f].end());
      std::sort(sorted.corners.begin(), sorted.corners.end());
      std::sort(sorted.sides.begin(), sorted.sides.end());
    }
  }
  bool has_corner(SourceId f, VertexId v) const {
    const auto corners = in_.corners[f];
    if (corners.size() <= kFew) return std::find(corners.begin(), corners.end(), v) != corners.end();
    const std::vector<VertexId>& sorted = large_.at(f.value()).corners;
    return std::binary_search(sorted.begin(), sorted.end(), v);
  }
  bool has_side(SourceId f, SegmentId s) const {
    const auto sides = in_.sides[f];
    if (sides.size() <= kFew) return std::find(sides.begin(), sides.end(), s) != sides.end();
    const std::vector<SegmentId>& sorted = large_.at(f.value()).sides;
    return std::binary_search(sorted.begin(), sorted.end(), s);
  }

 private:
  static constexpr std::size_t kFew = 16;
  struct Sorted {
    std::vector<VertexId> corners;
    std::vector<SegmentId> sides;
  };
  const RefineInput& in_;
  std::unordered_map<std::uint32_t, Sorted> large_;
};

/// The pair tests of one thread, with its scratch memory and what it found.
class PairTester {
 public:
  /// `copies` of EqualFaces in contacts.cpp: a face stands for all that are equal to it.
  PairTester(const RefineInput& in, const FaceBoundaries& boundaries, const std::vector<std::uint32_t>& copies)
      : in_(in), t_(in.points), boundaries_(boundaries), copies_(copies) {}
  ContactList list;
  std::uint64_t filtered = 0;  ///< signs that the filters of planes decided

  void faces(SourceId f, SourceId g);
  void wire_face(SegmentId s, SourceId f);
  void point_face(VertexId p, SourceId f);
  void wires(SegmentId s, SegmentId t);
  void point_wire(VertexId p, SegmentId s);

 private:
  /// A point of a face on the common line of two planes.
  struct Event {
    PointKey key;
    PointView view;
    bool covered_after = false;  ///< the open interval to the next event belongs to the face
    int toggles = 0, depth = 0;  ///< see `cut`
  };
  enum class Contact { none, coplanar, possible };
  /// Signs of the corners of f against the plane of g; corners shared with g count as on it.
  Contact signs(SourceId f, SourceId g, std::vector<int>& out);
  bool only_shared(SourceId f, SourceId g, const std::vector<int>& sign) const;
  bool apart(SourceId f, SourceId g) const;
  /// A point in the plane of a face.
  void point_in_plane(VertexId p, SourceId f);
  void cut(SourceId f, SourceId g, const std::vector<int>& sign, std::vector<Event>& events);
  PointView view_of_key(const PointKey& key, const Definition& d);
  int order(Event& a, Event& b);
  const ExactPoint& exact(Event& e);
  std::uint64_t copies(SourceId f) const { return copies_.empty() ? 1 : copies_[f.index()]; }
  bool has_corner(SourceId f, VertexId v) const { return boundaries_.has_corner(f, v); }
  void choose_axis();
  /// Do chains of pairs found so far say that two faces are coplanar? No filter does, and exact zeros cost most.
  bool known_coplanar(SourceId f, SourceId g) {
    if (planes_.size() != 0 && planes_.find(f.value()) == planes_.find(g.value())) return true;
    // Pieces of one input face have its plane, by its three points.
    const auto [a, b, c] = t_.plane_points(RefineInput::plane(f));
    const auto [d, e, h] = t_.plane_points(RefineInput::plane(g));
    return a == d && ((b == e && c == h) || (b == h && c == e));
  }
  void note_coplanar(SourceId f, SourceId g) {
    if (planes_.size() == 0) planes_ = UnionFind(in_.corners.size());
    if (planes_.unite(f.value(), g.value())) list.coplanar.push_back(std::minmax(f, g));
  }

  const RefineInput& in_;
  const PointTable& t_;
  const FaceBoundaries& boundaries_;
  const std::vector<std::uint32_t>& copies_;
  UnionFind planes_;  // faces found coplanar with each other; empty until there are such
  std::vector<int> sign_f_, sign_g_;
  std::vector<Event> events_f_, events_g_;
  std::deque<ExactPoint> exact_;  // values of events that no table holds
  int axis_ = -1;                 // coordinate that orders the common line; -1: lexicographic order
};

/// Where a point of the plane of a face lies: 0 outside, 1 on the boundary, 2 inside.
int locate_in_face(const RefineInput& input, SourceId face, Projection axes, const PointView& p);

}  // namespace cnrg
