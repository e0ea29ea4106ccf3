#include "tests/baseline/oracle.h"

#include <ostream>
#include <set>

#include "bench/baseline/mantyla.h"
#include "bench/baseline/topology.h"
#include "bench/cases/soup_of.h"
#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "kernel/refine/refine.h"
#include "kernel/refine/soup.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench::baseline_test {
namespace {

std::set<RegionId> inside(const Group& group) {
  std::set<RegionId> cells;
  for (const auto& [cell, region] : group.cells) cells.insert(cell);
  return cells;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << "v " << c.vertices << " e " << c.edges << " f " << c.faces << " r " << c.rings << " s " << c.shells
             << " g " << c.genus;
}

Counts counts_of(const Model& model) {
  mantyla::Topology topology;
  std::vector<std::vector<std::vector<std::uint32_t>>> faces;
  for (const Model::Face& face : model.faces) faces.push_back(face.loops);
  topology.assemble(faces, model.points.size(), 0, 0);
  const mantyla::EulerCounts counts = topology.validate();
  return {counts.vertices, counts.edges, counts.faces, counts.rings, counts.shells, counts.genus};
}

Rational volume_of(const Model& model) {
  Rational sum = 0;
  for (const Model::Face& face : model.faces)
    for (const auto& loop : face.loops)
      for (std::size_t k = 2; k < loop.size(); ++k) {
        const RationalPoint &p = model.points[loop[0]], &q = model.points[loop[k - 1]], &r = model.points[loop[k]];
        sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]);
      }
  return sum / 6;
}

std::size_t duplicates_of(const Model& model) {
  const std::set<RationalPoint> places(model.points.begin(), model.points.end());
  return model.points.size() - places.size();
}

Truth truth_of(const Model& a, const Model& b, Operation operation, const Model& answer) {
  Soup soup;
  for (const Model* model : {&a, &b, &answer}) add_model(soup, *model);
  const auto built_complex = build_complex(soup, {.threads = 1}, nullptr);
  const Complex& complex = *built_complex;
  const std::vector<Group> groups = leaf_groups(complex);
  const BooleanOp op = operation == Operation::unite       ? BooleanOp::unite
                       : operation == Operation::intersect ? BooleanOp::intersect
                                                           : BooleanOp::subtract;
  const Group result =
      regularize(complex, boolean_operation(complex, op, Dominance::equal, groups[0], groups[1]).group);
  Truth truth;
  truth.same_set = inside(result) == inside(groups[2]);
  // One region, whatever the walls: the canonical form of the point set.
  Group whole = result;
  for (auto& [cell, region] : whole.cells) region = 1;
  if (!whole.cells.empty()) whole.regions.resize(1);
  whole.dominance = 0;
  whole = regularize(complex, whole);
  Selection selection = selection_of(complex, whole);
  std::vector<RegionId> cells;
  for (const auto& [cell, region] : whole.cells) cells.push_back(cell);
  truth.volume = cells.empty() ? Rational(0) : volume(complex, cells).value();
  const SimplifiedComplex simplified = simplify(complex, selection, {}, SimplifyMode::points);
  const auto counts = active_counts(simplified);
  truth.vertices = counts[0];
  truth.edges = counts[1];
  truth.faces = counts[2];
  long rings = 0, shells = 0;
  for (const auto& face : simplified.faces) rings += static_cast<long>(face.loops.size()) - 1;
  for (const auto& region : simplified.regions)
    if (region.component != 0) shells += static_cast<long>(region.shells.size());
  truth.genus = shells - (static_cast<long>(counts[0] + counts[2]) - static_cast<long>(counts[1]) - rings) / 2;
  return truth;
}

std::string outcome(const Model& a, const Model& b, Operation operation, const mantyla::Departures& departures) {
  Model answer;
  try {
    answer = mantyla::boolean_exact(a, b, operation, departures);
  } catch (const mantyla::Failure& failure) {
    return to_string(failure.stage());
  }
  try {
    return truth_of(a, b, operation, answer).same_set ? "same" : "wrong";
  } catch (const std::exception&) {
    return "wrong";  // its faces bound no solid
  }
}

}  // namespace cnrg::bench::baseline_test
