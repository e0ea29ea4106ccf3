#include "bench/cases/child.h"

#include <gmp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>

namespace cnrg::bench {
namespace {

constexpr int kOutOfMemory = 77, kUnheard = 78;

void* checked(void* memory) {
  if (memory == nullptr) _exit(kOutOfMemory);
  return memory;
}

/// GMP calls abort() without memory, and that would be taken for a crash.
void guard_gmp() {
  mp_set_memory_functions(
      [](std::size_t size) { return checked(std::malloc(size)); },
      [](void* old, std::size_t, std::size_t size) { return checked(std::realloc(old, size)); },
      [](void* old, std::size_t) { std::free(old); });
}

[[noreturn]] void child(const std::function<std::string()>& work, const Limits& limits, int pipe, pid_t parent) {
  // Nobody measures or waits once the parent is gone.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  guard_gmp();
  setsid();  // what it starts can be ended with it
  if (limits.bytes != 0) {
    const rlimit address{limits.bytes, limits.bytes};
    setrlimit(RLIMIT_AS, &address);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  int status = 0;
  try {
    const std::string text = work();
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t n = write(pipe, text.data() + at, text.size() - at);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) _exit(kUnheard);
      at += static_cast<std::size_t>(n);
    }
  } catch (const std::bad_alloc&) {
    status = kOutOfMemory;
  }
  _exit(status);
}

}  // namespace

ChildResult run_child(const std::function<std::string()>& work, const Limits& limits) {
  using Clock = std::chrono::steady_clock;
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error(std::string("no pipe to a process: ") + std::strerror(errno));
  const auto begin = Clock::now();
  const pid_t self = getpid();
  const pid_t pid = fork();
  if (pid < 0) {
    const int reason = errno;
    close(ends[0]), close(ends[1]);
    throw std::runtime_error(std::string("no process: ") + std::strerror(reason));
  }
  if (pid == 0) {
    close(ends[0]);
    child(work, limits, ends[1], self);
  }
  close(ends[1]);
  ChildResult result;
  int unheard = 0;
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  char buffer[4096];
  for (;;) {
    int wait = -1;
    if (limits.seconds > 0) wait = static_cast<int>(1000 * (limits.seconds - elapsed())) + 1;
    pollfd ready{ends[0], POLLIN, 0};
    if ((limits.seconds > 0 && wait <= 0) || poll(&ready, 1, wait) == 0) {
      kill(-pid, SIGKILL);
      kill(pid, SIGKILL);
      result.end = ChildResult::End::timeout;
      break;
    }
    const ssize_t n = read(ends[0], buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) unheard = errno;
    if (n <= 0) break;
    result.text.append(buffer, static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  kill(-pid, SIGKILL);  // what it left behind
  result.seconds = elapsed();
  result.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  if (result.end == ChildResult::End::timeout) return result;
  if (unheard != 0)
    throw std::runtime_error(std::string("the answer of a process cannot be read: ") + std::strerror(unheard));
  if (WIFEXITED(status) && WEXITSTATUS(status) == kUnheard)
    throw std::runtime_error("a process cannot write its answer");
  if (WIFSIGNALED(status)) {
    result.end = ChildResult::End::crash;
    result.signal = WTERMSIG(status);
  } else if (WEXITSTATUS(status) == kOutOfMemory) {
    result.end = ChildResult::End::out_of_memory;
  }
  return result;
}

}  // namespace cnrg::bench
