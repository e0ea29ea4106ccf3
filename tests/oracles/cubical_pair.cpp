#include "tests/oracles/cubical_pair.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "csg/operators/identities.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/simplify.h"
#include "tests/oracles/evaluation.h"
#include "tests/oracles/paper_classification.h"

namespace cubical {
namespace {

using cnrg::Rational;
using cnrg::RationalPoint;

std::string cell_name(const Grid& grid, Cell c) {
  const auto p = grid.position(c);
  return "(" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) + ")/2";
}

// The kernel's complex with the place of each grid cell in it.
class Kernel {
 public:
  Kernel(const Grid& grid, const Group& a, const Group& b, const Presentation& how)
      : grid_(grid), built_(build(grid, a, b, how)), locator_(complex_), leaves_(cnrg::leaf_groups(complex_)) {
    for (Cell c = 0; c < grid.cells(); ++c) {
      const auto p = grid.position(c);
      bool rim = false;
      for (int x : p) rim = rim || x <= 0 || x >= 2 * grid.n();
      if (rim) continue;
      cells_.push_back(c);
      const RationalPoint at{Rational(p[0], 2), Rational(p[1], 2), Rational(p[2], 2)};
      places_.push_back(locator_.locate(how.place ? (*how.place)(at) : at));
    }
  }

  const cnrg::Complex& complex() const { return complex_; }
  const cnrg::Group& leaf(std::size_t i) const { return leaves_[i]; }

  // Both groups hold the same entities, and regions that correspond one to one.
  std::string compare(const Group& want, const cnrg::Group& have) const {
    if (want.region_count < 0) return "the brute force itself left an invalid group";
    std::map<int, std::uint32_t> to;
    std::map<std::uint32_t, int> from;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell c = cells_[i];
      const bool entity = grid_.dimension(c) < 3 && want.entity[c];
      if (has(have, places_[i]) != entity) {
        return cell_name(grid_, c) + (entity ? " should be an entity" : " should be no entity");
      }
      if (entity) continue;
      const int region = region_around(grid_, want, c);
      const std::uint32_t mine = have.region_of(region_at(places_[i]));
      if ((region == 0) != (mine == 0)) {
        return cell_name(grid_, c) + (region ? " should be inside" : " should be outside");
      }
      if (region == 0) continue;
      if (!to.emplace(region, mine).second && to[region] != mine) return cell_name(grid_, c) + " splits a region";
      if (!from.emplace(mine, region).second && from[mine] != region)
        return cell_name(grid_, c) + " joins regions";
    }
    if (have.regions.size() != static_cast<std::size_t>(want.region_count)) return "the number of regions differs";
    return "";
  }

  // The simplified selection keeps each cell's component and has the canonical counts of the brute force.
  std::string compare_simplified(const Group& want, const cnrg::Group& have, bool components) const {
    cnrg::Selection selection = cnrg::selection_of(complex_, have);
    if (!components) selection = cnrg::properties::joined(std::move(selection));
    std::vector<int> state(grid_.cells(), 0);
    for (Cell c : cells_) {
      if (grid_.dimension(c) < 3 && want.entity[c]) state[c] = components ? want.region_count + 1 : 1;
      else if (const int r = region_around(grid_, want, c); r > 0) state[c] = components ? r : 1;
    }
    for (const auto mode : {cnrg::SimplifyMode::points, cnrg::SimplifyMode::features, cnrg::SimplifyMode::raw}) {
      const auto simplified = cnrg::simplify(complex_, selection, have.features, mode);
      std::string wrong = check_places(simplified, selection);
      if (wrong.empty() && mode == cnrg::SimplifyMode::points) {
        const auto counts = cnrg::active_counts(simplified), brute = canonical_counts(grid_, state);
        if (counts != brute) {
          for (int d = 0; d < 4; ++d) {
            wrong += " " + std::to_string(counts[d]) + "/" + std::to_string(brute[d]);
          }
          wrong = "simplified counts (kernel/brute force):" + wrong;
        }
      }
      if (!wrong.empty()) return "mode " + std::to_string(static_cast<int>(mode)) + ": " + wrong;
    }
    return "";
  }

