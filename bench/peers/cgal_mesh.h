// What the peers that are made of CGAL share: exact numbers, and surfaces of polygons.
#pragma once

#include <CGAL/assertions.h>

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg::bench {

/// CGAL's exact number, a wrapper of GMP's; which one depends on how CGAL was configured.
template <class Number>
Rational rational_of(const Number& value) {
  if constexpr (requires { value.backend().data(); }) return Rational(value.backend().data());
  else if constexpr (requires { value.mpq(); }) return Rational(value.mpq());
  else return Rational(value);
}

/// `Lazy` is a lazy exact number, such as EPECK's.
template <class Lazy>
Lazy lazy_number(const Rational& value) {
  return Lazy(typename Lazy::ET(value.get_mpq_t()));
}

/// Adds polygons (ranges of places of the mesh's vertices) to a CGAL surface mesh; false if one does not fit to
/// those before on a consistently oriented 2-manifold.
template <class Mesh, class Polygons>
bool add_polygons(Mesh& mesh, const Polygons& polygons) {
  std::vector<typename Mesh::Vertex_index> corners;
  for (const auto& polygon : polygons) {
    corners.clear();
    for (const std::uint32_t p : polygon) corners.emplace_back(p);
    if (mesh.add_face(corners) == Mesh::null_face()) return false;
  }
  return true;
}

/// What CGAL's assertion says, in one line.
inline std::string words_of(const CGAL::Failure_exception& error) {
  std::string words = error.library() + " " + error.expression();
  if (!error.message().empty()) words += ": " + error.message();
  return words;
}

}  // namespace cnrg::bench
