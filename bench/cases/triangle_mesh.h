// Triangles in doubles: the one input that every system of a comparison gets.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cnrg::bench {

struct TriangleMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The triangles of a mesh file, polygons cut into fans. Throws as the reader of mesh leaves does.
TriangleMesh read_mesh(const std::string& path);

/// Turned about the y axis through the origin by `angle` (radians), then moved; coordinates rounded to doubles.
TriangleMesh turned(const TriangleMesh& mesh, double angle, const std::array<double, 3>& move);

}  // namespace cnrg::bench
