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

}  // namespace cnrg

// Of the plug-in `cad`; to be called in a child.
extern "C" void cnrg_cad_text(const cnrg::CadParts& parts, cnrg::CadFormat format, cnrg::CadText& text);
