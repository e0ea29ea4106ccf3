// The child gets its input by the fork. It prints into a file in memory, and it never returns to the caller's
// code: it ends by _exit, whatever happens, without the caller's exit handlers and unwritten output.
//
// Handlers of signals are the caller's, too, and might write its reports or wait for its threads; the child has
// none. What the work returns is added to a status that no library is known to end a process with.
#include "csg/text/child.h"

#ifdef CNRG_FORK

#include <signal.h>
#include <sys/mman.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <thread>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr int kNoMemory = 98, kStrange = 99, kDone = 100;  // and up: what the work returned
constexpr int kMostNumber = 150;

/// Lowers a limit of this process, never raises it.
template <class Resource>
void lower(Resource resource, rlim_t soft, rlim_t hard) {
  rlimit limit;
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, soft);
  limit.rlim_max = std::min(limit.rlim_max, hard);
  setrlimit(resource, &limit);
}

/// Bytes of memory of its own that this process has, as RLIMIT_DATA counts them; 0 where the system does not tell.
std::size_t own_memory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kilobytes = 0;
  while (status >> word) {
    if (word == "VmData:" && status >> kilobytes) break;
  }
  return kilobytes * 1024;
}

/// Of processor time that a child has: ours, or those of the process, if these are fewer.
std::size_t seconds_of(const ChildLimits& limits) {
  rlimit limit;
  if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return limits.seconds;
  return limits.seconds == 0 ? limit.rlim_cur : std::min<std::size_t>(limits.seconds, limit.rlim_cur);
}

void obey(const ChildLimits& limits, std::size_t had, pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent) _exit(kStrange);  // it has ended before that
  for (int number = 1; number < NSIG; ++number) signal(number, number == SIGXFSZ ? SIG_IGN : SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  lower(RLIMIT_CORE, 0, 0);
  if (limits.seconds > 0) lower(RLIMIT_CPU, limits.seconds, limits.seconds + 1);
  if (limits.bytes > 0) {
    lower(RLIMIT_DATA, had + limits.bytes, RLIM_INFINITY);
    lower(RLIMIT_FSIZE, limits.bytes, RLIM_INFINITY);
    // Where the system runs out of memory all the same, it is the child that goes.
    std::ofstream("/proc/self/oom_score_adj") << 1000;
  }
}

/// For an exception that a library lets out where there is no catch. The caller's handler is not for its children.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    _exit(kNoMemory);
  } catch (...) {
  }
  std::abort();
}

[[noreturn]] void be_child(const ChildLimits& limits, std::size_t had, pid_t parent, const MemoryFile& said,
                           const std::function<int()>& work) {
  int status = kStrange;
  try {
    obey(limits, had, parent);
    dup2(said.descriptor(), STDOUT_FILENO);
    dup2(said.descriptor(), STDERR_FILENO);
    std::set_terminate(end_uncaught);
    status = kDone + std::min(work(), kMostNumber);
  } catch (const std::bad_alloc&) {
    status = kNoMemory;
  } catch (...) {
  }
  std::fflush(stdout);
  _exit(status);
}

/// The last line, without the program's name in front of a failed assertion.
std::string last_line(const std::string& text) {
  const std::size_t last_letter = text.find_last_not_of(" \t\r\n");
  if (last_letter == std::string::npos) return {};
  const std::size_t begin = text.rfind('\n', last_letter) + 1,
                    end = text.find('\n', last_letter);  // npos + 1 is 0
  const std::string last = text.substr(begin, end - begin);
  const auto assertion = last.find("Assertion");
  return assertion == std::string::npos ? last : last.substr(assertion);
}

ChildEnd end_of(int status) {
  using Kind = ChildEnd::Kind;
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return {.kind = number == SIGXCPU ? Kind::time : Kind::signal, .number = number};
  }
  const int number = WEXITSTATUS(status);
  if (number == kNoMemory) return {.kind = Kind::memory};
  if (number < kDone || number > kDone + kMostNumber) return {.kind = Kind::strange, .number = number};
  return {.number = number - kDone};
}

}  // namespace

