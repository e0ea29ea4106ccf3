// The table of formats by extension. The whole text is made before the file is touched, so that a format that
// refuses a result leaves an old file as it was.
#include "csg/formats/writer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "csg/formats/formats.h"
#include "csg/result/result_json.h"
#include "csg/result/rounding.h"
#include "csg/text/file.h"
#include "kernel/base/error.h"

namespace cnrg {

namespace {

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
