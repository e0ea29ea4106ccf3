// The choice of a mesh file's reader.
#include "csg/imports/mesh_file.h"

#include <string_view>
#include <utility>

#include "csg/imports/leaf_file.h"
#include "csg/text/file.h"
#include "kernel/base/error.h"

namespace cnrg {

namespace {

using MeshReader = MeshData (*)(const std::string&, const std::string&, bool);

/// nullptr for an extension that none reads.
MeshReader mesh_reader(const std::string& path) {
  static constexpr std::pair<std::string_view, MeshReader> kMeshReaders[] = {
      {".off", &read_off},  {".obj", &read_obj},  {".stl", &read_stl},  {".ply", &read_ply}, {".vtk", &read_vtk},
      {".ts", &read_gocad}, {".pl", &read_gocad}, {".wl", &read_gocad}, {".vtp", &read_vtp}, {".vtu", &read_vtp},
      {".msh", &read_msh},  {".glb", &read_glb},  {".3mf", &read_3mf},
  };
  const std::string extension = extension_of(path);
  for (const auto& [name, reader] : kMeshReaders) {
    if (extension == name) return reader;
  }
  return nullptr;
}

}  // namespace

bool is_mesh_file(const std::string& path) { return mesh_reader(path) != nullptr; }

MeshData read_mesh(const std::string& path, bool decimal, const std::string& inside) {
  if (const MeshReader reader = mesh_reader(path))
    return reader(path, read_leaf_file(path, inside, "write the mesh again"), decimal);
  throw InputError("mesh: '" + path +
                   "' has an unknown format: give a file with the extension .off, .obj, .stl, .ply, .vtp, .vtu, "
                   ".vtk, .msh, .glb, .3mf, .ts, .pl or .wl");
}

}  // namespace cnrg
