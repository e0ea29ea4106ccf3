// Every number is checked where it is read, so that a message names the place of a fault in the document.
#include "csg/imports/read_grades.h"

#include <algorithm>

#include "csg/geometry/exact_vectors.h"

namespace cnrg::result {
namespace {

Transform read_placement(const Cursor& placement) {
  Transform t;
  const Cursor rows = placement.member("linear");
  if (rows.array().size() != 3) rows.fail(std::string("a matrix has three rows") + kAgain);
  for (std::size_t k = 0; k < 3; ++k) t.linear[k] = rows.at(k).point();
  t.offset = placement.member("offset").point();
  if (t.determinant() == 0) rows.fail(std::string("the matrix is singular") + kAgain);
  return t;
}

template <std::size_t N>
void read_simplices(const Cursor& list, std::size_t points, std::vector<std::array<Index, N>>& out) {
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor simplex = list.at(i);
    if (simplex.array().size() != N) {
      simplex.fail(std::to_string(N) + " points are needed here" + kAgain);
    }
    auto& corners = out.emplace_back();
    for (std::size_t k = 0; k < N; ++k) corners[k] = simplex.at(k).number(points, "point");
  }
}

DistanceGrade read_distance(const Cursor& distance) {
  DistanceTarget target;
  const Cursor points = distance.member("points");
  for (std::size_t i = 0; i < points.array().size(); ++i) target.points.push_back(points.at(i).point());
  read_simplices(distance.member("vertices"), target.points.size(), target.vertices);
  read_simplices(distance.member("segments"), target.points.size(), target.segments);
  read_simplices(distance.member("triangles"), target.points.size(), target.triangles);
  if (target.empty()) distance.fail(std::string("there is nothing to measure a distance to") + kAgain);
  for (const auto& [a, b, c] : target.triangles) {
    if (collinear(target.points[a], target.points[b], target.points[c])) {
      distance.fail(std::string("a triangle has no area") + kAgain);
    }
  }
  return {distance.member("to").text(), std::make_shared<const DistanceTarget>(std::move(target))};
}

Mixture read_mixture(const Cursor& object) {
  Mixture mixture;
  Rational sum = 0;
  object.each_member([&](const std::string& name, const Cursor& value) {
    mixture.emplace_back(name, value.rational());
    if (mixture.back().second <= 0) value.fail(std::string("a fraction is positive") + kAgain);
    sum += mixture.back().second;
  });
  if (sum != 1) object.fail(std::string("fractions add up to 1") + kAgain);
  std::sort(mixture.begin(), mixture.end());
  return mixture;
}

}  // namespace

std::vector<std::shared_ptr<const PlacedGrade>> read_grades(const Cursor& root) {
  std::vector<std::shared_ptr<const PlacedGrade>> grades;
  if (!root.has("grades")) return grades;
  const Cursor list = root.member("grades");
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor one = list.at(i);
    PlacedGrade placed;
    placed.placement = read_placement(one.member("placement"));
    if (one.has("linear")) {
      const LinearGrade linear{one.member("linear").member("from").point(),
                               one.member("linear").member("to").point()};
      if (linear.from == linear.to)
        one.member("linear").fail(std::string("`from` and `to` are one point") + kAgain);
      placed.grade.along = linear;
    } else {
      placed.grade.along = read_distance(one.member("distance"));
    }
    const Cursor stops = one.member("stops");
    if (stops.array().size() == 0) stops.fail(std::string("a stop is needed here") + kAgain);
    for (std::size_t k = 0; k < stops.size(); ++k) {
      const Rational at = stops.at(k).member("at").rational();
      if (k > 0 && at <= placed.grade.stops.back().at) stops.fail(std::string("stops are ascending") + kAgain);
      placed.grade.stops.push_back({at, read_mixture(stops.at(k).member("mixture"))});
    }
    grades.push_back(std::make_shared<const PlacedGrade>(std::move(placed)));
  }
  return grades;
}

}  // namespace cnrg::result
