// Operands in CGAL's own forms.
#include "bench/peers/nef_parts.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>

#include "bench/peers/closed_surface.h"

namespace cnrg::bench::nef {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;

Kernel::Point_3 point_of(const RationalPoint& p) {
  const auto number = [](const Rational& x) { return lazy_number<Kernel::FT>(x); };
  return {number(p[0]), number(p[1]), number(p[2])};
}

/// Each piece by itself, from the largest to the smallest.
std::vector<Shell> pieces_of(const Mesh& surface, bool touching) {
  std::vector<Mesh> pieces;
  processing::split_connected_components(surface, pieces);
  std::vector<std::pair<Kernel::FT, Shell>> sized;
  for (Mesh& piece : pieces) {
    const Mesh cut = triangulated(piece);
    if (touching && processing::does_self_intersect(cut))
      throw Refusal("input", "a shell intersects or touches itself");
    const Kernel::FT volume = processing::volume(cut);
    const bool cavity = volume < 0;
    if (touching && cavity) throw Refusal("input", "a cavity intersects or touches another shell");
    if (cavity) processing::reverse_face_orientations(piece);
    sized.emplace_back(CGAL::abs(volume), Shell{std::move(piece), cavity});
  }
  std::stable_sort(sized.begin(), sized.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Shell> shells;
  for (auto& [volume, shell] : sized) shells.push_back(std::move(shell));
  return shells;
}

/// A Nef polyhedron of a surface fills all that it encloses, also cavities, and takes no shells that touch. So the
/// surface is given as one only if it has neither. Throws Refusal for what CGAL does not take.
std::vector<Shell> shells_of(const Mesh& surface) {
  const Mesh triangles = triangulated(surface);
  if (processing::does_self_intersect(triangles)) return pieces_of(surface, true);
  if (!processing::does_bound_a_volume(triangles)) throw Refusal("input", "an operand bounds no volume");
  std::vector<Shell> pieces = pieces_of(surface, false);
  if (std::any_of(pieces.begin(), pieces.end(), [](const Shell& shell) { return shell.cavity; })) return pieces;
  return {{surface, false}};
}

}  // namespace

Parts parts_of(const Model& model) {
  Parts parts;
  const auto is_solid = [](const Model::Face& face) { return face.solid; };
  if (std::any_of(model.faces.begin(), model.faces.end(), is_solid))
    parts.shells = shells_of(closed_surface<Mesh>(model, [](const RationalPoint& p) { return point_of(p); }));
  for (const Model::Face& face : model.faces) {
    if (face.solid) continue;
    if (face.loops.size() != 1) throw Refusal("input", "a face has holes");
    parts.sheets.emplace_back();
    for (const std::uint32_t p : face.loops[0]) parts.sheets.back().push_back(point_of(model.points[p]));
  }
  for (const auto& [a, b] : model.wires)
    parts.wires.push_back({point_of(model.points[a]), point_of(model.points[b])});
  for (const std::uint32_t p : model.isolated) parts.points.push_back(point_of(model.points[p]));
  return parts;
}

Parts parts_of_result(Model model) {
  cut_holes(model);
  std::vector<Kernel::Point_3> points;
  for (const RationalPoint& p : model.points) points.push_back(point_of(p));
  std::vector<std::vector<std::size_t>> polygons;
  for (const Model::Face& face : model.faces)
    if (face.solid) polygons.emplace_back(face.loops[0].begin(), face.loops[0].end());
  const std::size_t before = points.size();
  processing::orient_polygon_soup(points, polygons);  // they agree already: it parts what touches
  if (points.size() == before) return parts_of(model);
  for (std::size_t p = before; p < points.size(); ++p) {
    const auto number = [](const Kernel::FT& x) { return rational_of(CGAL::exact(x)); };
    model.points.push_back({number(points[p].x()), number(points[p].y()), number(points[p].z())});
  }
  auto polygon = polygons.begin();
  for (Model::Face& face : model.faces)
    if (face.solid) {
      face.loops[0].assign(polygon->begin(), polygon->end());
      ++polygon;
    }
  return parts_of(model);
}

}  // namespace cnrg::bench::nef
