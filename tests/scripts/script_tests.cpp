// Tests of what is written in Python are written in Python: test_*.py in the folder of their room. Here
// each of their methods becomes a test case, `test_a_fault_is_named` of test_rows.py the case "a fault is named"
// with the tag [rows]. All of them run in one process, which loads its modules once; a case that is chosen by name
// runs alone.
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>

#include "tests/catch.h"

extern const char kSuite[];  // the command that runs the tests of the room

namespace cnrg {
namespace {

struct Ended {
  int status = -1;
  std::string out;
};

/// Runs the suite; its errors are in the text, too.
Ended suite(const std::string& argument) {
  const std::string command = std::string(kSuite) + " " + argument + " 2>&1";
  Ended ended;
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ended;
  std::array<char, 4096> buffer{};
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) ended.out.append(buffer.data(), n);
  const int status = pclose(pipe);
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

const Ended& all_of_it() {
  static const Ended ended = suite("");
  return ended;
}

/// What the suite says of a test: from its line to the next one that is not indented. Nothing: it did not end.
std::string said_of(const std::string& id, const std::string& out) {
  std::istringstream lines(out);
  std::string said;
  bool here = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != ' ')
      here = line == "passed " + id || line == "failed " + id || line == "skipped " + id;
    if (here) said += line + "\n";
  }
  return said;
}

class PythonTest : public Catch::ITestInvoker {
 public:
  explicit PythonTest(std::string id) : id_(std::move(id)) {}
  void invoke() const override {
    static const bool chosen = Catch::getCurrentContext().getConfig()->hasTestFilters();
    const Ended ended = chosen ? suite(id_) : all_of_it();
    const std::string said = said_of(id_, ended.out);
    INFO((said.empty() ? ended.out : said));
    const std::string skipped = "skipped " + id_ + "\n";  // it says why
    if (said.rfind(skipped, 0) == 0) WARN(said);
    else CHECK(said == "passed " + id_ + "\n");
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
  Catch::AutoReg(Catch::Invoker(test), CATCH_INTERNAL_LINEINFO, "", Catch::NameAndTags(name, tag));
}

[[maybe_unused]] const bool registered = [] {
  const Ended list = suite("--list");
  if (list.status != 0) {
    add(new NoTests(list.out), "the tests of this room can be listed", "[suite]");
    return false;
  }
  std::istringstream lines(list.out);
  std::set<std::string> names;  // two classes may have a test of one name
  for (std::string id; std::getline(lines, id);) {
    const std::size_t dot = id.find_last_of('.');
    std::string name = id.substr(dot + 1), tag = id.substr(0, id.find('.'));
    for (std::string* text : {&name, &tag})
      if (text->rfind("test_", 0) == 0) text->erase(0, 5);
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::size_t module_end = id.find('.');
    if (!names.insert(name).second) name += " (" + id.substr(module_end + 1, dot - module_end - 1) + ")";
    add(new PythonTest(id), name, "[" + tag + "]");
  }
  return true;
}();

}  // namespace
}  // namespace cnrg
