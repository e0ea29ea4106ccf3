// A result as a CAD program sees it, before that has anything to do with it: cells with what carries them.
//
// Facets stand for surfaces. A face of a result whose patch has a surface with a name (csg/curves/surface.h) is a
// face on that surface; any other is as flat as its facets. Here surfaces are collected, each once, with places on
// them at which the search for the parameters of a point can begin.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csg/curves/surface.h"
#include "csg/result/flat.h"

namespace cnrg {

using CadPoint = std::array<double, 3>;
using CadParameters = std::array<double, 2>;

struct CadParts {
  using Index = FlatComplex::Index;
  struct Plane {
    CadPoint point{}, normal{};  ///< the normal has the length 1 and points to the front
  };
  struct Facet {
    std::vector<FlatComplex::Loop> loops;
    Plane plane;
    /// Parameters of the surface near to those of corners, where they are known.
    std::map<Index, CadParameters> near;
  };
  struct Face {
    std::optional<Index> surface;  ///< of `surfaces`; none: its facets are what is meant
    std::vector<Facet> facets;     ///< one of a flat face
    bool flat = true;
    std::string why;  ///< of a curved face without a surface: why there is none
  };
  struct Edge {
    std::vector<Index> surfaces;  ///< on which all of it lies, in faces of the result or not
    std::optional<Index> curve;   ///< of `curves`
    std::vector<double> at;       ///< parameters of its points on the curve, ascending or descending
  };
  struct Attributes {
    std::string name, material, color;  ///< the colour `#rrggbb`, or empty
  };

  FlatComplex flat;
  std::string name;
  std::vector<CadPoint> points;  ///< of `flat`, by number
  double size = 0;               ///< the diagonal of the box around them
  std::vector<SurfaceForm> surfaces;
  std::vector<std::string> surface_names;  ///< such as `sphere of ball`
  std::vector<CurveForm> curves;
  std::vector<Face> faces;             ///< parallel to those of `flat`
  std::vector<Edge> edges;             ///< the same
  std::vector<Attributes> components;  ///< by number, from 1
  std::vector<char>
      called_as_leaves;          ///< by component, from 1: what bounds no region of it is called as its leaves
  std::vector<Attributes> said;  ///< of sheets, wires and points, each once
  std::array<std::vector<Index>, 3> said_of;  ///< by dimension and cell of `flat`: a place in `said`, or kNone
  std::vector<LeafInfo> leaves;               ///< by LeafId
};

/// Throws InputError for a result with open sets or without bounds; `format` begins the message.
CadParts cad_parts(const ResultView& view, const std::string& format);

}  // namespace cnrg
