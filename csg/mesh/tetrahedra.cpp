// TetGen is asked in several ways (kAttempts) until its answer is proven to be a mesh of the result
// (proven_mesh.h). Where all of them fail, exact tetrahedra are made that are bound to conform
// (constrained_run.h). What there is then is improved by moves that keep that (improved.h), and proven once more.
#include "csg/mesh/tetrahedra.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>

#include "csg/mesh/constrained_run.h"
#include "csg/mesh/forecast.h"
#include "csg/mesh/has_to_be_split.h"
#include "csg/mesh/improved.h"
#include "csg/mesh/planar_facets.h"
#include "csg/mesh/proven_mesh.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/mesh/tetgen_run.h"
#include "csg/result/file_numbers.h"
#include "csg/result/solid.h"
#include "csg/text/input_file.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/base/vectors.h"
#include "kernel/tetrahedra/bounds.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = std::array<double, 3>;
constexpr double kSizedQuality = 2;  // where no quality is asked for; it refines for sizes only with some

class TetrahedraMaker {
 public:
  TetrahedraMaker(const ResultView& view, const TetrahedraOptions& options, const Deadline& deadline,
                  const TetgenTrial& trial)
      : view_(view),
        options_(options),
        trial_(options.constrained || !trial.fault.empty() || plugin_fault(kTetgenPlugin).empty()
                   ? trial
                   : TetgenTrial{false, plugin_fault(kTetgenPlugin)}),
        deadline_(deadline),
        watch_(deadline.watch()),
        flat_(flatten_for_mesh(view)) {}

  TetrahedralMesh run() {
    require_closed_and_bounded(flat_, "a mesh of tetrahedra");
    const bool solid = std::any_of(flat_.regions.begin(), flat_.regions.end(),
                                   [](const auto& region) { return region.component != 0; });
    if (!solid) {
      throw InputError(
          "the result has no region to fill with tetrahedra; `cnrg mesh --surface` writes triangles and lines, "
          "and `cnrg eval -o` its faces, wires and points");
    }
    if (options_.constrained && options_.keep_boundary)
      throw InputError("constrained tetrahedra need points on the boundary; leave out --keep-boundary");
    if (options_.surface_first && (options_.keep_boundary || options_.constrained))
      throw InputError("a boundary that is meshed first is neither that of --keep-boundary nor of --constrained");
    watch_.begin("mesh: rounding");
    const RoundedResult rounded(view_, flat_, "a mesh of tetrahedra", watch_.stop);
    ask_for_sizes(rounded);
    const std::string refused = asks_tetgen() ? ask_tetgen(rounded) : trial_.fault;
    if (trial_.only && !refused.empty()) throw TetgenFault(refused);
    of_tetgen_ = asks_tetgen() && refused.empty() && !thin_ && !filled_;
    if (asks_tetgen() && bounded() && (filled_ || !refused.empty())) {  // others than it would have made
      ours_ = true;
      set_sizes_of_shapes(rounded.points());
      foretell(rounded, Mesher::own);
    }
    to_sizes_ = filled_ && !sizes_.empty() && !options_.keep_boundary;  // halves beside kept faces are flat
    if (options_.constrained || !refused.empty()) {
      surface_first_ = options_.surface_first;
      if (surface_first_) throw InputError(refused);
      make_constrained(rounded, refused);
      to_sizes_ = !sizes_.empty() && !options_.keep_boundary;
      if (!refused.empty()) {  // without its advice
        result_.notice = without_remedy(refused) + "; these are constrained tetrahedra, improved";
      }
    }
    if (thin_) to_sizes_ = sized();
    if (thin_ && !sized()) surface_first_ = options_.surface_first;  // TetGen had to keep it, halves need not
    tell(flat_text_);
    if (not_foretold_) tell("how many tetrahedra there would be was not counted, to leave the time for the mesh");
    improve_shapes(rounded);
    result_.rounding = rounded.report();
    result_.expected = expected_;
    number_points(result_.mesh, flat_, out_.points);
    result_.quality = quality_of(mesh(), leaf_names(*view_.leaves), options_.quality, options_.max_volume);
    tell_rationed();
    tell_larger(rounded);
    return std::move(result_);
  }

