// Radii of 1 and 1 + 1e-12 are those of different cylinders, with a gap between them, and that is what comes out.
// But hardly anybody means it. Whether two surfaces are the same is decided exactly, by the file's numbers;
// whether they are near is a question for a notice, and doubles answer it: each face's points are near the other's
// surface.
#include "csg/imports/cad_near.h"

#include <algorithm>
#include <cmath>

#include "csg/text/table.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Kind = CadSurface::Kind;
using Point = std::array<double, 3>;

/// In parts of the model's extent: nearer than people make gaps.
constexpr double kNear = 1e-9;

bool is_compared(const CadSurface& surface) { return surface.kind <= Kind::torus; }

/// How far a point is from a surface.
double distance_from(const CadSurface& surface, const Point& p) {
  const Point to = minus(p, surface.axes.origin), &z = surface.axes.z;
  const double along = dot(to, z);
  const double around = length({to[0] - along * z[0], to[1] - along * z[1], to[2] - along * z[2]});
  switch (surface.kind) {
    case Kind::plane: return std::abs(along);
    case Kind::cylinder: return std::abs(around - surface.radius);
    case Kind::cone:
      return std::abs((around - surface.radius) * std::cos(surface.half_angle) -
                      along * std::sin(surface.half_angle));
    case Kind::sphere: return std::abs(std::hypot(around, along) - surface.radius);
    default: return std::abs(std::hypot(around - surface.radius, along) - surface.minor_radius);
  }
}

/// Exactly the same set of points. Cones with different origins on one axis count as the same: their radii there
/// hang together by a tangent, which no file can hold.
bool same(const CadSurface& a, const CadSurface& b) {
  const RationalPoint z = from_doubles(a.axes.z), by = from_doubles(b.axes.origin) - from_doubles(a.axes.origin);
  if (a.kind == Kind::sphere) return is_zero(by) && a.radius == b.radius;
  if (!is_zero(cross(z, from_doubles(b.axes.z)))) return false;
  switch (a.kind) {
    case Kind::plane: return dot(by, z) == 0;
    case Kind::cylinder: return a.radius == b.radius && is_zero(cross(by, z));
    case Kind::cone:
      return std::abs(a.half_angle) == std::abs(b.half_angle) && is_zero(cross(by, z)) &&
             (!is_zero(by) || a.radius == b.radius);
    default: return is_zero(by) && a.radius == b.radius && a.minor_radius == b.minor_radius;
  }
}

const char* plural_of(Kind kind) {
  constexpr const char* kNames[] = {"planes", "cylinders", "cones", "spheres", "tori"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool share_a_solid(const CadModel::Face& a, const CadModel::Face& b) {
  for (const auto* solids : {&a.behind, &a.before}) {
    for (const auto* others : {&b.behind, &b.before})
      if (std::ranges::find_first_of(*solids, *others) != solids->end()) return true;
  }
  return false;
}

}  // namespace

Weld weld_cad(const CadModel& model, const Rational& d, const std::string& subject,
              const std::function<std::string(std::uint32_t)>& face_name,
              const std::function<std::string(std::uint32_t)>& solid_name) {
  WeldModel all;
  for (const auto& p : model.points) all.points.push_back(from_doubles(p));
  for (std::uint32_t s = 0; s < model.solids.size(); ++s) all.solids.push_back({solid_name(s), {}});
  for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
    const CadModel::Face& face = model.faces[f];
    all.faces.push_back({.curved = face.surface.kind != CadSurface::Kind::plane});
    for (const auto& triangle : face.triangles) {
      const auto facet = static_cast<std::uint32_t>(all.facets.size());
      all.facets.push_back({f, {{triangle.begin(), triangle.end()}}});
      for (const std::uint32_t s : face.behind) all.solids[s].facets.emplace_back(facet, true);
      for (const std::uint32_t s : face.before) all.solids[s].facets.emplace_back(facet, false);
    }
  }
  all.subject = subject;
  all.face_name = face_name;
  return weld(all, d);
}

std::string notice_of_near_surfaces(const CadModel& model) {
  std::vector<Box> boxes;
  for (const CadModel::Face& face : model.faces) {
    Box& box = boxes.emplace_back();
    if (!is_compared(face.surface)) continue;
    for (const auto& triangle : face.triangles) {
      for (const std::uint32_t p : triangle) box.extend(model.points[p], model.points[p]);
    }
  }
  const Box all = bounds(boxes);
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, all.hi[k] - all.lo[k]);
  if (!(extent > 0)) return {};
  const double most = kNear * extent;
  const auto farthest = [&](const CadModel::Face& face, const CadSurface& surface) {
    double far = 0;
    for (const auto& triangle : face.triangles) {
      for (const std::uint32_t p : triangle) far = std::max(far, distance_from(surface, model.points[p]));
    }
    return far;
  };
  std::size_t count = 0;
  std::string example;
  const BoxTree tree(boxes);
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    if (!(boxes[a].lo[0] <= boxes[a].hi[0])) continue;
    Box around = boxes[a];
    for (std::size_t k = 0; k < 3; ++k) around.lo[k] -= most, around.hi[k] += most;
    std::vector<std::uint32_t> others;
    tree.query([&](const Box& box) { return box.meets(around); },
               [&](std::uint32_t b) {
                 if (b > a) others.push_back(b);
               });
    std::sort(others.begin(), others.end());
    for (const std::uint32_t b : others) {
      const CadModel::Face &one = model.faces[a], &other = model.faces[b];
      if (one.surface.kind != other.surface.kind || share_a_solid(one, other)) continue;
      if (same(one.surface, other.surface)) continue;
      const double apart = std::max(farthest(one, other.surface), farthest(other, one.surface));
      if (apart > most || count++ > 0) continue;
      example = "face " + std::to_string(a) + " and face " + std::to_string(b) + " on " +
                plural_of(one.surface.kind) + " that are " + decimal(apart, "%.1e") + " apart";
    }
  }
  if (count == 0) return {};
  return counted(count, "pair of faces", "pairs of faces") + " of different solids nearly coincide, " +
         (count == 1 ? "" : "such as ") + example + ": they are taken as different; to join them, give `weld`";
}

}  // namespace cnrg
