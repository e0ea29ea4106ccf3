// The Boolean as the sequence of its stages (mantyla1988, program 15.1).
//
// Where it departs from the book; what each departure repairs or refuses is not measured:
// - loops run counter-clockwise from outside; operands are assembled from polygons, not by Euler operators;
// - both operands live in one structure, so that moving faces to the result is choosing shells (finish.cpp);
// - the tables of on-sectors and on-edges are applied to parts of arcs instead of pairs of sectors (classify.cpp);
// - null edges are made in pairs, A's with B's, and keep the order of the curve's directions in a corner instead
//   of finding their orientation from convexity (null_edges.cpp); so they are sorted in pairs, too;
// - ends are joined with the nearest ahead on the line of their faces, and rings are moved where a join needs them
//   and by place at the end (connect.cpp);
// - null faces are paired by their curve and glued by its pieces, not by comparing coordinates (finish.cpp);
// - shells without a curve, which the book leaves open, are located by rays (locate.cpp);
// - one epsilon, relative to the operands' size, serves all comparisons of doubles; fractions have none;
// - the result's own invariants are checked at the end, and edges that share both ends get a vertex in the middle
//   (output.cpp); the last result in doubles is cut into triangles, since its points are in no plane any more.
//   Both fail as stage output;
// - a fold reads the result of a step, polygons, as the operand of the next one;
// - the operands keep what reduction adds: neither collinear edges nor coplanar faces are joined, as in the book.
//
// What the method cannot do, and says: operands that are no 2-manifold, or whose faces are not planar (input); a
// boundary that touches itself, as the result of an earlier Boolean may, where the other crosses it
// (classification, null_edges). Exact arithmetic fails in another way in folds of many boxes:
// connecting, in boxes-union-s100-kexact-r7. Doubles may fail in any stage where points are nearly within epsilon.
#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

/// Runs a stage: what the structure or an array refuses fails in it.
template <class Step>
auto staged(Stage stage, Step&& step) {
  try {
    return step();
  } catch (const std::logic_error& error) {
    throw Failure(stage, error.what());
  }
}

}  // namespace

const char* to_string(Stage stage) {
  constexpr const char* names[] = {"input",      "reduction", "classification", "null_edges",
                                   "connecting", "finishing", "output"};
  return names[static_cast<int>(stage)];
}

template <class N>
Model evaluate(const Model& a, const Model& b, Operation operation, const N& epsilon,
               const Departures& departures) {
  auto scene = staged(Stage::input, [&] { return read_operands(a, b, operation, epsilon, departures); });
  staged(Stage::reduction, [&] { reduce(scene); });
  staged(Stage::classification, [&] { classify(scene); });
  staged(Stage::null_edges, [&] { insert_null_edges(scene); });
  staged(Stage::connecting, [&] { connect(scene); });
  const std::vector<FaceId> faces = staged(Stage::finishing, [&] { return finish(scene); });
  return staged(Stage::output, [&] { return write_result(scene, faces); });
}

template Model evaluate(const Model&, const Model&, Operation, const double&, const Departures&);
template Model evaluate(const Model&, const Model&, Operation, const Rational&, const Departures&);

Model step_double(const Model& a, const Model& b, Operation operation, double epsilon,
                  const Departures& departures) {
  return evaluate<double>(a, b, operation, epsilon, departures);
}

Model boolean_double(const Model& a, const Model& b, Operation operation, double epsilon,
                     const Departures& departures) {
  return triangulated(step_double(a, b, operation, epsilon, departures));
}

Model boolean_exact(const Model& a, const Model& b, Operation operation, const Departures& departures) {
  return evaluate<Rational>(a, b, operation, 0, departures);
}

}  // namespace cnrg::bench::mantyla
