// Transforms of jets, Newton's method; see the header.
#include "csg/curves/surface_placed.h"

#include <cmath>

namespace cnrg {

using namespace surface_math;

namespace {

/// A matrix, by rows, times a vector.
template <class N>
Vector3<N> mapped_by(const std::array<Vector3<Constant>, 3>& rows, const Vector3<N>& x) {
  return {dot(as<N>(rows[0]), x), dot(as<N>(rows[1]), x), dot(as<N>(rows[2]), x)};
}

}  // namespace

PlacedSurface::PlacedSurface(std::shared_ptr<const LeafSurfaces> leaf, std::uint32_t patch,
                             const Transform& transform)
    : leaf_(std::move(leaf)),
      surface_(leaf_ ? leaf_->patch(patch) : nullptr),
      shifted_(transform.linear == Transform().linear) {
  const auto& m = transform.linear;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    offset_[i] = constant(transform.offset[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t c = (j + 1) % 3, d = (j + 2) % 3;
      linear_[i][j] = constant(m[i][j]);
      cofactors_[i][j] = constant(Rational(m[a][c] * m[b][d] - m[a][d] * m[b][c]));
    }
  }
}

template <class N>
SurfaceJet<N> PlacedSurface::moved(const SurfaceJet<N>& jet) const {
  if (shifted_)
    return {sum(jet.point, as<N>(offset_)), jet.along_u, jet.along_v, jet.normal, jet.way_u, jet.way_v};
  // (A a) x (A b) is the matrix of cofactors of A times a x b.
  return {sum(mapped_by(linear_, jet.point), as<N>(offset_)),
          mapped_by(linear_, jet.along_u),
          mapped_by(linear_, jet.along_v),
          mapped_by(cofactors_, jet.normal),
          mapped_by(linear_, jet.way_u),
          mapped_by(linear_, jet.way_v)};
}

SurfaceJet<double> PlacedSurface::at(double u, double v) const { return moved(surface_->at(u, v)); }
SurfaceJet<Interval> PlacedSurface::over(const Interval& u, const Interval& v) const {
  const enclosure::RoundOutward outward;
  return moved(surface_->over(u, v));
}

std::optional<SurfaceBend> PlacedSurface::bend_over(const Interval& u, const Interval& v) const {
  const enclosure::RoundOutward outward;
  const std::optional<SurfaceBend> bend = surface_->bend_over(u, v);
  if (!bend) return bend;
  return SurfaceBend{mapped_by(linear_, bend->uu), mapped_by(linear_, bend->uv), mapped_by(linear_, bend->vv)};
}
std::optional<Vector3<Interval>> PlacedSurface::fan_over(std::size_t around, double pole, const Interval& u,
                                                         const Interval& v) const {
  const enclosure::RoundOutward outward;
  const std::optional<Vector3<Interval>> fan = surface_->fan_over(around, pole, u, v);
  return fan ? std::optional(mapped_by(linear_, *fan)) : std::nullopt;
}

std::optional<Revolution> PlacedSurface::revolution() const {
  const enclosure::RoundNearest nearest;
  std::optional<Revolution> revolution = surface_->revolution();
  if (!revolution) return revolution;
  constexpr double kRounded = 1e-13;
  std::array<Vector3<double>, 3> columns;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) columns[k][i] = linear_[i][k].value;
  }
  const double square = dot(columns[0], columns[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (!(std::abs(dot(columns[i], columns[j]) - (i == j ? square : 0)) <= kRounded * square))
        return std::nullopt;
    }
  }
  revolution->center = sum(mapped_by(linear_, revolution->center), as<double>(offset_));
  revolution->axis = scaled(1 / std::sqrt(square), mapped_by(linear_, revolution->axis));
  return revolution;
}

namespace {

class MovedCurve final : public Curve {
 public:
  MovedCurve(std::shared_ptr<const Curve> curve, const Transform& transform)
      : curve_(std::move(curve)), offset_(constants(transform.offset)) {
    for (std::size_t i = 0; i < 3; ++i) linear_[i] = constants(transform.linear[i]);
  }
  CurveJet<double> at(double t) const override { return moved(curve_->at(t)); }
  CurveJet<Interval> over(const Interval& t) const override {
    const enclosure::RoundOutward outward;
    return moved(curve_->over(t));
  }

 private:
  template <class N>
  CurveJet<N> moved(const CurveJet<N>& jet) const {
    return {sum(mapped_by(linear_, jet.point), as<N>(offset_)), mapped_by(linear_, jet.along)};
  }
  std::shared_ptr<const Curve> curve_;
  std::array<Vector3<Constant>, 3> linear_;  // rows
  Vector3<Constant> offset_;
};

}  // namespace

