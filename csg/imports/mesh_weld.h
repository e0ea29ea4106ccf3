// The polygons of a mesh file as input of the weld (csg/weld/weld.h).
#pragma once

#include "csg/imports/mesh_file.h"
#include "csg/weld/weld.h"

namespace cnrg {

struct MeshWeld {
  WeldModel model;  ///< before it
  Weld made;
};

/// Moves the points of the mesh. Polygons may lose corners, or all of their area. `name` is for messages.
MeshWeld weld_mesh(MeshData& data, const std::string& name, const Rational& d, bool only_planes);

/// Throws InputError if polygons that are closed now have other signs of volume than before.
void check_volume(const MeshWeld& weld, const Rational& d);

}  // namespace cnrg
