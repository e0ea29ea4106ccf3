// The extension decides: .dot is a graph, every other format gets the result as writers see it (ResultView).
// A .json is read back as a tree would read it: as a leaf, alone in a complex of its own.
#include "csg/formats/result_file.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "csg/exports/cad_text.h"
#include "csg/formats/dag_graph.h"
#include "csg/formats/formats.h"
#include "csg/formats/mesh_file.h"
#include "csg/formats/writer.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/text/file.h"
#include "csg/text/plugin.h"
#include "csg/topology/region_graph.h"
#include "csg/transfer/leaf_value.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

bool shows_regions(const std::string& path) {
  return extension_of(path) == ".dot" && extension_of(path.substr(0, path.size() - 4)) == ".regions";
}

struct MeshFormat {
  std::string_view extension;
  bool second_order;
  bool quads;
  bool wedges;
  std::string (*make)(const std::string& path, const ResultView& view, const Mesh& mesh);
};

template <std::string (*text)(const Mesh&)>
std::string make(const std::string&, const ResultView&, const Mesh& mesh) {
  return text(mesh);
}

constexpr std::array<MeshFormat, 10> kMeshFormats{
    {{".msh", true, true, true, make<msh_text>},
     {".msh2", true, true, true, make<msh2_text>},
     {".mesh", false, true, false, make<medit_text>},
     {".vtu", true, true, true,
      [](const std::string&, const ResultView& view, const Mesh& mesh) { return vtu_text(view, mesh); }},
     {".inp", true, true, true, make<abaqus_text>},
     {".bdf", true, true, false, make<nastran_text>},
     {".h5m", false, false, false, make<h5m_bytes>},
     {".f3grid", false, true, false, make<flac3d_text>},
     {".med", true, true, false, make<med_bytes>},
     {".xdmf", true, true, false,
      [](const std::string& path, const ResultView&, const Mesh& mesh) { return xdmf_text(path, mesh); }}}};

/// Each with a space before it. `can`: those that can hold such elements.
std::string known_mesh_formats(bool MeshFormat::*can = nullptr) {
  std::string known;
  for (const MeshFormat& format : kMeshFormats) {
    if (can == nullptr || format.*can) known += " " + std::string(format.extension);
  }
  return known;
}

const MeshFormat& mesh_format_of(const std::string& path, const std::string& others = {}) {
  const std::string extension = extension_of(path);
  const auto format = std::ranges::find(kMeshFormats, extension, &MeshFormat::extension);
  if (format != kMeshFormats.end()) return *format;
  const bool surface = extension == ".smesh" || extension == ".poly";
  throw InputError(path +
                   (surface ? ": this format holds faces and no tetrahedra; `cnrg eval -o` writes it"
                            : ": no writer of tetrahedra for the extension `" + extension + "`") +
                   "; use one of" + known_mesh_formats() + others);
}

/// Before the work.
void require_plugin_of(const std::string& path) {
  const std::string extension = extension_of(path);
  if (is_cad_file(path)) require_plugin(kCadPlugin, path, "write .msh or .json");
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

void check_one_group_file_name(const std::string& path) {
  if (extension_of(path) == ".msh") return;
  throw InputError(path + ": --one-group is for .msh, in which an element is in all its groups; leave it out");
}

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
  const auto text_of = [&](const Result& of, bool parameters) {
    ResultView view = of.data().view(parameters);
    view.one_group = options.one_group;
    return file_text(path, view, options.binary);
  };
  try {
    file = text_of(result, options.parameters || shows_surfaces(path));
    broken = !file.rounding.embedded;
  } catch (const RoundingFault&) {
    if (!snaps) throw;
    broken = true;
  }
  if (broken && snaps) {
    SnappedResultOnce once;
    SnappedResultOnce& snapped = options.snapped != nullptr ? *options.snapped : once;
    if (!snapped.result) snapped.result = snap(result, &snapped.report);
    file = text_of(*snapped.result, false);
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

/// `words`: why it cannot; `option`: who asks for it.
void require_can(bool MeshFormat::*can, const std::string& path, const std::string& others, const char* words,
                 const char* option) {
  check_mesh_file_name(path, others);
  if (mesh_format_of(path).*can) return;
  throw InputError(path + ": this format " + words + "; use one of" + known_mesh_formats(can) + others + " for " +
                   option);
}

}  // namespace

void check_second_order_file_name(const std::string& path, const std::string& others) {
  require_can(&MeshFormat::second_order, path, others, "holds elements of first order only",
              "--curved and --order 2");
}
void check_quads_file_name(const std::string& path, const std::string& others) {
  require_can(&MeshFormat::quads, path, others, "is read by programs that take triangles only", "--quads");
}
void check_interfaces_file_name(const std::string& path, const std::string& others) {
  require_can(&MeshFormat::wedges, path, others, "gets no wedges", "--interfaces");
}

void write(const std::string& path, const Result& result, const Mesh& mesh, const std::stop_token& stop) {
  check_mesh_file_name(path);
  if (!mesh.quads.empty()) check_quads_file_name(path);
  if (!mesh.middles.empty()) check_second_order_file_name(path);
  if (!mesh.wedges.empty()) check_interfaces_file_name(path);
  std::string content;
  try {
    content = mesh_format_of(path).make(path, result.data().view(), mesh);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  } catch (const FileError& error) {
    throw FileError(path + ": " + error.what());
  }
  replace_file(path, content, stop);
}

}  // namespace cnrg
