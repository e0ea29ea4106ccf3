// The report of a sweep is a script (bench/report), and so are its tests, in this folder: test_*.py. Here each of
// their methods becomes a test case, `a_fault_is_named` of test_rows.py the case "a fault is named", tag [rows].
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <sstream>
#include <string>

namespace cnrg {
namespace {

struct Ended {
  int status = -1;
  std::string out;
};

/// The suite with one argument; its errors are in the text, too.
Ended suite(const std::string& argument) {
  const std::string command = "/usr/bin/python3 '" CNRG_SOURCES "/tests/report/suite.py' '" + argument + "' 2>&1";
  Ended ended;
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ended;
  std::array<char, 4096> buffer{};
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) ended.out.append(buffer.data(), n);
  const int status = pclose(pipe);
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

class PythonTest : public Catch::ITestInvoker {
 public:
  explicit PythonTest(std::string id) : id_(std::move(id)) {}
  void invoke() const override {
    const Ended ended = suite(id_);
    INFO(ended.out);
    CHECK(ended.status == 0);
  }

 private:
  std::string id_;  // module.Class.test_name
};

/// The suite cannot say which tests it has.
class NoTests : public Catch::ITestInvoker {
 public:
  explicit NoTests(std::string why) : why_(std::move(why)) {}
  void invoke() const override { FAIL(why_); }

 private:
  std::string why_;
};

void add(Catch::ITestInvoker* test, const std::string& name, const std::string& tag) {
  Catch::getMutableRegistryHub().registerTest(
      Catch::makeTestCase(test, "", Catch::NameAndTags(name, tag), CATCH_INTERNAL_LINEINFO));
}

[[maybe_unused]] const bool registered = [] {
  const Ended list = suite("--list");
  if (list.status != 0) {
    add(new NoTests(list.out), "the tests of the report can be listed", "[suite]");
    return false;
  }
  std::istringstream lines(list.out);
  for (std::string id; std::getline(lines, id);) {
    std::string name = id.substr(id.find_last_of('.') + std::string(".test_").size());
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string module = id.substr(0, id.find('.'));
    add(new PythonTest(id), name, "[" + module.substr(std::string("test_").size()) + "]");
  }
  return true;
}();

}  // namespace
}  // namespace cnrg
