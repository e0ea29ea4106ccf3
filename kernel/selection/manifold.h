// What a point set looks like around its edges and vertices: manifold, with boundary, or neither and how.
//
// Asked of the closure of a set (what is missing from an open set is the business of its Betti numbers). A vertex
// is seen by what the closure leaves on its small sphere: a closed set of germs, arcs and nodes; an edge by the
// same on a circle, the sectors and uses around it. The terms are weiler1986's: a set is a manifold with boundary
// where that is all of the sphere, a disk (of solid), a circle (a sheet), an arc (its border).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kernel/selection/neighbourhood.h"
#include "kernel/selection/selection.h"

namespace cnrg {

enum class LocalForm : std::uint8_t {
  interior,        ///< the set all around
  manifold,        ///< on the boundary of solid, which is one half-ball there
  surface,         ///< inside a sheet without solid
  surface_border,  ///< on the border of one sheet
  wire,            ///< inside a curve without faces
  wire_end,        ///< the end of one
  isolated_point,
  non_manifold,  ///< none of these; the reason says how
};
/// Such as `surface border`.
const char* to_string(LocalForm form);

struct LocalShape {
  LocalForm form = LocalForm::interior;
  /// Of `non_manifold`, such as `4 boundary faces meet: 2 solid sectors` or `2 solid cones touch`.
  std::string reason;
  friend bool operator==(const LocalShape&, const LocalShape&) = default;
};

/// The shape at each edge and vertex of the closure of a set, ascending.
struct Manifoldness {
  std::vector<std::pair<EdgeId, LocalShape>> edges;
  std::vector<std::pair<VertexId, LocalShape>> vertices;
  /// No edge and no vertex is `non_manifold`.
  bool manifold() const;
};
Manifoldness manifoldness(const Complex& complex, const CellSet& set, Neighbourhoods& neighbourhoods);

/// Faces without solid of a set on both sides, joined over the edges that are `surface`.
struct Sheet {
  std::vector<FaceId> faces;  ///< ascending
  bool orientable = true;     ///< false for a one-sided sheet, such as a Moebius strip
  bool closed = true;         ///< no other edge of the closure bounds it
};
/// The sheets of the closure of a set, by first face. The boundary of solid needs no such question: it has a side
/// with solid and one without, so it is orientable, shell by shell.
std::vector<Sheet> sheets(const Complex& complex, const CellSet& set);

}  // namespace cnrg
