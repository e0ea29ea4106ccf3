// A build without plug-ins: this program has a csg/text/plugin.cpp of its own, compiled with none.
#include <string>

#include "csg/formats/result_file.h"
#include "csg/text/plugin.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::string remedy_of(const Plugin& plugin) {
  return std::string("this cnrg was built without ") + plugin.library + ": install " + plugin.package +
         " and build cnrg again with " + plugin.option + "=ON";
}

TEST_CASE("a build without a plug-in says what to install, and how to build with it", "[direct]") {
  for (const Plugin* plugin : kPlugins) {
    const std::string remedy = remedy_of(*plugin);
    CHECK(plugin_fault(*plugin) == remedy);
    CHECK_THROWS_WITH(plugin_version(*plugin), remedy);
  }
  CHECK_THROWS_WITH(check_file_name("model.step"),
                    "model.step: " + remedy_of(kCadPlugin) + ", or write .msh or .json");
}

}  // namespace
}  // namespace cnrg
