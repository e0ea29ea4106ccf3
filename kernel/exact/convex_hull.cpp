#include "kernel/exact/convex_hull.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>

#include "kernel/base/union_find.h"
#include "kernel/exact/lazy.h"

namespace cnrg {

std::vector<std::vector<std::uint32_t>> convex_hull(std::span<const RationalPoint> points) {
  using Point = lazy::Kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  std::vector<Point> exact;
  std::map<Point, std::uint32_t> number;
  for (const RationalPoint& p : points) {
    exact.push_back(lazy::point(p));
    number.emplace(exact.back(), static_cast<std::uint32_t>(number.size()));
  }
  Mesh mesh;
  CGAL::convex_hull_3(exact.begin(), exact.end(), mesh);
  // CGAL cuts facets of four corners and more as the addresses of its cells are.
  UnionFind planes(mesh.number_of_faces());
  const auto plane_of = [&](Mesh::Halfedge_index h) { return planes.find(mesh.face(h)); };
  const auto corner = [&](Mesh::Halfedge_index h) { return mesh.point(mesh.target(h)); };
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e), other = mesh.opposite(h);
    if (CGAL::coplanar(corner(h), corner(other), corner(mesh.next(h)), corner(mesh.next(other))))
      planes.unite(mesh.face(h), mesh.face(other));
  }
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> next;  // around each plane's facet
  for (const auto h : mesh.halfedges()) {
    if (plane_of(h) != plane_of(mesh.opposite(h)))
      next[plane_of(h)][number.at(mesh.point(mesh.source(h)))] = number.at(corner(h));
  }
  std::vector<std::vector<std::uint32_t>> facets;
  for (const auto& [plane, after] : next) {
    auto& corners = facets.emplace_back();
    std::uint32_t at = after.begin()->first;
    do {
      corners.push_back(at);
      at = after.at(at);
    } while (at != corners.front());
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

}  // namespace cnrg
