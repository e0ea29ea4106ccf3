// A linear grade is brought to one form: t as an affine function of the coordinates of the result, then stops that
// lie between their neighbours on a line go, then t is scaled so that it is 0 at the first stop and 1 at the last,
// and turned round if its gradient is lexicographically negative.
//
// A distance is sqrt((p - q)' G (p - q)) for the nearest q of the placed target, where G comes from the linear
// part of the placement. So two are alike if G and the placed targets are. Targets are lists of triangles that
// depend on how they came about; as point sets they are compared like any others, on a complex of both.
//
// Graded materials in mixtures may be called anything. Those of both sides are put into classes, from the inside
// out, of which all members are the same function; then a class takes the place of the names in mixtures, and
// stops are compared as those of constant materials are.
#include "csg/compare/same_material.h"

#include <algorithm>
#include <map>

#include "csg/leaves/leaf.h"
#include "csg/operators/group.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Stops = std::vector<Grade::Stop>;

Rational fraction_of(const Mixture& mixture, const std::string& material) {
  const auto it =
      std::find_if(mixture.begin(), mixture.end(), [&](const auto& entry) { return entry.first == material; });
  return it == mixture.end() ? Rational(0) : it->second;
}

/// The mixture at `at` of a line through two stops is that of `stop`.
bool on_line(const Grade::Stop& from, const Grade::Stop& stop, const Grade::Stop& to) {
  const Rational u = (stop.at - from.at) / (to.at - from.at);
  for (const Mixture* mixture : {&from.mixture, &stop.mixture, &to.mixture}) {
    for (const auto& [material, unused] : *mixture) {
      const Rational a = fraction_of(from.mixture, material), b = fraction_of(to.mixture, material);
      if (a + u * (b - a) != fraction_of(stop.mixture, material)) return false;
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

LinearForm form_of(const LinearGrade& line, const Transform& placement, const Stops& stops) {
  const auto t = [&](const RationalPoint& p) {
    RationalPoint way, to;
    for (int k = 0; k < 3; ++k) way[k] = line.to[k] - line.from[k], to[k] = p[k] - line.from[k];
    return Rational(dot(way, to) / dot(way, way));
  };
  const Transform back = placement.inverse();
  LinearForm form;
  form.stops = needed(stops);
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

/// A grade that is no blend, with the names of its mixtures put into words that both sides have in common.
struct Stated {
  const Grade* grade = nullptr;
  const Transform* placement = nullptr;
  Stops stops;
};

bool same_function(const Stated& a, const Stated& b) {
  const auto *line_a = std::get_if<LinearGrade>(&a.grade->along),
             *line_b = std::get_if<LinearGrade>(&b.grade->along);
  if (line_a != nullptr && line_b != nullptr) {
    return form_of(*line_a, *a.placement, a.stops) == form_of(*line_b, *b.placement, b.stops);
  }
  const auto *to_a = std::get_if<DistanceGrade>(&a.grade->along),
             *to_b = std::get_if<DistanceGrade>(&b.grade->along);
  if (to_a == nullptr || to_b == nullptr || !to_a->target || !to_b->target) return false;
  return needed(a.stops) == needed(b.stops) && metric_of(*a.placement) == metric_of(*b.placement) &&
         same_set(*to_a->target, *a.placement, *to_b->target, *b.placement);
}

/// MaterialClasses of graded materials that are the same function.
class MaterialClasses {
 public:
  /// Puts a grade and all that are nested in it into classes; returns that of the outermost.
  std::string of(const PlacedGrade& placed, const std::string& mark) {
    std::map<std::string, std::string> words;  // by nested name
    std::vector<const std::string*> open{nullptr};
    while (true) {  // the outermost is nullptr; what a grade names comes before it
      const std::string* name = open.back();
      const Grade& grade = name == nullptr ? placed.grade : placed.nested.at(*name);
      const std::string* inner = first_open(grade, placed, words);
      if (inner != nullptr) {
        open.push_back(inner);
        continue;
      }
      const std::string word = class_of({&grade, &placed.placement, stated(grade.stops, words, mark)});
      if (name == nullptr) return word;
      words.emplace(*name, word);
      open.pop_back();
    }
  }

 private:
  static const std::string* first_open(const Grade& grade, const PlacedGrade& placed,
                                       const std::map<std::string, std::string>& words) {
    for (const Grade::Stop& stop : grade.stops) {
      for (const auto& part : stop.mixture) {
        const auto it = placed.nested.find(part.first);
        if (it != placed.nested.end() && !words.contains(part.first)) return &it->first;
      }
    }
    return nullptr;
  }

  static Stops stated(const Stops& stops, const std::map<std::string, std::string>& words,
                      const std::string& mark) {
    Stops out;
    for (const Grade::Stop& stop : stops) {
      std::map<std::string, Rational> sums;
      for (const auto& [name, part] : stop.mixture) {
        const auto word = words.find(name);
        sums[word != words.end() ? word->second : "=" + without_mark(name, mark)] += part;
      }
      out.push_back({stop.at, {sums.begin(), sums.end()}});
    }
    return out;
  }

  std::string class_of(Stated grade) {
    const auto it = std::find_if(known_.begin(), known_.end(),
                                 [&](const Stated& known) { return same_function(known, grade); });
    const auto number = it - known_.begin();
    if (it == known_.end()) known_.push_back(std::move(grade));
    return "#" + std::to_string(number);  // other names begin with an equals sign
  }

  std::vector<Stated> known_;
};

bool same_side(const BlendGrade::Side& a, const Transform& place_a, const BlendGrade::Side& b,
               const Transform& place_b, const std::string& mark) {
  if (a.material.name() != without_mark(b.material.name(), mark)) return false;
  const PlacedGrade *grade_a = a.material.grade(), *grade_b = b.material.grade();
  if ((grade_a == nullptr) != (grade_b == nullptr)) return false;
  if (grade_a != nullptr) {
    PlacedGrade in_a = *grade_a, in_b = *grade_b;
    in_a.placement = place_a * in_a.placement;
    in_b.placement = place_b * in_b.placement;
    if (!same_grade(in_a, in_b, mark)) return false;
  }
  return same_set(*a.boundary, place_a, *b.boundary, place_b);
}

/// The fraction of the first is d2 / (d1 + d2), of the second d1 / (d1 + d2): the order of the two does not
/// matter, nor does a factor in both distances.
bool same_blend(const BlendGrade& a, const Transform& place_a, const BlendGrade& b, const Transform& place_b,
                const std::string& mark) {
  const auto in_proportion = [](const auto& m, const auto& n) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (m[i][j] * n[0][0] != n[i][j] * m[0][0]) return false;
      }
    }
    return true;
  };
  if (!in_proportion(metric_of(place_a), metric_of(place_b))) return false;
  const auto same = [&](const BlendGrade::Side& x, const BlendGrade::Side& y) {
    return same_side(x, place_a, y, place_b, mark);
  };
  return (same(a.first, b.first) && same(a.second, b.second)) ||
         (same(a.first, b.second) && same(a.second, b.first));
}

}  // namespace

std::string without_mark(const std::string& name, const std::string& mark) {
  std::string out = name;
  for (std::size_t at = 0; !mark.empty() && (at = out.find(mark, at)) != std::string::npos;)
    out.erase(at, mark.size());
  return out;
}

bool same_grade(const PlacedGrade& a, const PlacedGrade& b, const std::string& mark) {
  const auto *blend_a = std::get_if<BlendGrade>(&a.grade.along),
             *blend_b = std::get_if<BlendGrade>(&b.grade.along);
  if (blend_a != nullptr && blend_b != nullptr)
    return same_blend(*blend_a, a.placement, *blend_b, b.placement, mark);
  if (blend_a != nullptr || blend_b != nullptr) return false;
  MaterialClasses classes;
  return classes.of(a, {}) == classes.of(b, mark);
}

}  // namespace cnrg