 private:
  /// A way to ask TetGen. Whole facets it may triangulate as it likes, which gives better tetrahedra; but rounding
  /// has moved their points off the plane, and now and then TetGen stumbles over that. Our triangles are planar,
  /// and keep volumes exact. Where both fail, a less regular box about the model has helped.
  struct Attempt {
    PlcFacets facets;
    TetgenFrame frame;
  };
  static constexpr Attempt kAttempts[] = {{PlcFacets::all, TetgenFrame::even},
                                          {PlcFacets::planar, TetgenFrame::even},
                                          {PlcFacets::planar, TetgenFrame::uneven}};

  /// So many times as many tetrahedra as are expected, or as are few, are made at most.
  static constexpr std::size_t kMostOfExpected = 8, kFewTetrahedra = 60'000;
  /// Steps of TetGen, in all where there is another way to a mesh; to fill, and more for each point; for each
  /// tetrahedron that is expected.
  static constexpr std::size_t kTetgenSteps = 500'000'000, kTetgenFills = 20'000'000, kTetgenFillsPoint = 2'000,
                               kTetgenMakes = 10;
  /// Of the improver.
  static constexpr std::size_t kStepsOfShapes = 200'000'000;
  /// Points that are added at most to keep bounds that are asked for.
  static constexpr std::size_t kPointsForBounds = 3'000'000;

  const ResultView& view_;
  const TetrahedraOptions options_;
  const TetgenTrial trial_;
  const Deadline& deadline_;
  const Watch& watch_;  // of the deadline
  const FlatComplex flat_;
  Plc plc_;
  Plc surface_;  // of surfaces, where these come first
  PlcMesh out_;
  TetrahedralMesh result_;
  MeshSizes sizes_;
  std::optional<MeshSizes> said_;
  std::optional<RegionLocator> regions_;
  TooLarge too_large_;                                    // where sizes are asked for
  TooLarge has_to_be_split_;                              // where what is wide is bounded
  std::array<std::optional<ThinForecast>, 2> forecasts_;  // by meshers
  double expected_ = 0;
  double for_shapes_ = 0;  // as many would be made if points that nobody asks for were not rationed
  double expected_most_ = 0;
  bool not_foretold_ = false;  // since that takes too long
  bool late_ = false;          // TetGen has not come to an end of refining
  bool surface_first_ = options_.surface_first;
  bool ours_ = options_.constrained || !trial_.fault.empty();  // TetGen is not asked, or has failed
  bool rationed_ = false;                                      // points in narrow parts are
  bool thin_ = false;                    // TetGen fills the regions and no more, since it would not end
  std::string flat_text_;                // why
  bool fills_ = false, filled_ = false;  // it fills, or has filled, since it does not end of refining
  bool of_tetgen_ = false;               // it has made the mesh, to all bounds
  bool to_sizes_ = false;                // the improver makes them
  double afterwards_ = 0;  // seconds that are kept for what follows the improver, for each tetrahedron

  Mesh& mesh() { return result_.mesh; }
  bool asks_tetgen() const { return !options_.constrained && trial_.fault.empty(); }
  bool sized() const { return bool(too_large_); }

  /// What the mesh is to be, and how many tetrahedra that takes.
  void ask_for_sizes(const RoundedResult& rounded) {
    set_sizes(rounded.points(), false);
    if (surface_first_ && !bounded()) surface_ = surface_complex(rounded);
    find_thin(rounded.points());
    set_sizes_of_shapes(rounded.points());
    const bool own = options_.constrained || (!asks_tetgen() && bounded());
    foretell(rounded, own ? Mesher::own : Mesher::tetgen);
  }

  void set_sizes(const RoundedPoints& points, bool wide) {
    sizes_ = mesh_sizes(view_, flat_, points, {options_.size, options_.growth, false, false, wide});
    forecasts_ = {};
    if (sizes_.empty()) return;
    if (!regions_) regions_.emplace(flat_, points);
    too_large_ = larger_than(sizes_, *regions_, flat_);
  }

  /// Ours come to a bound of shapes by lengths that change gradually: halves of what is bad alone make ever more
  /// that is as bad, since nothing beside them is small.
  void set_sizes_of_shapes(const RoundedPoints& points) {
    if (!ours_ || options_.quality == 0 || !sizes_.empty() || rationed_ || thin_) return;
    sizes_ = mesh_sizes(view_, flat_, points, {0, kGrowthOfShapes, true});
    if (!regions_) regions_.emplace(flat_, points);
    forecasts_ = {};
  }

