// Work without a process of its own, as on systems without fork: this program has csg/text/child_direct.cpp in the
// place of the library's own.
#include <new>
#include <stdexcept>
#include <vector>

#include "csg/text/child.h"
#include "kernel/base/error.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Kind = ChildEnd::Kind;

TEST_CASE("without fork work is done by the caller, and its end is told", "[direct]") {
  int here = 0;
  const ChildEnd done = run_in_child("work", {.seconds = 7}, [&] { return here = 3; });
  CHECK(here == 3);  // a child would have changed its own copy
  CHECK(done.kind == Kind::done);
  CHECK(done.number == 3);
  CHECK(done.seconds == 7);
  CHECK(run_in_child("work", {}, []() -> int { throw std::bad_alloc(); }).kind == Kind::memory);
  CHECK(run_in_child("work", {}, []() -> int { throw std::runtime_error("?"); }).kind == Kind::strange);
}

TEST_CASE("without fork a stop is seen when the work is done", "[direct]") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(run_in_child(
                      "work", {}, [] { return 0; }, source.get_token()),
                  Stopped);
}

TEST_CASE("without fork what is written is read, and no more", "[direct]") {
  const MemoryFile file("work");
  const SharedCount count;
  file.write_list(std::vector<int>{1, 2, 3});
  file.write_value(0.5);
  count.add();
  file.rewind();
  std::vector<int> list;
  file.read_list(list);
  CHECK(list == std::vector{1, 2, 3});
  CHECK(file.rest() == sizeof(double));
  CHECK(file.read_value<double>() == 0.5);
  CHECK_THROWS_WITH(file.read_value<int>(), "work returned a result that is damaged");
  CHECK(count.value() == 1);
}

}  // namespace
}  // namespace cnrg
