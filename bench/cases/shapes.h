// Closed meshes made from numbers.
#pragma once

#include <cstddef>

#include "bench/cases/triangle_mesh.h"

namespace cnrg::bench {

/// A sphere of radius about 1 with smooth bumps that the seed chooses, about the origin: an octahedron, each side
/// cut into k^2 triangles, 8 k^2 in all, the nearest to `triangles`. Vertices have four or six triangles. Turned
/// at random: no three vertices are on a line and no four in a plane, but by accident.
TriangleMesh bumpy_sphere(std::size_t triangles, unsigned seed);

/// A sphere of radius 1 of 32 meridians and 16 rings as OpenSCAD has it, 1,020 triangles, turned at random: its
/// caps and quadrilaterals are flat but for rounding, which is hard on filters.
TriangleMesh ringed_sphere(unsigned seed);

/// The upper half of the octahedral sphere of 8 k^2 triangles, closed by a flat base at z = 0 (one planar face).
TriangleMesh dome(std::size_t k);

struct IntegerBox {
  std::array<int, 3> min, max;
};

/// Twelve triangles, six planar faces.
TriangleMesh box_mesh(const IntegerBox& box);

/// Over a convex polygon, counter-clockwise, from one height to a larger one, in triangles alone.
TriangleMesh prism_mesh(const std::vector<std::array<int, 2>>& base, int low, int high);

/// The cube [0, n]^3, each side n x n squares of two triangles: 12 n^2 triangles, six planar faces.
TriangleMesh tiled_cube(int n);

}  // namespace cnrg::bench
