#include "kernel/exact/convex_hull.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <map>

#include "kernel/exact/lazy.h"

namespace cnrg {

std::vector<std::vector<std::uint32_t>> convex_hull(std::span<const RationalPoint> points) {
  using Point = lazy::Kernel::Point_3;
  std::vector<Point> exact;
  std::map<Point, std::uint32_t> number;
  for (const RationalPoint& p : points) {
    exact.push_back(lazy::point(p));
    number.emplace(exact.back(), static_cast<std::uint32_t>(number.size()));
  }
  CGAL::Surface_mesh<Point> mesh;
  CGAL::convex_hull_3(exact.begin(), exact.end(), mesh);
  std::vector<std::vector<std::uint32_t>> facets;
  for (const auto f : mesh.faces()) {
    auto& corners = facets.emplace_back();
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(number.at(mesh.point(v)));
  }
  return facets;
}

}  // namespace cnrg
