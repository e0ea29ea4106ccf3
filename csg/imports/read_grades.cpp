// Every number is checked where it is read, so that a message names the place of a fault in the document.
#include "csg/imports/read_grades.h"

#include <algorithm>
#include <set>

#include "csg/materials/sampler.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg::result {
namespace {

Transform read_placement(const Cursor& placement) {
  Transform t;
  const Cursor rows = placement.member("linear");
  rows.array_of(3, "a matrix has three rows");
  for (std::size_t k = 0; k < 3; ++k) t.linear[k] = rows.at(k).point();
  t.offset = placement.member("offset").point();
  if (t.determinant() == 0) rows.refuse("the matrix is singular");
  return t;
}

template <std::size_t N>
void read_simplices(const Cursor& list, std::size_t points, std::vector<std::array<Index, N>>& out) {
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor simplex = list.at(i);
    if (simplex.array().size() != N) simplex.refuse("so many points are needed here: " + std::to_string(N));
    auto& corners = out.emplace_back();
    for (std::size_t k = 0; k < N; ++k) corners[k] = simplex.at(k).number(points, "point");
  }
}

SharedTarget read_target(const Cursor& distance) {
  DistanceTarget target;
  const Cursor points = distance.member("points");
  for (std::size_t i = 0; i < points.array().size(); ++i) target.points.push_back(points.at(i).point());
  read_simplices(distance.member("vertices"), target.points.size(), target.vertices);
  read_simplices(distance.member("segments"), target.points.size(), target.segments);
  read_simplices(distance.member("triangles"), target.points.size(), target.triangles);
  if (target.empty()) distance.refuse("there is nothing to measure a distance to");
  for (const auto& [a, b, c] : target.triangles) {
    if (collinear(target.points[a], target.points[b], target.points[c])) {
      distance.refuse("a triangle has no area");
    }
  }
  return std::make_shared<const DistanceTarget>(std::move(target));
}

Mixture read_mixture(const Cursor& object) {
  Mixture mixture;
  Rational sum = 0;
  object.each_member([&](const std::string& name, const Cursor& value) {
    mixture.emplace_back(name, value.rational());
    if (mixture.back().second <= 0) value.refuse("a fraction is positive");
    sum += mixture.back().second;
  });
  if (sum != 1) object.refuse("fractions add up to 1");
  std::sort(mixture.begin(), mixture.end());
  return mixture;
}

using SeeMaterial = std::function<void(const std::string&, const Cursor&)>;

std::variant<LinearGrade, DistanceGrade, BlendGrade> read_along(const Cursor& one) {
  if (one.has("linear") == one.has("distance")) one.refuse("a grade has `linear` or `distance`");
  if (one.has("distance")) {
    const Cursor distance = one.member("distance");
    SharedTarget target = read_target(distance);
    return DistanceGrade{distance.member("to").text(), std::move(target)};
  }
  const LinearGrade linear{one.member("linear").member("from").point(), one.member("linear").member("to").point()};
  if (linear.from == linear.to) one.member("linear").refuse("`from` and `to` are one point");
  return linear;
}

Grade read_grade(const Cursor& one, const std::string& own, const SeeMaterial& material) {
  Grade grade{read_along(one), {}};
  const Cursor stops = one.member("stops");
  if (stops.array().size() == 0) stops.refuse("a stop is needed here");
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const Rational at = stops.at(k).member("at").rational();
    if (k > 0 && at <= grade.stops.back().at) stops.refuse("stops are ascending");
    const Cursor mixture = stops.at(k).member("mixture");
    mixture.each_member([&](const std::string& name, const Cursor& part) {
      material(name, part);
      if (name == own) part.refuse("a graded material is made of itself");
    });
    grade.stops.push_back({at, read_mixture(mixture)});
  }
  return grade;
}

/// Every nested grade is named by the outer one, or by one that is; and none by itself, nor by those inside of it.
void check_nested(const PlacedGrade& placed, const Cursor& list) {
  std::set<std::string> wanted;
  const auto want = [&](const Grade& grade) {
    for_each_nested(placed, grade, [&](const std::string& name) { wanted.insert(name); });
  };
  want(placed.grade);
  const std::vector<const std::string*> names = nested_in_order(placed);
  for (const std::string* name : names) {
    if (!wanted.contains(*name)) list.refuse("no stop names `" + *name + "`");
    want(placed.nested.at(*name));
  }
  if (names.size() != placed.nested.size()) list.refuse("a graded material is made of itself");
}

void read_nested(const Cursor& list, const SeeMaterial& material, PlacedGrade& placed) {
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor one = list.at(i);
    const Cursor name = one.member("material");
    material(name.text(), name);
    placed.nested.emplace(name.text(), read_grade(one, name.text(), material));
  }
  check_nested(placed, list);
}

using Grades = std::vector<std::shared_ptr<const PlacedGrade>>;

BlendGrade::Side read_side(const Cursor& side, const Cursor& list, const Grades& before,
                           const SeeMaterial& material) {
  const Cursor name = side.member("material");
  material(name.text(), name);
  BlendGrade::Side out{RegionMaterial(name.text()), nullptr};
  if (side.has("grade")) {
    const Index grade = side.member("grade").number(before.size(), "grade before this one");
    if (list.at(grade).member("material").text() != name.text()) {
      side.member("grade").refuse("this grade is of another material");
    }
    out.material = RegionMaterial(name.text(), before[grade]);
  }
  out.boundary = read_target(side.member("boundary"));
  return out;
}

}  // namespace

std::vector<std::shared_ptr<const PlacedGrade>> read_grades(const Cursor& root, const SeeMaterial& material) {
  Grades grades;
  if (!root.has("grades")) return grades;
  const Cursor list = root.member("grades");
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor one = list.at(i);
    const Cursor name = one.member("material");
    material(name.text(), name);
    PlacedGrade placed;
    placed.placement = read_placement(one.member("placement"));
    if (one.has("blend")) {
      const Cursor sides = one.member("blend");
      sides.array_of(2, "two materials blend");
      placed.grade.along = BlendGrade{read_side(sides.at(0), list, grades, material),
                                      read_side(sides.at(1), list, grades, material)};
    } else {
      placed.grade = read_grade(one, name.text(), material);
      if (one.has("nested")) read_nested(one.member("nested"), material, placed);
    }
    grades.push_back(std::make_shared<const PlacedGrade>(std::move(placed)));
  }
  return grades;
}

}  // namespace cnrg::result
