// The shape of a result: vertices, edges and faces that are shared by all that have them. Knows OpenCASCADE's
// types.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <set>
#include <vector>

#include "csg/exports/occt_curves.h"

namespace cnrg::occt {

/// What cells of one part have in common: the component, and what is said of them (CadParts::said_of).
using CadPartOf = std::pair<Component, FlatComplex::Index>;

/// A solid, a sheet (shell or face), a wire, or a compound of all points of one kind.
struct CadPart {
  TopoDS_Shape shape;
  CadPartOf of{0, FlatComplex::kNone};
  std::set<LeafId> leaves{};  ///< that it came from; not of solids
};

struct CadModelMade {
  std::vector<CadPart> parts;
  TopoDS_Shape whole;      ///< their compound
  double off_surface = 0;  ///< farthest of an edge from one of its surfaces
  double off_curve = 0;    ///< farthest of an edge from itself in the parameters of a face
  std::size_t moved = 0;   ///< vertices that were moved to the surfaces
  double farthest = 0;
  std::size_t splines = 0;  ///< edges that are no lines and circles
};

/// Faces that cannot be made, or that OpenCASCADE finds wrong, are added to `failed`; then nothing else counts.
CadModelMade make_model(const CadParts& parts, const Faceted& faceted, double tolerance, Faceted& failed);

}  // namespace cnrg::occt
