// Keys of papers in comments of the code, in the table of papers and as names of folders are in references.bib.
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/catch.h"
#include "tests/pages/page.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;
using Keys = std::set<std::string>;

/// Words that look like a key: letters and a year.
Keys keys_in(const std::string& text) {
  static const std::regex key("\\b[a-z]{3,}(1[89]|20)[0-9]{2}\\b");
  Keys keys;
  for (std::sregex_iterator i(text.begin(), text.end(), key), end; i != end; ++i) keys.insert(i->str());
  return keys;
}

Keys bibliography() {
  static const std::regex entry("@[a-z]+\\{([^,]+),");
  const std::string text = text_of(root() / "papers" / "references.bib");
  Keys keys;
  for (std::sregex_iterator i(text.begin(), text.end(), entry), end; i != end; ++i) keys.insert(i->str(1));
  return keys;
}

/// What people read of a file: all of a page; else the comments, from the mark on, line by line (a mark in an
/// address is none).
std::string prose_of(const fs::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".md") return text_of(path);
  const std::string mark = extension == ".cpp" || extension == ".h" ? "//" : "#";
  std::string comments;
  for (const std::string& line : lines_of(text_of(path))) {
    std::size_t at = line.find(mark);
    while (at != std::string::npos && at > 0 && line[at - 1] == ':') at = line.find(mark, at + mark.size());
    if (at != std::string::npos) comments += line.substr(at) + "\n";
  }
  return comments;
}

TEST_CASE("keys are words with a year", "[pages]") {
  // Put together here, so that this file cites nobody.
  const std::string nobody =
      "nobody"
      "1999";
  CHECK(keys_in("see " + nobody + " 3, and #998877, abc2100, v2001, x1991y") == Keys{nobody});
}

TEST_CASE("keys in comments and pages are in the bibliography", "[pages]") {
  const Keys known = bibliography();
  Keys cited;
  for (const fs::path& path : sources()) {
    const Keys keys = keys_in(prose_of(path));
    for (const std::string& key : keys) {
      INFO(name_of(path) << " cites " << key);
      CHECK(known.contains(key));
    }
    cited.insert(keys.begin(), keys.end());
  }
  CHECK(cited.contains("pereira2012"));
  CHECK(cited.size() >= 8);
}

TEST_CASE("the table of papers, the folders and the bibliography agree", "[pages]") {
  const Keys known = bibliography();
  const Keys listed = keys_in(text_of(root() / "papers" / "README.md"));
  std::size_t folders = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(root() / "papers")) {
    if (!entry.is_directory() || entry.path().filename() == "lessons") continue;
    ++folders;
    const std::string key = entry.path().filename().string();
    INFO("papers/" << key);
    CHECK(known.contains(key));
    CHECK(listed.contains(key));
    CHECK(fs::exists(entry.path() / "README.md"));
  }
  CHECK(folders >= 14);
}

}  // namespace
}  // namespace cnrg
