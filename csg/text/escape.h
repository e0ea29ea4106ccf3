// Names as people and programs may see them.
//
// A name in a tree, a mesh or a CAD model is any text, and so is a path. Printed as it is, it can clear a terminal
// (ESC, the C1 controls), turn a line around (bidirectional marks) or add a line that looks like one of ours
// (newlines). Therefore a name is shown with such characters as escapes: `\n`, `\x1b`, `\u202e`. Letters of all
// scripts stay as they are, and so does a backslash: what was shown once may be shown again and stays the same, so
// that it can be escaped where it enters a text and once more where the text leaves the program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cnrg {

/// The character at the front of a text that is not empty.
struct Character {
  std::uint32_t code = 0;  ///< of a byte that begins no character of UTF-8 that byte
  std::size_t length = 1;  ///< in bytes
  bool valid = true;       ///< false: a stray byte, an overlong form, a surrogate
};
Character first_character(std::string_view text);

/// True for characters that may not reach a terminal: controls, marks that change the direction of a text or end
/// a line, characters that nobody sees.
bool is_hostile(std::uint32_t code);

/// On one line, with hostile characters and bytes that are no UTF-8 as escapes.
std::string shown(std::string_view text);

/// The same but for line ends and tabulators, which stay: for text of many lines.
std::string shown_lines(std::string_view text);

/// Appends a line: the text as it is shown, and a line end.
void append_line(std::string& out, std::string_view text);

/// The beginning of a text that may be long, as it is shown; `...` says that there is more.
std::string excerpt(std::string_view text);

/// As it is shown, for formats with names in quotation marks and no escapes: these become apostrophes.
std::string shown_in_quotes(std::string_view name);

/// Where the first byte that is no UTF-8 stands; the size of the text if there is none.
std::size_t first_invalid(std::string_view text);

}  // namespace cnrg
