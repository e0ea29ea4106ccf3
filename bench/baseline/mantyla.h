// Mäntylä's Boolean set operations on boundary models after mantyla1986 and mantyla1988, chapters 12 to 15:
// half-edge solids and Euler operators, reduction, vertex neighbourhood classification, null edges, connecting,
// finishing. Departures from the published algorithm are switches (departures.h), all on unless somebody says
// otherwise. The exact kernel of this project takes no part.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/baseline/departures.h"
#include "bench/cases/model.h"
#include "bench/cases/operation.h"

namespace cnrg::bench::mantyla {

/// Where the algorithm stopped.
enum class Stage {
  input,           ///< an operand is no planar, orientable, closed 2-manifold
  reduction,       ///< finding the intersections of edges with faces and splitting there
  classification,  ///< vertex neighbourhoods: sectors, on-sectors, on-edges
  null_edges,      ///< inserting null edges into the neighbourhoods
  connecting,      ///< sorting null edges and joining loose ends into loops
  finishing,       ///< pairing the loops, moving and gluing the parts
  output,          ///< the result is no valid solid: its own invariants do not hold
};
const char* to_string(Stage stage);

class Failure : public std::runtime_error {
 public:
  using Places = std::vector<RationalPoint>;

  Failure(Stage stage, const std::string& what, Places places = {})
      : std::runtime_error(what), stage_(stage), places_(std::move(places)) {}
  Stage stage() const { return stage_; }
  const Places& places() const { return places_; }  ///< where, if one place or some are known

 private:
  Stage stage_;
  Places places_;
};

/// a op b in double with one epsilon for all comparisons, as a part of the largest coordinate of both operands.
/// Operands' coordinates are rounded to doubles, faces of the result cut into triangles. An empty result has no
/// faces; where the result touches itself points are there twice. Throws Failure. Without the departure `checks` a
/// result may be no solid.
Model boolean_double(const Model& a, const Model& b, Operation operation, double epsilon = 1e-10,
                     const Departures& departures = {});

/// The same, but faces are polygons, also with holes, planar within epsilon: the operand of a next step.
Model step_double(const Model& a, const Model& b, Operation operation, double epsilon,
                  const Departures& departures = {});
/// Each face with more than three corners as triangles over the same points. Throws Failure (output), such as for
/// a face whose parts hang together in a point, where the result touches itself.
Model triangulated(const Model& model);

/// The same source on rationals, epsilon 0. Throws Failure.
Model boolean_exact(const Model& a, const Model& b, Operation operation, const Departures& departures = {});

}  // namespace cnrg::bench::mantyla
