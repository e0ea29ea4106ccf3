// The small corpus of the fuzzers, with what they have found, in the build of all other tests: what was mended
// stays mended, and the fuzzers have where to start.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "tests/campaign/fuzz/targets.h"
#include "tests/catch.h"

namespace cnrg::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = CNRG_FUZZ_CORPUS;

std::set<fs::path> files_of(const std::string& target) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kCorpus / target)) files.insert(entry.path());
  return files;
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_CASE("the fuzzers' corpus and past finds are read without a fault", "[fuzz]") {
  limit_children();
  for (const Target& target : targets()) {
    for (const fs::path& file : files_of(target.name)) {
      INFO(file.string());
      CHECK_NOTHROW(target.run(content_of(file)));
    }
    CHECK_NOTHROW(target.run(""));
  }
}

TEST_CASE("the fuzzers' corpus stays small, and none of it is without a fuzzer", "[fuzz]") {
  std::uintmax_t total = 0;
  std::map<std::string, std::size_t> counts{{"step", 1}, {"brep", 1}};  // a build may be without these
  for (const Target& target : targets()) counts[target.name] = 0;
  for (const auto& folder : fs::directory_iterator(kCorpus)) {
    const std::string name = folder.path().filename().string();
    CAPTURE(name);
    REQUIRE(counts.contains(name));
    for (const fs::path& file : files_of(name)) {
      ++counts[name];
      total += fs::file_size(file);
    }
  }
  CHECK(total < 200'000);
  for (const auto& [name, count] : counts) {
    CAPTURE(name);
    CHECK(count > 0);
  }
}

}  // namespace
}  // namespace cnrg::fuzz
