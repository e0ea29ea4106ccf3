// Which leaves may have an axis in common: in doubles, generously, since most pairs end here.
#include <algorithm>
#include <cmath>
#include <map>

#include "csg/carriers/banded_leaves.h"
#include "csg/carriers/extruded_arcs.h"
#include "csg/carriers/revolved_families.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;

/// The axis of a leaf in doubles.
struct RoughAxis {
  std::array<double, 3> point, along;  ///< along has length 1
  double size = 0;                     ///< of the leaf, at least
  double radius = 0;                   ///< of a sphere, along its axis
  bool sphere = false;

  RoughAxis(const ExtrudedArc& arc, const Transform& transform)
      : point(to_doubles(transform.apply(arc.placed.axis.foot))),
        along(to_doubles(transform.apply_to_vector(arc.placed.axis.direction))) {
    const double length = hypotenuse(along[0], along[1], along[2]);
    for (double& x : along) x /= length;
    size = to_double(arc.placed.lines[0][0].from.r);
    for (const double x : point) size = std::max(size, std::abs(x));
  }
  RoughAxis(const RevolvedForm& form, const Transform& transform)
      : point(to_doubles(transform.apply(form.center))),
        along(to_doubles(transform.apply_to_vector(form.axis))),
        sphere(form.is_sphere()) {
    const double length = hypotenuse(along[0], along[1], along[2]);
    for (double& x : along) x /= length;
    size = length;
    if (sphere) {
      const std::array<double, 3> own = to_doubles(form.axis);
      radius = to_double(form.lines[0][0].radius) * length / hypotenuse(own[0], own[1], own[2]);
    }
    for (const auto& line : form.lines) {
      for (const MeridianPiece& piece : line)
        size = std::max({size, to_double(piece.from.r), to_double(piece.to.r), to_double(piece.radius)});
    }
    for (const double x : point) size = std::max(size, std::abs(x));
  }

  double distance(const std::array<double, 3>& p) const {
    double off[3], part = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) part += (off[k] = p[k] - point[k]) * along[k];
    for (std::size_t k = 0; k < 3; ++k) square += (off[k] - part * along[k]) * (off[k] - part * along[k]);
    return std::sqrt(square);
  }
  /// False only if the two certainly have no axis in common.
  bool near(const RoughAxis& b) const {
    constexpr double kNear = 1e-6;
    const double limit = kNear * (size + b.size);
    if (sphere && b.sphere) {
      const double apart = hypotenuse(point[0] - b.point[0], point[1] - b.point[1], point[2] - b.point[2]);
      return apart <= limit + kNearBalls * (radius + b.radius);
    }
    if (sphere) return !(b.distance(point) > limit);
    if (b.sphere) return !(distance(b.point) > limit);
    const double turn = std::abs(along[0] * b.along[0] + along[1] * b.along[1] + along[2] * b.along[2]);
    return !(turn < 1 - kNear) && !(distance(b.point) > limit);
  }
};

}  // namespace

std::vector<std::array<Index, 2>> near_axes(const std::vector<LeafInstance>& instances,
                                            const std::vector<std::array<Index, 2>>& pairs) {
  std::map<Index, std::vector<RoughAxis>> rough;
  const auto rough_of = [&](Index i) -> const std::vector<RoughAxis>& {
    const auto [it, fresh] = rough.try_emplace(i);
    if (!fresh) return it->second;
    const CurvedForm* const form = instances[i].leaf->form().get();
    const Transform& transform = instances[i].transform;
    if (const auto* revolved = dynamic_cast<const RevolvedForm*>(form))
      it->second.emplace_back(*revolved, transform);
    if (const auto* extrusion =
            dynamic_cast<const ExtrudeForm*>(form)) {  // its arcs, also where they are stretched
      for (const ExtrudedArc& arc : arcs_of(*extrusion, {})) it->second.emplace_back(arc, transform);
    }
    if (const auto* banded = dynamic_cast<const BandedForm*>(form)) {
      for (const Band& band : banded->bands) {
        it->second.emplace_back(band.form, transform);
        it->second.back().sphere = false;  // it is drawn about this axis, whole or not
      }
    }
    return it->second;
  };
  const auto any_near = [&](Index i, Index j) {
    for (const RoughAxis& a : rough_of(i)) {
      for (const RoughAxis& b : rough_of(j)) {
        if (a.near(b)) return true;
      }
    }
    return false;
  };
  std::vector<std::array<Index, 2>> near;
  for (const auto& [i, j] : pairs) {
    if (any_near(i, j)) near.push_back({i, j});
  }
  return near;
}

}  // namespace cnrg
