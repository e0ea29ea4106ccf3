// The cells of a result file in the complex that they make, one by one.
//
// The file's cells are refined by themselves. If it is right then nothing is cut: every cell of the complex is one
// cell of the file, but that a face that is not flat has a face for each facet, and an edge an edge for each step.
// Otherwise the first cell of the file that is cut, covered or missing is the fault.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "csg/imports/result_content.h"
#include "kernel/complex/complex.h"

namespace cnrg::result {

using Step = std::pair<Index, Index>;  ///< from point to point

inline VertexId vertex(Index point) {
  return VertexId(point);
}  // points of a soup, all distinct, keep their numbers
inline Index point(VertexId v) { return v.value(); }

/// For messages: `face 3`, `[1, 2, 3]`.
std::string words(const char* kind, Index number);
std::string words(const std::vector<Index>& list);
std::string words(const std::vector<Loop>& loops);

template <class See>
void for_each_step(const std::vector<Loop>& walks, See see) {
  for (const Loop& walk : walks) {
    for (std::size_t i = 0; i < walk.size(); ++i) see(Step(walk[i], walk[i + 1 < walk.size() ? i + 1 : 0]));
  }
}

class PlacedCells {
 public:
  /// `complex` is that of the content alone (`add_to`). Throws LeafFileError for cells that are not placed. All
  /// three must outlive this.
  PlacedCells(const Cursor& root, const Content& content, const Complex& complex);

  const Cursor& root;
  const Content& content;
  const CellTable& table;
  const Complex& complex;
  IdVector<EdgeId, Index> edge_of;      ///< of the file; kNone: between facets of a face
  IdVector<FaceId, Index> facet_of;     ///< of the file
  std::vector<FaceId> cell_of;          ///< by facet of the file
  IdVector<RegionId, Index> region_of;  ///< of the file; kNone only for R0, when the file has no region
  std::vector<RegionId> place_of;       ///< by region of the file; none() for one that no face names
  std::vector<Index> segments_at;       ///< by point: how many steps of edges end there

  Cursor edge_at(Index i) const { return root.member("edges").at(i); }
  Cursor face_at(Index i) const { return root.member("faces").at(i); }

  /// The front of a facet's face is that of the facet.
  bool same(FaceId f) const { return complex.cover(f)[0].same; }
  HalfFace half_face(FaceId f, unsigned side) const { return HalfFace(f, same(f) ? side : 1 - side); }
  bool on_edge(const Step& step) const { return table.segments.contains(std::minmax(step.first, step.second)); }

  // The component that the file says.
  Index component(RegionId r) const;
  Index component(FaceId f) const { return table.faces[content.facets[facet_of[f]].face]; }
  Index component(EdgeId e) const;
  Index component(VertexId v) const;

 private:
  struct Fault;
  void tell(const Fault& first) const;
  void edges_on(EdgeId e, std::vector<Index>& out) const;
  void faces_on(FaceId f, std::vector<Index>& out) const;
  void require_no_crossing() const;
  bool walks_along(Index face, Index edge) const;
  void place_edges();
  void place_inner_side(EdgeId e, Index a, Index b, Fault& first) const;
  void place_facets();
  void place_regions();
};

/// Holds what the file says of a face against its place: loops, fronts, triangles, cells of patches.
void check_face(const PlacedCells& placed, const Face& face, const Cursor& at);

}  // namespace cnrg::result
