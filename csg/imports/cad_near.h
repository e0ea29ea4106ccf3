// Faces of different solids of a CAD file that lie on nearly the same surface, and not on the same.
#pragma once

#include <string>

#include "csg/imports/cad_model.h"

namespace cnrg {

/// A notice that counts the pairs and says how near one of them is; empty if there are none. Planes, cylinders,
/// cones, spheres and tori are compared. `weld` would join their faces.
std::string notice_of_near_surfaces(const CadModel& model);

}  // namespace cnrg
