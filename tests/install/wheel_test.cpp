// A wheel of the Python module, made without the network of what is built, holds the library and works by itself.
// tests/packages/run makes one from the sources alone, which takes minutes.
#ifdef CNRG_PYTHON

#include <filesystem>

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/install/installed.h"

namespace cnrg {
namespace {

using Catch::Contains;
namespace fs = std::filesystem;

const char* const kScript = R"(import sys, numpy
def objects():
    return {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}
before = objects()
import cnrg
assert cnrg.__file__.startswith(sys.argv[1]), cnrg.__file__
assert "cnrg " + cnrg.__version__ == sys.argv[2].split("\n")[0], (cnrg.__version__, sys.argv[2])
ours = objects() - before
assert len(ours) < 25, sorted(ours)
model = cnrg.box([0, 0, 0], [2, 2, 2]) - cnrg.box([1, 1, 1], ["10/3", 3, 3])
ev = cnrg.evaluate(model)
assert ev.rows[-1].volume == 7, ev.rows
for name in ("model.json", "model.h5m", "model.step"):
    model.evaluate().write(name)
model.evaluate().picture("model.png")
try:
    cnrg.box([0, 0, 0], [1, 1, 0])
    model = cnrg.box([0, 0, 0], [1, 1, 0])
    model.evaluate()
except cnrg.InputError as e:
    print(e.message)
)";

TEST_CASE("a wheel of the Python module is built without the network, and works by itself", "[install][python]") {
  const Workshop w;
  // As in the repository; what building leaves beside the sources stays here.
  fs::create_directories(w.path("source/csg"));
  for (const char* file : {"CMakeLists.txt", "LICENSE"})
    fs::copy(fs::path(CNRG_SOURCES) / file, w.path("source") / file);
  fs::copy(CNRG_SOURCES "/csg/python", w.path("source/csg/python"), fs::copy_options::recursive);
  succeed(w, "PIP_DISABLE_PIP_VERSION_CHECK=1 CNRG_BUILD='" CNRG_BUILD "' '" CNRG_PYTHON
             "' -m pip wheel --no-build-isolation --no-deps --no-index -w wheels source/csg/python");
  succeed(w, "'" CNRG_PYTHON "' -m pip install --no-index --no-deps --target site wheels/cnrg-*.whl");
  for (const char* file : {"__init__.py", "py.typed", "_cnrg.pyi", "LICENSE"})
    CHECK(fs::exists(w.path("site/cnrg") / file));
  w.write("script.py", kScript);
  CHECK_THAT(succeed(w, "env -i PATH=\"$PATH\" PYTHONPATH=\"$PWD/site\" '" CNRG_PYTHON
                        "' -s script.py \"$PWD/site\" \"$('" CNRG_PROGRAM "' --version)\""),
             Contains("box"));
  for (const char* file : {"model.json", "model.h5m", "model.step", "model.png"}) {
    INFO(file);
    CHECK(fs::exists(w.path(file)));
  }
}

}  // namespace
}  // namespace cnrg

#endif
