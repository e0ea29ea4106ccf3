// The table of formats by extension. The whole text is made before the file is touched, so that a format that
// refuses a result leaves an old file as it was.
#include "csg/formats/writer.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "csg/exports/cad_text.h"
#include "csg/formats/formats.h"
#include "csg/mesh/mesh.h"
#include "csg/result/result_json.h"
#include "csg/result/rounding.h"
#include "csg/result/solid.h"
#include "csg/text/file.h"
#include "kernel/base/error.h"

namespace cnrg {

namespace {

/// What was flattened goes before the text is made: it takes as much memory as that.
std::pair<Mesh, RoundingReport> rounded_mesh(const ResultView& view, const std::string& format) {
  const FlatComplex flat = flatten(view);
  require_closed_and_bounded(flat, format);
  if (flat.vertices.empty() && flat.edges.empty() && flat.faces.empty()) {
    throw InputError(format +
                     " is a mesh, and readers refuse one of nothing, as this result is; write .vtu or .json");
  }
  const RoundedPoints points = round_points(view, flat);
  RoundingReport rounding = report_rounding(points, drawing_of(flat));
  return {surface_mesh(view, flat, points), std::move(rounding)};
}

/// The surface mesh of a result as `text` makes it; `format` is for messages.
FileText surface_text(const ResultView& view, const std::string& format, std::string (*text)(const Mesh&)) {
  auto [mesh, rounding] = rounded_mesh(view, format);
  return {text(mesh), std::move(rounding)};
}

/// The result as a CAD model on its true surfaces (csg/exports).
FileText cad_file(const ResultView& view, const std::string& name, CadFormat format) {
  CadText made = cad_text(cad_parts(view, name), format);
  return {std::move(made.text), {.notices = std::move(made.notices)}};
}

FileText step_text(const ResultView& view) { return cad_file(view, "STEP", CadFormat::step); }
FileText brep_text(const ResultView& view) { return cad_file(view, "BREP", CadFormat::brep); }

struct Format {
  std::string_view extension;
  FileText (*make)(const ResultView&);
  FileText (*make_binary)(const ResultView&) = nullptr;  ///< on request
};

constexpr std::array<Format, 20> kFormats{
    {{".json", json_text},
     {".vtu", vtu_text},
     {".msh", [](const ResultView& view) { return surface_text(view, "MSH", msh_text); }},
     {".msh2", [](const ResultView& view) { return surface_text(view, "MSH", msh2_text); }},
     {".mesh", [](const ResultView& view) { return surface_text(view, "MESH", medit_text); }},
     {".smesh", smesh_text},
     {".poly", poly_text},
     {".inp", [](const ResultView& view) { return surface_text(view, "INP", abaqus_text); }},
     {".bdf", [](const ResultView& view) { return surface_text(view, "BDF", nastran_text); }},
     {".h5m", [](const ResultView& view) { return surface_text(view, "H5M", h5m_bytes); }},
     {".med", [](const ResultView& view) { return surface_text(view, "MED", med_bytes); }},
     {".obj", obj_text},
     {".off", off_text},
     {".stl", stl_text, stl_bytes},
     {".ply", ply_text, ply_bytes},
     {".3mf", three_mf_text},
     {".glb", glb_text},
     {".step", step_text},
     {".stp", step_text},
     {".brep", brep_text}}};

/// Each with a space before it.
std::string listed_extensions(bool with_binary_form) {
  std::string known;
  for (const Format& format : kFormats) {
    if (!with_binary_form || format.make_binary != nullptr) known += " " + std::string(format.extension);
  }
  return known;
}

const Format& format_of(const std::string& path) {
  const std::string extension = extension_of(path);
  const auto format = std::ranges::find(kFormats, extension, &Format::extension);
  if (format != kFormats.end()) return *format;
  throw InputError(path + ": no writer for the extension `" + extension + "`; use one of" +
                   listed_extensions(false));
}

}  // namespace

bool is_cad_file(const std::string& path) {
  const auto format = std::ranges::find(kFormats, extension_of(path), &Format::extension);
  return format != kFormats.end() && (format->make == step_text || format->make == brep_text);
}

bool shows_surfaces(const std::string& path) { return is_cad_file(path) || format_of(path).make == glb_text; }

void check_extension(const std::string& path) { format_of(path); }

void check_binary(const std::string& path) {
  const auto format = std::ranges::find(kFormats, extension_of(path), &Format::extension);
  if (format != kFormats.end() && format->make_binary != nullptr) return;
  throw InputError(path + ": this format has one form only; leave out --binary, which is for" +
                   listed_extensions(true));
}

FileText json_text(const ResultView& view) { return {result_json(view), {}}; }

FileText file_text(const std::string& path, const ResultView& view, bool binary) {
  if (binary) check_binary(path);
  const Format& format = format_of(path);
  try {
    return (binary ? format.make_binary : format.make)(view);
  } catch (const RoundingFault& fault) {
    throw RoundingFault(path + ": " + fault.what());
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  } catch (const FileError& error) {
    throw FileError(path + ": " + error.what());
  }
}

RoundingReport write(const std::string& path, const ResultView& view) {
  const FileText file = file_text(path, view);
  replace_file(path, file.text);
  return file.rounding;
}

}  // namespace cnrg
