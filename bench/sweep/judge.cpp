#include "bench/sweep/judge.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/cases/soup_of.h"
#include "bench/cases/value_model.h"
#include "bench/sweep/facts.h"
#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "kernel/base/error.h"
#include "kernel/base/union_find.h"
#include "kernel/selection/manifold.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

using Leaves = std::vector<std::vector<LeafId>>;

BooleanOp table_op(Operation operation) {
  switch (operation) {
    case Operation::unite: return BooleanOp::unite;
    case Operation::intersect: return BooleanOp::intersect;
    case Operation::subtract: break;
  }
  return BooleanOp::subtract;
}

Group united(const Complex& complex, const std::vector<Group>& groups, const std::vector<LeafId>& leaves) {
  Group all = groups[leaves[0].index()];
  for (std::size_t i = 1; i < leaves.size(); ++i)
    all = boolean_operation(complex, BooleanOp::unite, Dominance::equal, all, groups[leaves[i].index()]).group;
  return all;
}

CellSet set_of_group(const Complex& complex, const Group& group) { return support(selection_of(complex, group)); }

/// The exact result by the tables.
CellSet exact_set(const Complex& complex, const std::vector<Group>& groups, const Problem& problem,
                  const Leaves& operands) {
  Group value = united(complex, groups, operands[0]);
  for (std::size_t i = 0; i < problem.steps.size(); ++i)
    value = boolean_operation(complex, table_op(problem.steps[i]), Dominance::equal, value,
                              united(complex, groups, operands[i + 1]))
                .group;
  return set_of_group(complex, value);
}

/// Vertices that are used and lie where another used one lies.
std::size_t duplicates_of(const Model& model) {
  std::vector<char> used(model.points.size());
  for (const Model::Face& face : model.faces)
    for (const auto& loop : face.loops)
      for (const std::uint32_t p : loop) used[p] = 1;
  for (const auto& [a, b] : model.wires) used[a] = used[b] = 1;
  for (const std::uint32_t p : model.isolated) used[p] = 1;
  std::vector<const RationalPoint*> points;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) points.push_back(&model.points[i]);
  std::sort(points.begin(), points.end(), [](const auto* a, const auto* b) { return *a < *b; });
  const auto end =
      std::unique(points.begin(), points.end(), [](const auto* a, const auto* b) { return *a == *b; });
  return static_cast<std::size_t>(points.end() - end);
}

/// Shells and genus of the boundary as the system's own vertices and faces say it; nothing when these are no
/// closed 2-manifold.
std::optional<BoundarySurface> own_surface(const Model& model) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> face_left_of;  // by directed edge
  UnionFind faces(model.faces.size()), places(model.points.size());
  long euler = 0;
  std::vector<char> used(model.points.size());
  for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
    if (!model.faces[f].solid) continue;
    euler += 2;
    for (const auto& loop : model.faces[f].loops) {
      --euler;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::array edge{loop[i], loop[(i + 1) % loop.size()]};
        if (!face_left_of.emplace(edge, f).second) return {};
        used[loop[i]] = 1;
      }
    }
  }
  std::vector<std::uint32_t> fan(model.points.size());  // edges that leave each vertex
  for (const auto& [edge, f] : face_left_of) {
    const auto other = face_left_of.find({edge[1], edge[0]});
    if (other == face_left_of.end()) return {};
    if (edge[0] < edge[1]) --euler;
    faces.unite(f, other->second);
    ++fan[edge[0]];
  }
  // A vertex is one only if its faces go around it once.
  std::map<std::array<std::uint32_t, 2>, std::uint32_t>
      before;  // of each directed edge, where the loop comes from
  for (const Model::Face& face : model.faces) {
    if (!face.solid) continue;
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        before[{loop[i], loop[(i + 1) % loop.size()]}] = loop[(i + loop.size() - 1) % loop.size()];
  }
  std::vector<char> done(model.points.size());
  for (const auto& [edge, f] : face_left_of) {
    const std::uint32_t v = edge[0];
    if (done[v]) continue;
    done[v] = 1;
    std::uint32_t to = edge[1], steps = 0;
    do {
      to = before.at({v, to});
      ++steps;
    } while (to != edge[1] && steps <= fan[v]);
    if (steps != fan[v]) return {};
  }
  BoundarySurface surface;
  for (std::uint32_t f = 0; f < model.faces.size(); ++f)
    if (model.faces[f].solid && faces.find(f) == f) ++surface.shells;
  for (const char u : used) euler += u;
  surface.genus = static_cast<long>(surface.shells) - euler / 2;
  return surface;
}

