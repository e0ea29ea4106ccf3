#include "csg/text/xml.h"

#include "csg/text/escape.h"

namespace cnrg {

std::string in_xml(const std::string& text) {
  std::string result;
  for (const char c : shown(text)) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace cnrg
