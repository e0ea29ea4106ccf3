#include "bench/cases/perturbation.h"

#include <utility>

namespace cnrg::bench {
namespace {

/// first, then second.
AffineMap then(const AffineMap& first, const AffineMap& second) {
  AffineMap map;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      map.rows[i][k] = 0;
      for (int j = 0; j < 3; ++j) map.rows[i][k] += second.rows[i][j] * first.rows[j][k];
    }
  }
  map.move = second(first.move);
  return map;
}

AffineMap turn_in_plane(const ProblemId& id, int sign) {
  // Unit vectors of fractions, near the y axis.
  constexpr std::array<std::array<int, 3>, 4> kAxes{{{5, 12, 13}, {-7, 24, 25}, {-5, 12, 13}, {9, 40, 41}}};
  const auto& [x, y, length] = kAxes[id.seed / 2 % kAxes.size()];
  const Rational u = Rational(x) / length, v = Rational(y) / length;
  const RationalPoint middle{v / 2, -u / 2, Rational(1, 4)};
  const AffineMap turn = rotation({2 / power_of_tenth(*id.distance), sign * u, sign * v, 0});
  return then(then(translation({-middle[0], -middle[1], -middle[2]}), turn), translation(middle));
}

}  // namespace

AffineMap perturbation(const ProblemId& id) {
  if (!id.distance) return {};
  const unsigned way = (id.seed + 3) % 4;
  if (way % 2 == 1) return turn_in_plane(id, way == 1 ? 1 : -1);
  return translation({0, 0, (way == 0 ? 1 : -1) * power_of_tenth(*id.distance)});
}

unsigned kind_of(const ProblemId& id, unsigned kinds) {
  const unsigned from_zero = id.seed - 1;
  return (from_zero + from_zero / 4) % kinds;
}

AffineMap placement(const ProblemId& id) {
  if (id.seed <= 2) return {};
  Random random(id.seed);
  AffineMap map = random_rotation(random);
  for (Rational& x : map.move) x = Rational(random.integer(-64, 64)) / 64;
  return map;
}

Random random_of(const ProblemId& id) {
  unsigned mix = id.seed;
  for (const char letter : id.family) mix = mix * 31 + static_cast<unsigned char>(letter);
  return Random(mix);
}

std::vector<Model> placed_pair(const ProblemId& id, Model first, Model second) {
  const AffineMap place = placement(id);
  std::vector<Model> pair;
  pair.push_back(mapped(std::move(first), place));
  pair.push_back(mapped(std::move(second), then(perturbation(id), place)));
  return pair;
}

}  // namespace cnrg::bench
