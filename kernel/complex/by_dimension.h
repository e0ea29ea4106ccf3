// The same for cells of each dimension: structures whose members `vertices`, `edges`, `faces` and mostly `regions`
// are lists or arrays, such as `CellSet`.
#pragma once

#include <type_traits>

#include "kernel/complex/complex.h"

namespace cnrg {

/// f(vertices of each of `of`), then of their edges, faces and 3-cells.
template <class F, class... Of>
void for_each_dimension(F f, Of&&... of) {
  f(of.vertices...);
  f(of.edges...);
  f(of.faces...);
  f(of.regions...);
}

/// f(faces of each of `of`), then of their edges and vertices.
template <class F, class... Of>
void for_each_entity(F f, Of&&... of) {
  f(of.faces...);
  f(of.edges...);
  f(of.vertices...);
}

/// The member of `of` for cells such as this one.
template <class Of, class IdT>
auto& list_for(Of& of, IdT) {
  if constexpr (std::is_same_v<IdT, VertexId>) return of.vertices;
  else if constexpr (std::is_same_v<IdT, EdgeId>) return of.edges;
  else if constexpr (std::is_same_v<IdT, FaceId>) return of.faces;
  else return of.regions;
}

/// f(the id of the cell that a location names).
template <class F>
decltype(auto) with_id(const Location& at, F f) {
  switch (at.dimension) {
    case 0: return f(at.vertex);
    case 1: return f(at.edge);
    case 2: return f(at.face);
    default: return f(at.region);
  }
}

/// A list for each dimension, or an array over all cells of a complex.
template <template <class> class List>
struct OfCells {
  OfCells() = default;
  explicit OfCells(const Complex& complex)
      : vertices(complex.points.size()),
        edges(complex.edge_count()),
        faces(complex.face_count()),
        regions(complex.region_count) {}
  List<VertexId> vertices;
  List<EdgeId> edges;
  List<FaceId> faces;
  List<RegionId> regions;
};

/// The same without 3-cells.
template <template <class> class List>
struct OfEntities {
  OfEntities() = default;
  explicit OfEntities(const Complex& complex)
      : faces(complex.face_count()), edges(complex.edge_count()), vertices(complex.points.size()) {}
  List<FaceId> faces;
  List<EdgeId> edges;
  List<VertexId> vertices;
};

}  // namespace cnrg
