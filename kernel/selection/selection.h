// A selection on the complex (cavalcanti1997): for each cell of any dimension a component, or inactive.
//
// Sparse: only active cells are listed, sorted by id, so that a value costs what it touches. Components are
// numbered from 1; their attributes live with whoever numbered them.
//
// Topology is read off the complex by incidence (csg/SEMANTICS.md#cells-and-selections): a cell is interior to a
// set when its whole star is in the set; the closure adds the boundaries of cells. With a frame, cells on or
// outside of it belong to no set, and what lies beyond it is not asked.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

using Component = std::uint32_t;  ///< 0: inactive

struct Selection {
  std::vector<std::pair<VertexId, Component>> vertices;
  std::vector<std::pair<EdgeId, Component>> edges;
  std::vector<std::pair<FaceId, Component>> faces;
  std::vector<std::pair<RegionId, Component>> regions;
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// Entities in their own right that `simplify` keeps (csg/SEMANTICS.md#simplification); sorted.
struct Features {
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;
};

/// A set of cells of any dimension, each list ascending and unique.
struct CellSet {
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;
  std::vector<RegionId> regions;
  bool empty() const { return vertices.empty() && edges.empty() && faces.empty() && regions.empty(); }
  std::size_t size() const { return vertices.size() + edges.size() + faces.size() + regions.size(); }
  friend bool operator==(const CellSet&, const CellSet&) = default;
};

/// The active cells of a selection: |X|.
CellSet support(const Selection& selection);
/// The cells of one component.
CellSet support(const Selection& selection, Component component);
/// All cells of the complex, but those on the frame or outside of it.
CellSet all_cells(const Complex& complex);

CellSet unite(const CellSet& a, const CellSet& b);
CellSet intersect(const CellSet& a, const CellSet& b);
CellSet subtract(const CellSet& a, const CellSet& b);

/// The cells whose closure holds a cell of the set, the set included (the smallest open set of cells around it).
CellSet star(const Complex& complex, const CellSet& set);
/// The set and the boundaries of its cells.
CellSet closure(const Complex& complex, const CellSet& set);
/// The cells of the set whose star is in the set.
CellSet interior(const Complex& complex, const CellSet& set);
/// cl S - int S, which is what cl S and the closure of the complement have in common.
CellSet boundary(const Complex& complex, const CellSet& set);

/// The selection restricted to a set: its cells outside of the set are inactive.
Selection restrict_to(const Selection& selection, const CellSet& set);
/// The selection with the cells of `set` added as `component`; cells that are active keep theirs.
Selection add_component(const Selection& selection, const CellSet& set, Component component);

}  // namespace cnrg
