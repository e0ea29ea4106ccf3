// Faces of different solids of a CAD file that lie on nearly the same surface, and not on the same.
#pragma once

#include <string>

#include "csg/imports/cad_model.h"
#include "csg/weld/weld.h"

namespace cnrg {

/// A notice that counts the pairs and says how near one of them is; empty if there are none. Planes, cylinders,
/// cones, spheres and tori are compared. `weld` would join their faces.
std::string notice_of_near_surfaces(const CadModel& model);

// The faces, edges and solids of a CAD model as input of the weld (csg/weld/weld.h).

/// Faces on planes are flat, all others are curved. `subject`, `face_name` and `solid_name` are for messages.
Weld weld_cad(const CadModel& model, const Rational& d, const std::string& subject,
              const std::function<std::string(std::uint32_t)>& face_name,
              const std::function<std::string(std::uint32_t)>& solid_name);

}  // namespace cnrg
