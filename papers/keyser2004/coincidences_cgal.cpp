// What CGAL makes of a Boolean of closed meshes, for coincidences.py:
//
//   coincidences_cgal nef A.off B.off - C.off +    operands first, then the operator: + union, - difference,
//                                                  x intersection
//   coincidences_cgal corefinement A.off B.off -
//   coincidences_cgal nef RESULT.nef3              as OpenSCAD writes it
//
// Prints solids, voids, volume and what is in no solid: faces, edges, vertices. Numbers are exact, also those of
// corefinement, which loses its way in a row of rounded results. Polygons are cut into triangles first, as the
// doubles of a file are not quite planar.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/Nef_polyhedron_iostream_3.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Found {
  std::size_t solids = 0, voids = 0;
  double volume = 0;
  std::size_t faces = 0, edges = 0, vertices = 0;
};

Mesh read_mesh(const std::string& path) {
  Mesh mesh;
  if (!CGAL::IO::read_OFF(path, mesh)) throw std::runtime_error("cannot read " + path);
  PMP::triangulate_faces(mesh);
  return mesh;
}

/// Operands and operators in the order of a calculator with a stack.
template <class Value, class Read, class Operate>
Value folded(const std::vector<std::string>& words, Read read, Operate operate) {
  std::vector<Value> stack;
  for (const std::string& word : words) {
    if (word.size() > 1) {
      stack.push_back(read(word));
      continue;
    }
    Value b = std::move(stack.back());
    stack.pop_back();
    stack.back() = operate(word[0], stack.back(), b);
  }
  return stack.back();
}

// --- Nef polyhedra

Nef read_nef(const std::string& path) {
  if (path.ends_with(".nef3")) {
    std::ifstream in(path);
    Nef nef;
    in >> nef;
    if (!in) throw std::runtime_error("cannot read " + path);
    return nef;
  }
  const Mesh mesh = read_mesh(path);
  if (CGAL::is_closed(mesh)) return Nef(mesh);
  Nef sheet(Nef::EMPTY);
  for (const auto face : mesh.faces()) {
    std::vector<Kernel::Point_3> corners;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) corners.push_back(mesh.point(v));
    sheet = sheet + Nef(corners.begin(), corners.end());
  }
  return sheet;
}

Found nef(const std::vector<std::string>& words) {
  const Nef result = folded<Nef>(words, read_nef, [](char op, const Nef& a, const Nef& b) {
    return op == '+' ? a + b : op == '-' ? a - b : a * b;
  });
  Found found;
  std::size_t volumes = 0;
  for (auto v = result.volumes_begin(); v != result.volumes_end(); ++v, ++volumes) {
    if (v->mark()) ++found.solids;
    else if (volumes > 0) ++found.voids;  // the first one is around all
  }
  for (auto f = result.halffacets_begin(); f != result.halffacets_end(); ++f) {
    if (f->is_twin() && f->mark() && !f->incident_volume()->mark() && !f->twin()->incident_volume()->mark())
      ++found.faces;
    if (!f->incident_volume()->mark()) continue;  // seen from inside: loops turn the other way round
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;
      std::vector<Kernel::Point_3> corners;
      Nef::SHalfedge_around_facet_const_circulator at(cycle), end(at);
      CGAL_For_all(at, end) corners.push_back(at->source()->source()->point());
      for (std::size_t i = 2; i < corners.size(); ++i) {
        const Kernel::FT volume =
            CGAL::determinant(corners[0] - CGAL::ORIGIN, corners[i - 1] - CGAL::ORIGIN, corners[i] - CGAL::ORIGIN);
        found.volume -= CGAL::to_double(volume) / 6;
      }
    }
  }
  for (auto e = result.halfedges_begin(); e != result.halfedges_end(); ++e)
    found.edges += !e->is_twin() && e->mark() && e->out_sedge() == Nef::SHalfedge_const_handle() &&
                   !e->incident_sface()->mark();
  for (auto v = result.vertices_begin(); v != result.vertices_end(); ++v)
    found.vertices += v->svertices_begin() == v->svertices_end() && v->mark() && !v->sfaces_begin()->mark();
  return found;
}

// --- corefinement

Found corefinement(const std::vector<std::string>& words) {
  const auto operate = [](char op, Mesh a, Mesh b) {
    for (const Mesh* operand : {&a, &b}) {
      if (operand->number_of_faces() == 0) continue;
      if (PMP::does_self_intersect(*operand)) throw std::runtime_error("refused: a result touches itself");
      if (!PMP::does_bound_a_volume(*operand)) throw std::runtime_error("refused: a result bounds no volume");
    }
    Mesh made;
    const auto checked = CGAL::parameters::throw_on_self_intersection(true);
    const bool done = op == '+'   ? PMP::corefine_and_compute_union(a, b, made, checked, checked)
                      : op == '-' ? PMP::corefine_and_compute_difference(a, b, made, checked, checked)
                                  : PMP::corefine_and_compute_intersection(a, b, made, checked, checked);
    if (!done) throw std::runtime_error("refused: the result is no manifold");
    return made;
  };
  Mesh result = folded<Mesh>(words, read_mesh, operate);
  Found found;
  if (result.number_of_faces() == 0) return found;
  std::vector<Mesh> shells;
  PMP::split_connected_components(result, shells);
  for (const Mesh& shell : shells) {
    const double volume = CGAL::to_double(PMP::volume(shell));
    found.volume += volume;
    ++(volume < 0 ? found.voids : found.solids);
  }
  return found;
}

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 2, arguments + count);
  try {
    const Found found = arguments[1] == std::string("nef") ? nef(words) : corefinement(words);
    std::printf("%zu %zu %.17g %zu %zu %zu\n", found.solids, found.voids, found.volume, found.faces, found.edges,
                found.vertices);
  } catch (const PMP::Corefinement::Self_intersection_exception&) {
    std::puts("refused: an operand intersects itself");
  } catch (const CGAL::Failure_exception& error) {
    std::printf("refused: %s\n", error.expression().c_str());
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
  }
}
