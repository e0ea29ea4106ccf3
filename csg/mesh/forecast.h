// How many tetrahedra a mesh will have, estimated from sizes and bounds before any is made; from that a bound of
// memory and time, and whether good shapes in thin regions are worth their number.
//
// Tetrahedra whose edges have the length h fill space with c / h^3 of them per unit of volume: their number is the
// integral of that over the active regions. The integrand changes by orders of magnitude within a model, so a box
// around the model is halved along all axes where the error of its share may be largest. Regions thinner than
// edges are to be long are integrated over their faces instead, by the distance to the face opposite: once as good
// shapes fill them, once as flat as they have to be.
//
// An estimate is good within a factor of two for most models. Meshers split for features that nearly touch and for
// sharp angles, too, of which an integral of sizes knows nothing; so people are told a range.
#pragma once

#include <optional>

#include "csg/mesh/mesh_sizes.h"
#include "csg/mesh/region_locator.h"
#include "csg/result/result.h"

namespace cnrg {

/// TetGen, or our own improver (kernel/tetrahedra/improve.h), which leaves thin regions much flatter.
enum class Mesher : std::uint8_t { tetgen, own };

/// By sizes and bounds of volumes; then in thin regions, if shapes there are good, or as flat as they have to be.
struct ExpectedTetrahedra {
  double wide = 0, thin = 0, flat = 0;
  double good_shapes() const { return wide + thin; }
  double flat_shapes() const { return wide + flat; }
};

/// `sizes` are not empty. `max_volume`: 0 is no bound. Takes milliseconds. Throws Stopped.
ExpectedTetrahedra expected_tetrahedra(const FlatComplex& flat, const RoundedPoints& points,
                                       const MeshSizes& sizes, const RegionLocator& regions, Mesher mesher,
                                       double max_volume = 0, const Watch& watch = {});

/// Growth of the lengths that facets and pieces ask for where only volumes or shapes are bounded.
inline constexpr double kGrowthOfShapes = 0.6;

/// Two forecasts of the mesh that the options ask for: with good shapes everywhere, and flat ones in thin regions.
struct ThinForecast {
  MeshForecast good, flat;
};

/// `sizes` are those of the options, or those by which our own mesher comes to a quality; `regions` are there
/// where sizes are. `complex_points`: of what the mesh is begun with, where that has more points than the result.
/// Throws Stopped by `watch`, not by that of the options.
ThinForecast forecast(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                      const MeshSizes& sizes, const std::optional<RegionLocator>& regions, Mesher mesher,
                      const TetrahedraOptions& options, const Watch& watch, std::size_t complex_points = 0);

/// More than that are refused.
inline constexpr double kMostTetrahedra = 2e8;

/// Empty, or what it takes if that is more than kMostTetrahedra, or if the fewest that are expected need more
/// memory (bytes, 0: unknown) than there is.
std::string impossible_text(const MeshForecast& mesh, double memory);

/// Throws InputError, with what helps, if it is impossible.
void require_possible(const MeshForecast& mesh, double memory);

/// Of one core, for each tetrahedron that is improved for its shape, by many rounds of moves.
inline constexpr double kSecondsOfShapes = 80e-6;

/// `33 seconds`, `5 minutes`.
std::string time_text(double seconds);

/// `from 5,000 to 15,000 tetrahedra are expected, up to 50 MB of memory, a second`.
std::string forecast_text(const MeshForecast& mesh);

/// `about 1,230,000`, with three digits that count; `more than 1,000,000,000,000,000`.
std::string count_text(double count);

}  // namespace cnrg
