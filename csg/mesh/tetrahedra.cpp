// The driver of a mesh: a plan (mesh_plan.h), then a mesher, then better shapes.
//
// TetGen is asked in several ways (kAttempts) until its answer is proven to be a mesh of the result
// (proven_mesh.h). Where all of them fail, exact tetrahedra are made that are bound to conform
// (constrained_run.h). Moves that keep this improve the mesh (improved.h), and it is proven once more.
#include "csg/mesh/tetrahedra.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "csg/mesh/constrained_run.h"
#include "csg/mesh/improved.h"
#include "csg/mesh/mesh_plan.h"
#include "csg/mesh/planar_facets.h"
#include "csg/mesh/proven_mesh.h"
#include "csg/result/file_numbers.h"
#include "csg/result/solid.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "kernel/base/vectors.h"
#include "kernel/tetrahedra/bounds.h"

namespace cnrg {
namespace {

using Vector = std::array<double, 3>;

/// What TetGen is asked for: a mesh within all bounds, or, since it does not come to an end of refining, any.
enum class TetgenTask : std::uint8_t { refine, fill };

/// The mesher, and what is left to be done for its mesh.
enum class MadeBy : std::uint8_t {
  tetgen,         ///< within all bounds
  tetgen_filled,  ///< the improver makes the sizes
  constrained,    ///< the same
};

/// A way to ask TetGen. Whole facets it may triangulate as it likes, which gives better tetrahedra; but rounding
/// has moved their points off the plane, and now and then TetGen stumbles over that. Our triangles are planar, and
/// keep volumes exact. Where both fail, a less regular box about the model has helped.
struct Attempt {
  PlcFacets facets;
  TetgenFrame frame;
};
constexpr Attempt kAttempts[] = {{PlcFacets::all, TetgenFrame::even},
                                 {PlcFacets::planar, TetgenFrame::even},
                                 {PlcFacets::planar, TetgenFrame::uneven}};

/// So many times as many tetrahedra as are expected, or as are few, are made at most.
constexpr std::size_t kMostOfExpected = 8, kFewTetrahedra = 60'000;
/// Steps of TetGen, in all where there is another way to a mesh; to fill, and more for each point; for each
/// tetrahedron that is expected.
constexpr std::size_t kTetgenSteps = 500'000'000, kTetgenFills = 20'000'000, kTetgenFillsPoint = 2'000,
                      kTetgenMakes = 10;
/// Of the improver.
constexpr std::size_t kStepsOfShapes = 200'000'000;
/// Points that are added at most to keep bounds that are asked for.
constexpr std::size_t kPointsForBounds = 3'000'000;

void require_meshable(const FlatComplex& flat, const TetrahedraOptions& options) {
  require_closed_and_bounded(flat, "a mesh of tetrahedra");
  const bool solid = std::any_of(flat.regions.begin(), flat.regions.end(),
                                 [](const auto& region) { return region.component != 0; });
  if (!solid) {
    throw InputError(
        "the result has no region to fill with tetrahedra; `cnrg mesh --surface` writes triangles and lines, "
        "and `cnrg eval -o` its faces, wires and points");
  }
  if (options.constrained && options.keep_boundary)
    throw InputError("constrained tetrahedra need points on the boundary; leave out --keep-boundary");
  if (options.surface_first && (options.keep_boundary || options.constrained))
    throw InputError("a boundary that is meshed first is neither that of --keep-boundary nor of --constrained");
}

class TetrahedralMesher {
 public:
  TetrahedralMesher(const ResultView& view, const FlatComplex& flat, const RoundedResult& rounded,
                    const TetrahedraOptions& options, const Deadline& deadline, const TetgenTrial& trial)
      : view_(view),
        flat_(flat),
        rounded_(rounded),
        options_(options),
        deadline_(deadline),
        watch_(deadline.watch()),
        plan_(view, flat, rounded, options, deadline, trial) {
    std::string filled;  // why TetGen was not asked to refine in the end
    const std::string refused = plan_.asks_tetgen() ? ask_tetgen(filled) : trial.fault;
    if (trial.only && !refused.empty()) throw TetgenFault(refused);
    const bool constrained = options_.constrained || !refused.empty();
    const MadeBy made = constrained      ? MadeBy::constrained
                        : filled.empty() ? MadeBy::tetgen
                                         : MadeBy::tetgen_filled;
    if (plan_.asks_tetgen() && plan_.bounded() && made != MadeBy::tetgen) plan_.give_to_own_mesher();
    if (made == MadeBy::constrained) make_constrained(refused);
    // TetGen had to keep it, halves need not.
    if (plan_.leaves_flat() && !plan_.sized()) plan_.mesh_surface_as_asked();
    tell(filled.empty() ? plan_.flat_text() : filled);
    if (!plan_.foretold())
      tell("how many tetrahedra there would be was not counted, to leave the time for the mesh");
    improve_shapes(made);
    result_.rounding = rounded.report();
    result_.expected = plan_.expected().tetrahedra;
    number_points(result_.mesh, flat_, out_.points);
    result_.quality = quality_of(result_.mesh, leaf_names(*view_.leaves), options_.quality, options_.max_volume);
    tell_rationed();
    tell_larger();
  }