double extent_of(const Problem& problem) {
  Rational largest = 0;
  for (const Model& operand : problem.operands)
    for (const RationalPoint& p : operand.points)
      for (const Rational& x : p) largest = std::max<Rational>(largest, abs(x));
  return to_double(largest);
}

/// Everything that a judgement compares.
struct Comparison {
  const Complex& complex;
  CellSet exact, found;
  std::vector<LeafId> result;  ///< the leaves of `found`
  double rounding = 0, extent = 0;
  bool solids = true;  ///< all operands are

  bool of_result(SegmentId s) const {
    for (const SourceId f : complex.segment_faces[s])
      if (std::find(result.begin(), result.end(), complex.sources[f].leaf) != result.end()) return true;
    return false;
  }

  std::vector<FaceId> boundary(const CellSet& set) const {
    const auto in = [&](RegionId r) { return std::binary_search(set.regions.begin(), set.regions.end(), r); };
    std::vector<FaceId> faces;
    for (const FaceId f : set.faces)
      if (in(complex.face_regions[f][0]) != in(complex.face_regions[f][1])) faces.push_back(f);
    return faces;
  }
};

std::string cells_of(const CellSet& set) {
  const std::size_t counts[] = {set.regions.size(), set.faces.size(), set.edges.size(), set.vertices.size()};
  const char* const names[] = {"regions", "faces", "edges", "vertices"};
  std::string text;
  for (int i = 0; i < 4; ++i)
    if (counts[i] != 0) text += (text.empty() ? "" : ", ") + std::to_string(counts[i]) + " " + names[i];
  return text;
}

/// What lacks, when it bounds no solid: the fault of the operation or of the system.
Verdict without_dangling(const Comparison& c) {
  return c.solids ? Verdict::same_regularized : Verdict::dangling_lost;
}

/// At a non-manifold edge two edges of the result overlap, or at such a vertex one goes through it: cells that lie
/// at one place without being one, though none of their ends coincide.
bool overlaps_at_contact(const Comparison& c) {
  Neighbourhoods neighbourhoods(c.complex);
  const Manifoldness shapes = manifoldness(c.complex, c.found, neighbourhoods);
  const auto segments_of = [&](EdgeId e) {
    std::vector<SegmentId> segments;
    for (const SegmentId s : c.complex.edge_segments[e])
      if (c.of_result(s)) segments.push_back(s);
    return segments;
  };
  for (const auto& [e, shape] : shapes.edges)
    if (shape.form == LocalForm::non_manifold && segments_of(e).size() > 1) return true;
  // Along such an edge the refinement has vertices that are no contact of their own.
  const SimplifiedComplex simplified = simplify(c.complex, as_one(c.found), {}, SimplifyMode::points);
  for (const auto& [v, shape] : shapes.vertices) {
    if (shape.form != LocalForm::non_manifold || simplified.vertex_place[v.index()].dimension != 0) continue;
    std::vector<SegmentId> through;
    for (const EdgeId e : c.complex.vertex_edges[v])
      for (const SegmentId s : segments_of(e)) through.push_back(s);
    std::sort(through.begin(), through.end());
    if (std::adjacent_find(through.begin(), through.end()) != through.end()) return true;
  }
  return false;
}

Verdict same_with(const Comparison& c, const Judgement& j) {
  const bool contact = j.truth.non_manifold_edges + j.truth.non_manifold_vertices > 0;
  if (!contact) return Verdict::same;
  return j.duplicates > 0 || overlaps_at_contact(c) ? Verdict::contact_duplicated : Verdict::same;
}

void reject(Judgement& j, const char* stage, std::string message) {
  j.verdict = Verdict::wrong;
  j.stage = stage;
  j.message = std::move(message);
}

void judge_exact(const Comparison& c, Judgement& j) {
  const CellSet excess = subtract(c.found, c.exact), missing = subtract(c.exact, c.found);
  if (!excess.empty())
    return reject(j, excess.regions.empty() ? "dangling" : "volume",
                  "too much: " + cells_of(excess) + " of the refinement");
  if (!missing.regions.empty()) return reject(j, "volume", "missing: " + cells_of(missing) + " of the refinement");
  j.verdict = missing.empty() ? same_with(c, j) : without_dangling(c);
}

