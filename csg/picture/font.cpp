#include "csg/picture/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <cstdio>
#include <new>

#include "csg/text/escape.h"

namespace cnrg {

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
};

Font::Font() : face_(std::make_unique<Face>()) {
  const std::string_view bytes = file();
  // The font is part of the program: nothing but memory can be lacking.
  if (FT_Init_FreeType(&face_->library) != 0) throw std::bad_alloc();
  if (FT_New_Memory_Face(face_->library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                         static_cast<FT_Long>(bytes.size()), 0, &face_->face) != 0) {
    FT_Done_FreeType(face_->library);
    throw std::bad_alloc();
  }
}

Font::~Font() { FT_Done_FreeType(face_->library); }  // and the face with it

double Font::width(std::string_view text, double size) const {
  std::int64_t units = 0;
  const FT_Face face = face_->face;
  for (std::size_t i = 0; i < text.size();) {
    const Character c = first_character(text.substr(i));
    i += c.length;
    const FT_UInt glyph = FT_Get_Char_Index(face, c.code);
    if (glyph == 0) {
      units += face->units_per_EM;
    } else {
      if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) != 0) throw std::bad_alloc();
      units += face->glyph->advance.x;
    }
  }
  return size * static_cast<double>(units) / face->units_per_EM;
}

std::uint32_t Font::glyph(std::uint32_t character) const { return FT_Get_Char_Index(face_->face, character); }

std::string Font::without_unknown(std::string_view text) const {
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

}  // namespace cnrg