  TetrahedralMesh result() { return std::move(result_); }

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  const RoundedResult& rounded_;
  const TetrahedraOptions& options_;
  const Deadline& deadline_;
  const Watch& watch_;  // of the deadline
  MeshPlan plan_;
  Plc plc_;
  PlcMesh out_;
  TetrahedralMesh result_;
  double afterwards_ = 0;  // seconds that are kept for what follows the improver, for each tetrahedron

  /// Empty once there is a mesh; else why there is none. `filled`: empty, or why TetGen has only filled the
  /// regions.
  std::string ask_tetgen(std::string& filled) {
    if (plan_.surface_first()) plan_.surface();
    bool late = false;  // it has not come to an end of refining
    std::string refused = ask_in_all_ways(TetgenTask::refine, late);
    // Then it may still fill. Where it stumbles, others do better, if they may have points on the boundary.
    if (!refused.empty() && plan_.bounded() && !plan_.leaves_flat() && (late || plan_.keeps_boundary())) {
      const std::string why = without_remedy(refused);
      refused = ask_in_all_ways(TetgenTask::fill, late);
      if (refused.empty())
        filled = why + (options_.surface_first ? " with the triangles of the surface" : "") +
                 "; it has filled the regions, and the tetrahedra are improved";
    }
    if (options_.surface_first && !refused.empty())
      refused = without_remedy(refused) + "; leave out " + boundary_option() +
                ", give other sizes, or join what nearly touches by --join";
    return refused;
  }
  std::string ask_in_all_ways(TetgenTask task, bool& late) {
    const bool fills = task == TetgenTask::fill;
    std::string refused;
    for (const Attempt& attempt : kAttempts) {
      if (plan_.keeps_boundary() && attempt.facets == PlcFacets::all) continue;
      try {
        plc_ = plan_.surface_first() ? plan_.surface() : plc_of(view_, flat_, rounded_, attempt.facets);
        plc_.max_volume = plan_.leaves_flat() || fills ? 0 : options_.max_volume;
        set_seeds(plc_, rounded_);
        const TetgenBounds bounds = bounds_of_tetgen(task);
        const std::string stage = stage_of_tetgen(task, bounds);
        watch_.begin(stage);
        out_ = run_tetgen(plc_, fills ? TetgenSwitches{.keep_boundary = plan_.keeps_boundary()} : plan_.switches(),
                          attempt.frame, bounds, fills ? TooLarge() : plan_.split_by_tetgen(), watch_.stop,
                          looked_at(task, stage));
        take(watch_);
        return {};
      } catch (const TetgenLate& e) {
        refused = e.what();
        late = plan_.bounded() && !plan_.leaves_flat() && !fills;
        if (late || attempt.facets == PlcFacets::planar) break;  // in another box it would take as long
      } catch (const InputError& e) {
        refused = e.what();
      } catch (const InvariantError& e) {  // the proof refuses what the mesher returns
        refused = std::string("the answer of TetGen is no mesh of the result (") + e.what() +
                  "); try --quality 2, curved leaves that are finer or coarser, or leave out --keep-boundary";
      }
    }
    return refused;
  }

