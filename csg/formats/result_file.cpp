// The extension decides: .dot is a graph, every other format gets the result as writers see it (ResultView).
// A .json is read back as a tree would read it: as a leaf, alone in a complex of its own.
#include "csg/formats/result_file.h"

#include <array>
#include <exception>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "csg/exports/cad_text.h"
#include "csg/formats/dag_graph.h"
#include "csg/formats/formats.h"
#include "csg/formats/mesh_file.h"
#include "csg/formats/writer.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/mesh/material_field.h"
#include "csg/mesh/straight_order.h"
#include "csg/result/join.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/vanished.h"
#include "csg/text/file.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "csg/topology/region_graph.h"
#include "csg/transfer/leaf_value.h"
#include "kernel/selection/canonical.h"
#include "kernel/tetrahedra/constrained.h"

namespace cnrg {
namespace {

bool shows_regions(const std::string& path) {
  return extension_of(path) == ".dot" && extension_of(path.substr(0, path.size() - 4)) == ".regions";
}

struct MeshFormat {
  std::string_view extension;
  bool second_order;
  bool quads;
  std::string (*make)(const std::string& path, const ResultView& view, const Mesh& mesh);
};

template <std::string (*text)(const Mesh&)>
std::string make(const std::string&, const ResultView&, const Mesh& mesh) {
  return text(mesh);
}

constexpr std::array<MeshFormat, 8> kMeshFormats{
    {{".msh", true, true, make<msh_text>},
     {".mesh", false, true, make<medit_text>},
     {".vtu", true, true,
      [](const std::string&, const ResultView& view, const Mesh& mesh) { return vtu_text(view, mesh); }},
     {".inp", true, true, make<abaqus_text>},
     {".bdf", true, true, make<nastran_text>},
     {".h5m", false, false, make<h5m_bytes>},
     {".med", true, true, make<med_bytes>},
     {".xdmf", true, true,
      [](const std::string& path, const ResultView&, const Mesh& mesh) { return xdmf_text(path, mesh); }}}};

/// Each with a space before it.
std::string known_mesh_formats(bool second_order, bool quads = false) {
  std::string known;
  for (const MeshFormat& format : kMeshFormats) {
    if ((format.second_order || !second_order) && (format.quads || !quads))
      known += " " + std::string(format.extension);
  }
  return known;
}

const MeshFormat& mesh_format_of(const std::string& path, const std::string& others = {}) {
  const std::string extension = extension_of(path);
  for (const MeshFormat& format : kMeshFormats) {
    if (format.extension == extension) return format;
  }
  const bool surface = extension == ".smesh" || extension == ".poly";
  throw InputError(path +
                   (surface ? ": this format holds faces and no tetrahedra; `cnrg eval -o` writes it"
                            : ": no writer of tetrahedra for the extension `" + extension + "`") +
                   "; use one of" + known_mesh_formats(false) + others);
}

/// Before the work.
void require_plugin_of(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".step" || extension == ".stp" || extension == ".brep")
    require_plugin(kCadPlugin, path, "write .msh or .json");
  if (extension == ".h5m" || extension == ".med") require_plugin(kHdf5Plugin, path, "write .msh or .vtu");
}

}  // namespace

bool shows_dag(const std::string& path) { return extension_of(path) == ".dot" && !shows_regions(path); }

void check_file_name(const std::string& path, const std::string& others) {
  require_no_directory(path);
  if (extension_of(path) == ".dot") return;
  try {
    check_extension(path);
  } catch (const InputError& e) {
    throw InputError(std::string(e.what()) + " .dot .regions.dot" + others);
  }
  require_plugin_of(path);
}

bool is_exact(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".json" || extension == ".dot";
}

void check_binary_file_name(const std::string& path) { check_binary(path); }

