// What a stranger gets: the built tree installed to a folder of its own, and a project outside that finds it.
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/install/installed.h"

namespace cnrg {
namespace {

using Catch::StartsWith;
namespace fs = std::filesystem;

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// The header and all that it includes by its path in the folder.
void add_closure(const fs::path& include, const std::string& header, std::set<std::string>& closure) {
  if (!closure.insert(header).second) return;
  std::ifstream file(include / header);
  INFO(header);
  CHECK(file.is_open());
  for (std::string line; std::getline(file, line);) {
    INFO(line);
    if (line.rfind("#include \"", 0) == 0) {
      add_closure(include, line.substr(10, line.find('"', 10) - 10), closure);
    } else if (line.rfind("#include <", 0) == 0 && line.find('/') != std::string::npos) {
      FAIL_CHECK("a header of another library, which who uses ours would need");
    }
  }
}

TEST_CASE("the installed headers are cnrg.h and what it includes", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  const fs::path include = w.path("installed/include/cnrg");
  std::set<std::string> installed, closure;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(include)) {
    if (entry.is_regular_file()) installed.insert(fs::relative(entry.path(), include).generic_string());
  }
  add_closure(include, "cnrg.h", closure);
  CHECK(installed == closure);
  // A surface that a person can read: whoever makes it larger says why here. Ten are all that the Python module
  // asks of a result, in plain numbers and texts. Eight are what is said of cells, and who decides where two say
  // different things: attributes, names, dominance, gradients and their samples, `said`, `say`. Three are
  // `select`, which asks for it, how a tree says so, and what may be asked for. One has lists of cells by
  // dimension, for all of these.
  CHECK(installed.size() <= 55);
}

TEST_CASE("each installed header compiles by itself", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  succeed(
      w, "find installed/include/cnrg -name '*.h' -print0 | xargs -0 -n 1 -P 2 " + quoted(CNRG_CXX) +
             " -std=c++20 -Wall -Wextra -Werror -fsyntax-only -Iinstalled/include/cnrg -x c++ /dev/null -include");
}

TEST_CASE("the installed program runs", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  CHECK_THAT(succeed(w, "installed/bin/cnrg --version"), StartsWith("cnrg "));
}

TEST_CASE("the manual page and the completions are installed, and are those of the program", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  CHECK(w.read("installed/share/man/man1/cnrg.1") == succeed(w, "installed/bin/cnrg manual"));
  CHECK(w.read("installed/share/bash-completion/completions/cnrg") == succeed(w, "installed/bin/cnrg completion"));
  CHECK(w.read("installed/share/zsh/site-functions/_cnrg") == succeed(w, "installed/bin/cnrg completion zsh"));
  CHECK(w.read("installed/share/fish/vendor_completions.d/cnrg.fish") ==
        succeed(w, "installed/bin/cnrg completion fish"));
  CHECK(w.read("installed/share/cnrg/tree.schema.json") == succeed(w, "installed/bin/cnrg schema"));
  CHECK(succeed(w, "MANPATH=\"$PWD/installed/share/man\" man -w cnrg").find("cnrg.1") != std::string::npos);
  CHECK(
      succeed(w, "bash --norc -c 'source installed/share/bash-completion/completions/cnrg && complete -p cnrg'") ==
      "complete -F _cnrg cnrg\n");
}

TEST_CASE("a project outside finds, compiles, links and runs the installed library", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  succeed(w, quoted(CNRG_CMAKE) +
                 " -S '" CNRG_CONSUMER "' -B consumer -G '" CNRG_GENERATOR
                 "'"
                 " -DCMAKE_PREFIX_PATH=" +
                 quoted(w.path("installed").string()) + " " CNRG_CONSUMER_OPTIONS);
  succeed(w, quoted(CNRG_CMAKE) + " --build consumer");
  CHECK(succeed(w, "consumer/consumer") ==
        "a 8, center in a cell of dimension 3\n"
        "2 regions, \n"
        "2 regions, \n"
        "2 components, as before: 2\n");
}

}  // namespace
}  // namespace cnrg
