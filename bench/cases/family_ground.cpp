// Ground: layers with faults and tunnels; networks of fractures in a box with wells.
#include <algorithm>

#include "bench/cases/family_makers.h"
#include "bench/cases/perturbation.h"

namespace cnrg::bench {
namespace {

// --- layers

constexpr int kCells = 4;       // of the grid that layers are made on, along each side
constexpr int kWidth = 8;       // of a cell
constexpr int kThickness = 12;  // of a layer, about

/// Heights at the corners of the grid, row by row.
using Heights = std::vector<int>;

constexpr std::uint32_t kRow = kCells + 1;

/// Between two height fields, `low` below everywhere: triangles above and below, upright quadrilaterals around.
Model layer(const Heights& low, const Heights& high) {
  Model model;
  for (const Heights* heights : {&low, &high})
    for (std::uint32_t i = 0; i < kRow * kRow; ++i)
      model.points.push_back({Rational(i % kRow * kWidth), Rational(i / kRow * kWidth), Rational((*heights)[i])});
  const auto add = [&](std::vector<std::uint32_t> loop) { model.faces.push_back({{std::move(loop)}, true}); };
  constexpr std::uint32_t up = kRow * kRow;
  for (std::uint32_t y = 0; y < kCells; ++y) {
    for (std::uint32_t x = 0; x < kCells; ++x) {
      const std::uint32_t a = y * kRow + x, b = a + 1, c = b + kRow, d = a + kRow;
      add({a, c, b});
      add({a, d, c});
      add({up + a, up + b, up + c});
      add({up + a, up + c, up + d});
    }
  }
  const auto wall = [&](std::uint32_t a, std::uint32_t b) { add({a, b, up + b, up + a}); };
  for (std::uint32_t i = 0; i < kCells; ++i) {
    wall(i, i + 1);
    wall(i * kRow + kCells, (i + 1) * kRow + kCells);
    wall(kCells * kRow + i + 1, kCells * kRow + i);
    wall((i + 1) * kRow, i * kRow);
  }
  return model;
}

/// A parallelogram that dips, beyond the ground on all sides.
Model fault(int height, Random& random) {
  constexpr int kEnd = kCells * kWidth;
  const int low = random.integer(4, kEnd - 4), high = random.integer(4, kEnd - 4), skew = random.integer(-3, 3);
  return sheet_of(
      {{low, -2, -2}, {low + skew, kEnd + 2, -2}, {high + skew, kEnd + 2, height + 2}, {high, -2, height + 2}});
}

/// An octagonal prism along x: from wall to wall, or beyond them.
Model tunnel(int height, bool beyond, Random& random) {
  Polygon section{{2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}};
  const Rational y = random.integer(6, kCells * kWidth - 6), z = random.integer(4, height - 8);
  section = scaled(section, 1, {y, z});
  const int out = beyond ? 3 : 0;
  AffineMap turn;  // (x, y, z) -> (z, x, y)
  turn.rows = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  return mapped(frustum(section, -out, section, kCells * kWidth + out), turn);
}

/// Layers, united from the bottom; then two faults and two tunnels, subtracted: faults as slits.
Problem ground(const ProblemId& id) {
  Random random = random_of(id);
  Problem problem;
  Heights low(kRow * kRow, 0);
  for (long i = 0; i < id.size; ++i) {
    Heights high = low;
    for (int& z : high) z += random.integer(kThickness - 6, kThickness + 6);
    if (i > 0) problem.steps.push_back(Operation::unite);
    problem.operands.push_back(layer(low, high));
    low = std::move(high);
  }
  const int height = *std::max_element(low.begin(), low.end());
  for (int i = 0; i < 2; ++i) problem.operands.push_back(fault(height, random));
  for (const bool beyond : {true, false}) problem.operands.push_back(tunnel(height, beyond, random));
  problem.steps.insert(problem.steps.end(), 4, Operation::subtract);
  const AffineMap place = placement(id);
  for (Model& model : problem.operands) model = mapped(std::move(model), place);
  return problem;
}

// --- fractures

constexpr int kBox = 64;

/// A convex polygon of four or six corners in a plane that two small vectors span; every third one lies in a plane
/// of the integer grid, so that fractures end on others and on the box.
Model fracture(long number, Random& random) {
  RationalPoint middle, u, v;
  for (Rational& x : middle) x = random.integer(4, kBox - 4);
  if (number % 3 == 0) {
    const int axis = random.integer(0, 2);
    for (Rational& x : middle) x = 8 * random.integer(1, kBox / 8 - 1);
    u[(axis + 1) % 3] = 4 * random.integer(1, 4);
    v[(axis + 2) % 3] = 4 * random.integer(1, 4);
  } else {
    do {
      for (int k = 0; k < 3; ++k) {
        u[k] = random.integer(-10, 10);
        v[k] = random.integer(-10, 10);
      }
    } while (u[0] * v[1] == u[1] * v[0] || u[1] * v[2] == u[2] * v[1] || u[2] * v[0] == u[0] * v[2]);
  }
  constexpr std::array<std::array<int, 2>, 4> kFour{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  constexpr std::array<std::array<int, 2>, 6> kSix{{{-2, 0}, {-1, -1}, {1, -1}, {2, 0}, {1, 1}, {-1, 1}}};
  std::vector<RationalPoint> corners;
  const auto add = [&](const std::array<int, 2>& place) {
    RationalPoint p = middle;
    for (int k = 0; k < 3; ++k) p[k] += place[0] * u[k] + place[1] * v[k];
    corners.push_back(std::move(p));
  };
  if (number % 2 == 0) std::for_each(kFour.begin(), kFour.end(), add);
  else std::for_each(kSix.begin(), kSix.end(), add);
  return sheet_of(corners);
}

/// From above the box down into it, then aside.
Model well(Random& random) {
  const int x = random.integer(8, kBox - 8), y = random.integer(8, kBox - 8), z = random.integer(16, kBox / 2);
  const RationalPoint end{random.integer(4, kBox - 4), random.integer(4, kBox - 4), random.integer(2, 14)};
  return wire_of({{x, y, kBox + 6}, {x, y, z}, end});
}

Model box() { return box_between({0, 0, 0}, {kBox, kBox, kBox}); }

/// `fold`: all united, then intersected with the box, so that they end at it. `difference`: the box without them.
Problem fractures(const ProblemId& id) {
  Random random = random_of(id);
  std::vector<Model> network;
  for (long i = 0; i < id.size; ++i) network.push_back(fracture(i, random));
  for (long i = 0; i < 1 + id.size / 10; ++i) network.push_back(well(random));
  Problem problem;
  if (id.operation == "fold") {
    problem.steps.assign(network.size() - 1, Operation::unite);
    problem.steps.push_back(Operation::intersect);
    problem.operands = std::move(network);
    problem.operands.push_back(box());
  } else {
    problem.steps.assign(network.size(), operation_of(id));
    problem.operands.push_back(box());
    problem.operands.insert(problem.operands.end(), network.begin(), network.end());
  }
  const AffineMap place = placement(id);
  for (Model& model : problem.operands) model = mapped(std::move(model), place);
  return problem;
}

}  // namespace

std::vector<FamilyMaker> ground_families() {
  return {{"ground", {"fold"}, 1, 1000, false, ground},
          {"fractures", {"fold", "difference"}, 1, 10000, false, fractures}};
}

}  // namespace cnrg::bench
