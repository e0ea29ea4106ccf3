// The pages of the papers: each command in them prints what the page says, and each tree is in such a command.
//
// A page shows a command as a line `$ cnrg ...` in a block of code; the lines below it are its claim: they must be
// printed, in this order. Lines may be left out, spaces and times are free, and `N/D (decimal)` counts as N/D, or
// as the decimal where D is long.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

const fs::path kPapers = fs::path(CNRG_SOURCES) / "papers";
constexpr std::size_t kLongDenominator = 12;  // digits

struct Claim {
  std::string arguments;  // of the program
  std::vector<std::string> lines;
};

std::vector<std::string> lines_of(std::istream&& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Claim> claims_of(const fs::path& page) {
  static const std::string prompt = "$ cnrg ", fence = "```";
  std::vector<Claim> claims;
  bool in_block = false, in_claim = false;
  for (const std::string& line : lines_of(std::ifstream(page))) {
    if (line.starts_with(fence)) {
      in_block = !in_block;
      in_claim = false;
    } else if (in_block && line.starts_with(prompt)) {
      claims.push_back({line.substr(prompt.size()), {}});
      in_claim = true;
    } else if (in_claim) {
      claims.back().lines.push_back(line);
    }
  }
  return claims;
}

/// The words of a line without what is free: decimals of fractions, the remark that one is too long to be printed,
/// and the time of a row (before the volume).
std::vector<std::string> words_of(const std::string& whole) {
  const std::string line = whole.substr(0, whole.find(" (the fraction has "));
  static const std::regex fraction("-?[0-9]+/([0-9]+)"), seconds("[0-9]+\\.[0-9]{3}");
  std::istringstream stream(line);
  std::vector<std::string> words;
  bool after_short = false, after_long = false;
  for (std::string word; stream >> word;) {
    const bool decimal = word.starts_with("(") && word.ends_with(")");
    if (decimal && after_long) words.back() = word.substr(1, word.size() - 2);
    else if (!(decimal && after_short)) words.push_back(word);
    std::smatch match;
    const bool is_fraction = std::regex_match(word, match, fraction);
    after_long = is_fraction && match.str(1).size() >= kLongDenominator;
    after_short = is_fraction && !after_long;
  }
  if (words.size() > 2 && std::regex_match(words[words.size() - 2], seconds)) words.erase(words.end() - 2);
  return words;
}

/// The first line of the claim that is not printed after those before it; empty if there is none.
std::string first_missing(const std::vector<std::string>& claim, const std::vector<std::string>& printed) {
  std::size_t next = 0;
  for (const std::string& line : claim) {
    const std::vector<std::string> words = words_of(line);
    while (next < printed.size() && words_of(printed[next]) != words) ++next;
    if (next == printed.size()) return line;
    ++next;
  }
  return {};
}

/// Folders of papers, or the files with an extension in one.
std::vector<fs::path> entries_of(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool wanted = extension.empty() ? entry.is_directory() : entry.path().extension() == extension;
    if (wanted) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST_CASE("claims are compared word by word", "[papers]") {
  const std::vector<std::string> printed{"node  op   regions  seconds  volume", "a  box  1  0.000  8",
                                         "b  cone  2  0.125  1/123456789012 (8.1e-12)",
                                         "c  box  1  0.001  1/2 (0.5)"};
  CHECK(first_missing({"a box 1 9.999 8", "b cone 2 0.000 8.1e-12", "c box 1 0.000 1/2"}, printed).empty());
  CHECK(first_missing({"a box 1 0.000 9"}, printed) == "a box 1 0.000 9");
  CHECK(first_missing({"a box 2 0.000 8"}, printed) == "a box 2 0.000 8");
  CHECK(first_missing({"b cone 2 0.000 8.2e-12"}, printed) == "b cone 2 0.000 8.2e-12");
  CHECK(first_missing({"c box 1 0.000 1/3 (0.5)"}, printed) == "c box 1 0.000 1/3 (0.5)");
  CHECK(first_missing({"c box 1 0.000 1/2", "a box 1 0.000 8"}, printed) == "a box 1 0.000 8");
}

TEST_CASE("what the pages of papers show is what the program prints", "[papers]") {
  const std::vector<fs::path> folders = entries_of(kPapers, "");
  REQUIRE(folders.size() >= 14);
  for (const fs::path& folder : folders) {
    DYNAMIC_SECTION(folder.filename().string()) {
      CHECK(fs::exists(folder / "README.md"));
      const Workshop w;
      fs::copy(kPapers, w.path("papers"), fs::copy_options::recursive);
      fs::create_directories(w.path("out") / folder.filename());
      std::set<std::string> shown;  // trees with a claim
      for (const fs::path& page : entries_of(folder, ".md")) {
        for (const Claim& claim : claims_of(page)) {
          INFO(page.filename().string() << ": cnrg " << claim.arguments);
          const Outcome o = w.run(claim.arguments);
          INFO(o.err << o.out);
          CHECK(o.status == 0);
          CHECK(first_missing(claim.lines, lines_of(std::istringstream(o.out))) == "");
          std::istringstream words(claim.arguments);
          for (std::string word; !claim.lines.empty() && words >> word;) shown.insert(word);
        }
      }
      for (const fs::path& tree : entries_of(folder, ".yaml")) {
        const std::string name = fs::relative(tree, CNRG_SOURCES).string();
        INFO(name << ": no page in its folder has a block with a line `$ cnrg eval " << name
                  << " ...` and rows of its output");
        CHECK(shown.contains(name));
      }
    }
  }
}

}  // namespace
}  // namespace cnrg
