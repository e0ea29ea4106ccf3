#include "csg/mesh/mesh_plan.h"

#include <cmath>

#include "csg/mesh/has_to_be_split.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/text/input_file.h"
#include "kernel/tetrahedra/bounds.h"

namespace cnrg {
namespace {

using Vector = std::array<double, 3>;
constexpr double kSizedQuality = 2;  // where no quality is asked for; TetGen refines for sizes only with some

/// How many times as many tetrahedra are far more.
constexpr double kFar = 3;

std::string to_have_all(const MeshForecast& good) {
  if (!impossible_text(good, 0).empty()) return "";
  return ", since that takes " + time_text(good.seconds) + "; --seconds 0 makes them";
}

}  // namespace

MeshPlan::MeshPlan(const ResultView& view, const FlatComplex& flat, const RoundedResult& rounded,
                   const TetrahedraOptions& options, const Deadline& deadline, const TetgenTrial& trial)
    : view_(view),
      flat_(flat),
      points_(rounded.points()),
      options_(options),
      deadline_(deadline),
      trial_(trial),
      surface_first_(options.surface_first) {
  set_sizes(false);
  if (surface_first_ && !bounded()) surface_ = surface_complex();
  decide_thin_parts();
  if (!asks_tetgen()) set_sizes_of_shapes();
  foretell(options_.constrained || (!asks_tetgen() && bounded()) ? Mesher::own : Mesher::tetgen);
}

void MeshPlan::give_to_own_mesher() {
  set_sizes_of_shapes();
  foretell(Mesher::own);
}

const RegionLocator& MeshPlan::regions() {
  if (!regions_) regions_.emplace(flat_, points_);
  return *regions_;
}

void MeshPlan::set_sizes(bool wide) {
  sizes_ = mesh_sizes(view_, flat_, points_, {options_.size, options_.growth, false, false, wide});
  forecasts_ = {};
  if (!sizes_.empty()) too_large_ = larger_than(sizes_, regions(), flat_);
}

/// Our mesher comes to a bound of shapes by lengths that change gradually: halves of what is bad alone make ever
/// more that is as bad, since nothing beside them is small.
void MeshPlan::set_sizes_of_shapes() {
  if (options_.quality == 0 || !sizes_.empty() || thin_ != ThinParts::refined) return;
  sizes_ = mesh_sizes(view_, flat_, points_, {0, kGrowthOfShapes, true});
  regions();
  forecasts_ = {};
}

/// TetGen refines until no edge is much longer than the region is thick. What takes longer than somebody waits is
/// left out where it cannot be had; with a quality, too, unless `seconds` say that he waits.
void MeshPlan::decide_thin_parts() {
  if (options_.keep_boundary || !bounded()) return;
  const Mesher mesher = options_.constrained && sized() ? Mesher::own : Mesher::tetgen;
  MeshForecast good = forecast_for(mesher).good;
  if (options_.constrained) good.seconds = kSecondsOfShapes * good.tetrahedra;
  const auto are_many = [&] { return good.tetrahedra > kFar * forecast_for(mesher).flat.tetrahedra; };
  if (takes_too_long(good)) {
    set_sizes(true);
    if (are_many()) return ration(good);
    set_sizes(false);
  }
  if (surface_first_ && sized() && options_.quality == 0 && options_.max_volume == 0 && are_many()) keep_flat();
}

void MeshPlan::ration(const MeshForecast& good) {
  thin_ = ThinParts::rationed;
  // Sizes have room on faces, and none inside; and what is wide can get good shapes beside triangles that stay.
  surface_first_ = leaves_flat() && (options_.surface_first || sized() || options_.quality > 0);
  if (leaves_flat() && options_.quality > 0)
    worse_where_wide_ = worse_where_wide(options_.quality, options_.max_volume, too_large_, regions(), flat_);
  flat_text_ =
      count_text(good.tetrahedra) + " tetrahedra of a good shape would fill regions that are very thin; " +
      (options_.quality == 0 ? "since no --quality was asked for, those there are as flat as they have to be"
                             : "those there are as flat as they have to be" + to_have_all(good));
}

void MeshPlan::keep_flat() {
  thin_ = ThinParts::flat;
  flat_text_ =
      "some regions are thinner than the triangles around them are wide; as these are kept, tetrahedra there "
      "are as flat as they have to be";
}

bool MeshPlan::takes_too_long(const MeshForecast& good) const {
  constexpr double kPatience = 20;  // seconds
  const double patience = !options_.seconds       ? kPatience
                          : *options_.seconds > 0 ? *options_.seconds / 3.0
                                                  : HUGE_VAL;
  return good.seconds > patience || (options_.quality == 0 && !impossible_text(good, 0).empty());
}

/// To the sizes that there are; each is made once. With few seconds the mesh is worth more than to know its size:
/// the forecast gets a quarter of them, and is empty where that is too little.
const ThinForecast& MeshPlan::forecast_for(Mesher mesher) {
  std::optional<ThinForecast>& made = forecasts_[std::size_t(mesher)];
  if (made) return *made;
  made.emplace();
  if (forecast_left_out_) return *made;
  const Watch& watch = deadline_.watch();
  watch.begin("mesh: forecast");
  const Deadline part(watch, deadline_.seconds_left() / 4);
  try {
    made =
        forecast(view_, flat_, points_, sizes_, regions_, mesher, options_, part.watch(), surface_.points.size());
  } catch (const Stopped&) {
    if (watch.stop.stop_requested()) throw;
    forecast_left_out_ = true;
  }
  return *made;
}

void MeshPlan::foretell(Mesher mesher) {
  const ThinForecast& both = forecast_for(mesher);
  const MeshForecast& mesh = thin_ == ThinParts::refined ? both.good : both.flat;
  if (mesh.tetrahedra == 0) return;
  if (!options_.keep_boundary) require_possible(mesh, double(memory_of_machine()));  // else few may do
  if (std::isinf(mesh.most)) return;
  expected_ = mesh;
  const bool known = !trial_.fault.empty() && !bounded();  // it was foretold with TetGen, and is the same
  if (options_.foretold && !known) options_.foretold(mesh);
}

TetgenSwitches MeshPlan::switches() const {
  constexpr double kAny = 1e30;
  if (leaves_flat()) return {.keep_boundary = keeps_boundary(), .quality = worse_where_wide_ ? kAny : 0};
  return {keeps_boundary(),
          options_.quality > 0 ? options_.quality
          : sized()            ? kSizedQuality
                               : 0,
          options_.max_volume > 0};
}

const MeshSizes& MeshPlan::said_sizes() {
  if (!said_) said_ = mesh_sizes(view_, flat_, points_, {options_.size, options_.growth, false, true});
  return *said_;
}

Plc MeshPlan::surface_complex() {
  SurfaceOptions asked;
  asked.watch = deadline_.watch();
  asked.periodic = options_.periodic;
  const SurfaceNarrow narrow = rationed() ? SurfaceNarrow::left : SurfaceNarrow::rationed;
  if (sizes_.empty()) return refined_plc(flat_, points_, asked, {}, narrow);
  asked.size = [&](const Vector& p) { return kLongestEdge * sizes_.field.at(p); };
  const MeshSizes& said = said_sizes();
  return refined_plc(
      flat_, points_, asked, [&](const Vector& p) { return kLongestEdge * said.field.at(p); }, narrow);
}

const Plc& MeshPlan::surface() {
  if (surface_.facets.empty()) surface_ = surface_complex();
  // Each triangle has a tetrahedron: if there are more than were foretold, the surface is finer than the sizes
  // inside, which TetGen would refine for without an end.
  if (sized() && options_.quality == 0 && options_.max_volume == 0 && expected_.tetrahedra > 0 && !leaves_flat() &&
      double(surface_.facets.size()) > expected_.tetrahedra)
    keep_flat();
  return surface_;
}

}  // namespace cnrg