  /// Are there regions in which good shapes take far more tetrahedra than all else? TetGen refines until no edge
  /// is much longer than the region is thick, and where triangles on the boundary are, and have to stay, without
  /// an end. What takes longer than somebody waits is left out where it cannot be had: with a quality, too, unless
  /// he says by `seconds` that he waits.
  void find_thin(const RoundedPoints& points) {
    constexpr double kFar = 3;
    if (options_.keep_boundary || !bounded()) return;
    const Mesher mesher = options_.constrained && sized() ? Mesher::own : Mesher::tetgen;
    MeshForecast told = forecast_of(points, mesher).good;
    if (options_.constrained) told.seconds = kSecondsOfShapes * told.tetrahedra;
    const double good = told.tetrahedra;
    if (takes_too_long(told)) {
      set_sizes(points, true);
      rationed_ = good > kFar * forecast_of(points, mesher).flat.tetrahedra;
      if (rationed_) return ration(points, told);
      set_sizes(points, false);
    }
    if (surface_first_ && sized() && options_.quality == 0 && options_.max_volume == 0 &&
        good > kFar * forecast_of(points, mesher).flat.tetrahedra)
      keep_flat();
  }
  void ration(const RoundedPoints& points, const MeshForecast& told) {
    thin_ = !options_.constrained;
    // Sizes have room on faces, and none inside; and what is wide can get good shapes beside triangles that stay.
    surface_first_ = thin_ && (options_.surface_first || sized() || options_.quality > 0);
    if (thin_ && options_.quality > 0) {
      if (!regions_) regions_.emplace(flat_, points);
      has_to_be_split_ = worse_where_wide(options_.quality, options_.max_volume, too_large_, *regions_, flat_);
    }
    flat_text_ =
        count_text(told.tetrahedra) + " tetrahedra of a good shape would fill regions that are very thin; " +
        (options_.quality == 0 ? "since no --quality was asked for, those there are as flat as they have to be"
                               : "those there are as flat as they have to be" + to_have_all(told));
  }
  bool takes_too_long(const MeshForecast& told) const {
    constexpr double kPatience = 20;  // seconds
    const double patience = !options_.seconds       ? kPatience
                            : *options_.seconds > 0 ? *options_.seconds / 3.0
                                                    : HUGE_VAL;
    if (told.seconds > patience) return true;
    return options_.quality == 0 && !impossible_text(told, 0).empty();
  }
  static std::string to_have_all(const MeshForecast& told) {
    if (!impossible_text(told, 0).empty()) return "";
    return ", since that takes " + time_text(told.seconds) + "; --seconds 0 makes them";
  }
  void keep_flat() {
    thin_ = true;
    flat_text_ =
        "some regions are thinner than the triangles around them are wide; as these are kept, tetrahedra there "
        "are as flat as they have to be";
  }

  /// To the sizes that there are; each is made once. With few seconds the mesh is worth more than to know its
  /// size: it gets a quarter of them, and is empty where that is too little.
  const ThinForecast& forecast_of(const RoundedPoints& points, Mesher mesher) {
    std::optional<ThinForecast>& made = forecasts_[std::size_t(mesher)];
    if (made) return *made;
    made.emplace();
    if (not_foretold_) return *made;
    watch_.begin("mesh: forecast");
    const Deadline part(watch_, deadline_.seconds_left() / 4);
    try {
      made =
          forecast(view_, flat_, points, sizes_, regions_, mesher, options_, part.watch(), surface_.points.size());
    } catch (const Stopped&) {
      if (watch_.stop.stop_requested()) throw;
      not_foretold_ = true;
    }
    return *made;
  }

