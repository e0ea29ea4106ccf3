// The choice of a mesh file's reader.
#include "csg/imports/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "csg/imports/leaf_file.h"
#include "kernel/base/error.h"

namespace cnrg {

MeshData read_mesh(const std::string& path, bool decimal, const std::string& inside) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  using Reader = MeshData (*)(const std::string&, const std::string&, bool);
  const std::pair<const char*, Reader> readers[] = {
      {".off", &read_off},  {".obj", &read_obj},  {".stl", &read_stl},  {".ply", &read_ply}, {".vtk", &read_vtk},
      {".ts", &read_gocad}, {".pl", &read_gocad}, {".wl", &read_gocad}, {".vtp", &read_vtp},
  };
  for (const auto& [name, reader] : readers) {
    if (extension != name) continue;
    return reader(path, read_leaf_file(path, inside, "write the mesh again"), decimal);
  }
  throw InputError(
      "mesh: '" + path +
      "' has an unknown format: give a file with the extension .off, .obj, .stl, .ply, .vtp, .vtk, .ts, .pl or "
      ".wl");
}

}  // namespace cnrg
