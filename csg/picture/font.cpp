// The plug-in's font, read by FreeType.
#include "csg/picture/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <cstdio>
#include <new>

#include "csg/picture/paper.h"
#include "csg/text/escape.h"
#include "csg/text/plugin.h"

namespace cnrg {
namespace {

class FreetypeFont : public Font {
 public:
  FreetypeFont() {
    const std::string_view bytes = font_file();
    // The font is part of the plug-in: nothing but memory can be lacking.
    if (FT_Init_FreeType(&library_) != 0) throw std::bad_alloc();
    if (FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes.data()),
                           static_cast<FT_Long>(bytes.size()), 0, &face_) != 0) {
      FT_Done_FreeType(library_);
      throw std::bad_alloc();
    }
  }
  ~FreetypeFont() override { FT_Done_FreeType(library_); }  // and the face with it
  FreetypeFont(const FreetypeFont&) = delete;
  FreetypeFont& operator=(const FreetypeFont&) = delete;

  double width(std::string_view text, double size) const override {
    std::int64_t units = 0;
    for (std::size_t i = 0; i < text.size();) {
      const Character c = first_character(text.substr(i));
      i += c.length;
      const FT_UInt glyph = FT_Get_Char_Index(face_, c.code);
      if (glyph == 0) {
        units += face_->units_per_EM;
      } else {
        if (FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE) != 0) throw std::bad_alloc();
        units += face_->glyph->advance.x;
      }
    }
    return size * static_cast<double>(units) / face_->units_per_EM;
  }

  std::uint32_t glyph(std::uint32_t character) const override { return FT_Get_Char_Index(face_, character); }

  std::string without_unknown(std::string_view text) const override {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      const Character c = first_character(text.substr(i));
      if (glyph(c.code) != 0) {
        result.append(text, i, c.length);
      } else {
        char digits[16];
        std::snprintf(digits, sizeof digits, c.code <= 0xffff ? "\\u%04x" : "\\U%08x", c.code);
        result += digits;
      }
      i += c.length;
    }
    return result;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

}  // namespace
}  // namespace cnrg

CNRG_PLUGIN_EXPORT cnrg::Font* cnrg_paper_font() { return new cnrg::FreetypeFont; }
