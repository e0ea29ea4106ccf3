// The bytes of the font's file, put in by the assembler: a text of them would take the compiler seconds.
#include "csg/picture/paper.h"

asm(".section .rodata\n"
    "cnrg_font_begin:\n"
    ".incbin \"" CNRG_FONT
    "\"\n"
    "cnrg_font_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char cnrg_font_begin[];
extern const char cnrg_font_end[];
}

namespace cnrg {

std::string_view font_file() {
  return {cnrg_font_begin, static_cast<std::size_t>(cnrg_font_end - cnrg_font_begin)};
}

}  // namespace cnrg
