// Text inside of the quotes of a .dot file.
#pragma once

#include <string>

namespace cnrg {

/// Quotes and backslashes escaped; line breaks as Graphviz writes them.
inline std::string graphviz_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace cnrg
