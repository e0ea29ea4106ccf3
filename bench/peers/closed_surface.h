// A solid operand as a CGAL surface mesh, and what CGAL's documentation demands of it. For CGAL's peers only.
//
// Both Boolean operations of CGAL ask for surfaces that are closed, oriented outward and do not intersect
// themselves; what they do with others is undefined, so that is asked before.
#pragma once

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include "bench/cases/face_loops.h"
#include "bench/peers/cgal_mesh.h"
#include "bench/peers/system.h"

namespace cnrg::bench {

/// The solid faces of a model, which have one loop each. `point_of` makes the mesh's points. Throws Refusal for
/// what is no closed, consistently oriented 2-manifold.
template <class Mesh, class PointOf>
Mesh closed_surface(const Model& model, PointOf point_of) {
  Mesh mesh;
  for (const RationalPoint& p : model.points) mesh.add_vertex(point_of(p));
  std::vector<PointLoop> polygons;
  for (const Model::Face& face : model.faces) {
    if (!face.solid) continue;
    if (face.loops.size() != 1) throw Refusal("input", "a face has holes");
    polygons.push_back(face.loops[0]);
  }
  if (!add_polygons(mesh, polygons)) throw Refusal("input", "an operand is no oriented 2-manifold");
  std::vector<typename Mesh::Vertex_index> unused;
  for (const auto v : mesh.vertices())
    if (mesh.is_isolated(v)) unused.push_back(v);
  for (const auto v : unused) mesh.remove_vertex(v);
  mesh.collect_garbage();
  if (!CGAL::is_closed(mesh)) throw Refusal("input", "an operand is not closed");
  return mesh;
}

template <class Mesh>
Mesh triangulated(Mesh mesh) {
  if (!CGAL::Polygon_mesh_processing::triangulate_faces(mesh))
    throw Refusal("input", "a polygon of an operand cannot be triangulated");
  return mesh;
}

}  // namespace cnrg::bench
