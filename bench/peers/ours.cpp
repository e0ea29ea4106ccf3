#include <chrono>
#include <sstream>

#include "bench/peers/peer.h"
#include "csg/operators/boolean.h"
#include "csg/operators/leaf_group.h"
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

/// Exact: the divergence theorem over the half-faces of the regions of the result.
Rational volume(const Complex& c, const Group& group) {
  std::vector<Rational> parts;
  for (const auto& [cell, region] : group.cells) {
    for (const HalfFace h : c.region_faces[cell]) {
      const RationalPoint base = c.points.rational(c.origin(c.loop[c.face_loops[h.face()][0]][0]));
      Rational part = 0;
      for (const LoopId l : c.face_loops[h.face()])
        for (const HalfEdge e : c.loop[l]) {
          const RationalPoint p = c.points.rational(c.origin(e)), q = c.points.rational(c.target(e));
          for (int k = 0; k < 3; ++k)
            part += base[k] * (p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3]);
        }
      parts.push_back(h.side() == 0 ? Rational(-part) : part);
    }
  }
  return sum(std::move(parts)) / 6;
}

Outcome unite(const TriangleMesh& a, const TriangleMesh& b, int threads) {
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
  const SimplifiedComplex simplified = simplify(complex, selection_of(complex, result.group), result.group.features);
  outcome.stages.emplace_back("simplify", watch.lap());
  outcome.vertices = simplified.vertices.size();
  outcome.faces = simplified.faces.size();
  outcome.volume = to_double(volume(complex, result.group));
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

Outcome unite_ours(const TriangleMesh& a, const TriangleMesh& b) { return unite(a, b, 0); }
Outcome unite_ours_one_thread(const TriangleMesh& a, const TriangleMesh& b) { return unite(a, b, 1); }

}  // namespace cnrg::bench
