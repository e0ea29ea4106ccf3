// CGAL's Nef polyhedra: exact, of mixed dimension. Built without CGAL's assertions for times, and with them, so
// that what goes wrong is said (bench/asserted.cpp).
//
// Differences are closed after each step: cl(A - B), as everywhere in this project.
#include <CGAL/IO/Nef_polyhedron_iostream_3.h>
#include <CGAL/Nef_nary_union_3.h>
#include <CGAL/version.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <unordered_map>

#include "bench/cases/face_loops.h"
#include "bench/peers/built_in.h"
#include "bench/peers/cgal_mesh.h"
#include "bench/peers/nef_algebra.h"
#include "bench/peers/nef_file.h"
#include "bench/peers/nef_parts.h"

namespace cnrg::bench {
namespace {

using nef::Kernel;
using nef::Parts;
using Nef = nef::Set;

RationalPoint point_of(const Kernel::Point_3& p) {
  const auto number = [](const Kernel::FT& x) { return rational_of(CGAL::exact(x)); };
  return {number(p.x()), number(p.y()), number(p.z())};
}

// --- operations

/// Of bounded sets.
Nef united_nef(const std::vector<Nef>& sets) {
  if (sets.empty()) return Nef(Nef::EMPTY);
  if (sets.size() == 1) return sets[0];
  if (sets.size() == 2) return nef::united(sets[0], sets[1]);
  CGAL::Nef_nary_union_3<Nef> all;
  for (const Nef& set : sets) all.add_polyhedron(set);
  return nef::with_unbounded(all.get_union(), false);
}

Nef set_of(const Parts& parts) {
  std::vector<Nef> sets;
  for (const auto& [mesh, cavity] : parts.shells) {
    if (cavity) sets = {nef::closed_difference(united_nef(sets), Nef(mesh))};
    else sets.emplace_back(mesh);
  }
  for (const auto& sheet : parts.sheets) sets.emplace_back(sheet.begin(), sheet.end());
  for (const auto& [a, b] : parts.wires) sets.emplace_back(Nef::Segment_3(a, b));
  for (const Kernel::Point_3& p : parts.points) sets.emplace_back(p);
  return united_nef(sets);
}

Nef folded_nef(const Problem& problem, const std::vector<Nef>& operands) {
  Nef value = operands[0];
  for (std::size_t i = 0; i < problem.steps.size();) {
    if (problem.steps[i] == Operation::unite) {
      std::vector<Nef> run{value};
      for (; i < problem.steps.size() && problem.steps[i] == Operation::unite; ++i) run.push_back(operands[i + 1]);
      value = united_nef(run);
      continue;
    }
    const Nef& right = operands[i + 1];
    value = problem.steps[i] == Operation::intersect ? nef::common(value, right)
                                                     : nef::closed_difference(value, right);
    ++i;
  }
  return value;
}

// --- results

class NefModelMaker {
 public:
  explicit NefModelMaker(const Nef& nef) : nef_(nef) {}

  Model run() {
    for (auto f = nef_.halffacets_begin(); f != nef_.halffacets_end(); ++f) add_facet(f);
    for (auto e = nef_.halfedges_begin(); e != nef_.halfedges_end(); ++e) add_edge(e);
    for (auto v = nef_.vertices_begin(); v != nef_.vertices_end(); ++v) add_vertex(v);
    return std::move(model_);
  }

 private:
  std::uint32_t number(Nef::Vertex_const_handle v) {
    const auto [it, is_new] = numbers_.emplace(&*v, static_cast<std::uint32_t>(model_.points.size()));
    if (is_new) model_.points.push_back(point_of(v->point()));
    return it->second;
  }

