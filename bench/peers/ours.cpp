#include <chrono>
#include <sstream>

#include "bench/peers/peer.h"
#include "csg/operators/boolean.h"
#include "csg/operators/leaf_group.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

void add_leaf(Soup& soup, const TriangleMesh& mesh) {
  const LeafId leaf = soup.add_leaf(Fill::winding);
  std::vector<PointId> ids;
  ids.reserve(mesh.points.size());
  for (const auto& p : mesh.points) ids.push_back(soup.add_point(p[0], p[1], p[2]));
  std::uint32_t number = 0;
  for (const auto& t : mesh.triangles) {
    soup.add_triangle(leaf, ids[t[0]], ids[t[1]], ids[t[2]], number, number);
    ++number;
  }
}

std::vector<RegionId> cells(const Group& group) {
  std::vector<RegionId> result;
  for (const auto& [cell, region] : group.cells) result.push_back(cell);
  return result;
}

Outcome unite(const TriangleMesh& a, const TriangleMesh& b, int threads, bool check) {
  Soup soup;
  add_leaf(soup, a);
  add_leaf(soup, b);
  Outcome outcome;
  RefineReport report;
  Stopwatch watch;
  const Complex complex = build_complex(soup, {.threads = threads}, &report);
  outcome.stages.emplace_back("complex", watch.lap());
  const std::vector<Group> groups = leaf_groups(complex);
  outcome.stages.emplace_back("leaves", watch.lap());
  const BooleanResult result = apply(complex, BooleanOp::unite, Dominance::equal, groups[0], groups[1]);
  outcome.stages.emplace_back("union", watch.lap());
  const SimplifiedComplex simplified =
      simplify(complex, selection_of(complex, result.group), result.group.features);
  outcome.stages.emplace_back("simplify", watch.lap());
  outcome.vertices = simplified.vertices.size();
  outcome.faces = simplified.faces.size();
  if (!check) return outcome;
  outcome.volume = to_double(volume(complex, cells(result.group)).value());
  const std::string invalid = validate(complex);
  std::ostringstream note;
  note << "exact stage " << 100 * report.stages.exact_share() << " %, constructed " << report.constructed
       << (invalid.empty() ? ", valid" : ", INVALID: " + invalid);
  outcome.note = note.str();
  return outcome;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Stopwatch::Stopwatch() : last_(now()) {}

double Stopwatch::lap() {
  const double before = last_;
  last_ = now();
  return last_ - before;
}

double Outcome::seconds() const {
  double all = 0;
  for (const auto& [stage, time] : stages) all += time;
  return all;
}

Outcome unite_ours(const TriangleMesh& a, const TriangleMesh& b, bool check) { return unite(a, b, 0, check); }
Outcome unite_ours_one_thread(const TriangleMesh& a, const TriangleMesh& b, bool check) {
  return unite(a, b, 1, check);
}

}  // namespace cnrg::bench