struct Loose {
  double area = 0, length = 0;
  std::size_t points = 0;
};
Loose loose_of(const Comparison& c, const CellSet& set) {
  const CellSet all = dangling(c.complex, set);
  CellSet sheets, curves;
  sheets.faces = all.faces;
  const CellSet wires = subtract(all, closure(c.complex, sheets));
  curves.edges = wires.edges;
  return {area(c.complex, sheets.faces), length(c.complex, wires.edges),
          subtract(wires, closure(c.complex, curves)).vertices.size()};
}

/// Less than what the set has (-1), as much (0) or more (1), up to the rounding.
int compare_loose(const Comparison& c, const Loose& found, const Loose& exact) {
  const double step = 16 * c.rounding * c.extent;
  const auto sign = [](double difference, double allowed) {
    return difference > allowed ? 1 : difference < -allowed ? -1 : 0;
  };
  const int signs[] = {sign(found.area - exact.area, step * (c.extent + std::sqrt(exact.area))),
                       sign(found.length - exact.length, step + 16 * c.rounding * exact.length),
                       sign(static_cast<double>(found.points) - static_cast<double>(exact.points), 0)};
  if (std::count(signs, signs + 3, 1) > 0) return 1;
  return std::count(signs, signs + 3, -1) > 0 ? -1 : 0;
}

/// What reaches out of the box of the operands further than rounding explains may have no volume to speak of, such
/// as a spike.
bool reaches_too_far(const Comparison& c, const Problem& problem, const Model& result) {
  const double allowed = 8 * c.rounding * c.extent;
  for (int k = 0; k < 3; ++k) {
    std::optional<Rational> low, high;
    for (const Model& operand : problem.operands)
      for (const RationalPoint& p : operand.points) {
        if (!low || p[k] < *low) low = p[k];
        if (!high || p[k] > *high) high = p[k];
      }
    for (const RationalPoint& p : result.points)
      if (!low || to_double(*low - p[k]) > allowed || to_double(p[k] - *high) > allowed) return true;
  }
  return false;
}

/// A region that only one of the two has is thicker than moving the boundary makes it: twice its volume over its
/// area, which is a half to all of the depth of a notch, a ridge or a spike.
bool differs_in_depth(const Comparison& c) {
  const CellSet excess = subtract(c.found, c.exact), missing = subtract(c.exact, c.found);
  std::map<RegionId, double> areas;
  for (const CellSet* set : {&excess, &missing})
    for (const RegionId r : set->regions) areas[r] = 0;
  if (areas.empty()) return false;
  for (const FaceId f : IdRange<FaceId>(c.complex.face_count())) {
    const auto& [front, back] = c.complex.face_regions[f];
    const auto a = areas.find(front), b = areas.find(back);
    if (front == back || (a == areas.end() && b == areas.end())) continue;
    const double part = area(c.complex, {f});
    if (a != areas.end()) a->second += part;
    if (b != areas.end()) b->second += part;
  }
  const double allowed = 64 * c.rounding * c.extent;
  return std::any_of(areas.begin(), areas.end(), [&](const auto& region) {
    return 2 * to_double(volume(c.complex, {region.first}).value()) > allowed * region.second;
  });
}

std::string topology_text(const BoundarySurface& found, const BoundarySurface& expected) {
  return std::to_string(found.shells) + " shells of genus " + std::to_string(found.genus) + " instead of " +
         std::to_string(expected.shells) + " of " + std::to_string(expected.genus) +
         ": what differs is thinner than the rounding of the system";
}

void judge_rounded(const Comparison& c, const Problem& problem, const Model& result, double apart, double allowed,
                   Judgement& j) {
  if (!(apart <= allowed))
    return reject(j, "volume", "the volume of the symmetric difference is beyond what rounding explains");
  if (differs_in_depth(c))
    return reject(j, "volume", "a part of the symmetric difference is thicker than rounding explains");
  if (reaches_too_far(c, problem, result))
    return reject(j, "surface", "it reaches out of the box of the operands further than rounding explains");
  const auto same = [](const BoundarySurface& a, const BoundarySurface& b) {
    return a.shells == b.shells && a.genus == b.genus;
  };
  const BoundarySurface expected{j.truth.shells, j.truth.genus}, as_set{j.facts->shells, j.facts->genus};
  const BoundarySurface own = own_surface(result).value_or(as_set);
  if (!same(own, expected) && !same(as_set, expected)) {
    j.verdict = Verdict::within_rounding;
    j.message = topology_text(own, expected);
    return;
  }
  const int loose = compare_loose(c, loose_of(c, c.found), loose_of(c, c.exact));
  if (loose > 0) return reject(j, "dangling", "faces, wires or points that bound no solid are too many");
  if (loose < 0) {
    j.verdict = without_dangling(c);
    return;
  }
  const auto compare = [](std::size_t found, std::size_t exact) { return found < exact ? -1 : found > exact; };
  const int edges = compare(j.facts->non_manifold_edges, j.truth.non_manifold_edges),
            vertices = compare(j.facts->non_manifold_vertices, j.truth.non_manifold_vertices);
  if (edges == 0 && vertices == 0) {
    j.verdict = same_with(c, j);
    return;
  }
  j.verdict = Verdict::contact_lost;
  if (edges > 0 || vertices > 0) j.message = "it touches itself where the exact result does not";
}