MemoryFile::MemoryFile(std::string owner) : owner_(std::move(owner)) {
#ifdef __linux__
  descriptor_ = memfd_create("cnrg", MFD_CLOEXEC);
#else  // a file that has lost its name
  if (std::FILE* const file = std::tmpfile()) {
    descriptor_ = dup(fileno(file));
    std::fclose(file);
  }
#endif
  if (descriptor_ < 0) throw FileError(std::string("no file in memory: ") + std::strerror(errno));
}
MemoryFile::~MemoryFile() { close(descriptor_); }

std::size_t MemoryFile::seek(std::ptrdiff_t at, int whence) const {
  const off_t found = lseek(descriptor_, at, whence);
  if (found < 0) fail_by_system();
  return std::size_t(found);
}

void MemoryFile::rewind() const { seek(0, SEEK_SET); }

void MemoryFile::write(const void* data, std::size_t size) const {
  for (const char* at = static_cast<const char*>(data); size > 0;) {
    const ssize_t n = ::write(descriptor_, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw std::bad_alloc();
    at += n;
    size -= std::size_t(n);
  }
}

void MemoryFile::read(void* data, std::size_t size) const {
  for (char* at = static_cast<char*>(data); size > 0;) {
    const ssize_t n = ::read(descriptor_, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_by_system();
    if (n == 0) fail();
    at += n;
    size -= std::size_t(n);
  }
}

std::size_t MemoryFile::rest() const {
  const std::size_t at = seek(0, SEEK_CUR), end = seek(0, SEEK_END);
  seek(std::ptrdiff_t(at), SEEK_SET);
  return end - at;
}

std::string MemoryFile::text() const {
  rewind();
  std::string result(rest(), ' ');
  read(result.data(), result.size());
  return result;
}

void MemoryFile::fail_by_system() const {
  throw FileError("the result of " + owner_ + " cannot be read: " + std::strerror(errno));
}
void MemoryFile::fail() const { throw InputError(owner_ + " returned a result that is damaged"); }

SharedCount::SharedCount() {
  void* const page = mmap(nullptr, sizeof *count_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw std::bad_alloc();
  count_ = new (page) std::atomic<std::size_t>(0);
}
SharedCount::~SharedCount() { munmap(count_, sizeof *count_); }

ChildEnd run_in_child(const std::string& owner, const ChildLimits& limits, const std::function<int()>& work,
                      const std::stop_token& stop, const std::function<void()>& meanwhile) {
  const MemoryFile said(owner);
  const std::size_t seconds = seconds_of(limits);
  const std::size_t had = limits.bytes > 0 ? own_memory() : 0;
  std::fflush(stdout);  // so that the child has nothing of the caller's to print
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw FileError(owner + " could not be started: " + std::strerror(errno));
  if (child == 0) be_child(limits, had, parent, said, work);
  // A token wakes nobody who waits for a process: who may be stopped looks at it now and then.
  const bool looks = stop.stop_possible() || meanwhile;
  std::exception_ptr thrown;  // by who waits
  int status = 0;
  for (pid_t ended = 0; ended != child;) {
    ended = waitpid(child, &status, looks && !thrown ? WNOHANG : 0);
    if (ended < 0 && errno != EINTR) {
      const std::string why = std::strerror(errno);
      kill(child, SIGKILL);  // nobody will wait for it
      throw FileError(owner + " was lost: " + why);
    }
    if (ended != 0) continue;
    try {
      if (stop.stop_requested()) throw Stopped();
      if (meanwhile) meanwhile();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    } catch (...) {
      thrown = std::current_exception();
      kill(child, SIGKILL);
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  ChildEnd end = end_of(status);
  end.seconds = seconds;
  end.said = last_line(said.text());
  return end;
}

}  // namespace cnrg

#endif
