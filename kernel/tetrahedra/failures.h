// Local moves that were tried and made nothing better.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "kernel/tetrahedra/stars.h"

namespace cnrg {

/// The moves that made nothing better. A move looks at nothing but the star of a vertex, so until that changes it
/// need not be tried again, whichever of the bad tetrahedra around asks for it: a bad one has bad neighbours.
class Failures {
 public:
  using Index = Stars::Index;
  explicit Failures(const Stars& mesh) : mesh_(mesh) {}

  bool edge(Index a, Index b) { return has(at(std::min(a, b)).edges, std::max(a, b)); }
  void add_edge(Index a, Index b) { at(std::min(a, b)).edges.push_back(std::max(a, b)); }
  /// Of `a` into `b`.
  bool collapse(Index a, Index b) { return has(at(a).collapses, b); }
  void add_collapse(Index a, Index b) { at(a).collapses.push_back(b); }
  /// With that gain or less: what gains less than that does not gain more.
  bool smooth(Index v, double gain) { return gain >= at(v).gain; }
  void add_smooth(Index v, double gain) { at(v).gain = gain; }
  void clear() { vertices_.clear(); }

 private:
  struct Vertex {
    std::uint64_t since = 0;  // the number of changes then
    double gain = std::numeric_limits<double>::infinity();
    std::vector<Index> edges, collapses;  // their other ends
  };
  const Stars& mesh_;
  std::vector<Vertex> vertices_;

  static bool has(const std::vector<Index>& list, Index v) {
    return std::find(list.begin(), list.end(), v) != list.end();
  }
  Vertex& at(Index v) {
    if (v >= vertices_.size()) vertices_.resize(mesh_.point_count());
    Vertex& vertex = vertices_[v];
    if (mesh_.changed_at(v, vertex.since)) {
      vertex.gain = std::numeric_limits<double>::infinity();
      vertex.edges.clear(), vertex.collapses.clear();
      vertex.since = mesh_.changes();
    }
    return vertex;
  }
};

}  // namespace cnrg
