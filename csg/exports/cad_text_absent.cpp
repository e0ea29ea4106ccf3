// STEP and BREP files are refused in a build without OpenCASCADE (CMake's option CNRG_OPENCASCADE).
#include "csg/exports/cad_text.h"
#include "kernel/base/error.h"

namespace cnrg {

CadText cad_text(const CadParts&, CadFormat) { throw InvariantError("exports: a CAD model without OpenCASCADE"); }

void require_cad_writer(const std::string& path) {
  throw InputError(path +
                   ": this cnrg is built without OpenCASCADE, which writes CAD models: install "
                   "libocct-data-exchange-dev and build cnrg with -DCNRG_OPENCASCADE=ON, or write .msh or .json");
}

}  // namespace cnrg
