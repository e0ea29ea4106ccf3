// Keys of papers in comments of the code, in the table of papers and as names of folders are in references.bib.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace cnrg {
namespace {

namespace fs = std::filesystem;
using Keys = std::set<std::string>;

const fs::path kSources = CNRG_SOURCES;

/// Words that look like a key: letters and a year.
Keys keys_in(const std::string& text) {
  static const std::regex key("\\b[a-z]{3,}(1[89]|20)[0-9]{2}\\b");
  Keys keys;
  for (std::sregex_iterator i(text.begin(), text.end(), key), end; i != end; ++i) keys.insert(i->str());
  return keys;
}

std::string read(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Keys bibliography() {
  static const std::regex entry("@[a-z]+\\{([^,]+),");
  const std::string text = read(kSources / "papers" / "references.bib");
  Keys keys;
  for (std::sregex_iterator i(text.begin(), text.end(), entry), end; i != end; ++i) keys.insert(i->str(1));
  return keys;
}

/// The comments of a file: from the mark on, line by line; a mark in an address is none.
std::string comments_of(const fs::path& path) {
  const std::string extension = path.extension().string();
  const std::string mark = extension == ".cpp" || extension == ".h" ? "//" : "#";
  std::ifstream stream(path);
  std::string comments;
  for (std::string line; std::getline(stream, line);) {
    std::size_t at = line.find(mark);
    while (at != std::string::npos && at > 0 && line[at - 1] == ':') at = line.find(mark, at + mark.size());
    if (at != std::string::npos) comments += line.substr(at) + "\n";
  }
  return comments;
}

TEST_CASE("keys are words with a year", "[papers]") {
  // Put together here, so that this file cites nobody.
  const std::string nobody =
      "nobody"
      "1999";
  CHECK(keys_in("see " + nobody + " 3, and #998877, abc2100, v2001, x1991y") == Keys{nobody});
}

TEST_CASE("keys in comments of the code are in the bibliography", "[papers]") {
  const Keys known = bibliography();
  Keys cited;
  for (const char* room : {"kernel", "csg", "bench", "tests"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kSources / room)) {
      if (!entry.is_regular_file()) continue;
      const Keys keys = keys_in(comments_of(entry.path()));
      for (const std::string& key : keys) {
        INFO(fs::relative(entry.path(), kSources).string() << " cites " << key);
        CHECK(known.contains(key));
      }
      cited.insert(keys.begin(), keys.end());
    }
  }
  CHECK(cited.contains("pereira2012"));
  CHECK(cited.size() >= 8);
}

TEST_CASE("the table of papers, the folders and the bibliography agree", "[papers]") {
  const Keys known = bibliography();
  const Keys listed = keys_in(read(kSources / "papers" / "README.md"));
  for (const std::string& key : listed) {
    INFO("papers/README.md has " << key);
    CHECK(known.contains(key));
  }
  std::size_t folders = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kSources / "papers")) {
    if (!entry.is_directory()) continue;
    ++folders;
    const std::string key = entry.path().filename().string();
    INFO("papers/" << key);
    CHECK(known.contains(key));
    CHECK(listed.contains(key));
    for (const std::string& cited : keys_in(read(entry.path() / "README.md"))) {
      INFO("its page cites " << cited);
      CHECK(known.contains(cited));
    }
  }
  CHECK(folders >= 14);
}

}  // namespace
}  // namespace cnrg
