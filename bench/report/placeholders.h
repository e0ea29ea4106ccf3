// Colours and font in scripts of gnuplot that stand for those of the page: no plot uses them for themselves.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace cnrg::bench {

inline constexpr const char* kFontPlaceholder = "PAGEFONT";
inline constexpr const char *kInk = "'#fd0000'", *kMuted = "'#fd0001'", *kRule = "'#fd0002'";

inline std::string series_placeholder(std::size_t series) {
  char text[16];
  std::snprintf(text, sizeof text, "'#fe00%02x'", static_cast<unsigned>(series % 256));
  return text;
}

}  // namespace cnrg::bench
