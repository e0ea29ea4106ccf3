// Small models by hand.
#pragma once

#include "bench/cases/family.h"

namespace cnrg::bench {

using Corner = std::array<Rational, 3>;

inline Model box(const Corner& min, const Corner& max) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.points.push_back({i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? max[2] : min[2]});
  const std::uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : sides) model.faces.push_back({{{s[0], s[1], s[2], s[3]}}, true});
  return model;
}

inline Model sheet(const std::vector<Corner>& corners) {
  Model model;
  model.points = corners;
  std::vector<std::uint32_t> loop(corners.size());
  for (std::uint32_t i = 0; i < loop.size(); ++i) loop[i] = i;
  model.faces.push_back({{loop}, false});
  return model;
}

inline Model wire(const Corner& a, const Corner& b) {
  Model model;
  model.points = {a, b};
  model.wires = {{0, 1}};
  return model;
}

/// Both, no point in common by name.
inline Model together(Model a, const Model& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (Model::Face face : b.faces) {
    for (auto& loop : face.loops)
      for (std::uint32_t& p : loop) p += first;
    a.faces.push_back(face);
  }
  for (const auto& [p, q] : b.wires) a.wires.push_back({p + first, q + first});
  for (const std::uint32_t p : b.isolated) a.isolated.push_back(p + first);
  return a;
}

/// Points of equal coordinates become one.
inline Model welded(Model model) {
  std::vector<std::uint32_t> first(model.points.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    first[i] = i;
    for (std::uint32_t k = 0; k < i; ++k)
      if (model.points[k] == model.points[i] && first[i] == i) first[i] = k;
  }
  for (Model::Face& face : model.faces)
    for (auto& loop : face.loops)
      for (std::uint32_t& p : loop) p = first[p];
  return model;
}

inline Model moved(Model model, const Corner& by) {
  for (RationalPoint& p : model.points)
    for (int k = 0; k < 3; ++k) p[k] += by[k];
  return model;
}

inline Problem problem_of(Model a, Operation operation, Model b) {
  return {"by-hand", {std::move(a), std::move(b)}, {operation}};
}

}  // namespace cnrg::bench
