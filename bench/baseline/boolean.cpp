// The Boolean as the sequence of its stages (mantyla1988, program 15.1).
//
// The rules in which it departs from the published algorithm are switches: departures.h. Representation and
// arithmetic, which are none:
// - loops run counter-clockwise from outside; operands are assembled from polygons, not by Euler operators; both
//   live in one structure, so that moving faces to the result is choosing shells (finish.cpp);
// - wide sectors are bisected at a vertex in a face, too, which the archive leaves to stubs;
// - null edges are sorted however few there are, and joined null edges are kept in pairs, A's with B's;
// - one epsilon, relative to the operands' size, serves all comparisons of doubles (the archive has floats, 1e-6
//   and 1e-4 for the order); fractions have none;
// - without `checks`, too, what the structure cannot do is refused in its stage, where the archive would crash or
//   not end;
// - edges that share both ends get a vertex in the middle (output.cpp); the last result in doubles is cut into
//   triangles, since its points are in no plane any more. Both fail as stage output. A fold reads the result of a
//   step, polygons, as the operand of the next one;
// - the operands keep what reduction adds: neither collinear edges nor coplanar faces are joined, as in the book.
//
// What the method cannot do, and says: operands that are no 2-manifold, or whose faces are not planar (input); a
// boundary that touches itself, as the result of an earlier Boolean may, where the other crosses it
// (classification, null_edges). Exact arithmetic fails in another way in folds of many boxes: connecting, in
// `bench/run boxes -D seed=7 --one boxes-union-s100-kexact-r7 mantyla-exact`. Doubles may fail in any stage where
// points are nearly within epsilon.
#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
const char* to_string(Stage stage) {
  constexpr const char* names[] = {"input",      "reduction", "classification", "null_edges",
                                   "connecting", "finishing", "output"};
  return names[static_cast<int>(stage)];
}

template <class N>
Model run_stages(Scene<N>& scene, const std::function<void(Stage)>& after) {
  const auto run = [&](Stage stage, void (*step)(Scene<N>&)) {
    staged(stage, [&] { step(scene); });
    if (after) after(stage);
  };
  run(Stage::reduction, reduce);
  run(Stage::classification, classify);
  run(Stage::null_edges, insert_null_edges);
  run(Stage::connecting, connect);
  run(Stage::finishing, part);
  const std::vector<FaceId> faces = staged(Stage::finishing, [&] { return glue(scene); });
  return staged(Stage::output, [&] { return write_result(scene, faces); });
}

template <class N>
Model evaluate(const Model& a, const Model& b, Operation operation, const N& epsilon,
               const Departures& departures) {
  auto scene = staged(Stage::input, [&] { return read_operands(a, b, operation, epsilon, departures); });
  return run_stages(scene);
}

template Model run_stages(Scene<double>&, const std::function<void(Stage)>&);
template Model run_stages(Scene<Rational>&, const std::function<void(Stage)>&);
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
