// The report page of a mesh: `cnrg mesh -o report.html`. It loads nothing, and has no script.
#pragma once

#include <string>
#include <vector>

#include "csg/mesh/curved_mesh.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/mesh/tetrahedra.h"
#include "csg/result/result.h"

namespace cnrg {

/// What stands around it.
struct MeshPageOptions {
  std::string tree, node;            ///< names
  double radius_edge = 0;            ///< the largest ratio that was asked for, 0: none
  std::vector<std::string> notices;  ///< what was told of the mesh, escaped
  int threads = 0;
};

/// Regions, histograms of shapes, the worst ones and pictures, as HTML. `result` is what was meshed; a mesh of
/// second order is measured and drawn by its corners.
std::string mesh_page(const Result& result, const TetrahedralMesh& made, const MeshPageOptions& options);
/// Of faces without volumes: groups, a histogram of angles, the smallest ones and pictures.
std::string mesh_page(const Result& result, const SurfaceTriangles& made, const MeshPageOptions& options);

/// True for .html and .htm.
bool is_page(const std::string& path);

}  // namespace cnrg
