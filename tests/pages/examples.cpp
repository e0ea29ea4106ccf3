// What is shown is a pattern: parts without `...` have to be printed line by line, each after the one before it;
// the first part begins where the output does, the last one ends where it ends.
#include "tests/pages/examples.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

namespace cnrg {
namespace {

using Lines = std::vector<std::string>;

constexpr const char* kPrompt = "$ ";
constexpr const char* kAnything = "...";
const char* const kSeconds = "[0-9]+\\.[0-9]{3}";
// A row of time that is of no node: it has no name and no volume.
const char* const kStage = "( +(?:leaves|refinement|crossings|results)\\b.* {2})( *)([0-9]+\\.[0-9]{3})()";

/// The words of a line without what is free, and without the fraction behind a decimal.
Lines words_of(const std::string& whole) {
  static const std::regex fraction(" \\(-?[0-9]+(/[0-9]+)?\\)$"), seconds(kSeconds);
  std::istringstream stream(std::regex_replace(whole.substr(0, whole.find(" (the fraction has ")), fraction, ""));
  Lines words{std::istream_iterator<std::string>(stream), {}};
  // Before the volume, and how far that may be off.
  const std::size_t last = words.size() > 3 && words[words.size() - 2].starts_with("±") ? 3 : 2;
  const bool time = words.size() > last && std::regex_match(words[words.size() - last], seconds);
  if (time) words.erase(words.end() - static_cast<std::ptrdiff_t>(last));
  static const std::regex stage(kStage);
  if (std::regex_match(whole, stage)) words.pop_back();
  return words;
}

bool same(const std::string& a, const std::string& b) {
  return a.find_first_not_of(' ') == b.find_first_not_of(' ') && words_of(a) == words_of(b);
}

/// Whether lines [from, to) of `shown`, which have no `...`, are printed from line `at` on.
bool matches(const Lines& shown, std::size_t from, std::size_t to, const Lines& printed, std::size_t at) {
  if (printed.size() < at + (to - from)) return false;
  for (std::size_t i = from; i < to; ++i) {
    if (!same(shown[i], printed[at + i - from])) return false;
  }
  return true;
}

/// Without the blank lines at both ends.
Lines trimmed(Lines lines) {
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  lines.erase(lines.begin(), std::find_if(lines.begin(), lines.end(), [](const auto& l) { return !l.empty(); }));
  return lines;
}

}  // namespace

std::vector<Claim> claims_of(const Page& page, const CodeBlock& block) {
  std::vector<Claim> claims;
  if (!block.file.empty()) return claims;
  for (std::size_t i = block.begin; i < block.end; ++i) {
    if (page.lines[i].starts_with(kPrompt)) claims.push_back({page.lines[i].substr(2), i + 1, i + 1});
    else if (!claims.empty()) claims.back().end = i + 1;
  }
  return claims;
}

std::string difference(const Lines& shown, const Lines& all_printed) {
  const Lines printed = trimmed(all_printed);
  // Between two `...` the first place that fits is the best one; only the last part has to end where all ends.
  std::size_t at = 0, from = 0;
  bool anywhere = false;
  while (true) {
    std::size_t to = from;
    while (to < shown.size() && shown[to] != kAnything) ++to;
    const bool last = to == shown.size();
    const std::size_t size = to - from;
    if (anywhere && last && printed.size() >= at + size) at = printed.size() - size;
    if (anywhere && !last) {
      while (at + size <= printed.size() && !matches(shown, from, to, printed, at)) ++at;
    }
    if (!matches(shown, from, to, printed, at)) {
      std::size_t wrong = from;
      while (!anywhere && wrong < to && at + wrong - from < printed.size() &&
             same(shown[wrong], printed[at + wrong - from]))
        ++wrong;
      return "not printed there: " + shown[wrong];
    }
    at += size;
    if (last) break;
    anywhere = true;
    from = to + 1;
  }
  return at == printed.size() ? "" : "printed, too: " + printed[at];
}

Lines corrected(const Lines& shown, const Lines& printed) {
  if (difference(shown, printed).empty()) return shown;
  static const std::regex stage(kStage), seconds("^(.* {2})( *)([0-9]+\\.[0-9]{3})(  +[^ ].*)$");
  Lines result;
  std::size_t next = 0;
  for (const std::string& line : trimmed(printed)) {
    std::size_t i = next;
    while (i < shown.size() && !same(shown[i], line)) ++i;
    if (i < shown.size()) {
      result.push_back(shown[i]);
      next = i + 1;
      continue;
    }
    std::smatch match;
    if (std::regex_match(line, match, stage) || std::regex_match(line, match, seconds)) {
      const std::string zero = std::string(match.str(3).size() - 5, ' ') + "0.000";
      result.push_back(match.str(1) + match.str(2) + zero + match.str(4));
    } else {
      result.push_back(line);
    }
  }
  return result;
}

}  // namespace cnrg