FileReport write(const std::string& path, const Result& result, const FileOptions& options) {
  FileReport report;
  if (shows_regions(path)) {
    replace_file(path, region_graph(result.cells(), result.data().value->attributes()).dot(), options.stop);
    return report;
  }
  // A snapped result has lost the surfaces to which CAD models bring their vertices.
  const bool snaps = options.snap && !is_cad_file(path) && !(options.parameters && extension_of(path) == ".vtu");
  FileText file;
  bool broken = false;
  try {
    file = file_text(path, result.data().view(options.parameters || shows_surfaces(path)), options.binary);
    broken = !file.rounding.embedded;
  } catch (const RoundingFault&) {
    if (!snaps) throw;
    broken = true;
  }
  if (broken && snaps) {
    SnappedResultOnce once;
    SnappedResultOnce& snapped = options.snapped != nullptr ? *options.snapped : once;
    if (!snapped.result) snapped.result = snap(result, &snapped.report);
    file = file_text(path, snapped.result->data().view(), options.binary);
    report.snapped = snapped.report;
  }
  replace_file(path, file.text, options.stop);
  static_cast<RoundingReport&>(report) = std::move(file.rounding);
  return report;
}

void write(const std::string& path, const Evaluation& evaluation) {
  if (!shows_dag(path)) throw InputError(path + ": the DAG of an evaluation is written as .dot");
  replace_file(path, dag_dot(evaluation));
}

namespace {

/// The value of a leaf that has one, on a complex of its own.
Result result_of_leaf(const std::shared_ptr<const PreparedLeaf>& leaf, ResultNames names) {
  RefineOptions options;
  options.vertices = true;
  RefineReport report;
  const std::shared_ptr<const Complex> complex = build_complex(make_soup({{leaf}}), options, &report);
  const CellMap map(*complex, {part_of(LeafId(0), *leaf->stored(), report.vertex_of)});
  const auto data = std::make_shared<Result::Data>();
  data->complex = complex;
  const auto value = std::make_shared<const NodeValue>(leaf_value(
      *complex, LeafId(0), leaf_groups(*complex).front(), *leaf->stored(), map, leaf->regions(), std::identity()));
  data->value = value;
  SimplifiedComplex simplified = simplify(*complex, *value, selection_of(*complex, *value));
  put_in_order(*complex, simplified);
  data->simplified = std::make_shared<const SimplifiedComplex>(std::move(simplified));
  data->name(std::move(names));
  data->volume_bound = [bound = leaf->volume_bound()] { return bound; };
  return Result(data);
}

}  // namespace

Result read_result(const std::string& path) {
  return result_of_leaf(prepare(ResultShape{path}), {.result = path, .leaves = {path}});
}

Result result_of_text(const std::string& json, ResultNames names) {
  return result_of_leaf(prepare_result(json, names.result), std::move(names));
}

void check_mesh_file_name(const std::string& path, const std::string& others) {
  require_no_directory(path);
  mesh_format_of(path, others);
  require_plugin_of(path);
}

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
  const RoundedPoints points = round_points(view, flat);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(points.xyz.begin(), points.xyz.end(),
                                                 [&](const auto& p, const auto& q) { return p[k] < q[k]; });
    longest = std::max(longest, (*high)[k] - (*low)[k]);
  }
  return from_double(longest);
}

/// What is joined so that there is a good mesh, in parts of the extent: some of the last digits of doubles, then
/// more, and not more than somebody who draws by hand would see. The first ones nobody draws, and they are joined
/// where that takes nothing away.
constexpr double kJoined[] = {0x1p-40, 0x1p-32, 0x1p-24, 0x1p-16};
constexpr std::size_t kDigits = 2;

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

/// By TetGen; where it fails, of what has been joined in the last digits, which it stumbles over. Then constrained
/// ones of that, for what is so near makes bad shapes; and where there are none in doubles, of what has been
/// joined more and more.
TetrahedralMesh snapped_in_time(Result& result, TetrahedraOptions options, SnapReport& report,
                                const Deadline& deadline) {
  MadeOfDoubles<TetrahedralMesh> made_of(result, report, deadline.watch());
  TetgenTrial trial{!options.constrained && plugin_fault(kTetgenPlugin).empty(), {}};
  const auto make = [&] { return tetrahedra_in_time(result, options, deadline, trial); };
  const std::span<const double> digits(kJoined, kDigits);
  if (trial.only) {
    std::string fault;
    try {
      return made_of.as_it_is(make);
    } catch (const TetgenFault& e) {
      fault = e.what();
    } catch (const NearFault& e) {
      fault = e.what();
    }
    const auto foretold = std::exchange(options.foretold, {});  // it was told already
    for (const double part : digits) {
      try {
        if (auto made = made_of.joined(part, Joins::harmless, without_remedy(fault), make))
          return std::move(*made);
      } catch (const TetgenFault&) {
      } catch (const NearFault&) {
      }
    }
    trial = {false, fault};
    options.foretold = foretold;  // others are made now
    for (auto part = digits.rbegin(); part != digits.rend(); ++part) {
      try {
        if (auto made = made_of.joined(*part, Joins::harmless, {}, make)) return std::move(*made);
      } catch (const NearFault&) {
      }
    }
  }
  std::exception_ptr near;
  try {
    TetrahedralMesh made = made_of.as_it_is(make);
    if (const std::string advice = made_of.advice(); made.quality.bad > 0 && !advice.empty())
      made.notice += "; " + advice;
    return made;
  } catch (const NearFault&) {
    near = std::current_exception();
  }
  options.foretold = {};
  for (const double part : kJoined) {
    try {
      if (auto made = made_of.joined(part, Joins::all, "there were no tetrahedra in doubles", make))
        return std::move(*made);
    } catch (const NearFault&) {
    }
  }
  std::rethrow_exception(near);
}

}  // namespace

