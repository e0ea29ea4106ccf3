// In a build without Expat and zlib (CMake's option CNRG_VTP).
#include "csg/imports/mesh_file.h"
#include "kernel/base/error.h"

namespace cnrg {

MeshData read_vtp(const std::string& path, const std::string&, bool) {
  throw InputError(
      "mesh: '" + path +
      "': this cnrg has no Expat and zlib: install libexpat1-dev and zlib1g-dev and build cnrg again, or "
      "give the mesh as .vtk");
}

}  // namespace cnrg
