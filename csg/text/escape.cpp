// UTF-8 is decoded by hand: the shortest form of each code point only, none above U+10FFFF, no surrogates. What a
// lenient decoder would take as ESC or as a line end is shown byte by byte.
#include "csg/text/escape.h"

#include <algorithm>
#include <cstdio>

#include "csg/text/json_text.h"

namespace cnrg {
namespace {

unsigned byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

bool is_plain(char c) { return static_cast<unsigned char>(c) - 0x20u < 0x5fu; }

void append_escape(std::string& out, const Character& c) {
  if (c.code == '\n') out += "\\n";
  else if (c.code == '\r') out += "\\r";
  else if (c.code == '\t') out += "\\t";
  else {
    char digits[16];
    const bool one_byte = !c.valid || c.code < 0x80;
    std::snprintf(digits, sizeof digits, one_byte ? "\\x%02x" : c.code <= 0xffff ? "\\u%04x" : "\\U%08x", c.code);
    out += digits;
  }
}

/// `kept`: characters that are no escapes although they are hostile.
std::string escaped(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (is_plain(text[end]) || kept.find(text[end]) != std::string_view::npos)) ++end;
    out.append(text, i, end - i);
    if (end == text.size()) break;
    const Character c = first_character(text.substr(end));
    if (c.valid && !is_hostile(c.code)) out.append(text, end, c.length);
    else append_escape(out, c);
    i = end + c.length;
  }
  return out;
}

void append_json_escape(std::string& out, std::uint32_t code) {
  char digits[16];
  if (code <= 0xffff) std::snprintf(digits, sizeof digits, "\\u%04x", code);
  else std::snprintf(digits, sizeof digits, "\\u%04x\\u%04x", 0xd7c0 + (code >> 10), 0xdc00 + (code & 0x3ff));
  out += digits;
}

}  // namespace

Character first_character(std::string_view text) {
  const unsigned first = byte(text, 0);
  if (first < 0x80) return {first, 1, true};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  const Character stray{first, 1, false};
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return stray;
  std::uint32_t code = first & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(text, i) & 0xc0) != 0x80) return stray;
    code = code << 6 | (byte(text, i) & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[length] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return stray;
  return {code, length, true};
}

bool is_hostile(std::uint32_t code) {
  constexpr std::uint32_t kRanges[][2] = {
      {0x00, 0x1f},     {0x7f, 0x9f},      {0x061c, 0x061c}, {0x180e, 0x180e},  // controls, an Arabic mark
      {0x200b, 0x200b}, {0x200e, 0x200f},  {0x2028, 0x202e},                    // marks, ends of lines, embeddings
      {0x2060, 0x206f}, {0xfeff, 0xfeff},  {0xfff9, 0xfffb},                    // isolates, what nobody sees
      {0xfffe, 0xffff}, {0xe0000, 0xe007f}};
  return std::any_of(std::begin(kRanges), std::end(kRanges),
                     [&](const auto& range) { return code >= range[0] && code <= range[1]; });
}

std::string shown(std::string_view text) { return escaped(text, ""); }

std::string shown_lines(std::string_view text) { return escaped(text, "\n\t"); }

void append_line(std::string& out, std::string_view text) {
  out += shown(text);
  out += '\n';
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return shown(text);
  std::size_t end = 0;
  while (end < kLongest) end += first_character(text.substr(end)).length;
  return shown(text.substr(0, end)) + "...";
}

std::string shown_in_quotes(std::string_view name) {
  std::string text = shown(name);
  std::replace(text.begin(), text.end(), '"', '\'');
  return text;
}

void append_json(std::string& text, std::string_view value) {
  constexpr std::string_view kControls = "\b\t\n\f\r\"\\", kLetters = "btnfr\"\\";
  text += '"';
  for (std::size_t i = 0; i < value.size();) {
    const Character c = first_character(value.substr(i));
    if (const std::size_t k = kControls.find(value[i]); k != std::string_view::npos) (text += '\\') += kLetters[k];
    else if (!c.valid) text += "\ufffd";
    else if (is_hostile(c.code)) append_json_escape(text, c.code);
    else text.append(value, i, c.length);
    i += c.length;
  }
  text += '"';
}

std::size_t first_invalid(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const Character c = first_character(text.substr(i));
    if (!c.valid) break;
    i += c.length;
  }
  return i;
}

}  // namespace cnrg
