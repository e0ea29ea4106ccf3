// Children that end in every way, and a parent that goes on as if nothing had been.
#include "csg/text/child.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <thread>

#include "kernel/base/error.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Kind = ChildEnd::Kind;

ChildEnd run(const std::function<int()>& work, const ChildLimits& limits = {}) {
  return run_in_child("the library", limits, work);
}

/// Takes processor time for ever.
[[noreturn]] void spin() {
  for (std::atomic<unsigned> i = 0;; ++i) {
  }
}

TEST_CASE("a child that is stopped is gone at once", "[child]") {
  std::stop_source stop;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  CHECK_THROWS_AS(run_in_child(
                      "the library", {},
                      [] {
                        spin();
                        return 0;
                      },
                      stop.get_token()),
                  Stopped);
  other.join();
  CHECK(run_in_child(
            "the library", {}, [] { return 3; }, std::stop_source().get_token())
            .number == 3);
}

TEST_CASE("a child counts, and who waits sees it and may end it", "[child]") {
  const SharedCount count;
  const auto work = [&] {
    for (int i = 0; i < 1000; ++i) count.add();
    return 0;
  };
  CHECK(run(work).number == 0);
  CHECK(count.value() == 1000);
  std::size_t looks = 0, seen = 0;
  const auto spins = [&]() -> int {
    work();
    spin();
  };
  CHECK_THROWS_WITH(run_in_child("the library", {}, spins, {},
                                 [&] {
                                   ++looks;
                                   seen = count.value();
                                   if (seen == 2000) throw std::runtime_error("seen enough");
                                 }),
                    "seen enough");
  CHECK(looks > 0);
  CHECK(seen == 2000);
}

TEST_CASE("a child returns a number, and what it wrote", "[child]") {
  const MemoryFile file("the library");
  const std::vector<double> numbers{0.1, -0.0, 5e-324};
  const ChildEnd end = run([&] {
    file.write_list(numbers);
    file.write_list(std::string("words"));
    file.write_list(std::vector<int>{});
    return 7;
  });
  CHECK(end.kind == Kind::done);
  CHECK(end.number == 7);
  file.rewind();
  std::vector<double> back;
  std::string words;
  std::vector<int> none{1};
  file.read_list(back);
  file.read_list(words);
  file.read_list(none);
  CHECK(back == numbers);
  CHECK(std::signbit(back[1]));
  CHECK(words == "words");
  CHECK(none.empty());
  CHECK(file.rest() == 0);
  CHECK_THROWS_AS(file.read_value<int>(), InputError);
}

TEST_CASE("a list that says to be longer than its file is damaged", "[child]") {
  const MemoryFile file("the library");
  file.write_value(~std::uint64_t(0));
  file.write_value(1.0);
  file.rewind();
  std::vector<double> list;
  CHECK_THROWS_WITH(file.read_list(list), "the library returned a result that is damaged");
}

TEST_CASE("a crash, an end and an exception stay in the child", "[child]") {
  const ChildEnd crash = run([]() -> int {
    raise(SIGSEGV);
    return 0;
  });
  CHECK(crash.kind == Kind::signal);
  CHECK(crash.number == SIGSEGV);
  const ChildEnd aborted = run([]() -> int {
    std::fputs("first\nprogram: file.c:1: f: Assertion `a < b' failed.\n\n", stderr);
    std::abort();
  });
  CHECK(aborted.kind == Kind::signal);
  CHECK(aborted.said == "Assertion `a < b' failed.");
  for (const int status : {0, 1, 255}) {
    const ChildEnd ended = run([status]() -> int { _exit(status); });
    CHECK(ended.kind == Kind::strange);
    CHECK(ended.number == status);
  }
  CHECK(run([]() -> int { throw std::runtime_error("nobody hears this"); }).kind == Kind::strange);
  CHECK(run([]() -> int { throw std::bad_alloc(); }).kind == Kind::memory);
}

TEST_CASE("a child that does not end is ended", "[child]") {
  const ChildEnd late = run([]() -> int { spin(); }, {.seconds = 1});
  CHECK(late.kind == Kind::time);
  CHECK(late.seconds == 1);
}

// Sanitizers map more memory than any limit allows.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("a child that takes all memory is ended", "[child]") {
  const ChildEnd large = run(
      []() -> int {
        std::vector<std::string> kept;
        for (;;) kept.emplace_back(1 << 20, 'x');
      },
      {.seconds = 20, .bytes = 100 << 20});
  CHECK(large.kind == Kind::memory);
}
#endif

TEST_CASE("handlers of signals and blocked signals are the parent's", "[child]") {
  const auto before = signal(SIGSEGV, [](int) { _exit(100); });  // a child would seem to be done
  sigset_t blocked, old;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGXCPU);
  sigprocmask(SIG_BLOCK, &blocked, &old);
  CHECK(run([]() -> int {
          raise(SIGSEGV);
          return 0;
        }).kind == Kind::signal);
  CHECK(run([]() -> int { spin(); }, {.seconds = 1}).kind == Kind::time);
  sigprocmask(SIG_SETMASK, &old, nullptr);
  signal(SIGSEGV, before);
}

TEST_CASE("children may allocate, throw and print while other threads do", "[child]") {
  std::atomic<bool> stop{false};
  std::vector<std::thread> others;
  for (int i = 0; i < 3; ++i) {
    others.emplace_back([&] {
      while (!stop) {
        std::vector<std::string> texts(100, std::string(100, 'x'));
        try {
          throw std::runtime_error(texts[0]);
        } catch (const std::runtime_error&) {
        }
      }
    });
  }
  for (int i = 0; i < 50; ++i) {
    const ChildEnd end = run(
        [] {
          std::vector<std::string> texts(1000, std::string(1000, 'x'));
          std::puts(texts.back().c_str());
          try {
            throw std::runtime_error(texts[0]);
          } catch (const std::runtime_error&) {
            return 1;
          }
        },
        {.seconds = 5});
    CHECK(end.kind == Kind::done);
    CHECK(end.said.size() == 1000);
  }
  stop = true;
  for (std::thread& other : others) other.join();
}

}  // namespace
}  // namespace cnrg
