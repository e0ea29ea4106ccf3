#include "bench/sweep/regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernel/base/union_find.h"

namespace cnrg::bench {
namespace {

// --- the tables

/// Regions of one operand on the two sides of a face.
struct Sides {
  std::uint32_t first = 0, second = 0;
  bool wall = false;  ///< the face is one of the operand; else it is in one region or in none
  int num_reg() const { return first == second ? 0 : first != 0 && second != 0 ? 2 : 1; }
  bool inside() const { return !wall && first != 0; }
};

bool union_keeps(const Sides& a, const Sides& b, bool equal) {
  if (a.wall && b.wall) return !equal || a.num_reg() != 1 || b.num_reg() != 1 || (a.first != 0) == (b.first != 0);
  if (a.wall) return !b.inside() || !equal || a.num_reg() != 1;
  return !a.inside() || (equal && b.num_reg() != 1);
}

bool intersection_keeps(const Sides& a, const Sides& b, bool equal) {
  if (a.wall && b.wall) return true;
  if (a.wall) return b.inside();
  return a.inside() && (equal || b.num_reg() == 1 || b.first == 0);
}

bool difference_keeps(const Sides& a, const Sides& b) {
  if (a.wall && b.wall)
    return ((a.first != 0 && b.first == 0) || (a.second != 0 && b.second == 0)) &&
           (a.num_reg() != 0 || b.num_reg() != 0);
  if (a.wall) return !b.inside();
  return a.inside() && b.num_reg() == 1;
}

// --- values on an arrangement

/// A group: the region of each part, and which faces are walls.
struct Parcels {
  std::vector<std::uint32_t> regions;
  std::vector<char> walls;
};

Sides sides_of(const Arrangement& arrangement, const Parcels& value, std::size_t face) {
  const auto& [first, second] = arrangement.faces[face].parts;
  return {value.regions[first], value.regions[second], value.walls[face] != 0};
}

Parcels operand_parcels(const Arrangement& arrangement, std::size_t k) {
  Parcels value;
  for (const Arrangement::Part& part : arrangement.parts) value.regions.push_back(part.regions[k]);
  for (const Arrangement::Face& face : arrangement.faces) value.walls.push_back(face.of[k]);
  return value;
}

bool is_in(Operator op, bool in_a, bool in_b) {
  switch (op) {
    case Operator::unite: return in_a || in_b;
    case Operator::intersect: return in_a && in_b;
    default: return in_a && !in_b;
  }
}

bool keeps(const RegionProblem& problem, Dominance dominance, Sides a, Sides b) {
  if (!a.wall && !b.wall) return false;
  if (problem.blend) return true;
  if (problem.op == Operator::subtract) return difference_keeps(a, b);
  if (dominance == Dominance::right) std::swap(a, b);
  const bool equal = dominance == Dominance::equal;
  return problem.op == Operator::unite ? union_keeps(a, b, equal) : intersection_keeps(a, b, equal);
}

/// Parts that no wall parts are one region.
Parcels boolean_step(const RegionProblem& problem, const Arrangement& arrangement, Dominance dominance,
                     const Parcels& a, const Parcels& b) {
  Parcels value;
  UnionFind joined(arrangement.parts.size());
  std::vector<char> in;
  for (std::size_t p = 0; p < arrangement.parts.size(); ++p)
    in.push_back(is_in(problem.op, a.regions[p] != 0, b.regions[p] != 0));
  for (std::size_t f = 0; f < arrangement.faces.size(); ++f) {
    value.walls.push_back(keeps(problem, dominance, sides_of(arrangement, a, f), sides_of(arrangement, b, f)));
    const auto& [first, second] = arrangement.faces[f].parts;
    if (value.walls.back() == 0 && in[first] != 0 && in[second] != 0)
      joined.unite(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second));
  }
  for (std::uint32_t p = 0; p < arrangement.parts.size(); ++p)
    value.regions.push_back(in[p] != 0 ? joined.find(p) + 1 : 0);
  return value;
}

bool has_steps(Operator op) {
  return op == Operator::unite || op == Operator::intersect || op == Operator::subtract;
}

/// Whether components have what lies there: then they are told by the components of the operands.
bool component_has(Operator op, const Place& place) {
  const auto is_some = [](std::uint32_t region) { return region != 0; };
  switch (op) {
    case Operator::product: return std::all_of(place.begin(), place.end(), is_some);
    case Operator::cnrg_subtract: return place[0] != 0 && std::none_of(place.begin() + 1, place.end(), is_some);
    case Operator::complement: return place[0] == 0;
    case Operator::boundary: return false;
    default: return std::any_of(place.begin(), place.end(), is_some);
  }
}

std::vector<std::uint32_t> component_numbers(Operator op, const Arrangement& arrangement) {
  std::map<Place, std::uint32_t> numbers;
  std::vector<std::uint32_t> of_parts;
  for (const Arrangement::Part& part : arrangement.parts) {
    const Place place = op == Operator::unify ? Place{} : part.regions;
    const auto next = static_cast<std::uint32_t>(numbers.size() + 1);
    of_parts.push_back(component_has(op, part.regions) ? numbers.emplace(place, next).first->second : 0);
  }
  return of_parts;
}

std::vector<std::uint32_t> region_numbers(const RegionProblem& problem, const Arrangement& arrangement) {
  if (!has_steps(problem.op)) return component_numbers(problem.op, arrangement);
  Parcels value = operand_parcels(arrangement, 0);
  for (std::size_t k = 1; k < problem.operands.size(); ++k)
    value = boolean_step(problem, arrangement, problem.dominances[k - 1], value, operand_parcels(arrangement, k));
  return value.regions;
}

// --- the judgement

std::string place_text(const Place& place) {
  std::string text;
  for (std::size_t k = 0; k < place.size(); ++k)
    if (place[k] != 0)
      text += (text.empty() ? "" : ", ") + std::string("region ") + std::to_string(place[k]) + " of operand " +
              std::to_string(k + 1);
  return text;
}

class RegionJudge {
 public:
  RegionJudge(const RegionProblem& problem, double rounding) : problem_(problem), rounding_(rounding) {
    for (const ExactRegion& region : problem.regions)
      for (const auto& [place, exact] : region) most_ = std::max(most_, allowed(exact));
  }

