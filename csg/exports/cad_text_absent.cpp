// STEP and BREP files are refused in a build without OpenCASCADE (CMake's option CNRG_OPENCASCADE).
#include "csg/exports/cad_text.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

const char* const kWords =
    "this cnrg is built without OpenCASCADE, which writes CAD models: install libocct-data-exchange-dev and build "
    "cnrg with -DCNRG_OPENCASCADE=ON, or write .msh or .json";

}  // namespace

CadText cad_text(const CadParts&, CadFormat) { throw InputError(kWords); }

void require_cad_writer(const std::string& path) { throw InputError(path + ": " + kWords); }

}  // namespace cnrg
