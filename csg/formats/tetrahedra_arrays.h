// The tetrahedra or the surface mesh of a result as flat arrays, each simplex with the cell of the result that it
// lies in, for programs that compute with arrays. The same mesh may be written to files.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "csg/formats/result_file.h"
#include "csg/mesh/cell_groups.h"
#include "csg/result/arrays.h"
#include "csg/result/result.h"

namespace cnrg {

struct SurfaceTriangles;
struct TetrahedralMesh;

/// Of a mesh of any kind.
struct MeshArrays {
  using Numbers = std::vector<std::int32_t>;

  /// Simplices of one dimension d.
  struct Simplices {
    /// d + 1 of each; of a mesh of second order then the middles of its edges, in the order of a .msh
    /// (csg/FORMATS.md).
    Numbers points;
    Numbers cell;         ///< the number of the cell of the result, of dimension d, that it lies in
    Numbers component;    ///< of that cell, from 1
    Numbers front, back;  ///< the components of the regions on both sides of a triangle; 0: none
    Numbers region;       ///< the component of the region that holds it, is behind it, or in front; 0: none
    Numbers material;     ///< its own or of that region, a place in `materials` plus 1; 0: none
    Numbers said;         ///< what is said of that cell, a place in `said`; -1: nothing
    Numbers leaf, face;   ///< the face of a leaf that it came from, as in a .vtu; -1: none
  };
  std::vector<double> points;   ///< x, y, z of each
  std::array<Simplices, 4> of;  ///< by dimension; triangles counter-clockwise as seen from the front
  /// Four points of each, counter-clockwise as seen from the front; `cell` is a face.
  Simplices quads;
  std::array<std::vector<CellGroup>, 4> groups;  ///< by dimension
  std::vector<std::string> leaves;               ///< names of leaves, by `Simplices::leaf`
  std::vector<std::string> materials;            ///< names
  SaidTable said;
  RoundingReport rounding;
  bool curved = false;  ///< of second order
};

struct TetrahedraArrays : MeshArrays {
  std::vector<RegionTetrahedra> regions;  ///< of each region of the result that is filled, in the order of cells
  std::vector<std::pair<std::string, std::vector<double>>> fields;  ///< at each corner of each tetrahedron
};

/// A mesh that was made; copies share it.
class TetrahedralResult {
 public:
  /// Fills the regions of a closed and bounded result (csg/mesh/tetrahedra.h says what is proven). Throws
  /// InputError for one that cannot be meshed, RoundingFault for one that rounding would break: `snap` it.
  explicit TetrahedralResult(const Result& result, const TetrahedraOptions& options = {});

  TetrahedraArrays arrays() const;
  /// That TetGen made none, and so no bound is kept; else empty.
  const std::string& notice() const;
  /// How many tetrahedra were expected before any was made, mostly within a factor of two where sizes or volumes
  /// were asked for; 0 where nothing was foretold.
  double expected() const;
  /// In the formats of check_mesh_file_name (result_file.h); of second order not .mesh and .h5m. Throws InputError
  /// for another extension, FileError, Stopped: then the old file is untouched.
  void write(const std::string& path, const std::stop_token& stop = {}) const;

 private:
  Result result_;
  std::shared_ptr<const TetrahedralMesh> made_;
};

struct SurfaceArrays : MeshArrays {
  std::vector<FaceTriangles> faces;  ///< by first group
};

/// A surface mesh that was made; copies share it.
class SurfaceMeshResult {
 public:
  /// All faces, edges, wires and points of a closed result. Throws InputError, RoundingFault.
  explicit SurfaceMeshResult(const Result& result, const SurfaceOptions& options = {});

  SurfaceArrays arrays() const;
  std::size_t kept() const;  ///< facets that keep their triangles since others of doubles would cross what is near
  /// In the formats of check_mesh_file_name (result_file.h); of second order not .mesh and .h5m, with
  /// quadrilaterals not .h5m. Throws InputError for another extension, FileError, Stopped.
  void write(const std::string& path, const std::stop_token& stop = {}) const;

 private:
  Result result_;
  std::shared_ptr<const SurfaceTriangles> made_;
};

}  // namespace cnrg
