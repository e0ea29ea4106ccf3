// Faults of the system by injection: a fixed small part of `tests/campaign/faults/run`; and that it finds programs
// which take a fault badly. These are scripts around ours: they fail where it fails, and then do something wrong.
#include <filesystem>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

Outcome faults(const Workshop& w, const std::string& options) {
  return w.shell("'" CNRG_SOURCES "/tests/campaign/faults/run' --built '" CNRG_BUILD "' " + options +
                 " >.out 2>.err");
}

TEST_CASE("each fault of the small part is survived or told", "[faults]") {
  const Workshop w;
  const Outcome o = faults(w, "--small");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains(" faults, 0 wrong\n"));
}

TEST_CASE("programs that take a fault badly are found", "[faults]") {
  struct Liar {
    std::string when_failed, found;
    std::string options{};
  };
  const Liar liars[] = {
      {"exit 0", "an old file stays, and the status is 0"},
      {"exit 4", "exit status 4"},
      {"kill -ABRT $$", "ended by SIGABRT"},
      {"sleep 60", "no end", " --seconds 8"},  // undisturbed it ends before, on a busy machine, too
      {"sleep 60 >/dev/null 2>&1 & exit 3", "a process stays behind"},
      {"echo part >r.json; exit 3", "a file is not whole"},
      {"rm r.json; exit 3", "an old file is gone"},
      {"touch r.json.7.0.tmp; exit 3", "a file stays: r.json.N.N.tmp"},
      {"echo 'cnrg: error: memory ran out' >&2; exit 3", "2 error lines"},
      {"echo more; exit 3", "another output"},
  };
  for (const Liar& liar : liars) {
    const Workshop w;
    w.write("liar", "#!/bin/sh\n'" CNRG_PROGRAM "' \"$@\" && exit\n" + liar.when_failed + "\n");
    std::filesystem::permissions(w.path("liar"), std::filesystem::perms::owner_all);
    const Outcome o = faults(w, "--program ./liar --only 'write .json' --kind flush" + liar.options);
    INFO(liar.when_failed << "\n" << o.out << o.err);
    CHECK(o.status == 1);
    CHECK_THAT(o.out, Contains("1 faults, 1 wrong") && Contains(liar.found));
  }
  const Workshop w;
  w.write("mute", "#!/bin/sh\nexec '" CNRG_PROGRAM "' \"$@\" 2>/dev/null\n");
  std::filesystem::permissions(w.path("mute"), std::filesystem::perms::owner_all);
  CHECK_THAT(faults(w, "--program ./mute --only 'write .json' --kind flush").out, Contains("0 error lines"));
}

}  // namespace
}  // namespace cnrg
