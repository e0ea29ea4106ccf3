// The ways to a mesh are a list (kMeshAttempts): each is made only if all before it have failed, and what one
// makes is proven before it counts (tetrahedra.h, surface_triangles.h).
#include "csg/mesh/mesh_of_result.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include "csg/mesh/curved_mesh.h"
#include "csg/mesh/material_field.h"
#include "csg/mesh/periodic.h"
#include "csg/mesh/reach.h"
#include "csg/mesh/straight_order.h"
#include "csg/result/join.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/vanished.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "kernel/tetrahedra/constrained.h"

namespace cnrg {
namespace {

/// As a part of work that has a deadline.
TetrahedralMesh tetrahedra_in_time(const Result& result, const TetrahedraOptions& options,
                                   const Deadline& deadline, const TetgenTrial& trial = {}) {
  const ResultView view = result.data().view();
  TetrahedralMesh made = tetrahedra(view, options, deadline, trial);
  sample_materials(view, made.mesh);
  add_properties(view, made.mesh);
  if (options.order == 2) add_straight_middles(made.mesh);
  return made;
}

/// What `make` makes of a result, or of the snapped one where rounding would break it.
template <class Make>
auto snapped_if_broken(Result& result, SnapReport& report, const Watch& watch, const Make& make) {
  try {
    return make();
  } catch (const RoundingFault&) {
    result = snap(result, &report, watch);
  }
  return make();
}

/// The longest side of the box around a result.
Rational extent_of(const Result& result) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view, Flattening::shapes);
  return from_double(Reach(round_points(view, flat).xyz).longest_side());
}

/// A result, and what is made of it in doubles: as it is, or with joined what is near.
template <class Made>
class MadeOfDoubles {
 public:
  MadeOfDoubles(Result& result, SnapReport& report, const Watch& watch)
      : result_(result), exact_(result), whole_(result), report_(report), watch_(watch) {}

  template <class Make>
  Made as_it_is(const Make& make) {
    result_ = whole_;
    report_ = snapped_;
    try {
      return snapped_if_broken(result_, report_, watch_, make);
    } catch (const InputError&) {  // it need not be snapped once more
      whole_ = result_;
      snapped_ = report_;
      throw;
    }
  }
  /// What the user may join himself, since it was not to be joined unasked; empty: nothing.
  std::string advice() const {
    const auto refused = std::ranges::find_if(joined_, [](const Joined& j) { return j.report.refused; });
    if (refused == joined_.end()) return {};
    const std::string d = decimal(to_double(refused->within), "%.2g");
    return "features nearer than " + d +
           " were not joined, since that would take a region or a wire away, or be hundreds; --join " + d +
           " does it and names what vanishes";
  }
  /// Nothing if nothing was so near, or was joined. `part`: of the extent; `before`: how it was without that, for
  /// the notice.
  template <class Make>
  std::optional<Made> joined(double part, Joins joins, const std::string& before, const Make& make) {
    const Joined& joined = joined_by(part, joins);
    if (joined.report.rounds == 0) return {};
    result_ = joined.result;
    report_ = {};
    Made made = snapped_if_broken(result_, report_, watch_, make);
    const std::string text =
        (before.empty() ? "" : before + " without that: ") + joined.report.text(joined.within);
    made.notice = text + (made.notice.empty() ? "" : "; ") + made.notice;
    made.warnings = vanished_warnings(joined.report.lost_regions, to_decimal(joined.within, 6));
    return made;
  }

 private:
  Result& result_;
  const Result exact_;
  Result whole_;  // exact, or snapped
  SnapReport snapped_;
  SnapReport& report_;
  const Watch& watch_;

  struct Joined {
    double part;
    Joins joins;
    Rational within;
    JoinReport report{};
    Result result;
  };
  std::vector<Joined> joined_;

  const Joined& joined_by(double part, Joins joins) {
    for (const Joined& known : joined_) {
      if (known.part == part && known.joins == joins) return known;
    }
    Joined joined{part, joins, extent_of(exact_) * from_double(part), {}, exact_};
    joined.result = join(exact_, joined.within, &joined.report, watch_, joins);
    return joined_.emplace_back(std::move(joined));
  }
};

/// TetGen; others, where it has failed; or others in any case.
enum class MeshedBy : std::uint8_t { tetgen, others_after_tetgen, others };

/// A way to tetrahedra, tried where all before it have failed.
struct MeshAttempt {
  MeshedBy by;
  double part = 0;  ///< of the extent: what is nearer is joined first; 0: nothing is
  Joins joins = Joins::harmless;
  bool foretells = false;  ///< its tetrahedra are foretold
};

/// TetGen stumbles over what is some of the last digits apart: nobody draws that, and it is joined where that
/// takes nothing away. Constrained tetrahedra are made of that, too, for what is so near makes bad shapes. Where
/// there are none in doubles more and more is joined, but not more than somebody who draws by hand would see.
constexpr double kLastDigits = 0x1p-40, kMoreDigits = 0x1p-32;
constexpr MeshAttempt kMeshAttempts[] = {{MeshedBy::tetgen, 0, Joins::harmless, true},
                                         {MeshedBy::tetgen, kLastDigits},
                                         {MeshedBy::tetgen, kMoreDigits},
                                         {MeshedBy::others_after_tetgen, kMoreDigits, Joins::harmless, true},
                                         {MeshedBy::others_after_tetgen, kLastDigits, Joins::harmless, true},
                                         {MeshedBy::others, 0, Joins::harmless, true},
                                         {MeshedBy::others, kLastDigits, Joins::all},
                                         {MeshedBy::others, kMoreDigits, Joins::all},
                                         {MeshedBy::others, 0x1p-24, Joins::all},
                                         {MeshedBy::others, 0x1p-16, Joins::all}};

