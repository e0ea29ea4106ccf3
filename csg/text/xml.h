// Names in XML and HTML, which have no way to write control characters.
#pragma once

#include <string>

namespace cnrg {

/// As it may be shown (escape.h), in an element or an attribute.
std::string in_xml(const std::string& text);

}  // namespace cnrg
