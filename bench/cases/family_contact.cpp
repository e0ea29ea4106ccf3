// Two solids that touch: in a face, a part of one, an edge, a vertex, or from inside.
#include "bench/cases/family_makers.h"
#include "bench/cases/perturbation.h"
#include "bench/cases/touching.h"

namespace cnrg::bench {
namespace {

Problem face(const ProblemId& id) {
  Random random = random_of(id);
  const Polygon common = random_polygon(static_cast<std::size_t>(id.size), random);
  Model first = slab(common, Side::below, random), second = slab(common, Side::above, random);
  return problem_of(id, placed_pair(id, std::move(first), std::move(second)));
}

Problem part_of_face(const ProblemId& id) {
  Random random = random_of(id);
  const auto corners = static_cast<std::size_t>(id.size);
  const Polygon whole = random_polygon(corners, random);
  Polygon part;
  switch (kind_of(id, 3)) {
    case 0: part = part_inside(corners, random); break;
    case 1: part = part_across(corners, random); break;
    default: part = part_at_edge(whole); break;
  }
  Model first = slab(whole, Side::below, random), second = slab(part, Side::above, random);
  return problem_of(id, placed_pair(id, std::move(first), std::move(second)));
}

Problem edge(const ProblemId& id) {
  Random random = random_of(id);
  const auto corners = static_cast<std::size_t>(id.size);
  const Rational half(1, 2), quarter(1, 4);
  Model first, second;
  switch (kind_of(id, 3)) {
    case 0:  // the whole of both edges
      first = ridge(corners, -1, 1, Side::below, random);
      second = ridge(corners, -1, 1, Side::above, random);
      break;
    case 1:  // a part of both
      first = ridge(corners, -1, half, Side::below, random);
      second = ridge(corners, -half, 1, Side::above, random);
      break;
    default:  // an edge in a face
      first = slab(random_polygon(corners, random), Side::below, random);
      second = ridge(corners, -quarter, quarter, Side::above, random);
      break;
  }
  return problem_of(id, placed_pair(id, std::move(first), std::move(second)));
}

Problem vertex(const ProblemId& id) {
  Random random = random_of(id);
  const auto corners = static_cast<std::size_t>(id.size);
  Model first, second;
  switch (kind_of(id, 4)) {
    case 0: first = spike(corners, Side::below, random); break;
    case 1: first = slab(random_polygon(corners, random), Side::below, random); break;
    default: first = ridge(corners, -1, 1, Side::below, random); break;
  }
  if (kind_of(id, 4) == 3) {  // two edges that cross, at about 53 degrees
    second = mapped(ridge(corners, -1, 1, Side::above, random), rotation({2, 0, 0, 1}));
  } else {
    second = spike(corners, Side::above, random);
  }
  return problem_of(id, placed_pair(id, std::move(first), std::move(second)));
}

/// The second solid lies within the first one, which grows away from the wall while it gets smaller.
Problem wall(const ProblemId& id) {
  Random random = random_of(id);
  const auto corners = static_cast<std::size_t>(id.size);
  const auto sixteenths = [&](int low, int high) -> Rational { return Rational(random.integer(low, high)) / 16; };
  const Polygon whole = random_polygon(corners, random);
  Polygon part;
  switch (kind_of(id, 3)) {
    case 0: part = part_inside(corners, random); break;
    case 1: part = part_at_edge(whole); break;
    default: part = whole; break;
  }
  const Rational flare = sixteenths(17, 20), depth = sixteenths(20, 26);
  const Rational shrink = sixteenths(8, 12), reach = sixteenths(10, 14);
  const Rational a = Rational(random.integer(1, 7)) / 128, b = Rational(random.integer(-7, -1)) / 128;
  Model first = frustum(scaled(whole, flare), -depth, whole, 0);
  Model second = mapped(frustum(scaled(part, shrink), -reach, part, 0), shear(a, b));
  return problem_of(id, placed_pair(id, std::move(first), std::move(second)));
}

}  // namespace

std::vector<FamilyMaker> contact_families() {
  constexpr long kLargest = 1000;
  return {{"face", kOperations, 4, kLargest, true, face},
          {"part-of-face", kOperations, 4, kLargest, true, part_of_face},
          {"edge", kOperations, 4, kLargest, true, edge},
          {"vertex", kOperations, 4, kLargest, true, vertex},
          {"wall", kOperations, 4, kLargest, true, wall}};
}

}  // namespace cnrg::bench
