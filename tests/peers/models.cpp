#include "tests/peers/models.h"

#include <map>
#include <set>

namespace cnrg::peers {
namespace {

/// Of the closed polygon, by the right-hand rule.
RationalPoint area_of(const Model& model, const std::vector<std::uint32_t>& loop) {
  RationalPoint area{0, 0, 0};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const RationalPoint &p = model.points[loop[i]], &q = model.points[loop[(i + 1) % loop.size()]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      area[k] += (p[l] * q[m] - p[m] * q[l]) / 2;
    }
  }
  return area;
}

}  // namespace

Model box(const RationalPoint& low, const RationalPoint& high) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.points.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  const std::vector<std::vector<std::uint32_t>> sides{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : sides) model.faces.push_back({{side}, true});
  return model;
}

Model sheet(const RationalPoint& corner, const RationalPoint& u, const RationalPoint& v) {
  Model model;
  for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    RationalPoint p = corner;
    for (std::size_t k = 0; k < 3; ++k) p[k] += a * u[k] + b * v[k];
    model.points.push_back(p);
  }
  model.faces.push_back({{{0, 1, 2, 3}}, false});
  return model;
}

Model wire(const RationalPoint& a, const RationalPoint& b) {
  Model model;
  model.points = {a, b};
  model.wires.push_back({0, 1});
  return model;
}

Model point(const RationalPoint& p) {
  Model model;
  model.points = {p};
  model.isolated.push_back(0);
  return model;
}

Problem pair_of(Model a, Operation operation, Model b) {
  return {"pair", {std::move(a), std::move(b)}, {operation}};
}

Rational volume(const Model& model) {
  Rational sum = 0;
  for (const Model::Face& face : model.faces) {
    if (!face.solid) continue;
    const RationalPoint& apex = model.points[face.loops[0][0]];
    for (const auto& loop : face.loops) {
      const RationalPoint area = area_of(model, loop);
      for (std::size_t k = 0; k < 3; ++k) sum += apex[k] * area[k] / 3;
    }
  }
  return sum;
}

Rational sheet_area(const Model& model) {
  Rational sum = 0;
  for (const Model::Face& face : model.faces) {
    if (face.solid) continue;
    RationalPoint area{0, 0, 0};
    for (const auto& loop : face.loops) {
      const RationalPoint part = area_of(model, loop);
      for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
    }
    for (const Rational& x : area) sum += abs(x);
  }
  return sum;
}

Rational wire_length(const Model& model) {
  Rational sum = 0;
  for (const auto& [a, b] : model.wires)
    for (std::size_t k = 0; k < 3; ++k) sum += abs(model.points[a][k] - model.points[b][k]);
  return sum;
}

std::size_t duplicates(const Model& model) {
  return model.points.size() - std::set<RationalPoint>(model.points.begin(), model.points.end()).size();
}

bool closed(const Model& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const Model::Face& face : model.faces) {
    if (!face.solid) continue;
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
  }
  for (const auto& [side, sum] : balance)
    if (sum != 0) return false;
  return true;
}

}  // namespace cnrg::peers
