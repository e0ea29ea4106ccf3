// Each example prints what the comment at its end says, all of it and nothing else.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

namespace fs = std::filesystem;

/// The lines after the line `// Output:`, without their `// `.
std::string expected_output(const fs::path& source) {
  std::ifstream file(source);
  std::string text;
  bool found = false;
  for (std::string line; std::getline(file, line);) {
    if (found) text += line.substr(std::min<std::size_t>(3, line.size())) + "\n";
    if (line == "// Output:") found = true;
  }
  return text;
}

TEST_CASE("examples print what they say", "[examples]") {
  std::vector<fs::path> sources;
  for (const fs::directory_entry& entry : fs::directory_iterator(CNRG_EXAMPLES)) {
    if (entry.path().extension() == ".cpp") sources.push_back(entry.path());
  }
  std::sort(sources.begin(), sources.end());
  REQUIRE(sources.size() >= 6);
  for (const fs::path& source : sources) {
    const std::string name = source.stem().string();
    DYNAMIC_SECTION(name) {
      const Workshop w;
      const Outcome o = w.shell("'" CNRG_EXAMPLE_PROGRAMS "/example_" + name + "' >.out 2>.err");
      CHECK(o.status == 0);
      CHECK(o.err.empty());
      const std::string expected = expected_output(source);
      CHECK_FALSE(expected.empty());
      CHECK(o.out == expected);
    }
  }
}

}  // namespace
}  // namespace cnrg