  /// For one way to ask it. There are models on which it never ends. To wait long for it to fill, or longer for a
  /// step of refinement, is of no use where there is another way to a mesh.
  TetgenBounds bounds_of_tetgen(TetgenTask task) const {
    const double clock = deadline_.seconds_left() / 3;  // so nearly a third is left after all ways to ask it
    const std::size_t most = options_.seconds ? 0 : kTetgenSteps;
    const std::size_t enough = kTetgenFills + kTetgenFillsPoint * plc_.points.size();
    if (plan_.keeps_boundary() && !plan_.bounded()) return {most, 0, clock};
    if (plan_.leaves_flat() || task == TetgenTask::fill || !plan_.bounded()) return {enough, 0, clock};
    const auto expected = std::size_t(double(kTetgenMakes) * plan_.expected().most);
    return {most == 0 ? 0 : std::min(most, kTetgenFills + 10 * expected), enough + 2 * expected, clock};
  }

  /// In words, with its bound of time where it cannot say how far it is.
  std::string stage_of_tetgen(TetgenTask task, const TetgenBounds& bounds) const {
    std::string text = "mesh: TetGen";
    if (plan_.bounded() && task == TetgenTask::refine && plan_.expected().tetrahedra > 0) return text;
    if (std::isfinite(bounds.clock) && bounds.clock > 0)
      text += ", at most " + std::to_string(std::llround(std::ceil(bounds.clock))) + " s";
    return text;
  }

  /// How far TetGen is where it refines: it looks at each tetrahedron that it makes, those around the model
  /// included. Measured on meshes of 1,500 to 480,000: 2.7 to 1.3 looks for each that stays. Nobody knows before
  /// what it will split, so that is no better than the forecast.
  LookedAt looked_at(TetgenTask task, const std::string& stage) const {
    const double expected = plan_.expected().tetrahedra;
    if (!watch_.progress || expected == 0 || task == TetgenTask::fill) return {};
    const auto total = std::size_t(1.3 * std::pow(5e5 / expected, 0.125) * expected);
    return [this, &stage, total](std::size_t looks) {
      if (looks > 0) watch_.progress(stage, std::min(looks, total - total / 50), total);
    };
  }

  /// `refused`: empty, or why TetGen has made no mesh.
  void make_constrained(const std::string& refused) {
    plan_.mesh_surface_as_asked();
    if (options_.surface_first) throw InputError(refused);
    plc_ = plc_of(view_, flat_, rounded_, PlcFacets::triangles);
    watch_.begin("mesh: constrained tetrahedra");
    out_ = run_constrained(plc_, flat_, watch_);
    try {
      take(watch_);
    } catch (const InputError&) {
      // Few need points on the boundary; with those that do it is not kept.
      if (options_.keep_boundary) throw InputError(refused);
      throw;
    }
    if (!refused.empty())  // without its advice
      result_.notice = without_remedy(refused) + "; these are constrained tetrahedra, improved";
  }

  /// Does the improver make lengths, since the mesher has not?
  bool improves_sizes(MadeBy made) const {
    if (plan_.leaves_flat()) return plan_.sized();
    if (made == MadeBy::tetgen_filled)
      return !plan_.sizes().empty() && !options_.keep_boundary;  // else flat halves
    return made == MadeBy::constrained && !plan_.sizes().empty() && !options_.keep_boundary;
  }

  /// By places in regions of the complex, which are those of the mesh in their order.
  WantedLength said_lengths() {
    return [this, &said = plan_.said_sizes()](const Vector& p, std::int32_t region) {
      return said.at(p, plc_.regions[std::size_t(region)].region);
    };
  }