  void foretell(const RoundedResult& rounded, Mesher mesher) {
    const ThinForecast& both = forecast_of(rounded.points(), mesher);
    const MeshForecast& mesh = rationed_ || thin_ ? both.flat : both.good;
    if (mesh.tetrahedra == 0) return;
    if (!options_.keep_boundary) require_possible(mesh, double(memory_of_machine()));  // else few may do
    if (std::isinf(mesh.most)) return;
    expected_ = mesh.tetrahedra;
    for_shapes_ = mesh.for_shapes;
    expected_most_ = mesh.most;
    const bool told = !trial_.fault.empty() && !bounded();  // with TetGen, and it is the same
    if (options_.foretold && !told) options_.foretold(mesh);
  }

  bool keeps_boundary() const { return options_.keep_boundary || surface_first_; }
  TooLarge asked_of_each() const {
    if (fills_) return {};
    return sized() && !thin_ ? too_large_ : has_to_be_split_;
  }
  bool bounded() const { return options_.quality > 0 || options_.max_volume > 0 || sized(); }

  TetgenSwitches switches() const {
    constexpr double kAny = 1e30;
    if (fills_) return {.keep_boundary = keeps_boundary()};
    if (thin_) return {.keep_boundary = keeps_boundary(), .quality = has_to_be_split_ ? kAny : 0};
    return {keeps_boundary(),
            options_.quality > 0 ? options_.quality
            : sized()            ? kSizedQuality
                                 : 0,
            options_.max_volume > 0};
  }

  /// For one way to ask it. There are models on which it never ends. To wait long for it to fill, or longer for a
  /// step of refinement, is of no use where there is another way to a mesh.
  TetgenBounds bounds_of_tetgen() const {
    const double clock = deadline_.seconds_left() / 3;  // so nearly a third is left after all ways to ask it
    const std::size_t most = options_.seconds ? 0 : kTetgenSteps;
    const std::size_t enough = kTetgenFills + kTetgenFillsPoint * plc_.points.size();
    if (keeps_boundary() && !bounded()) return {most, 0, clock};
    if (thin_ || fills_ || !bounded()) return {enough, 0, clock};
    const auto expected = std::size_t(double(kTetgenMakes) * expected_most_);
    return {most == 0 ? 0 : std::min(most, kTetgenFills + 10 * expected), enough + 2 * expected, clock};
  }

  /// In words, with its bound of time where it cannot say how far it is.
  std::string stage_of_tetgen(const TetgenBounds& bounds) const {
    std::string text = "mesh: TetGen";
    if (bounded() && !fills_ && expected_ > 0) return text;
    if (std::isfinite(bounds.clock) && bounds.clock > 0)
      text += ", at most " + std::to_string(std::llround(std::ceil(bounds.clock))) + " s";
    return text;
  }

  /// How far TetGen is where it refines: it looks at each tetrahedron that it makes, those around the model
  /// included. Measured on meshes of 1,500 to 480,000: 2.7 to 1.3 looks for each that stays. Nobody knows before
  /// what it will split, so that is no better than the forecast.
  LookedAt looked_at(const std::string& stage) const {
    if (!watch_.progress || expected_ == 0 || fills_) return {};
    const auto total = std::size_t(1.3 * std::pow(5e5 / expected_, 0.125) * expected_);
    return [this, &stage, total](std::size_t looks) {
      if (looks > 0) watch_.progress(stage, std::min(looks, total - total / 50), total);
    };
  }

  /// Without what features ask for by themselves.
  const MeshSizes& said_sizes(const RoundedResult& rounded) {
    if (!said_) said_ = mesh_sizes(view_, flat_, rounded.points(), {options_.size, options_.growth, false, true});
    return *said_;
  }

  /// The same by places in regions of the complex, which are those of the mesh in their order.
  WantedLength said_lengths(const RoundedResult& rounded) {
    return [this, &said = said_sizes(rounded)](const Vector& p, std::int32_t region) {
      return said.at(p, plc_.regions[std::size_t(region)].region);
    };
  }

  /// The triangles of surfaces as facets.
  Plc surface_complex(const RoundedResult& rounded) {
    SurfaceOptions asked;
    asked.watch = watch_;
    const SurfaceNarrow narrow = rationed_ ? SurfaceNarrow::left : SurfaceNarrow::rationed;
    if (sizes_.empty()) return refined_plc(flat_, rounded.points(), asked, {}, narrow);
    asked.size = [&](const Vector& p) { return kLongestEdge * sizes_.field.at(p); };
    const MeshSizes& said = said_sizes(rounded);
    return refined_plc(
        flat_, rounded.points(), asked, [&](const Vector& p) { return kLongestEdge * said.field.at(p); }, narrow);
  }

