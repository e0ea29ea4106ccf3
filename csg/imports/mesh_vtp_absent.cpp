// In a build without Expat and zlib (CMake's option CNRG_VTP).
#include "csg/imports/mesh_file.h"
#include "kernel/base/error.h"

namespace cnrg {

std::string vtp_library() {
  return "this cnrg was built without Expat and zlib: install libexpat1-dev zlib1g-dev and build cnrg again with "
         "CNRG_VTP=ON";
}

MeshData read_vtp(const std::string& path, const std::string&, bool) {
  throw InputError("mesh: '" + path + "': " + vtp_library() + ", or give the mesh as .vtk");
}

MeshData read_3mf(const std::string& path, const std::string&, bool) {
  throw InputError("mesh: '" + path + "': " + vtp_library() + ", or give the mesh as .stl");
}

}  // namespace cnrg