TetrahedralMesh tetrahedra(const Result& result, const TetrahedraOptions& options) {
  const Deadline deadline(options.watch, options.seconds.value_or(0));
  return deadline.run([&] { return tetrahedra_in_time(result, options, deadline); });
}

TetrahedralMesh snapped_tetrahedra(Result& result, const TetrahedraOptions& options, SnapReport& report) {
  const Deadline deadline(options.watch, options.seconds.value_or(0));
  return deadline.run([&] { return snapped_in_time(result, options, report, deadline); });
}

SurfaceTriangles surface_triangles(const Result& result, const SurfaceOptions& options) {
  const ResultView view = result.data().view();
  SurfaceTriangles made = surface_triangles(view, options);
  add_properties(view, made.mesh);
  if (options.order == 2) add_straight_middles(made.mesh);
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
    if (auto made = made_of.joined(kJoined[0], Joins::harmless, without_remedy(words), make))
      return std::move(*made);
    std::rethrow_exception(near);
  });
}

CurvedReport curve(const Result& result, TetrahedralMesh& made, const Watch& watch) {
  const ResultView view = result.data().view(true);
  if (view.parameters == nullptr) {
    throw InputError("the result knows nothing of its true surfaces; mesh one that was not snapped");
  }
  const CurvedReport report = curve(view, made, watch);
  made.mesh.fields.clear();
  sample_materials(view, made.mesh);
  add_properties(view, made.mesh);
  return report;
}

void check_second_order_file_name(const std::string& path, const std::string& others) {
  check_mesh_file_name(path, others);
  if (mesh_format_of(path).second_order) return;
  throw InputError(path + ": this format holds elements of first order only; use one of" +
                   known_mesh_formats(true) + others + " for --curved and --order 2");
}

void check_quads_file_name(const std::string& path, const std::string& others) {
  check_mesh_file_name(path, others);
  if (mesh_format_of(path).quads) return;
  throw InputError(path + ": this format is read by programs that take triangles only; use one of" +
                   known_mesh_formats(false, true) + others + " for --quads");
}

void write(const std::string& path, const Result& result, const Mesh& mesh, const std::stop_token& stop) {
  check_mesh_file_name(path);
  if (!mesh.quads.empty()) check_quads_file_name(path);
  if (!mesh.middles.empty()) check_second_order_file_name(path);
  std::string content;
  try {
    content = mesh_format_of(path).make(path, result.data().view(), mesh);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  replace_file(path, content, stop);
}

TetrahedraReport write_tetrahedra(const std::vector<std::string>& paths, const Result& result,
                                  const TetrahedraOptions& options) {
  for (const std::string& path : paths) check_mesh_file_name(path);
  Result shown = result;
  SnapReport snapped;
  TetrahedralMesh made = snapped_tetrahedra(shown, options, snapped);
  const Mesh& mesh = made.mesh;
  for (const std::string& path : paths) write(path, shown, mesh);
  std::vector<std::string> warnings = std::move(made.warnings);
  for (std::string& warning : snapped.warnings()) warnings.push_back(std::move(warning));
  return {made.rounding,        snapped,     std::move(made.regions), mesh.points.size(), mesh.triangles.size(),
          mesh.segments.size(), made.notice, std::move(warnings)};
}

}  // namespace cnrg
