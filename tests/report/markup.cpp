#include "tests/report/markup.h"

#include <cctype>
#include <regex>

namespace cnrg::bench {
namespace {

bool starts(const std::string& text, std::size_t at, const char* with) {
  return text.compare(at, std::string(with).size(), with) == 0;
}

std::string fault(const std::string& what, const std::string& page, std::size_t at) {
  return what + " at byte " + std::to_string(at) + ": " + page.substr(at, 60);
}

bool entity(const std::string& text, std::size_t at) {
  for (const char* known : {"&lt;", "&gt;", "&amp;", "&quot;", "&#39;"}) {
    if (starts(text, at, known)) return true;
  }
  return false;
}

bool name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == ':';
}

/// Reads attributes from `at` to the end of the tag; sets `closed` for `/>`. An empty text when all is well.
std::string read_attributes(const std::string& page, std::size_t& at, bool& closed) {
  const std::size_t begin = at;
  for (;;) {
    const std::size_t gap = at;
    while (at < page.size() && std::isspace(static_cast<unsigned char>(page[at]))) ++at;
    if (at >= page.size()) return fault("tag without end", page, begin);
    if (page[at] == '>' || starts(page, at, "/>")) {
      closed = page[at] == '/';
      at += closed ? 2 : 1;
      return "";
    }
    if (gap == at) return fault("no space before attribute", page, at);
    while (at < page.size() && name_character(page[at])) ++at;
    const std::size_t value = page.find_first_not_of(" =", at);
    if (value == std::string::npos || page.substr(at, value - at).find('=') == std::string::npos ||
        (page[value] != '"' && page[value] != '\'')) {
      return fault("attribute without quotes", page, begin);
    }
    const char quote = page[value];
    for (at = value + 1; at < page.size() && page[at] != quote; ++at) {
      if (page[at] == '<' || (page[at] == '&' && !entity(page, at))) return fault("bare character", page, at);
    }
    ++at;
  }
}

}  // namespace

std::string markup_fault(const std::string& page) {
  std::vector<std::string> open;
  std::size_t at = 0, roots = 0;
  const std::string doctype = "<!DOCTYPE html>";
  if (starts(page, 0, doctype.c_str())) at = doctype.size();
  while (at < page.size()) {
    const char c = page[at];
    if (c == '&' && !entity(page, at)) return fault("bare &", page, at);
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
      return fault("control character", page, at);
    if (c != '<') {
      if (open.empty() && !std::isspace(static_cast<unsigned char>(c))) return fault("text outside", page, at);
      ++at;
      continue;
    }
    if (starts(page, at, "<![CDATA[")) {
      at = page.find("]]>", at);
      if (at == std::string::npos) return "CDATA without end";
      at += 3;
      continue;
    }
    const std::size_t begin = at;
    const bool end = starts(page, at, "</");
    at += end ? 2 : 1;
    std::string name;
    while (at < page.size() && name_character(page[at])) name += page[at++];
    if (name.empty()) return fault("bare <", page, begin);
    bool closed = false;
    const std::string attributes = read_attributes(page, at, closed);
    if (!attributes.empty()) return attributes;
    if (end) {
      if (open.empty() || open.back() != name) return fault("end of another element", page, begin);
      open.pop_back();
    } else if (!closed) {
      roots += open.empty();
      open.push_back(name);
    }
  }
  if (!open.empty()) return "element without end: " + open.back();
  return roots == 1 ? "" : "not one root";
}

std::vector<std::string> attribute_values(const std::string& page, const std::string& name) {
  std::vector<std::string> values;
  const std::regex pattern("\\s" + name + "=(\"([^\"]*)\"|'([^']*)')");
  for (std::sregex_iterator i(page.begin(), page.end(), pattern), end; i != end; ++i) {
    values.push_back((*i)[2].matched ? (*i)[2].str() : (*i)[3].str());
  }
  return values;
}

}  // namespace cnrg::bench