Leaves add_operands(Soup& soup, const Problem& problem) {
  Leaves leaves;
  for (const Model& operand : problem.operands) leaves.push_back(add_model(soup, operand));
  return leaves;
}

}  // namespace

Facts exact_facts(const Problem& problem) {
  Soup soup;
  const Leaves operands = add_operands(soup, problem);
  const auto built_complex = build_complex(soup);
  const Complex& complex = *built_complex;
  return facts_of(complex, exact_set(complex, leaf_groups(complex), problem, operands));
}

Judgement judge(const Problem& problem, const Model& result, double rounding) {
  Judgement j;
  j.duplicates = duplicates_of(result);
  Soup soup;
  const Leaves operands = add_operands(soup, problem);
  const std::vector<LeafId> found = add_model(soup, result);
  std::shared_ptr<const Complex> built;
  try {
    built = build_complex(soup);
  } catch (const InputError& error) {
    j.truth = exact_facts(problem);  // throws if it is the operands
    reject(j, "surface", std::string("the result bounds no solid: ") + error.what());
    return j;
  }
  const Complex& complex = *built;
  const std::vector<Group> groups = leaf_groups(complex);
  Comparison c{
      complex,         exact_set(complex, groups, problem, operands), {}, found, rounding, extent_of(problem),
      problem.solids()};
  for (const LeafId leaf : found) c.found = unite(c.found, set_of_group(complex, groups[leaf.index()]));
  j.truth = facts_of(complex, c.exact);
  j.facts = facts_of(complex, c.found);

  const double whole = to_double(Rational(j.truth.volume));
  const auto part = [&](const CellSet& a, const CellSet& b) {
    return to_double(volume(complex, subtract(a, b).regions).value());
  };
  const double excess = part(c.found, c.exact), missing = part(c.exact, c.found);
  const double unit = whole > 0 ? whole : c.extent * c.extent * c.extent;
  j.excess = excess / unit;
  j.missing = missing / unit;
  // Moving the boundary by the rounding changes the volume by that much; where solids only touch, that of a
  // sliver.
  const double moved = std::max(area(complex, c.boundary(c.exact)), area(complex, c.boundary(c.found)));
  const double allowed = rounding == 0 ? 0 : 16 * rounding * c.extent * moved;
  const Rational around = signed_volume(result), inside = volume(complex, c.found.regions).value();
  if (!(to_double(abs(around - inside)) <= allowed)) {
    reject(j, "surface",
           "its faces do not go around the solid once, outwards: their volume is " + to_decimal(around) +
               ", that of the set " + to_decimal(inside));
  } else if (rounding == 0) {
    judge_exact(c, j);
  } else {
    judge_rounded(c, problem, result, excess + missing, allowed, j);
  }
  return j;
}

Judgement judge_by_volume(const Problem& problem, const Model& result, double rounding) {
  Judgement j;
  j.truth = exact_facts(problem);
  j.duplicates = duplicates_of(result);
  j.verdict = Verdict::unjudged;
  const Rational exact(j.truth.volume), difference = signed_volume(result) - exact;
  const double extent = extent_of(problem), unit = exact > 0 ? to_double(exact) : extent * extent * extent;
  // Far beyond what rounding makes of any surface in reach.
  if (std::fabs(to_double(difference)) <= std::max(1e-6, 1e6 * rounding) * extent * extent * extent) return j;
  reject(j, "volume", "the volume that its faces enclose is not that of the exact result");
  (difference > 0 ? j.excess : j.missing) = std::fabs(to_double(difference)) / unit;
  return j;
}

}  // namespace cnrg::bench
