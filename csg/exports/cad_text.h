// The file of a result as a CAD model, made by OpenCASCADE in a process of its own (csg/text/child.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/exports/cad_parts.h"

namespace cnrg {

enum class CadFormat : std::uint8_t { step, brep };

struct CadText {
  std::string text;
  std::vector<std::string> notices;  ///< how near it is to the surfaces; what is faceted, and why
};

/// Faces that cannot be made on their surfaces, or not so that OpenCASCADE's check finds them right, become flat
/// faces, one for each facet. Throws InputError for what cannot be a CAD model, or without OpenCASCADE, FileError
/// where the system gives no memory or process.
CadText cad_text(const CadParts& parts, CadFormat format);

/// Throws InputError in a program that has no OpenCASCADE; `path` begins the message.
void require_cad_writer(const std::string& path);

}  // namespace cnrg