  /// The half-facet that looks out of a solid, or one of the two of a surface: its plane's normal points into the
  /// volume that it bounds.
  void add_facet(Nef::Halffacet_const_handle f) {
    if (f->incident_volume()->mark()) return;
    const bool solid = f->twin()->incident_volume()->mark();
    const RationalPoint normal = point_of(CGAL::ORIGIN + f->plane().orthogonal_vector());
    if (!solid && (!f->mark() || normal < RationalPoint{0, 0, 0})) return;
    std::vector<PointLoop> walks;
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;
      PointLoop& walk = walks.emplace_back();
      Nef::SHalfedge_around_facet_const_circulator at(cycle), end(at);
      CGAL_For_all(at, end) walk.push_back(number(at->source()->source()));
    }
    std::vector<PointLoop> loops = simple_loops(model_.points, walks);
    if (dot(doubled_area(model_.points, loops[0]), normal) < 0)
      for (PointLoop& loop : loops) std::reverse(loop.begin(), loop.end());
    model_.faces.push_back({std::move(loops), solid});
  }

  void add_edge(Nef::Halfedge_const_handle e) {
    const bool in_no_facet = e->out_sedge() == Nef::SHalfedge_const_handle();
    if (e->is_twin() || !in_no_facet || !e->mark() || e->incident_sface()->mark()) return;
    model_.wires.push_back({number(e->source()), number(e->twin()->source())});
  }

  void add_vertex(Nef::Vertex_const_handle v) {
    const bool by_itself = v->svertices_begin() == v->svertices_end() && !v->has_shalfloop();
    if (by_itself && v->mark() && !v->sfaces_begin()->mark()) model_.isolated.push_back(number(v));
  }

