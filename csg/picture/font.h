// The font of pictures: DejaVu Sans, which is in the program.
//
// Whoever asks the system for a font gets another one on the next machine, with other widths: labels that had room
// lie over one another, and the same tree has other bytes. So the font's file is part of the program, and widths
// are read from it in the units in which the font was drawn, without hinting, which differs between releases of
// FreeType.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace cnrg {

class Font {
 public:
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Of a text in letters of that size. A character that the font lacks counts as one that is as wide as high.
  double width(std::string_view text, double size) const;
  /// The number of a character's shape; 0 if there is none.
  std::uint32_t glyph(std::uint32_t character) const;
  /// The text with escapes for the characters that the font lacks (`\u4e2d`): for files that bring their font.
  std::string without_unknown(std::string_view text) const;

  /// The bytes of the font's file.
  static std::string_view file();

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace cnrg
