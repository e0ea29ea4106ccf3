// Numbers are the same where `long` has 32 bits: no source of kernel and csg names it, or takes a way that goes by
// it.
//
// A number that is cut off to the width of `long` is wrong on 64-bit Windows, on wasm and on 32-bit systems alone,
// where no test of ours runs. So what would cut it off is found in the text of the sources.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/catch.h"
#include "tests/pages/page.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The text of a source without what stands in comments and between quotation marks. Lines stay.
std::string code_of(const std::string& text) {
  std::string code;
  std::size_t i = 0;
  const auto leave_out = [&](std::size_t end) {
    for (end = std::min(end, text.size()); i < end; ++i) {
      if (text[i] == '\n') code += '\n';
    }
  };
  const auto behind = [&](const std::string& mark, std::size_t from) {
    const std::size_t at = text.find(mark, from);
    return at == std::string::npos ? text.size() : at + mark.size();
  };
  while (i < text.size()) {
    if (text.compare(i, 2, "//") == 0) {
      leave_out(text.find('\n', i));
    } else if (text.compare(i, 2, "/*") == 0) {
      leave_out(behind("*/", i + 2));
    } else if (text.compare(i, 2, "R\"") == 0) {
      const std::size_t open = text.find('(', i);
      leave_out(behind(")" + text.substr(i + 2, open - i - 2) + "\"", open));
    } else if (text[i] == '"' || text[i] == '\'') {
      std::size_t end = i + 1;
      while (end < text.size() && text[end] != text[i]) end += text[end] == '\\' ? 2 : 1;
      leave_out(end + 1);
    } else if (in_word(text[i])) {  // a word, or a number with marks between its digits
      const bool number = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
      for (; i < text.size() && (in_word(text[i]) || (number && (text[i] == '\'' || text[i] == '.'))); ++i) {
        if (text[i] != '\'') code += text[i];
      }
    } else {
      code += text[i++];
    }
  }
  return code;
}

/// Each place of a source that depends on how wide `long` is, as `line: what`, lines from 1.
std::vector<std::string> narrow_places(const std::string& text) {
  static const std::regex narrow(
      "\\blong\\b(?!\\s+(long|double)\\b)"              // the type, alone
      "|\\bmp[zqf]_\\w*(_si|_ui|_uiui|_ui_p|_si_p)\\b"  // functions of GMP that take or return it
      "|\\b(get|fits)_(si|ui|slong_p|ulong_p)\\b"
      "|\\bl(round|rint)[fl]?\\b|\\bstou?l\\b|\\bstrtou?l\\b|\\bato[l]\\b|\\blabs\\b|\\bldiv\\b"
      "|\\b(0[xX][0-9a-fA-F]+|0[bB][01]+|[0-9]+)([uU]?[lL]|[lL][uU])\\b");  // numbers
  std::vector<std::string> places;
  const std::vector<std::string> lines = lines_of(code_of(text));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::sregex_iterator match(lines[i].begin(), lines[i].end(), narrow), end; match != end; ++match) {
      // The second word of `long long`; the end of a `long double`.
      const std::string found = match->str(), before = match->prefix().str();
      if (found == "long" && std::regex_search(before, std::regex("\\blong\\s+$"))) continue;
      if (before.ends_with('.') && std::isdigit(static_cast<unsigned char>(found[0])) != 0) continue;
      places.push_back(std::to_string(i + 1) + ": " + found);
    }
  }
  return places;
}

TEST_CASE("places that depend on the width of long are found", "[pages][widths]") {
  using Places = std::vector<std::string>;
  CHECK(narrow_places("int a;\nlong b = x;\n") == Places{"2: long"});
  CHECK(narrow_places("auto c = static_cast<unsigned long>(x), d = 1L << 40, e = 7ul;") ==
        Places{"1: long", "1: 1L", "1: 7ul"});
  CHECK(narrow_places("mpz_set_si(a, b); mpz_divexact_ui(a, b, 4); mpz_divisible_ui_p(a, b); n.get_ui();\n"
                      "n.fits_slong_p(); mpz_bin_uiui(a, b, c);") == Places{"1: mpz_set_si", "1: mpz_divexact_ui",
                                                                            "1: mpz_divisible_ui_p", "1: get_ui",
                                                                            "2: fits_slong_p", "2: mpz_bin_uiui"});
  CHECK(narrow_places("f(std::lround(x), std::stoul(s), strtol(s, 0, 10));") ==
        Places{"1: lround", "1: stoul", "1: strtol"});
  CHECK(
      narrow_places("/* long\n long */ long x; // a long line\n\"a \\\" long text\" 'l' R\"(\n long)\" long y;") ==
      Places{"2: long", "4: long"});
  CHECK(narrow_places("x = 1'000'000l; long z;") == Places{"1: 1000000l", "1: long"});
  CHECK(narrow_places("long long a = 5LL + 0x9e37ull; long double b = 1.5L; std::int64_t c; int longest = 0x1L1;\n"
                      "mpz_mul_2exp(a, b, 3); std::llround(x); std::stoull(s); unsigned long long d;")
            .empty());
}

TEST_CASE("no number depends on the width of long", "[pages][widths]") {
  std::size_t seen = 0;
  for (const fs::path& file : sources()) {
    const std::string name = name_of(file);
    if (!name.starts_with("kernel/") && !name.starts_with("csg/")) continue;
    if (file.extension() != ".cpp" && file.extension() != ".h") continue;
    ++seen;
    if (name == "kernel/exact/integers.h") continue;  // hands numbers to GMP that are known to fit
    for (const std::string& place : narrow_places(text_of(file))) {
      FAIL_CHECK(name << ":" << place
                      << " has 32 bits on some platforms: use std::int64_t, and for numbers of GMP "
                      << "kernel/exact/integers.h");
    }
  }
  CHECK(seen > 600);
}

}  // namespace
}  // namespace cnrg
