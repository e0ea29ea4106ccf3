// STEP and BREP files are refused in a build without OpenCASCADE (CMake's option CNRG_OPENCASCADE).
#include "csg/imports/cad_model.h"
#include "kernel/base/error.h"

namespace cnrg {

CadModel read_cad(const CadShape& shape) {
  throw InputError(std::string(shape.name()) + ": this cnrg is built without OpenCASCADE, which reads '" +
                   shape.file +
                   "': install libocct-data-exchange-dev and build cnrg with -DCNRG_OPENCASCADE=ON, or give the "
                   "part as a mesh file");
}

std::string cad_library() { return {}; }

}  // namespace cnrg
