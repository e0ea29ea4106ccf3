// A solid with a surface or a wire.
#include "bench/cases/family_makers.h"
#include "bench/cases/perturbation.h"
#include "bench/cases/touching.h"

namespace cnrg::bench {
namespace {

RationalPoint lying(const std::array<Rational, 2>& p) { return {p[0], p[1], 0}; }

/// A rectangle in the plane of the solid's upper face, partly beyond its border.
Model lying_sheet(Random& random) {
  // Sides along (4, 3) and (-3, 4).
  const Rational x = Rational(random.integer(-8, 8)) / 128, y = Rational(random.integer(-8, 8)) / 128;
  const std::array<Rational, 2> middle{x, y}, along{Rational(9, 8), Rational(27, 32)};
  const std::array<Rational, 2> across{Rational(-9, 32), Rational(3, 8)};
  const auto corner = [&](int i, int j) {
    return lying({middle[0] + i * along[0] + j * across[0], middle[1] + i * along[1] + j * across[1]});
  };
  return sheet_of({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
}

/// A rectangle that stands on the upper face, its lower edge within it.
Model standing_sheet(Random& random) {
  const Rational x = Rational(random.integer(2, 8)) / 32, y = Rational(random.integer(2, 8)) / 32;
  const Rational top = Rational(random.integer(20, 28)) / 16;
  return sheet_of({{-x, -y, 0}, {x, y, 0}, {x, y, top}, {-x, -y, top}});
}

/// A rectangle through the whole solid that holds the edge of its corner 0: from (1, 0, 0) to `end`, whose y is 0.
/// Its sides are parallel to that edge and to the x axis.
Model cutting_sheet(const RationalPoint& end, const Rational& beyond) {
  const Rational x = end[0] - 1, z = end[2];
  const auto at = [&](const Rational& across, const Rational& down) {
    return RationalPoint{across + down * x, 0, down * z};
  };
  return sheet_of({at(-beyond, Rational(5, 4)), at(beyond, Rational(5, 4)), at(beyond, Rational(-1, 4)),
                   at(-beyond, Rational(-1, 4))});
}

/// A sheet in the plane y = 0 moves along y, not along z: both axes change places with x.
Problem cut_through(const ProblemId& id, Random& random) {
  const Polygon whole = random_polygon(static_cast<std::size_t>(id.size), random);
  const Rational flare = Rational(random.integer(18, 22)) / 16, depth = Rational(random.integer(20, 26)) / 16;
  Model solid = frustum(scaled(whole, flare), -depth, whole, 0);
  Model sheet = cutting_sheet({flare, 0, -depth}, 2);
  AffineMap turn;  // (x, y, z) -> (z, x, y)
  turn.rows = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  return problem_of(id, placed_pair(id, mapped(std::move(solid), turn), mapped(std::move(sheet), turn)));
}

Problem sheet(const ProblemId& id) {
  Random random = random_of(id);
  if (kind_of(id, 3) == 2) return cut_through(id, random);
  Model solid = slab(random_polygon(static_cast<std::size_t>(id.size), random), Side::below, random);
  Model surface = kind_of(id, 3) == 0 ? lying_sheet(random) : standing_sheet(random);
  return problem_of(id, placed_pair(id, std::move(solid), std::move(surface)));
}

/// A wire of three segments: in the upper face and beyond its border, along an edge and beyond it, or through the
/// vertex at the origin.
Problem bolt(const ProblemId& id) {
  Random random = random_of(id);
  const auto corners = static_cast<std::size_t>(id.size);
  const auto part = [&](int low, int high) -> Rational { return Rational(random.integer(low, high)) / 64; };
  const Rational x = part(8, 24), y = part(4, 20), z = part(40, 60);
  Model solid, wire;
  switch (kind_of(id, 3)) {
    case 0:
      solid = slab(random_polygon(corners, random), Side::below, random);
      wire = wire_of({{-x, -y, z}, {-x, -y, 0}, {x, y / 2, 0}, {5 * x + 1, 2 * y, 0}});
      break;
    case 1:
      solid = ridge(corners, -1, Rational(1, 2), Side::below, random);
      wire = wire_of({{x, -1, z}, {0, Rational(-1, 2), 0}, {0, 1, 0}, {-x, 1, z}});
      break;
    default:
      solid = spike(corners, Side::below, random);
      wire = wire_of({{-x, y, 2 * z}, {-x, -y, z}, {0, 0, 0}, {x, -y, z}});
      break;
  }
  return problem_of(id, placed_pair(id, std::move(solid), std::move(wire)));
}

}  // namespace

std::vector<FamilyMaker> mixed_families() {
  constexpr long kLargest = 1000;
  return {{"sheet", kOperations, 4, kLargest, true, sheet}, {"bolt", kOperations, 4, kLargest, true, bolt}};
}

}  // namespace cnrg::bench
