// What starting costs: libraries that most runs never need are not loaded, and strange ones never.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

constexpr const char* kMeasuredBox = "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 2, 3]}}\nresult: a\n";

TEST_CASE("the rows of a box take at most 20 shared objects, also of those that are opened", "[app]") {
  const Workshop w;
  w.write("box.yaml", kMeasuredBox);
  const Outcome o = w.shell("LD_DEBUG=files LD_DEBUG_OUTPUT=loaded '" CNRG_PROGRAM
                            "' eval box.yaml >.err 2>&1 && grep -h 'generating link map' loaded.* >.out 2>>.err");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK(lines_in(o.out) > 5);  // some are
  CHECK(lines_in(o.out) <= 20);
  for (const char* library : {"libTK", "libhdf5", "libcairo", "libtet"})
    CHECK(o.out.find(library) == std::string::npos);
}

TEST_CASE("the rows of a box take at most 25 million instructions", "[app]") {
  if (std::system("command -v valgrind >/dev/null") != 0) NOT_RUN("valgrind is not installed (Debian: valgrind)");
  const Workshop w;
  w.write("box.yaml", kMeasuredBox);
  const Outcome o = w.shell("valgrind --tool=callgrind --callgrind-out-file=/dev/null '" CNRG_PROGRAM
                            "' eval box.yaml >.out 2>.err");
  INFO(o.err);
  REQUIRE(o.status == 0);
  const std::string key = "Collected : ";
  const std::size_t place = o.err.find(key);
  REQUIRE(place != std::string::npos);
  const long long instructions = std::stoll(o.err.substr(place + key.size()));
  CHECK(instructions > 1'000'000);  // it was counted
  CHECK(instructions <= 25'000'000);
}

TEST_CASE("cnrg-eval tells of the libraries that it can use", "[app]") {
  const Workshop w;
  const Outcome o = w.shell("\"$(dirname '" CNRG_PROGRAM "')/cnrg-eval\" --version >.out 2>.err");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  for (const char* library : {"cnrg-eval ", "CGAL ", "yaml-cpp ", "OpenCASCADE"})
    CHECK(o.out.find(library) != std::string::npos);
  for (const char* library : {"HDF5", "cairo", "TetGen"}) CHECK(o.out.find(library) == std::string::npos);
}

/// A workshop with a copy of the program and its plug-ins, to be spoilt.
struct CopiedProgram : Workshop {
  CopiedProgram() {
    const Outcome o = shell("{ mkdir -p bin && cd \"$(dirname '" CNRG_PROGRAM
                            "')\" && cp -r cnrg plugins \"$OLDPWD/bin\"; } >.out 2>.err");
    REQUIRE(o.status == 0);
  }
  Outcome run(const std::string& words) const { return shell("bin/" + words + " >.out 2>.err"); }
};

/// It is said once in the versions, and what needs it is refused with the same words.
void check_refused(const CopiedProgram& w, const std::string& fault) {
  INFO(fault);
  const Outcome versions = w.run("cnrg --version");
  INFO(versions.out << versions.err);
  CHECK(versions.status == 0);
  CHECK(versions.out.find(fault) != std::string::npos);
  const Outcome o = w.run("cnrg eval model.yaml -o model.h5m");
  INFO(o.err);
  CHECK(o.status == 2);
  CHECK(o.err.find("model.h5m: " + fault + ", or write .msh or .vtu") != std::string::npos);
  CHECK(lines_in(o.err) == 1);
}

TEST_CASE("a plug-in that is missing, cut short, damaged or of another build is one error", "[app]") {
  const CopiedProgram w;
  w.write("model.yaml", kMeasuredBox);
  const std::filesystem::path file = std::filesystem::canonical(w.path("bin/plugins/cnrg_hdf5.so"));
  const std::string place = file.string(), again = ": install or build cnrg again, with it";
  const auto closed = [&](const std::string& reason) {
    return "the plug-in for HDF5 cannot be opened (" + reason + ")" + again;
  };
  const std::uintmax_t size = std::filesystem::file_size(file);
  for (const std::uintmax_t bytes : {size - 1, size / 2, std::uintmax_t(4096), std::uintmax_t(64)}) {
    std::filesystem::resize_file(file, bytes);
    check_refused(w, closed(place + ": it is cut short: " + std::to_string(bytes) + " bytes are left"));
  }
  std::filesystem::resize_file(file, 63);
  check_refused(w, closed(place + ": it is no module"));
  std::filesystem::remove(file);
  check_refused(w, closed("cnrg_hdf5.so: cannot open shared object file: No such file or directory"));
  std::filesystem::copy_file(file.parent_path() / "cnrg_cad.so", file);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2);  // zeros, as a crash leaves them
  check_refused(w, closed(place + ": its table of sections is damaged"));
  std::filesystem::remove(file);
  // Any shared library will do: one that the program has loaded.
  const Outcome copied =
      w.shell("{ cp \"$(ldd '" CNRG_PROGRAM "' | sed -nE 's/.*gmp.* => ([^ ]+) .*/\\1/p' | head -1)\" '" + place +
              "'; } >.out 2>.err");
  REQUIRE(copied.status == 0);
  check_refused(w, "the file " + place + " is no plug-in for HDF5 of this build of cnrg" + again);
}

}  // namespace
}  // namespace cnrg