TetrahedralMesh snapped_in_time(Result& result, const TetrahedraOptions& asked, SnapReport& report,
                                const Deadline& deadline) {
  MadeOfDoubles<TetrahedralMesh> made_of(result, report, deadline.watch());
  const bool has_tetgen = !asked.constrained && plugin_fault(kTetgenPlugin).empty();
  std::string fault;        // of TetGen with the result as it is
  std::exception_ptr near;  // of others with the same
  for (const MeshAttempt& attempt : kMeshAttempts) {
    if (attempt.by != MeshedBy::others && !has_tetgen) continue;
    const bool by_tetgen = attempt.by == MeshedBy::tetgen;
    TetrahedraOptions options = asked;
    if (!attempt.foretells) options.foretold = {};
    const auto make = [&] {
      return tetrahedra_in_time(result, options, deadline, {by_tetgen, by_tetgen ? std::string() : fault});
    };
    try {
      if (attempt.part > 0) {
        const std::string before = by_tetgen                     ? without_remedy(fault)
                                   : attempt.joins == Joins::all ? "there were no tetrahedra in doubles"
                                                                 : "";
        if (auto made = made_of.joined(attempt.part, attempt.joins, before, make)) return std::move(*made);
        continue;
      }
      TetrahedralMesh made = made_of.as_it_is(make);
      if (const std::string advice = made_of.advice(); made.quality.bad > 0 && !advice.empty())
        made.notice += "; " + advice;
      return made;
    } catch (const TetgenFault& e) {
      if (fault.empty()) fault = e.what();
    } catch (const NearFault& e) {
      if (by_tetgen && fault.empty()) fault = e.what();
      if (attempt.by == MeshedBy::others && attempt.part == 0) near = std::current_exception();
    }
  }
  std::rethrow_exception(near);
}

void bend(const Result& result, TetrahedralMesh& made, const Watch& watch) {
  const ResultView view = result.data().view(true);
  if (view.parameters == nullptr) {
    throw InputError("the result knows nothing of its true surfaces; mesh one that was not snapped");
  }
  made.bent = curve(view, made, watch);
  made.mesh.fields.clear();
  sample_materials(view, made.mesh);
}

/// Says that a mesh repeats, once that is proven.
void repeat(Mesh& mesh, const PeriodicAxes& periodic) {
  mesh.periodic = periodic;
  periodic_links(mesh), periodic_nodes(mesh);
}

/// The straight mesh that `make` makes, curved and split as asked for; names to split are looked for before.
template <class Make>
TetrahedralMesh finished(const Result& result, TetrahedraOptions options, const Make& make) {
  if (!options.split.empty()) {
    const ResultView view = result.data().view();
    require_groups(mesh_groups(view, flatten(view)).names[2], options.split);
  }
  if (options.periodic != PeriodicAxes{}) {
    if (options.curved || !options.split.empty())
      throw InputError("a mesh with opposite sides alike is neither curved nor split; leave out --periodic");
    options.surface_first = true;
  }
  if (options.curved) options.order = 1;
  if (options.curved && options.quality == 0) options.quality = kCurvedQuality;
  const Deadline deadline(options.watch, options.seconds.value_or(0));
  TetrahedralMesh made = deadline.run([&] { return make(options, deadline); });
  if (options.curved) bend(result, made, options.watch);
  if (!options.split.empty()) made.parted = split(made.mesh, options.split, options.interfaces);
  repeat(made.mesh, options.periodic);
  return made;
}

}  // namespace

TetrahedralMesh tetrahedra(const Result& result, const TetrahedraOptions& options) {
  return finished(result, options, [&](const TetrahedraOptions& asked, const Deadline& deadline) {
    return tetrahedra_in_time(result, asked, deadline);
  });
}

TetrahedralMesh snapped_tetrahedra(Result& result, const TetrahedraOptions& options, SnapReport& report) {
  if (options.curved) return tetrahedra(result, options);
  return finished(result, options, [&](const TetrahedraOptions& asked, const Deadline& deadline) {
    return snapped_in_time(result, asked, report, deadline);
  });
}

SurfaceTriangles surface_triangles(const Result& result, const SurfaceOptions& options) {
  const ResultView view = result.data().view();
  SurfaceTriangles made = surface_triangles(view, options);
  add_properties(view, made.mesh);
  if (options.order == 2) add_straight_middles(made.mesh);
  repeat(made.mesh, options.periodic);
  return made;
}

SurfaceTriangles snapped_surface_triangles(Result& result, const SurfaceOptions& options, SnapReport& report) {
  const Deadline deadline(options.watch, options.seconds, "--size");
  SurfaceOptions bound = options;
  bound.watch = deadline.watch();
  bound.seconds = 0;  // the watch knows
  return deadline.run([&] {
    MadeOfDoubles<SurfaceTriangles> made_of(result, report, bound.watch);
    const auto make = [&] { return surface_triangles(result, bound); };
    std::exception_ptr near;
    std::string words;
    try {
      return made_of.as_it_is(make);
    } catch (const NearFault& fault) {
      near = std::current_exception();
      words = fault.what();
    }
    if (auto made = made_of.joined(kLastDigits, Joins::harmless, without_remedy(words), make))
      return std::move(*made);
    std::rethrow_exception(near);
  });
}

}  // namespace cnrg
