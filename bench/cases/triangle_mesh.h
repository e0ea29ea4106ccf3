// Triangles in doubles: the one input that every system of a comparison gets. Solids of planar polygons are given
// as such to the systems that take them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cnrg::bench {

struct TriangleMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise as seen from outside
  /// The planar face that each triangle is a part of, numbered from 0; empty: each triangle is one.
  std::vector<std::uint32_t> faces;
  /// The same surface as exactly planar polygons, if it is one of larger faces.
  std::vector<std::vector<std::uint32_t>> polygons;
};

/// The triangles of a mesh file, polygons cut into fans. Throws as the reader of mesh leaves does.
TriangleMesh read_mesh(const std::string& path);

/// Writes OFF with all digits of the coordinates. Throws std::runtime_error if the file cannot be written.
void write_off(const std::string& path, const TriangleMesh& mesh);

/// Turned about the y axis through the origin by `angle` (radians), then moved; coordinates rounded to doubles.
TriangleMesh turned(const TriangleMesh& mesh, double angle, const std::array<double, 3>& move);

/// Turned about the parallel to the y axis through the middle of its box by 0.7, then moved by 2 % of the box: a
/// mesh and this copy of it overlap in general position. Coordinates rounded to doubles.
TriangleMesh turned_about_middle(const TriangleMesh& mesh);

/// Turned in a direction and by an angle that the seed chooses, then moved; coordinates rounded to doubles.
TriangleMesh turned_at_random(const TriangleMesh& mesh, unsigned seed, const std::array<double, 3>& move);

/// Moved; exact where the sums are doubles.
TriangleMesh moved(const TriangleMesh& mesh, const std::array<double, 3>& move);

/// The mirror image in the plane z = 0, outside again outside.
TriangleMesh mirrored_z(const TriangleMesh& mesh);

}  // namespace cnrg::bench
