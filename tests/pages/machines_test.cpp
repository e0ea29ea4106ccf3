// No machine decides what a result is: functions of the C library that differ from one to another are called in
// the places alone that the page lists.
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/catch.h"
#include "tests/pages/tables.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

/// A line of C++ that calls one; comments do not.
bool calls_library(std::string line) {
  line = line.substr(0, line.find("//"));
  static const std::regex function("\\bstd::(a?(sin|cos|tan)h?|atan2|hypot|polar)[fl]?\\(");
  return std::regex_search(line, function);
}

TEST_CASE("a line that calls a function of angles of the C library is found", "[pages][machines]") {
  for (const std::string line :
       {"x = std::sin(a);", "std::atan2(y, x)", "1 / std::hypot(a, b)", "std::acosh(2.0)"}) {
    INFO(line);
    CHECK(calls_library(line));
  }
  for (const std::string line : {"// std::sin(x)", "mpfr_sin(x, y)", "rounded::cosine(x)", "std::sinless(x)"}) {
    INFO(line);
    CHECK_FALSE(calls_library(line));
  }
}

TEST_CASE("functions of angles of the C library are called where the page says so, and nowhere else",
          "[pages][machines]") {
  std::set<std::string> listed, found;
  for (const PageTable& table : tables_of(read_page(root() / "csg" / "README.md"))) {
    if (table.anchor != "machines") continue;
    for (const std::vector<std::string>& row : table.rows) {
      for (const std::string& file : quoted_words(row[0])) listed.insert("csg/" + file);
    }
  }
  for (const fs::path& file : sources()) {
    const std::string name = name_of(file), extension = file.extension().string();
    if (!name.starts_with("kernel/") && !name.starts_with("csg/")) continue;
    if (extension != ".cpp" && extension != ".h") continue;
    for (const std::string& line : lines_of(text_of(file))) {
      if (calls_library(line)) found.insert(name);
    }
  }
  CHECK(found == listed);
}

}  // namespace
}  // namespace cnrg
