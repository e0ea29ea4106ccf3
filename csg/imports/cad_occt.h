// OpenCASCADE's part of CAD leaves: files to shapes, shapes to facets. The only header that knows its types.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

#include "csg/imports/cad_model.h"

namespace cnrg::occt {

/// What a file holds, in the unit of the model.
struct CadFile {
  TopoDS_Shape shape;
  std::vector<std::pair<TopoDS_Shape, std::string>> solids;  ///< as they are in `shape`, with names
  std::vector<std::string> notices;
};

/// Errors as at read_cad.
CadFile read_step(const CadShape& shape, const std::string& content);
CadFile read_brep(const CadShape& shape, const std::string& content);

/// Meshes the faces and edges of a file, on one thread.
CadModel tessellate(const CadShape& shape, const CadFile& file);

/// What carries a face, an edge: with its location. `turned` is the face's own orientation.
CadSurface surface_of(const TopoDS_Face& face);
CadCurve curve_of(const TopoDS_Edge& edge);

}  // namespace cnrg::occt