 private:
  static std::shared_ptr<const cnrg::Complex> build(const Grid& grid, const Group& a, const Group& b,
                                                    const Presentation& how) {
    std::vector<cnrg::scenes::Leaf> leaves{leaf_of(grid, a, how.large_a), leaf_of(grid, b, how.large_b)};
    if (how.place)
      for (cnrg::scenes::Leaf& leaf : leaves) cubical::place(*how.place, leaf);
    cnrg::RefineOptions options;
    options.threads = 1;
    const auto complex = cnrg::build_complex(cnrg::scenes::make_soup(leaves), options);
    if (how.thorough) {
      if (const std::string wrong = cnrg::validate(*complex); !wrong.empty()) throw std::runtime_error(wrong);
    }
    return complex;
  }

  static bool has(const cnrg::Group& g, const cnrg::Location& at) {
    switch (at.dimension) {
      case 0: return g.has(at.vertex);
      case 1: return g.has(at.edge);
      case 2: return g.has(at.face);
      default: return false;
    }
  }
  cnrg::RegionId region_at(const cnrg::Location& at) const {
    switch (at.dimension) {
      case 0: return complex_.some_region(at.vertex);
      case 1: return complex_.some_region(at.edge);
      case 2: return complex_.some_region(at.face);
      default: return at.region;
    }
  }

  std::string check_places(const cnrg::SimplifiedComplex& s, const cnrg::Selection& selection) const {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const cnrg::Location& at = places_[i];
      const cnrg::Component want = cnrg::properties::component_at(selection, at);
      const auto place = s.place(complex_, at);
      const cnrg::Component have =
          place.index == cnrg::SimplifiedComplex::kNowhere ? 0 : cnrg::component_of(s, place);
      if (want != have) return cell_name(grid_, cells_[i]) + " changed its component";
    }
    // Loops are closed walks; each side of a face is in one shell of the region that it names.
    std::size_t sides = 0;
    for (const auto& face : s.faces) {
      for (std::uint32_t r : face.regions) sides += r != cnrg::SimplifiedComplex::kNowhere;
      for (const auto& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          if (complex_.target(loop[i]) != complex_.origin(loop[(i + 1) % loop.size()])) return "an open loop";
        }
      }
    }
    for (std::size_t r = 0; r < s.regions.size(); ++r) {
      for (const auto& shell : s.regions[r].shells) {
        sides -= shell.size();
        for (std::uint32_t code : shell) {
          if (s.faces[code / 2].regions[code & 1] != r) return "a shell in the wrong region";
        }
      }
    }
    return sides == 0 ? "" : "sides of faces are missing from shells";
  }

  const Grid& grid_;
  const std::shared_ptr<const cnrg::Complex> built_;
  const cnrg::Complex& complex_ = *built_;
  cnrg::Locator locator_;
  std::vector<cnrg::Group> leaves_;
  std::vector<Cell> cells_;
  std::vector<cnrg::Location> places_;
};

std::string compare_operations(const Grid& grid, const Kernel& kernel, const Group& a, const Group& b,
                               bool thorough) {
  const auto &ka = kernel.leaf(0), &kb = kernel.leaf(1);
  const cnrg::BooleanOp ops[] = {cnrg::BooleanOp::unite, cnrg::BooleanOp::intersect, cnrg::BooleanOp::subtract};
  for (int op = 0; op < 3; ++op) {
    for (const auto dominance : {cnrg::Dominance::left, cnrg::Dominance::right, cnrg::Dominance::equal}) {
      const bool swapped = dominance == cnrg::Dominance::right && op != 2;
      const Group want = boolean_operation(grid, static_cast<Op>(op), dominance != cnrg::Dominance::equal,
                                           swapped ? b : a, swapped ? a : b);
      const auto have = cnrg::boolean_operation(kernel.complex(), ops[op], dominance, ka, kb);
      std::string wrong = kernel.compare(want, have.group);
      if (wrong.empty() && thorough) wrong = cnrg::check_boolean(kernel.complex(), ops[op], ka, kb, have.group);
      if (wrong.empty() && thorough && dominance == cnrg::Dominance::equal) {
        wrong = kernel.compare_simplified(want, have.group, false);
        if (wrong.empty()) wrong = kernel.compare_simplified(want, have.group, true);
      }
      if (!wrong.empty()) {
        const char* names[] = {"left", "right", "equal"};
        return std::string(cnrg::name(ops[op])) + ", dominance " + names[static_cast<int>(dominance)] + ": " +
               wrong;
      }
    }
  }
  return "";
}

