// STEP and BREP: the result as a CAD model on its true surfaces (csg/exports).
#include "csg/exports/cad_text.h"
#include "csg/formats/formats.h"

namespace cnrg {
namespace {

FileText cad_file(const ResultView& view, const std::string& name, CadFormat format) {
  CadText made = cad_text(cad_parts(view, name), format);
  return {std::move(made.text), {.notices = std::move(made.notices)}};
}

}  // namespace

FileText step_text(const ResultView& view) { return cad_file(view, "STEP", CadFormat::step); }
FileText brep_text(const ResultView& view) { return cad_file(view, "BREP", CadFormat::brep); }

}  // namespace cnrg