  /// Few need points on the boundary; with those that do it is not kept, and what TetGen said is thrown.
  void make_constrained(const RoundedResult& rounded, const std::string& refused) {
    plc_ = plc_of(view_, flat_, rounded, PlcFacets::triangles);
    watch_.begin("mesh: constrained tetrahedra");
    out_ = run_constrained(plc_, flat_, watch_);
    try {
      take(watch_);
    } catch (const InputError&) {
      if (options_.keep_boundary) throw InputError(refused);
      throw;
    }
  }

  /// Empty once there is a mesh; else why there is none.
  std::string ask_tetgen(const RoundedResult& rounded) {
    if (surface_first_ && surface_.facets.empty()) surface_ = surface_complex(rounded);
    // Each triangle has a tetrahedron: if there are more than were foretold, the surface is finer than the sizes
    // inside, which TetGen would refine for without an end.
    if (surface_first_ && sized() && options_.quality == 0 && options_.max_volume == 0 && expected_ > 0 &&
        !thin_ && double(surface_.facets.size()) > expected_)
      keep_flat();
    std::string refused = ask_in_all_ways(rounded);
    // Where it does not come to an end of refining, it may still fill. Where it stumbles, others do better, if
    // they may have points on the boundary.
    if (!refused.empty() && bounded() && !thin_ && (late_ || keeps_boundary())) {
      const std::string why = without_remedy(refused);
      fills_ = true;
      refused = ask_in_all_ways(rounded);
      fills_ = false;
      filled_ = refused.empty();
      if (filled_)
        flat_text_ = why + (options_.surface_first ? " with the triangles of the surface" : "") +
                     "; it has filled the regions, and the tetrahedra are improved";
    }
    if (options_.surface_first && !refused.empty())
      refused = without_remedy(refused) +
                "; leave out --surface-first, give other sizes, or join what nearly touches by --join";
    return refused;
  }
  std::string ask_in_all_ways(const RoundedResult& rounded) {
    std::string refused;
    for (const Attempt& attempt : kAttempts) {
      if (keeps_boundary() && attempt.facets == PlcFacets::all) continue;
      try {
        plc_ = surface_first_ ? surface_ : plc_of(view_, flat_, rounded, attempt.facets);
        plc_.max_volume = thin_ || fills_ ? 0 : options_.max_volume;
        set_seeds(plc_, rounded);
        const TetgenBounds bounds = bounds_of_tetgen();
        const std::string stage = stage_of_tetgen(bounds);
        watch_.begin(stage);
        out_ = run_tetgen(plc_, switches(), attempt.frame, bounds, asked_of_each(), watch_.stop, looked_at(stage));
        take(watch_);
        return {};
      } catch (const TetgenLate& e) {
        refused = e.what();
        late_ = bounded() && !thin_ && !fills_;
        if (late_ || attempt.facets == PlcFacets::planar) break;  // in another box it would take as long
      } catch (const InputError& e) {
        refused = e.what();
      } catch (const InvariantError& e) {  // the proof refuses what the mesher returns
        refused = std::string("the answer of TetGen is no mesh of the result (") + e.what() +
                  "); try --quality 2, curved leaves that are finer or coarser, or leave out --keep-boundary";
      }
    }
    return refused;
  }