std::string compare_one(const Grid& grid, const Kernel& kernel, const Group& g, std::size_t leaf) {
  const cnrg::Group& mine = kernel.leaf(leaf);
  std::string wrong = kernel.compare(g, mine);
  if (wrong.empty()) wrong = cnrg::check_group(kernel.complex(), mine);
  if (!wrong.empty()) return "as a leaf: " + wrong;
  const cnrg::Group regular = cnrg::regularize(kernel.complex(), mine);
  wrong = kernel.compare(regularize(grid, g), regular);
  if (wrong.empty()) wrong = cnrg::check_group(kernel.complex(), regular);
  if (!wrong.empty()) return "regularized: " + wrong;
  const cnrg::Group rest = cnrg::complement(kernel.complex(), mine);
  wrong = kernel.compare(complement(grid, g), rest);
  if (wrong.empty()) wrong = cnrg::check_complement(kernel.complex(), mine, rest);
  return wrong.empty() ? "" : "complement: " + wrong;
}

}  // namespace

std::string compare_pair(const Grid& grid, const Group& a, const Group& b, const Presentation& how) {
  try {
    const Kernel kernel(grid, a, b, how);
    std::string wrong = compare_one(grid, kernel, a, 0);
    if (!wrong.empty()) return "a " + wrong;
    wrong = compare_one(grid, kernel, b, 1);
    if (!wrong.empty()) return "b " + wrong;
    if (how.thorough) {
      for (int i : {0, 1}) {
        const auto &x = kernel.leaf(i), &y = kernel.leaf(1 - i);
        if (cnrg::classify_by_location(kernel.complex(), x, y) !=
            cnrg::classify_by_propagation(kernel.complex(), x, y)) {
          return "the paper's classification and propagation differ";
        }
      }
    }
    Group cut_a = a, cut_b = b;
    if (how.large_a) mark_cuts(grid, cut_a);
    if (how.large_b) mark_cuts(grid, cut_b);
    return compare_operations(grid, kernel, cut_a, cut_b, how.thorough);
  } catch (const std::exception& error) {
    return std::string("an exception: ") + error.what();
  }
}

Pair random_pair(const Grid& grid, std::uint64_t seed, double loose) {
  std::mt19937_64 random(seed);
  Pair pair;
  pair.a = random_group(grid, random, random() % 2 == 0, loose);
  pair.b = random_group(grid, random, random() % 2 == 0, loose);
  pair.presentation.large_a = random() % 2 == 0;
  pair.presentation.large_b = random() % 2 == 0;
  return pair;
}

std::vector<Group> smaller(const Grid& grid, const Group& group) {
  std::vector<Group> out;
  for (Cell c = 0; c < grid.cells(); ++c) {
    Group next = group;
    if (grid.dimension(c) == 3) {
      if (!group.inside[c]) continue;
      next.inside[c] = 0;
    } else {
      const auto& up = grid.around(c);
      const auto bounded_by_it = [&](Cell d) { return grid.dimension(c) < 2 && group.entity[d]; };
      if (!group.entity[c] || std::any_of(up.begin(), up.end(), bounded_by_it)) continue;
      next.entity[c] = 0;
    }
    complete(grid, next);
    if (next != group) out.push_back(std::move(next));
  }
  return out;
}

