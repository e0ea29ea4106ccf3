// A linear grade is brought to one form: t as an affine function of the coordinates of the result, then stops that
// lie between their neighbours on a line go, then t is scaled so that it is 0 at the first stop and 1 at the last,
// and turned round if its gradient is lexicographically negative.
//
// A distance is sqrt((p - q)' G (p - q)) for the nearest q of the placed target, where G comes from the linear
// part of the placement. So two are alike if G and the placed targets are. Targets are lists of triangles that
// depend on how they came about; as point sets they are compared like any others, on a complex of both.
#include "csg/compare/same_material.h"

#include <algorithm>
#include <optional>

#include "csg/geometry/exact_vectors.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/group.h"
#include "kernel/complex/complex.h"

namespace cnrg {
namespace {

using Stops = std::vector<Grade::Stop>;

Rational fraction(const Mixture& mixture, const std::string& material) {
  const auto it =
      std::find_if(mixture.begin(), mixture.end(), [&](const auto& entry) { return entry.first == material; });
  return it == mixture.end() ? Rational(0) : it->second;
}

/// The mixture at `at` of a line through two stops is that of `stop`.
bool on_line(const Grade::Stop& from, const Grade::Stop& stop, const Grade::Stop& to) {
  const Rational u = (stop.at - from.at) / (to.at - from.at);
  for (const Mixture* mixture : {&from.mixture, &stop.mixture, &to.mixture}) {
    for (const auto& [material, unused] : *mixture) {
      const Rational a = fraction(from.mixture, material), b = fraction(to.mixture, material);
      if (a + u * (b - a) != fraction(stop.mixture, material)) return false;
    }
  }
  return true;
}

/// Without stops that say nothing: before the first and behind the last one fractions are constant.
Stops needed(const Stops& stops) {
  Stops out;
  for (const Grade::Stop& stop : stops) {
    while (out.size() > 1 && on_line(out[out.size() - 2], out.back(), stop)) out.pop_back();
    if (out.size() == 1 && out.back().mixture == stop.mixture) out.pop_back();
    out.push_back(stop);
  }
  while (out.size() > 1 && out[out.size() - 2].mixture == out.back().mixture) out.pop_back();
  return out;
}

/// Mixtures at values of t = gradient . p + constant.
struct LinearForm {
  RationalPoint gradient{0, 0, 0};
  Rational constant = 0;
  Stops stops;
  friend bool operator==(const LinearForm&, const LinearForm&) = default;
};

LinearForm form_of(const LinearGrade& line, const PlacedGrade& placed) {
  const auto t = [&](const RationalPoint& p) {
    RationalPoint way, to;
    for (int k = 0; k < 3; ++k) way[k] = line.to[k] - line.from[k], to[k] = p[k] - line.from[k];
    return Rational(dot(way, to) / dot(way, way));
  };
  const Transform back = placed.placement.inverse();
  LinearForm form;
  form.stops = needed(placed.grade.stops);
  if (form.stops.size() == 1) {  // one mixture everywhere
    form.stops[0].at = 0;
    return form;
  }
  form.constant = t(back.apply({0, 0, 0}));
  for (std::size_t k = 0; k < 3; ++k) {
    RationalPoint unit{0, 0, 0};
    unit[k] = 1;
    form.gradient[k] = t(back.apply(unit)) - form.constant;
  }
  const bool turned = form.gradient < RationalPoint{0, 0, 0};
  if (turned) std::reverse(form.stops.begin(), form.stops.end());
  const Rational first = form.stops.front().at, length = form.stops.back().at - first;
  for (Rational& x : form.gradient) x /= length;
  form.constant = (form.constant - first) / length;
  for (Grade::Stop& stop : form.stops) stop.at = (stop.at - first) / length;
  return form;
}

std::array<std::array<Rational, 3>, 3> metric_of(const Transform& placement) {
  const auto back = placement.inverse().linear;
  std::array<std::array<Rational, 3>, 3> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      out[i][j] = 0;
      for (int k = 0; k < 3; ++k) out[i][j] += back[k][i] * back[k][j];
    }
  }
  return out;
}

std::shared_ptr<const PreparedLeaf> leaf_of(const DistanceTarget& target, const Transform& placement) {
  GroupShape shape;
  for (const RationalPoint& p : target.points) shape.vertices.push_back(placement.apply(p));
  for (const auto& [a, b, c] : target.triangles) {
    GroupShape::Face& face = shape.faces.emplace_back();
    face.loops = {{a, b, c}};
  }
  for (const auto& [a, b] : target.segments) shape.edges.push_back({a, b});
  for (const auto& [a] : target.vertices) shape.points.push_back(a);
  shape.fill = Fill::none;
  return prepare(shape);
}

bool same_set(const DistanceTarget& a, const Transform& place_a, const DistanceTarget& b,
              const Transform& place_b) {
  if (a == b && place_a == place_b) return true;
  const auto complex = build_complex(make_soup({{leaf_of(a, place_a)}, {leaf_of(b, place_b)}}));
  const std::vector<Group> groups = leaf_groups(*complex);
  return groups[0].faces == groups[1].faces && groups[0].edges == groups[1].edges &&
         groups[0].vertices == groups[1].vertices;
}

}  // namespace

bool same_grade(const PlacedGrade& a, const PlacedGrade& b) {
  const auto *line_a = std::get_if<LinearGrade>(&a.grade.along),
             *line_b = std::get_if<LinearGrade>(&b.grade.along);
  if (line_a != nullptr && line_b != nullptr) return form_of(*line_a, a) == form_of(*line_b, b);
  const auto *to_a = std::get_if<DistanceGrade>(&a.grade.along),
             *to_b = std::get_if<DistanceGrade>(&b.grade.along);
  if (to_a == nullptr || to_b == nullptr || !to_a->target || !to_b->target) return false;
  return needed(a.grade.stops) == needed(b.grade.stops) && metric_of(a.placement) == metric_of(b.placement) &&
         same_set(*to_a->target, a.placement, *to_b->target, b.placement);
}

}  // namespace cnrg