  const Nef& nef_;
  Model model_;
  std::unordered_map<const void*, std::uint32_t> numbers_;
};

/// Runs a stage; an assertion of CGAL that fails there is a refusal.
template <class Work>
auto guarded_nef(const char* stage, Work work) {
  try {
    return work();
  } catch (const CGAL::Failure_exception& error) {
    throw Refusal(stage, words_of(error));
  } catch (const nef::BrokenSet& error) {
    throw Refusal(stage, error.what());
  }
}

Answer answer_of_nef(const Problem& problem) {
  std::vector<Parts> parts;
  guarded_nef("input", [&] {
    for (const Model& operand : problem.operands) parts.push_back(nef::parts_of(operand));
  });
  Measurement measurement;
  std::vector<Nef> operands;
  guarded_nef("conversion", [&] {
    for (const Parts& of_operand : parts) operands.push_back(set_of(of_operand));
  });
  measurement.lap("conversion");
  const Nef result = guarded_nef("Boolean", [&] { return folded_nef(problem, operands); });
  measurement.lap("Boolean");
  Answer answer;
  answer.measures = measurement.stop();
  answer.model = guarded_nef("output", [&] { return NefModelMaker(result).run(); });
  return answer;
}

// --- values of nodes

Nef marked_nef(const MarkedSet& set) {
  Nef all(Nef::EMPTY);
  for (std::size_t i = set.layers.size(); i-- > 0;)
    all = nef::without(set_of(nef::parts_of_result(set.layers[i])), all);
  return set.complement ? all.complement() : all;
}

using UnaryNef = Nef (*)(const Nef&);
using BinaryNef = Nef (*)(const Nef&, const Nef&);

const std::map<std::string, UnaryNef> kUnaryNef{
    {"interior", [](const Nef& a) { return nef::settled(a.interior()); }},
    {"closure", [](const Nef& a) { return nef::settled(a.closure()); }},
    {"boundary", [](const Nef& a) { return nef::settled(a.boundary()); }},
    {"regularization", [](const Nef& a) { return nef::settled(a.regularization()); }},
    {"complement", [](const Nef& a) { return a.complement(); }}};

const std::map<std::string, BinaryNef> kBinaryNef{{"union", nef::united},
                                                  {"intersection", nef::common},
                                                  {"difference", nef::closed_difference},
                                                  {"without", nef::without}};

/// An expression in postfix (SetProblem). Throws std::runtime_error for what is none.
Nef value_of_words(const std::vector<std::string>& words, const std::vector<Nef>& operands) {
  std::vector<Nef> stack;
  const auto take = [&] {
    if (stack.empty()) throw std::runtime_error("an operation lacks an operand");
    Nef top = std::move(stack.back());
    stack.pop_back();
    return top;
  };
  for (const std::string& word : words) {
    const auto unary = kUnaryNef.find(word);
    const auto binary = kBinaryNef.find(word);
    if (unary != kUnaryNef.end()) {
      stack.push_back(unary->second(take()));
    } else if (binary != kBinaryNef.end()) {
      const Nef right = take(), left = take();
      stack.push_back(binary->second(left, right));
    } else {
      stack.push_back(operands.at(std::stoul(word)));
    }
  }
  Nef value = take();
  if (!stack.empty()) throw std::runtime_error("an operand is left over");
  return value;
}

/// What one has and the other has not, by its vertices.
std::string excess_text(const Nef& of, const Nef& other, const char* what) {
  const Nef excess = nef::without(of, other);
  if (excess.is_empty()) return {};
  std::string text = std::string(what) + ": " + std::to_string(excess.number_of_vertices()) + " vertices, " +
                     std::to_string(excess.number_of_edges()) + " edges, " +
                     std::to_string(excess.number_of_facets()) + " facets, " +
                     std::to_string(excess.number_of_volumes() - 1) + " volumes";
  if (excess.number_of_vertices() == 0) return text;
  const RationalPoint p = point_of(excess.vertices_begin()->point());
  return text + ", one of them at " + cnrg::to_string(p[0]) + ", " + cnrg::to_string(p[1]) + ", " +
         cnrg::to_string(p[2]);
}

SetComparison compared_by_nef(const SetProblem& problem) {
  Measurement measurement;
  std::vector<Nef> operands;
  guarded_nef("conversion", [&] {
    for (const MarkedSet& operand : problem.operands) operands.push_back(marked_nef(operand));
  });
  measurement.lap("conversion");
  const Nef theirs = guarded_nef("operators", [&] { return value_of_words(problem.words, operands); });
  measurement.lap("operators");
  SetComparison found;
  guarded_nef("comparison", [&] {
    const Nef ours = marked_nef(problem.value);
    if (nef::are_equal(ours, theirs)) return;
    const std::string more = excess_text(ours, theirs, "too much"), less = excess_text(theirs, ours, "missing");
    found.difference = more + (more.empty() || less.empty() ? "" : "; ") + less;
    if (found.difference.empty())
      throw Refusal("comparison", "two sets are not equal, and neither lacks anything");
  });
  found.measures = measurement.stop();
  return found;
}

bool agrees_with_nef(const Problem& problem, const Model& result) {
  return guarded_nef("comparison", [&] {
    std::vector<Nef> operands;
    for (const Model& operand : problem.operands) operands.push_back(set_of(nef::parts_of(operand)));
    const Nef apart = folded_nef(problem, operands) ^ set_of(nef::parts_of_result(result));
    return apart.is_empty();
  });
}

}  // namespace

Model read_nef(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  Nef nef;
  guarded_nef("output", [&] { in >> nef; });
  if (!in) throw std::runtime_error("is no text of a Nef polyhedron: " + path);
  return guarded_nef("output", [&] { return NefModelMaker(nef).run(); });
}

System nef_system() {
  return {.name = "nef",
          .title = "CGAL Nef polyhedra",
          .guarantee = "closed 2-manifolds, surfaces, wires and points; exact",
          .version = [] { return std::string("CGAL ") + CGAL_VERSION_STR; },
          .rounding = 0,
          .regularized = false,
          .absent = "",
          .evaluate = answer_of_nef,
          .agrees = agrees_with_nef,
          .compare_sets = compared_by_nef,
          .asserted = true};
}

}  // namespace cnrg::bench