std::string tree_file(const Grid& grid, const Pair& pair) {
  std::string out = "cnrg: 1\nnodes:\n";
  const auto add = [&](const char* name, const Group& g, bool large) {
    cnrg::scenes::Leaf leaf = leaf_of(grid, g, large);
    if (pair.presentation.place) place(*pair.presentation.place, leaf);
    out += std::string("  ") + name + ":\n    group:\n" + cnrg::scenes::group_text(leaf);
  };
  add("a", pair.a, pair.presentation.large_a);
  add("b", pair.b, pair.presentation.large_b);
  std::string all;
  for (const char* op : {"union", "intersection"})
    for (const char* dominance : {"left", "right", "equal"}) {
      const std::string name = std::string(op) + "_" + dominance;
      out += "  " + name + ": {" + op + ": [a, b], dominance: " + dominance + "}\n";
      all += name + ", ";
    }
  return out + "  difference: {difference: [a, b]}\n  all: {sum: [" + all + "difference]}\nresult: all\n";
}

cnrg::scenes::Leaf leaf_of(const Grid& grid, const Group& g, bool large) {
  const auto point = [](const std::array<int, 3>& p) { return RationalPoint{p[0], p[1], p[2]}; };
  cnrg::scenes::Leaf leaf;
  for (const Rectangle& r : rectangles(grid, g, large)) {
    const int u = (r.axis + 1) % 3, v = (r.axis + 2) % 3;
    auto a = r.low, b = a, c = a, d = a;
    b[u] += r.extent[u], c[u] += r.extent[u], c[v] += r.extent[v], d[v] += r.extent[v];
    leaf.faces.push_back({{{point(a), point(b), point(c), point(d)}},
                          static_cast<std::uint32_t>(r.front),
                          static_cast<std::uint32_t>(r.back),
                          r.front == 0 && r.back == 0});
  }
  for (const Segment& s : wires(grid, g, large)) {
    auto end = s.low;
    end[s.axis] += s.length;
    leaf.wires.push_back({point(s.low), point(end)});
  }
  for (const auto& p : points(grid, g)) leaf.points.push_back(point(p));
  return leaf;
}

Group group_of(const Grid& grid, const cnrg::scenes::Leaf& leaf) {
  Group g;
  g.inside.assign(grid.cells(), 0);
  g.entity.assign(grid.cells(), 0);
  const auto twice = [](const RationalPoint& p) {
    std::array<int, 3> out;
    for (int k = 0; k < 3; ++k) out[k] = 2 * static_cast<int>(p[k].get_num().get_si());
    return out;
  };
  // All cells in a box of the grid.
  const auto for_each = [&](const std::vector<RationalPoint>& corners, auto visit) {
    std::array<int, 3> low = twice(corners[0]), high = low;
    for (const RationalPoint& p : corners) {
      const std::array<int, 3> q = twice(p);
      for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], q[k]), high[k] = std::max(high[k], q[k]);
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) visit(grid.at(x, y, z));
  };
  for (const auto& face : leaf.faces) {
    for_each(face.loops[0], [&](Cell c) {
      g.entity[c] = 1;
      if (grid.dimension(c) != 2) return;
      const auto& side = grid.around(c);  // negative side first
      if (face.back != 0) g.inside[side[0]] = 1;
      if (face.front != 0) g.inside[side[1]] = 1;
    });
  }
  for (const auto& wire : leaf.wires) for_each({wire[0], wire[1]}, [&](Cell c) { g.entity[c] = 1; });
  for (const auto& p : leaf.points) g.entity[grid.at(twice(p)[0], twice(p)[1], twice(p)[2])] = 1;
  // Inside goes on across all faces that are no entities.
  std::vector<Cell> stack;
  for (Cell c = 0; c < grid.cells(); ++c)
    if (g.inside[c]) stack.push_back(c);
  while (!stack.empty()) {
    const Cell c = stack.back();
    stack.pop_back();
    for (Cell f : grid.boundary(c)) {
      if (g.entity[f]) continue;
      for (Cell d : grid.around(f)) {
        if (g.inside[d]) continue;
        g.inside[d] = 1;
        stack.push_back(d);
      }
    }
  }
  complete(grid, g);
  return g;
}

void place(const cnrg::scenes::Motion& motion, cnrg::scenes::Leaf& leaf) {
  cnrg::scenes::apply(motion, leaf);
  if (motion.determinant() > 0) return;
  for (auto& face : leaf.faces)
    for (auto& loop : face.loops) std::reverse(loop.begin(), loop.end());
}

}  // namespace cubical