  void improve_shapes(MadeBy made) {
    const bool kept_bounds = made == MadeBy::tetgen && !plan_.leaves_flat();
    const bool to_sizes = improves_sizes(made);
    ImproveOptions asked;
    asked.keep_boundary = plan_.keeps_boundary();
    if (plan_.bounded() && kept_bounds) {  // moves for shapes alone might break bounds that TetGen has kept
      asked.good = asked.shape;
    } else {
      asked.radius_edge = options_.quality;
      asked.volume = options_.max_volume;
    }
    if ((to_sizes || plan_.leaves_flat()) && !kept_bounds)
      asked.most = kMostOfExpected * std::max(std::size_t(plan_.expected().tetrahedra), kFewTetrahedra);
    const std::size_t few = points_for_shapes(out_.points.size());
    asked.points = plan_.bounded() && (!plan_.leaves_flat() || options_.quality > 0) ? kPointsForBounds : few;
    if (plan_.rationed()) asked.narrow_points = few;
    if (deadline_.bounded()) asked.seconds = std::max(1e-3, deadline_.seconds_left());
    else if (!options_.seconds) asked.steps = kStepsOfShapes;
    asked.afterwards = deadline_.bounded() ? afterwards_ : 0;
    // Beside triangles that stay and are too long halves would become ever more, and none of them short enough.
    if (plan_.sized() && !plan_.keeps_boundary()) asked.longest = said_lengths();
    if (to_sizes) {
      const MeshSizes& sizes = plan_.sizes();
      asked.size = [&sizes](const Vector& p) { return sizes.field.at(p); };
      if (!sizes.regions.empty())
        for (const Plc::Seed& region : plc_.regions) asked.region_size.push_back(sizes.regions[region.region]);
    }
    // There is a mesh: when time is over it is proven and kept as it is then.
    Improved end = Improved::done;
    out_ = improved(plc_, flat_, out_, asked, deadline_.asked(), &end);
    take(deadline_.asked());
    if (!plan_.sized()) asked.size = {};
    if (end != Improved::done) tell(unfinished_text(asked, end));
  }

  /// One more thing that the user should know.
  void tell(const std::string& text) {
    if (!text.empty()) result_.notice += (result_.notice.empty() ? "" : "; ") + text;
  }

  /// What stays bad since nobody has asked for more.
  void tell_rationed() {
    const double for_shapes = plan_.expected().for_shapes;
    if (plan_.bounded() || for_shapes == 0 || result_.quality.bad == 0) return;
    tell("shapes above 0.1 everywhere would take " + count_text(for_shapes) +
         " tetrahedra, since some parts are very thin; where no --quality is asked for, the points that are added "
         "for shapes are 2,000 and four for each point of the model at most");
  }

  /// What is larger than asked for. Without new points on the boundary there may be no way to halve it.
  void tell_larger() {
    const bool kept = options_.keep_boundary || options_.surface_first;
    const std::string why = kept ? ": without new points on faces and edges they are not divided; leave out " +
                                       boundary_option() + ", or ask for larger ones"
                                 : "";
    const std::string text = larger_text(result_.quality);
    if (!text.empty()) return tell(text + why);
    if (!plan_.sized()) return;
    // What features ask for they do by themselves.
    const WantedLength said = said_lengths();
    const auto n = std::ranges::count_if(result_.mesh.tetrahedra, [&, &p = result_.mesh.points](const auto& t) {
      const auto& [a, b, c, d] = t.points;
      return is_too_long(p[a], p[b], p[c], p[d], std::int32_t(t.entity), said);
    });
    if (n == 0) return;
    tell(counted(std::size_t(n), "tetrahedron has", "tetrahedra have") +
         " an edge of more than 1.4 times the size that is asked for" + why);
  }

  /// Who asks for a boundary that stays.
  std::string boundary_option() const {
    return options_.keep_boundary                ? "--keep-boundary"
           : options_.periodic != PeriodicAxes{} ? "--periodic"
                                                 : "--surface-first";
  }

  /// What the mesher returns, once it is proven.
  void take(const Watch& watch) {
    const auto begin = std::chrono::steady_clock::now();
    watch.begin("mesh: proof");
    const KeptBoundary kept = plan_.surface_first()    ? KeptBoundary::facets
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
  const bool known = options.constrained || !trial.fault.empty() || plugin_fault(kTetgenPlugin).empty();
  const TetgenTrial of_plugin = known ? trial : TetgenTrial{false, plugin_fault(kTetgenPlugin)};
  const FlatComplex flat = flatten_for_mesh(view);
  require_meshable(flat, options);
  deadline.watch().begin("mesh: rounding");
  const RoundedResult rounded(view, flat, "a mesh of tetrahedra", deadline.watch().stop);
  return TetrahedralMesher(view, flat, rounded, options, deadline, of_plugin).result();
}

TetrahedralMesh tetrahedra(const ResultView& view, const TetrahedraOptions& options) {
  const Deadline deadline(options.watch, options.seconds.value_or(0));
  return deadline.run([&] { return tetrahedra(view, options, deadline); });
}

}  // namespace cnrg
