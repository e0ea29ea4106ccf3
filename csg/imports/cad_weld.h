// The faces, edges and solids of a CAD model as input of the weld (csg/weld/weld.h).
#pragma once

#include "csg/imports/cad_model.h"
#include "csg/weld/weld.h"

namespace cnrg {

/// Faces on planes are flat, all others are curved. `subject`, `face_name` and `solid_name` are for messages.
Weld weld_cad(const CadModel& model, const Rational& d, const std::string& subject,
              const std::function<std::string(std::uint32_t)>& face_name,
              const std::function<std::string(std::uint32_t)>& solid_name);

}  // namespace cnrg