  RegionJudgement run(const FoundRegions& found) const {
    std::vector<std::size_t> missing, left(found.regions.size());
    std::iota(left.begin(), left.end(), 0);
    for (std::size_t i = 0; i < problem_.regions.size(); ++i) {
      const auto it = std::find_if(left.begin(), left.end(),
                                   [&](std::size_t k) { return is_same(problem_.regions[i], found.regions[k]); });
      if (it == left.end()) missing.push_back(i);
      else left.erase(it);
    }
    if (missing.empty() && left.empty()) return {};
    const auto all_thin = [](const auto& places, const auto& regions, const auto& thin) {
      return std::all_of(places.begin(), places.end(), [&](std::size_t i) { return thin(regions[i]); });
    };
    const bool thin = all_thin(missing, problem_.regions, [&](const auto& r) { return is_thin(r); }) &&
                      all_thin(left, found.regions, [&](const auto& r) { return is_thin(r); });
    return {thin || is_regrouped(missing, left, found) ? Verdict::within_rounding : Verdict::wrong,
            std::to_string(found.regions.size()) + " regions, ours " + std::to_string(problem_.regions.size()) +
                (missing.empty() ? "" : "; ours alone: " + words(problem_.regions[missing[0]])) +
                (left.empty() ? "" : "; theirs alone: " + words(found.regions[left[0]]))};
  }

 private:
  double allowed(const ExactVolume& exact) const { return 16 * rounding_ * problem_.extent * exact.area; }

  bool is_same(const ExactRegion& exact, const FoundRegion& found) const {
    const auto is_near = [&](const auto& one) {
      const auto& [place, volume] = one;
      const auto it = found.find(place);
      const double there = it == found.end() ? 0 : it->second;
      return std::abs(there - to_double(volume.volume)) <= allowed(volume);
    };
    const auto is_little = [&](const auto& one) { return exact.contains(one.first) || one.second <= most_; };
    return std::all_of(exact.begin(), exact.end(), is_near) && std::all_of(found.begin(), found.end(), is_little);
  }

  bool is_thin(const ExactRegion& region) const {
    return std::all_of(region.begin(), region.end(),
                       [&](const auto& one) { return to_double(one.second.volume) <= allowed(one.second); });
  }
  bool is_thin(const FoundRegion& region) const {
    return std::all_of(region.begin(), region.end(), [&](const auto& one) { return one.second <= most_; });
  }

  /// Together the same, and no two of either share a wall.
  bool is_regrouped(const std::vector<std::size_t>& missing, const std::vector<std::size_t>& left,
                    const FoundRegions& found) const {
    ExactRegion exact;
    FoundRegion theirs;
    for (const std::size_t i : missing)
      for (const auto& [place, volume] : problem_.regions[i]) {
        exact[place].volume += volume.volume;
        exact[place].area += volume.area;
      }
    for (const std::size_t k : left)
      for (const auto& [place, volume] : found.regions[k]) theirs[place] += volume;
    return is_same(exact, theirs) && share_nothing(missing, problem_.walls) && share_nothing(left, found.walls);
  }

  bool share_nothing(const std::vector<std::size_t>& regions, const Walls& walls) const {
    const auto is_of = [&](std::size_t i) { return std::binary_search(regions.begin(), regions.end(), i); };
    const double little = 16 * rounding_ * problem_.extent * problem_.extent;
    return std::none_of(walls.begin(), walls.end(), [&](const auto& wall) {
      return is_of(wall.first.first) && is_of(wall.first.second) && wall.second > little;
    });
  }

  static std::string words(const ExactRegion& region) {
    FoundRegion rounded;
    for (const auto& [place, exact] : region) rounded[place] = to_double(exact.volume);
    return words(rounded);
  }
  static std::string words(const FoundRegion& region) {
    std::string text;
    for (const auto& [place, volume] : region)
      text += (text.empty() ? "" : " and ") + to_decimal(from_double(volume)) + " in " + place_text(place);
    return text;
  }

  const RegionProblem& problem_;
  double rounding_, most_ = 0;
};

}  // namespace

FoundRegions regions_of(const RegionProblem& problem, const Arrangement& arrangement) {
  const std::vector<std::uint32_t> numbers = region_numbers(problem, arrangement);
  std::map<std::uint32_t, std::size_t> places;
  FoundRegions found;
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    if (numbers[p] == 0) continue;
    const auto [it, is_new] = places.emplace(numbers[p], found.regions.size());
    if (is_new) found.regions.emplace_back();
    found.regions[it->second][arrangement.parts[p].regions] += arrangement.parts[p].volume;
  }
  for (const Arrangement::Face& face : arrangement.faces) {
    const std::uint32_t a = numbers[face.parts[0]], b = numbers[face.parts[1]];
    if (a != 0 && b != 0 && a != b) found.walls[std::minmax(places.at(a), places.at(b))] += face.area;
  }
  return found;
}

RegionJudgement judge_regions(const RegionProblem& problem, const FoundRegions& found, double rounding) {
  return RegionJudge(problem, rounding).run(found);
}

}  // namespace cnrg::bench