SurfaceSource moved(const SurfaceSource& leaf, const Transform& transform, bool complete) {
  if (!leaf) return {};
  return [leaf, transform, complete] {
    const std::shared_ptr<const LeafSurfaces> given = leaf();
    auto result = std::make_shared<LeafSurfaces>();
    for (const auto& [number, surface] : given->patches())
      result->add_patch(number, std::make_shared<const PlacedSurface>(given, number, transform));
    for (const auto& [number, curve] : given->curves())
      result->add_curve(number, std::make_shared<const MovedCurve>(curve, transform));
    const auto take = [&](std::uint32_t number, auto form) {
      form.placed = transform * form.placed;
      result->add_form(number, std::move(form));
    };
    for (const auto& [number, form] : given->forms()) take(number, form);
    for (const auto& [number, form] : given->curve_forms()) take(number, form);
    if (!complete || !given->complete()) result->add_unknown();
    return result;
  };
}

namespace {

/// One step of Gauss and Newton to the place of the surface that is next to p.
void approach(SurfaceSite& site, const SurfaceJet<double>& jet, const Vector3<double>& p) {
  const Vector3<double> way = difference(p, jet.point);
  const double uu = dot(jet.along_u, jet.along_u), uv = dot(jet.along_u, jet.along_v),
               vv = dot(jet.along_v, jet.along_v), u = dot(jet.along_u, way), v = dot(jet.along_v, way);
  const double determinant = uu * vv - uv * uv;
  std::array<double, 2> step{uu > 0 ? u / uu : 0, vv > 0 ? v / vv : 0};  // at a pole, along what there is
  if (determinant > 1e-20 * uu * vv) step = {(u * vv - v * uv) / determinant, (v * uu - u * uv) / determinant};
  for (std::size_t k = 0; k < 2; ++k) site.at[k] += std::clamp(step[k], -site.reach[k], site.reach[k]);
}

/// Moves p as little as it can be to the planes through it with unit `normals` moved by `gaps`. One that follows
/// from those before it, or contradicts them, is left out.
void move_to_planes(Vector3<double>& p, std::span<const Vector3<double>> normals, std::span<const double> gaps) {
  std::vector<Vector3<double>> directions;  // orthonormal
  Vector3<double> moved{0, 0, 0};
  for (std::size_t i = 0; i < normals.size(); ++i) {
    Vector3<double> d = normals[i];
    for (const Vector3<double>& other : directions) d = difference(d, scaled(dot(normals[i], other), other));
    const double length = std::sqrt(dot(d, d));
    if (length < 1e-7) continue;
    d = scaled(1 / length, d);
    moved = sum(moved, scaled((gaps[i] - dot(normals[i], moved)) / length, d));
    directions.push_back(d);
  }
  p = sum(p, moved);
}

}  // namespace

namespace {

/// From one surface to the next, over and over: slow, but patches that continue one another smoothly, and end
/// where they meet, have no planes that cross.
std::optional<Vector3<double>> find_by_turns(std::span<SurfaceSite> sites, const Vector3<double>& point) {
  std::vector<SurfaceSite> tried(sites.begin(), sites.end());
  Vector3<double> p = point;
  const double size = 1 + std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
  for (int i = 0; i < 60; ++i) {
    double far = 0;
    for (SurfaceSite& site : tried) {
      Vector3<double> next = p;
      if (site.surface != nullptr) {
        approach(site, site.surface->at(site.at[0], site.at[1]), p);
        next = site.surface->at(site.at[0], site.at[1]).point;
      } else {
        const double gap = dot(site.normal, difference(site.point, p)) / dot(site.normal, site.normal);
        next = sum(p, scaled(gap, site.normal));
      }
      const Vector3<double> way = difference(next, p);
      far = std::max(far, std::sqrt(dot(way, way)));
      p = next;
    }
    if (!std::isfinite(far)) return std::nullopt;
    if (far > 1e-13 * size) continue;
    std::copy(tried.begin(), tried.end(), sites.begin());
    return p;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vector3<double>> find_common(std::span<SurfaceSite> sites, const Vector3<double>& point) {
  std::vector<SurfaceSite> tried(sites.begin(), sites.end());
  Vector3<double> p = point;
  const double size = 1 + std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
  for (int i = 0; i < 40; ++i) {
    std::vector<Vector3<double>> normals;
    std::vector<double> gaps;
    double far = 0;
    for (SurfaceSite& site : tried) {
      Vector3<double> next = site.point, normal = site.normal;
      if (site.surface != nullptr) {
        approach(site, site.surface->at(site.at[0], site.at[1]), p);
        const SurfaceJet<double> jet = site.surface->at(site.at[0], site.at[1]);
        next = jet.point, normal = jet.normal;
      }
      const double norm = std::sqrt(dot(normal, normal));
      if (!(norm > 0) || !std::isfinite(norm)) return std::nullopt;
      const Vector3<double> way = difference(next, p);
      normals.push_back(scaled(1 / norm, normal));
      gaps.push_back(dot(normals.back(), way));
      far = std::max(far, site.surface != nullptr ? std::sqrt(dot(way, way)) : std::abs(gaps.back()));
    }
    if (!std::isfinite(far)) return std::nullopt;
    if (far <= 4e-15 * size) {
      std::copy(tried.begin(), tried.end(), sites.begin());
      return p;
    }
    move_to_planes(p, normals, gaps);
  }
  return find_by_turns(sites, point);
}

}  // namespace cnrg
