#include "csg/weld/fit_polygon.h"

#include "csg/weld/weld.h"

namespace cnrg {

std::vector<std::string> fit_polygon(std::vector<std::vector<RationalPoint>>& loops, const Rational& d,
                                     const std::string& name) {
  WeldModel model;
  model.only_planes = true;
  model.face_name = [&](WeldModel::Index) { return LeafWords(name); };
  model.faces.resize(1);
  WeldModel::Facet& facet = model.facets.emplace_back();
  for (const auto& loop : loops) {
    auto& numbers = facet.loops.emplace_back();
    for (const RationalPoint& p : loop) {
      numbers.push_back(static_cast<WeldModel::Index>(model.points.size()));
      model.points.push_back(p);
    }
  }
  const Weld made = weld(model, d);
  auto moved = made.points.begin();
  for (auto& loop : loops) {
    for (RationalPoint& p : loop) p = *moved++;
  }
  const std::string words = made.notice(d).text();
  return words.empty() ? std::vector<std::string>() : std::vector{name + ": " + words};
}

}  // namespace cnrg
