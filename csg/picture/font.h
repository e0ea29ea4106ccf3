// The font of pictures: DejaVu Sans, which is in the plug-in `paper`.
//
// Whoever asks the system for a font gets another one on the next machine, with other widths: labels that had room
// lie over one another, and the same tree has other bytes. So the font's file is part of the plug-in, and widths
// are read from it in the units in which the font was drawn, without hinting, which differs between releases of
// FreeType.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cnrg {

class Font {
 public:
  virtual ~Font() = default;

  /// Of a text in letters of that size. A character that the font lacks counts as one that is as wide as high.
  virtual double width(std::string_view text, double size) const = 0;
  /// The number of a character's shape; 0 if there is none.
  virtual std::uint32_t glyph(std::uint32_t character) const = 0;
  /// The text with escapes for the characters that the font lacks (`\u4e2d`): for files that bring their font.
  virtual std::string without_unknown(std::string_view text) const = 0;
};

}  // namespace cnrg
