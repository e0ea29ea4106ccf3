// Pieces of HTML that are XML as well: every element is closed, every attribute quoted.
#pragma once

#include <string>
#include <string_view>

namespace cnrg::bench {

/// Text for content and for attributes. Control characters, which XML has not, and bytes that are no UTF-8 become
/// U+FFFD.
std::string escaped(std::string_view text);

/// `<name attributes>content</name>`; the content is HTML already, attributes such as `class="x"` as well.
inline std::string element(const std::string& name, const std::string& content,
                           const std::string& attributes = "") {
  return "<" + name + (attributes.empty() ? "" : " ") + attributes + ">" + content + "</" + name + ">";
}

/// `name="value"` with the value escaped.
inline std::string attribute(const std::string& name, std::string_view value) {
  return name + "=\"" + escaped(value) + "\"";
}

/// JSON for a `script` element: `<`, `>` and `&` as escapes of JSON, so that nothing ends the element.
std::string script_safe(std::string_view json);

}  // namespace cnrg::bench
