// Text inside of the quotes of a .dot file.
#pragma once

#include <string>

#include "csg/text/escape.h"

namespace cnrg {

/// A name as it is shown, with what Graphviz would read as the end of the quotes, an escape or an entity escaped.
/// A line break in a label is `\n` between two names.
inline std::string graphviz_text(const std::string& name) {
  std::string out;
  for (const char c : shown(name)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
    if (c == '&') out += "amp;";
  }
  return out;
}

}  // namespace cnrg