  void improve_shapes(const RoundedResult& rounded) {
    ImproveOptions asked;
    asked.keep_boundary = keeps_boundary();
    if (bounded() && of_tetgen_) {  // moves for shapes alone might break bounds, which it has kept where it could
      asked.good = asked.shape;
    } else {
      asked.radius_edge = options_.quality;
      asked.volume = options_.max_volume;
    }
    if ((to_sizes_ || thin_) && !of_tetgen_)
      asked.most = kMostOfExpected * std::max(std::size_t(expected_), kFewTetrahedra);
    const std::size_t few = points_for_shapes(out_.points.size());
    asked.points = bounded() && (!thin_ || options_.quality > 0) ? kPointsForBounds : few;
    if (rationed_) asked.narrow_points = few;
    if (deadline_.bounded()) asked.seconds = std::max(1e-3, deadline_.seconds_left());
    else if (!options_.seconds) asked.steps = kStepsOfShapes;
    asked.afterwards = deadline_.bounded() ? afterwards_ : 0;
    // Beside triangles that stay and are too long halves would become ever more, and none of them short enough.
    if (sized() && !keeps_boundary()) asked.longest = said_lengths(rounded);
    if (to_sizes_) {
      asked.size = [this](const Vector& p) { return sizes_.field.at(p); };
      for (const Plc::Seed& region : plc_.regions) {
        if (!sizes_.regions.empty()) asked.region_size.push_back(sizes_.regions[region.region]);
      }
    }
    // There is a mesh: when time is over it is proven and kept as it is then.
    Improved end = Improved::done;
    out_ = improved(plc_, flat_, out_, asked, deadline_.asked(), &end);
    take(deadline_.asked());
    if (!sized()) asked.size = {};
    if (end != Improved::done) tell(unfinished_text(asked, end));
  }

  /// One more thing that the user should know.
  void tell(const std::string& text) {
    if (!text.empty()) result_.notice += (result_.notice.empty() ? "" : "; ") + text;
  }

  /// What stays bad since nobody has asked for more.
  void tell_rationed() {
    if (bounded() || for_shapes_ == 0 || result_.quality.bad == 0) return;
    tell("shapes above 0.1 everywhere would take " + count_text(for_shapes_) +
         " tetrahedra, since some parts are very thin; where no --quality is asked for, the points that are added "
         "for shapes are 2,000 and four for each point of the model at most");
  }

  /// What is larger than asked for. Without new points on the boundary there may be no way to halve it.
  void tell_larger(const RoundedResult& rounded) {
    const bool kept = options_.keep_boundary || options_.surface_first;
    const std::string why = kept
                                ? ": without new points on faces and edges they are not divided; leave out " +
                                      std::string(options_.keep_boundary ? "--keep-boundary" : "--surface-first") +
                                      ", or ask for larger ones"
                                : "";
    const std::string text = larger_text(result_.quality);
    if (!text.empty()) return tell(text + why);
    if (!sized()) return;
    // What features ask for they do by themselves.
    const WantedLength said = said_lengths(rounded);
    const auto n = std::ranges::count_if(mesh().tetrahedra, [&, &p = mesh().points](const auto& t) {
      const auto& [a, b, c, d] = t.points;
      return is_too_long(p[a], p[b], p[c], p[d], std::int32_t(t.entity), said);
    });
    if (n == 0) return;
    tell(counted(std::size_t(n), "tetrahedron has", "tetrahedra have") +
         " an edge of more than 1.4 times the size that is asked for" + why);
  }

  /// What the mesher returns, once it is proven.
  void take(const Watch& watch) {
    const auto begin = std::chrono::steady_clock::now();
    watch.begin("mesh: proof");
    const KeptBoundary kept = surface_first_           ? KeptBoundary::facets
                              : options_.keep_boundary ? KeptBoundary::points
                                                       : KeptBoundary::no;
    ProvenMesh proven = proven_mesh(view_, flat_, plc_, out_, kept, watch);
    result_.mesh = std::move(proven.mesh);
    result_.regions = std::move(proven.regions);
    // What is improved is proven once more, measured and written.
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    constexpr double kMost = 6e-6;  // small meshes say little of large ones
    afterwards_ = std::min(kMost, 2 * took.count() / double(std::max<std::size_t>(out_.tetrahedra.size(), 1)));
  }
};

}  // namespace

std::vector<std::size_t> listed_regions(const TetrahedralMesh& made) {
  std::vector<std::size_t> order(made.regions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return listed_before(made.regions[a].name, made.regions[b].name);
  });
  return order;
}

TetrahedralMesh tetrahedra(const ResultView& view, const TetrahedraOptions& options, const Deadline& deadline,
                           const TetgenTrial& trial) {
  return TetrahedraMaker(view, options, deadline, trial).run();
}

TetrahedralMesh tetrahedra(const ResultView& view, const TetrahedraOptions& options) {
  const Deadline deadline(options.watch, options.seconds.value_or(0));
  return deadline.run([&] { return tetrahedra(view, options, deadline); });
}

}  // namespace cnrg
