// How a result is to be filled with tetrahedra, decided before a mesher is asked: sizes, how many tetrahedra these
// take, whether surfaces are meshed first, and what becomes of thin regions.
//
// Good shapes in a region far thinner than its faces are wide take as many tetrahedra as it is wide in
// thicknesses, squared; TetGen makes them all, and where triangles on the boundary stay it does not end. So
// forecasts with and without good shapes there are compared first.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "csg/mesh/forecast.h"
#include "csg/mesh/plc.h"
#include "csg/mesh/rounded_result.h"
#include "csg/mesh/tetgen_run.h"
#include "csg/mesh/tetrahedra.h"

namespace cnrg {

/// What a mesher does in regions where good shapes take far more tetrahedra than all else.
enum class ThinParts : std::uint8_t {
  refined,   ///< the same as elsewhere
  flat,      ///< it leaves tetrahedra flat beside triangles that stay
  rationed,  ///< it leaves them flat, and few points are added for shapes: more would take too long
};

class MeshPlan {
 public:
  /// What is given must outlive the plan. Throws InputError if the mesh is impossible (forecast.h), Stopped.
  MeshPlan(const ResultView& view, const FlatComplex& flat, const RoundedResult& rounded,
           const TetrahedraOptions& options, const Deadline& deadline, const TetgenTrial& trial);

  bool asks_tetgen() const { return !options_.constrained && trial_.fault.empty(); }
  bool bounded() const { return options_.quality > 0 || options_.max_volume > 0 || sized(); }
  bool sized() const { return bool(too_large_); }
  const MeshSizes& sizes() const { return sizes_; }
  bool rationed() const { return thin_ == ThinParts::rationed; }
  /// TetGen only fills thin regions, since it would not end.
  bool leaves_flat() const { return thin_ == ThinParts::flat || (rationed() && !options_.constrained); }
  bool surface_first() const { return surface_first_; }
  bool keeps_boundary() const { return options_.keep_boundary || surface_first_; }
  /// The boundary is meshed first only if somebody asks for that: what was planned for TetGen alone is over.
  void mesh_surface_as_asked() { surface_first_ = options_.surface_first; }

  /// Sizes and the forecast for our own mesher, after TetGen has failed.
  void give_to_own_mesher();
  /// The triangles of surfaces as facets. Where these are more than the expected tetrahedra, thin regions stay
  /// flat.
  const Plc& surface();
  /// The sizes without what features ask for by themselves.
  const MeshSizes& said_sizes();

  /// What TetGen splits where it refines, besides what `switches` say.
  const TooLarge& split_by_tetgen() const { return sized() && !leaves_flat() ? too_large_ : worse_where_wide_; }
  TetgenSwitches switches() const;

  /// As foretold; all zero where nothing was.
  const MeshForecast& expected() const { return expected_; }
  /// What the user should know of these decisions: why regions stay flat, that nothing was foretold.
  const std::string& flat_text() const { return flat_text_; }
  bool foretold() const { return !forecast_left_out_; }

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  const RoundedPoints& points_;
  const TetrahedraOptions& options_;
  const Deadline& deadline_;
  const TetgenTrial& trial_;
  MeshSizes sizes_;
  std::optional<MeshSizes> said_;
  std::optional<RegionLocator> regions_;
  TooLarge too_large_;                                    // where sizes are asked for
  TooLarge worse_where_wide_;                             // where what is wide is bounded
  std::array<std::optional<ThinForecast>, 2> forecasts_;  // by meshers
  bool forecast_left_out_ = false;                        // it takes too long
  MeshForecast expected_;
  ThinParts thin_ = ThinParts::refined;
  bool surface_first_;
  std::string flat_text_;
  Plc surface_;

  const RegionLocator& regions();
  void set_sizes(bool wide);
  void set_sizes_of_shapes();
  void decide_thin_parts();
  void ration(const MeshForecast& good);
  void keep_flat();
  bool takes_too_long(const MeshForecast& good) const;
  const ThinForecast& forecast_for(Mesher mesher);
  void foretell(Mesher mesher);
  Plc surface_complex();
};

}  // namespace cnrg
