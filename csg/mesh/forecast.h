// How many tetrahedra a mesh will have, told from the sizes and bounds that are asked for before any is made, and
// what memory and time that takes.
//
// Tetrahedra whose edges have the length h fill space with c / h^3 of them per unit of volume; so their number is
// the integral of that over the active regions. The integrand changes by orders of magnitude within a model, and
// regions may be thin: a grid misses what is small, points at random come too late. So a box around the model is
// halved along all axes where the doubt about its share is largest, and then points are strewn by share, the same
// in every run. What is far thinner than edges are to be long no cell comes to: there the integral is one over
// faces, times the distance to the face that is opposite. On the other side of such a face edges are as short, and
// grow from there: one more integral over faces. Where features nearly touch TetGen makes short edges, too
// (near_sizes.h); where faces meet sharply it makes none.
//
// A bound of volumes is a least density. Where only shapes are bounded, refinement makes edges about as long as
// features are wide and lets them grow from there, so that sizes that nobody asked for tell of it, but not within
// 30 %: that is a range. Where nothing is bounded, edges grow faster, and counts depend on which shapes can be
// mended: the range is wide, and tells of memory and time more than of a number. Where the boundary is kept, it
// may leave no room for what is asked for, so there may be as few as its faces need.
#pragma once

#include <optional>

#include "csg/mesh/mesh_sizes.h"
#include "csg/mesh/region_locator.h"
#include "csg/result/result.h"

namespace cnrg {

/// Who makes tetrahedra to sizes: TetGen, or the improver out of constrained ones (kernel/tetrahedra/improve.h),
/// or the improver out of those that TetGen fills thin regions with, and leaves them as flat as they have to be.
enum class Maker : std::uint8_t { tetgen, own, flat };

/// How many there are, by what decides how long edges are: `even` where it is the overall size or that of a
/// region, `growing` where lengths grow from something.
struct ExpectedTetrahedra {
  double even = 0, growing = 0, by_thickness = 0, by_volume = 0;
  double all() const { return even + growing + by_thickness + by_volume; }
};

/// Of the mesh of a result, together, within 30 % where it is meshed by sizes or by a bound of volumes (0: none)
/// and has thousands; bounds of shapes are not seen. Takes some milliseconds, and up to a second for meshes of
/// millions. `sizes` are not empty. `rough`: a tenth more or less does not matter, and it takes an eighth of the
/// time. Throws Stopped.
ExpectedTetrahedra expected_tetrahedra(const FlatComplex& flat, const RoundedPoints& points,
                                       const MeshSizes& sizes, const RegionLocator& regions, Maker maker,
                                       double max_volume = 0, const Watch& watch = {}, bool rough = false);

/// As TetGen makes them where only volumes or shapes are bounded, growth of the sizes that facets and pieces have.
inline constexpr double kGrowthOfFeatures = 0.8, kGrowthOfShapes = 0.6;

/// Of our own in a volume, where volumes alone are bounded.
double expected_of_volume(double volume, double max_volume);

/// How many times as many a bound of the ratio of circumradius to shortest edge makes as 2 does; 1 for 0: no
/// bound.
double for_quality(double radius_edge);

/// With the memory and the time that so many take, or where the count is not told within 30 % the most; `seconds`
/// of each.
MeshForecast with_costs(double tetrahedra, double least, double most, double seconds);

/// What is foretold of the mesh that the options ask for. `sizes` are those of the options, or those by which ours
/// come to a quality, and `regions` are there where sizes are. `most` may be infinite: then only the least is
/// known. `complex_points`: of what the mesh is begun with, where that has more points than the result. Throws
/// Stopped by `watch`, not by that of the options.
MeshForecast forecast(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                      const MeshSizes& sizes, const std::optional<RegionLocator>& regions, Maker maker,
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

/// Is its count told within 30 %? Else it is a range, and bytes and seconds are those of the most.
bool is_close(const MeshForecast& mesh);

/// `about 12,300 tetrahedra are expected, 50 MB of memory, a second`; where 30 % cannot be promised `from 5,000 to
/// 15,000 tetrahedra are expected, up to ...`.
std::string forecast_text(const MeshForecast& mesh);

/// `about 1,230,000`, with three digits that count; `more than 1,000,000,000,000,000`.
std::string count_text(double count);

}  // namespace cnrg
