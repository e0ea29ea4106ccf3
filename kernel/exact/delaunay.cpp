// CGAL's Delaunay triangulation over doubles with exact predicates. Where four points lie on one circle its
// in-circle test perturbs the points in the order of their coordinates, which makes the result unique.
#include "kernel/exact/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace cnrg {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using DelaunayTriangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

}  // namespace

Delaunay delaunay(std::span<const std::array<double, 2>> points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> numbered;
  numbered.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), i);
  const DelaunayTriangulation made(numbered.begin(), numbered.end());

  Delaunay result;
  if (made.dimension() < 2) return result;
  for (auto face = made.finite_faces_begin(); face != made.finite_faces_end(); ++face) {
    std::array<std::uint32_t, 3> triangle;
    for (int k = 0; k < 3; ++k) triangle[static_cast<std::size_t>(k)] = face->vertex(k)->info();
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.triangles.push_back(triangle);
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  // Counter-clockwise about the vertex at infinity is clockwise about the points.
  const auto first = made.incident_vertices(made.infinite_vertex());
  auto at = first;
  do {
    result.border.push_back(at->info());
  } while (++at != first);
  std::reverse(result.border.begin(), result.border.end());
  std::rotate(result.border.begin(),
              std::min_element(result.border.begin(), result.border.end(),
                               [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; }),
              result.border.end());
  return result;
}

}  // namespace cnrg
