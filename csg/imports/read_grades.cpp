// Every number is checked where it is read, so that a message names the place of a fault in the document.
#include "csg/imports/read_grades.h"

#include <algorithm>
#include <set>

#include "csg/geometry/exact_vectors.h"

namespace cnrg::result {
namespace {

Transform read_placement(const Cursor& placement) {
  Transform t;
  const Cursor rows = placement.only({"linear", "offset"}).member("linear");
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

DistanceGrade read_distance(const Cursor& distance) {
  DistanceTarget target;
  const Cursor points = distance.only({"to", "points", "vertices", "segments", "triangles"}).member("points");
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
  return {distance.member("to").text(), std::make_shared<const DistanceTarget>(std::move(target))};
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

}  // namespace

std::vector<std::shared_ptr<const PlacedGrade>> read_grades(
    const Cursor& root, const std::function<void(const std::string&, const Cursor&)>& material) {
  std::vector<std::shared_ptr<const PlacedGrade>> grades;
  if (!root.has("grades")) return grades;
  const Cursor list = root.member("grades");
  std::set<std::string> graded;
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor name = list.at(i).member("material");
    material(name.text(), name);
    graded.insert(name.text());
  }
  for (std::size_t i = 0; i < list.array().size(); ++i) {
    const Cursor one = list.at(i).only({"material", "placement", "linear", "distance", "stops"});
    if (one.has("linear") == one.has("distance")) one.refuse("a grade has `linear` or `distance`");
    PlacedGrade placed;
    placed.placement = read_placement(one.member("placement"));
    if (one.has("linear")) {
      const LinearGrade linear{one.member("linear").only({"from", "to"}).member("from").point(),
                               one.member("linear").member("to").point()};
      if (linear.from == linear.to) one.member("linear").refuse("`from` and `to` are one point");
      placed.grade.along = linear;
    } else {
      placed.grade.along = read_distance(one.member("distance"));
    }
    const Cursor stops = one.member("stops");
    if (stops.array().size() == 0) stops.refuse("a stop is needed here");
    for (std::size_t k = 0; k < stops.size(); ++k) {
      const Rational at = stops.at(k).only({"at", "mixture"}).member("at").rational();
      if (k > 0 && at <= placed.grade.stops.back().at) stops.refuse("stops are ascending");
      const Cursor mixture = stops.at(k).member("mixture");
      mixture.each_member([&](const std::string& name, const Cursor& part) {
        material(name, part);
        if (graded.contains(name)) part.refuse("the material of a stop is not graded itself");
      });
      placed.grade.stops.push_back({at, read_mixture(mixture)});
    }
    grades.push_back(std::make_shared<const PlacedGrade>(std::move(placed)));
  }
  return grades;
}

}  // namespace cnrg::result
