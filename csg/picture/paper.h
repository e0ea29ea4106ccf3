// What the plug-in `paper` does: cairo, FreeType and the font.
#pragma once

#include <string>
#include <string_view>

#include "csg/picture/font.h"
#include "csg/picture/sheet.h"

namespace cnrg {

/// The bytes of the font's file. In the plug-in alone.
std::string_view font_file();

}  // namespace cnrg

// Throw std::bad_alloc; of a .png with too many pixels InputError. The caller owns the font. A .png has two pixels
// for each unit: screens have that many.
extern "C" {
cnrg::Font* cnrg_paper_font();
void cnrg_paper_pdf(const cnrg::PaperSheet& sheet, std::string& bytes);
void cnrg_paper_png(const cnrg::PaperSheet& sheet, std::string& bytes);
const char* cnrg_paper_version();
}
