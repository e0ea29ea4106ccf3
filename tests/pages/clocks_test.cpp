// No clock decides what a result is: sources read one in the places alone that the page lists.
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/catch.h"
#include "tests/pages/tables.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

/// A line of C++ that asks what time it is, or sets a bound of time; comments do not.
bool reads_clock(std::string line) {
  line = line.substr(0, line.find("//"));
  static const std::regex clock(
      "(steady|system|high_resolution|utc|file)_clock\\b|\\bclock_gettime\\b|\\bgetrusage\\b|\\bgettimeofday\\b|"
      "\\bCLOCK_[A-Z]+|\\bRLIMIT_CPU\\b|\\b(alarm|setitimer|timer_create)\\(|\\bclock\\(\\)|"
      "\\btime\\((nullptr|NULL|0|&)|\\bwait_(for|until)\\(|\\b__?rdtsc");
  return std::regex_search(line, clock);
}

TEST_CASE("a line that reads a clock is found", "[pages][clocks]") {
  for (const std::string line :
       {"auto t = std::chrono::steady_clock::now();", "  setrlimit(RLIMIT_CPU, &bound);", "srand(time(nullptr));",
        "if (clock() > end) break;", "alarm(10);", "ended_.wait_until(lock, token, until_, over)"}) {
    INFO(line);
    CHECK(reads_clock(line));
  }
  for (const std::string line : {"// steady_clock", "double seconds = 0;", "o_clock(3);", "runtime(nullptr);"}) {
    INFO(line);
    CHECK_FALSE(reads_clock(line));
  }
}

TEST_CASE("clocks are read where the page says so, and nowhere else", "[pages][clocks]") {
  std::set<std::string> listed, found;
  for (const PageTable& table : tables_of(read_page(root() / "csg" / "README.md"))) {
    if (table.anchor != "clocks") continue;
    for (const std::vector<std::string>& row : table.rows) {
      for (const std::string& file : quoted_words(row[0])) {
        const bool of_csg = fs::exists(root() / "csg" / file);
        listed.insert((of_csg ? "csg/" : "") + file);
      }
    }
  }
  for (const char* const part : {"kernel", "csg"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / part)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".h") continue;
      for (const std::string& line : lines_of(text_of(entry.path()))) {
        if (reads_clock(line)) found.insert(fs::relative(entry.path(), root()).generic_string());
      }
    }
  }
  CHECK(found == listed);
}

}  // namespace
}  // namespace cnrg
