// Makes one call of the system or of the C library fail: loaded by LD_PRELOAD in front of the C library, it counts
// calls by kind and answers the one with the chosen number as a system does that has no memory, no room, no right.
//
// Running out of memory or room for real happens where it happens; a run with a limit of memory fails at the same
// place each time, and mostly at the largest block. Here each call can be made to fail, one by one, and a run is
// repeatable as far as its threads are.
//
// Counting begins with `main`: what is in front of it belongs to the loader and to other libraries, before a line
// of the program runs. Counts are in a file that all processes of a run map, so that calls of children count, too,
// and whoever started the run reads what was counted and which call failed. The file is made by `run`, as is all
// else:
//
//   CNRG_FAULT_PAGE  that file
//   CNRG_FAULT       KIND:NUMBER:ANSWER:TIMES: calls NUMBER to NUMBER + TIMES - 1 of KIND, from 1 on, fail; ANSWER
//                    is a number of errno, or `short` for reads and writes that transfer half of what was asked
//                    for
//   CNRG_FAULT_OLD_DISK  no file may be without a name (O_TMPFILE), as on older file systems
//   CNRG_FAULT_TRACE where it happened is printed
//
// What the C library does inside of itself (a `read` by `fread`) is not seen, so calls of both layers are here.
// Memory is asked of the C library by its inner names, since a search for the outer ones asks for memory itself.
#include <dirent.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t n, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

/// As `run` numbers them.
enum Kind {
  memory,
  map,
  open_file,
  read_data,
  write_data,
  flush,
  close_file,
  rename_file,
  remove_file,
  truncate_file,
  start_process,
  open_pipe,
  wait_process,
  start_thread,
  inspect,
  kinds,
};
constexpr const char* kNames[kinds] = {"memory",  "map",   "open",   "read",   "write",
                                       "flush",   "close", "rename", "remove", "truncate",
                                       "process", "pipe",  "wait",   "thread", "inspect"};

struct Page {
  std::atomic<std::uint64_t> counts[kinds];
  std::atomic<std::uint64_t> failed;  ///< how many calls
  std::int64_t descriptor;            ///< of the first of them; -1: it had none
  char call[40];                      ///< its name
};
Page* page = nullptr;

constexpr int kNoFault = 0, kShort = -1;
int chosen_kind = -1, answer = kNoFault;
std::uint64_t first = 0, last = 0;
bool traces = false, old_disk = false;

/// The function of that name behind this library. What is asked for before `main` is found then, too.
template <class Function>
Function* behind(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
#define CNRG_BEHIND(name)                \
  static decltype(&name) next = nullptr; \
  if (next == nullptr) next = behind<decltype(name)>(#name)

/// A call that is counted as of a kind, with the file it is of (or -1): it answers `failed`, or what the function
/// behind does with these arguments. And one that is the system's without the C library.
#define CNRG_CALL(kind, file, result, name, parameters, failed, ...) \
  result name parameters {                                           \
    CNRG_BEHIND(name);                                               \
    return fails(kind, #name, file) ? failed : next(__VA_ARGS__);    \
  }
#define CNRG_SYSTEM_CALL(kind, file, result, name, parameters, ...) \
  result name parameters noexcept { return fails(kind, #name, file) ? -1 : result(syscall(__VA_ARGS__)); }

/// Reads CNRG_FAULT; false if it is none.
bool read_choice(const char* text) {
  const char* const colon = std::strchr(text, ':');
  if (colon == nullptr) return false;
  for (int kind = 0; kind < kinds; ++kind) {
    if (std::strncmp(text, kNames[kind], size_t(colon - text)) == 0 && kNames[kind][colon - text] == '\0')
      chosen_kind = kind;
  }
  char* at = nullptr;
  first = std::strtoull(colon + 1, &at, 10);
  if (*at != ':') return false;
  if (std::strncmp(at + 1, "short:", 6) == 0) {
    answer = kShort;
    at += 6;
  } else {
    answer = int(std::strtol(at + 1, &at, 10));
  }
  if (*at != ':') return false;
  last = first + std::strtoull(at + 1, nullptr, 10) - 1;
  return chosen_kind >= 0 && first > 0;
}

void begin() {
  const char* const name = std::getenv("CNRG_FAULT_PAGE");
  if (name == nullptr) return;
  const int file = int(syscall(SYS_openat, AT_FDCWD, name, O_RDWR | O_CLOEXEC));
  if (file < 0) return;
  void* const mapped = reinterpret_cast<void*>(
      syscall(SYS_mmap, nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
  syscall(SYS_close, file);
  if (mapped == MAP_FAILED) return;
  const char* const choice = std::getenv("CNRG_FAULT");
  if (choice != nullptr && !read_choice(choice)) _exit(125);
  old_disk = std::getenv("CNRG_FAULT_OLD_DISK") != nullptr;
  traces = std::getenv("CNRG_FAULT_TRACE") != nullptr;
  if (traces) {
    void* frame;
    backtrace(&frame, 1);  // loads what it needs now, not inside of an allocation
  }
  page = static_cast<Page*>(mapped);
}

/// Counts a call; an errno or kShort if it is to fail.
int fault(Kind kind, const char* call, int descriptor = -1) {
  if (page == nullptr) return kNoFault;
  const std::uint64_t number = page->counts[kind].fetch_add(1) + 1;
  if (kind != chosen_kind || number < first || number > last) return kNoFault;
  if (page->failed.fetch_add(1) == 0) {
    page->descriptor = descriptor;
    std::strncpy(page->call, call, sizeof page->call - 1);
  }
  if (traces) {
    void* frames[60];
    backtrace_symbols_fd(frames, backtrace(frames, 60), 2);
  }
  if (answer != kShort) errno = answer;
  return answer;
}

/// The same for calls that cannot be short.
bool fails(Kind kind, const char* call, int descriptor = -1) {
  const int kind_of_fault = fault(kind, call, descriptor);
  return kind_of_fault != kNoFault && kind_of_fault != kShort;
}

int open_at(const char* call, int folder, const char* path, int flags, mode_t mode) {
  if (fails(open_file, call)) return -1;
  if (old_disk && (flags & O_TMPFILE) == O_TMPFILE) {
    errno = EOPNOTSUPP;
    return -1;
  }
  return int(syscall(SYS_openat, folder, path, flags, mode));
}

size_t half(size_t size) { return size > 1 ? size / 2 : size; }

using Main = int (*)(int, char**, char**);
Main real_main = nullptr;
int counted_main(int argc, char** argv, char** environment) {
  begin();
  return real_main(argc, argv, environment);
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*end)(),
                      void* stack) {
  using Start = int(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  return behind<Start>("__libc_start_main")(counted_main, argc, argv, init, fini, end, stack);
}

// --- memory

void* malloc(size_t size) { return fails(memory, "malloc") ? nullptr : __libc_malloc(size); }
void* calloc(size_t n, size_t size) { return fails(memory, "calloc") ? nullptr : __libc_calloc(n, size); }
void* realloc(void* old, size_t size) { return fails(memory, "realloc") ? nullptr : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) {
  return fails(memory, "memalign") ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  return fails(memory, "aligned_alloc") ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** result, size_t alignment, size_t size) {
  const int before = errno;
  void* const found = fails(memory, "posix_memalign") ? nullptr : __libc_memalign(alignment, size);
  errno = before;  // POSIX: it is not set
  if (found == nullptr) return ENOMEM;
  *result = found;
  return 0;
}

void* mmap(void* at, size_t size, int protection, int flags, int file, off_t offset) {
  if (fails(map, "mmap", file)) return MAP_FAILED;
  return reinterpret_cast<void*>(syscall(SYS_mmap, at, size, protection, flags, file, offset));
}
void* mmap64(void* at, size_t size, int protection, int flags, int file, off_t offset) {
  return mmap(at, size, protection, flags, file, offset);
}

// --- files

#define CNRG_MODE                                   \
  va_list arguments;                                \
  va_start(arguments, flags);                       \
  const auto mode = mode_t(va_arg(arguments, int)); \
  va_end(arguments)
int open(const char* path, int flags, ...) {
  CNRG_MODE;
  return open_at("open", AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  CNRG_MODE;
  return open_at("open64", AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  CNRG_MODE;
  return open_at("openat", folder, path, flags, mode);
}
int openat64(int folder, const char* path, int flags, ...) {
  CNRG_MODE;
  return open_at("openat64", folder, path, flags, mode);
}
CNRG_CALL(open_file, -1, FILE*, fopen, (const char* path, const char* mode), nullptr, path, mode)
CNRG_CALL(open_file, -1, FILE*, fopen64, (const char* path, const char* mode), nullptr, path, mode)
CNRG_CALL(open_file, -1, DIR*, opendir, (const char* path), nullptr, path)
CNRG_CALL(open_file, file, DIR*, fdopendir, (int file), nullptr, file)
CNRG_SYSTEM_CALL(open_file, -1, int, memfd_create, (const char* name, unsigned flags), SYS_memfd_create, name,
                 flags)

ssize_t read(int file, void* data, size_t size) {
  const int f = fault(read_data, "read", file);
  if (f > 0) return -1;
  CNRG_BEHIND(read);
  return next(file, data, f == kShort ? half(size) : size);
}
ssize_t pread(int file, void* data, size_t size, off_t at) {
  const int f = fault(read_data, "pread", file);
  if (f > 0) return -1;
  CNRG_BEHIND(pread);
  return next(file, data, f == kShort ? half(size) : size, at);
}
ssize_t pread64(int file, void* data, size_t size, off_t at) { return pread(file, data, size, at); }
CNRG_CALL(read_data, fileno(file), size_t, fread, (void* data, size_t size, size_t n, FILE* file), 0, data, size,
          n, file)
CNRG_CALL(read_data, -1, dirent*, readdir, (DIR * folder), nullptr, folder)
CNRG_CALL(read_data, -1, dirent64*, readdir64, (DIR * folder), nullptr, folder)

ssize_t write(int file, const void* data, size_t size) {
  const int f = fault(write_data, "write", file);
  if (f > 0) return -1;
  CNRG_BEHIND(write);
  return next(file, data, f == kShort ? half(size) : size);
}
ssize_t pwrite(int file, const void* data, size_t size, off_t at) {
  const int f = fault(write_data, "pwrite", file);
  if (f > 0) return -1;
  CNRG_BEHIND(pwrite);
  return next(file, data, f == kShort ? half(size) : size, at);
}
ssize_t writev(int file, const iovec* parts, int n) {
  const int f = fault(write_data, "writev", file);
  if (f > 0) return -1;
  CNRG_BEHIND(writev);
  return next(file, parts, f == kShort ? int(half(size_t(n))) : n);
}
CNRG_CALL(write_data, fileno(file), size_t, fwrite, (const void* data, size_t size, size_t n, FILE* file), 0, data,
          size, n, file)
CNRG_CALL(write_data, fileno(file), int, fputs, (const char* text, FILE* file), EOF, text, file)
CNRG_CALL(write_data, file != nullptr ? fileno(file) : -1, int, fflush, (FILE * file), EOF, file)

CNRG_CALL(flush, file, int, fsync, (int file), -1, file)
CNRG_CALL(flush, file, int, fdatasync, (int file), -1, file)
/// Closes whatever it answers, as Linux does.
int close(int file) {
  const bool failed = fails(close_file, "close", file);
  const int reason = errno;
  const int result = int(syscall(SYS_close, file));
  if (failed) errno = reason;
  return failed ? -1 : result;
}
int fclose(FILE* file) {
  CNRG_BEHIND(fclose);
  const bool failed = fails(close_file, "fclose", fileno(file));
  const int result = next(file);
  if (failed) errno = answer;
  return failed ? EOF : result;
}

CNRG_CALL(rename_file, -1, int, rename, (const char* from, const char* to) noexcept, -1, from, to)
CNRG_CALL(rename_file, -1, int, renameat,
          (int from_folder, const char* from, int to_folder, const char* to) noexcept, -1, from_folder, from,
          to_folder, to)
CNRG_CALL(rename_file, -1, int, link, (const char* from, const char* to) noexcept, -1, from, to)
CNRG_CALL(rename_file, -1, int, linkat,
          (int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept, -1, from_folder,
          from, to_folder, to, flags)
CNRG_CALL(remove_file, -1, int, unlink, (const char* path) noexcept, -1, path)
CNRG_CALL(remove_file, -1, int, unlinkat, (int folder, const char* path, int flags) noexcept, -1, folder, path,
          flags)
CNRG_CALL(remove_file, -1, int, remove, (const char* path) noexcept, -1, path)
CNRG_CALL(rename_file, -1, int, mkdir, (const char* path, mode_t mode) noexcept, -1, path, mode)
CNRG_SYSTEM_CALL(truncate_file, file, int, ftruncate, (int file, off_t size), SYS_ftruncate, file, size)
int ftruncate64(int file, off_t size) noexcept { return ftruncate(file, size); }

// --- processes and threads

CNRG_CALL(start_process, -1, pid_t, fork, () noexcept, -1)
pid_t vfork() noexcept { return fork(); }  // a function cannot return twice into a frame that is gone
CNRG_CALL(start_process, -1, int, posix_spawn,
          (pid_t * process, const char* path, const posix_spawn_file_actions_t* actions,
           const posix_spawnattr_t* attributes, char* const* arguments, char* const* environment),
          answer, process, path, actions, attributes, arguments, environment)
CNRG_CALL(start_process, -1, int, posix_spawnp,
          (pid_t * process, const char* path, const posix_spawn_file_actions_t* actions,
           const posix_spawnattr_t* attributes, char* const* arguments, char* const* environment),
          answer, process, path, actions, attributes, arguments, environment)
CNRG_CALL(start_process, -1, int, execve,
          (const char* path, char* const* arguments, char* const* environment) noexcept, -1, path, arguments,
          environment)
CNRG_CALL(start_process, -1, int, execvp, (const char* path, char* const* arguments) noexcept, -1, path, arguments)
CNRG_CALL(start_process, -1, FILE*, popen, (const char* command, const char* mode), nullptr, command, mode)
CNRG_CALL(open_pipe, -1, int, pipe, (int* ends) noexcept, -1, ends)
CNRG_CALL(open_pipe, -1, int, pipe2, (int* ends, int flags) noexcept, -1, ends, flags)
/// Nobody is there to wait for where the system forgets children that ended (SIGCHLD is ignored): when they ended.
pid_t waitpid(pid_t process, int* status, int options) {
  CNRG_BEHIND(waitpid);
  if (!fails(wait_process, "waitpid")) return next(process, status, options);
  if (answer == ECHILD) next(process, status, options);
  errno = answer;
  return -1;
}
CNRG_CALL(wait_process, -1, pid_t, wait4, (pid_t process, int* status, int options, rusage* usage), -1, process,
          status, options, usage)
CNRG_CALL(start_thread, -1, int, pthread_create,
          (pthread_t * thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) noexcept,
          answer, thread, attributes, work, argument)

// --- questions about files, and small changes

CNRG_SYSTEM_CALL(inspect, -1, int, stat, (const char* path, struct stat* result), SYS_newfstatat, AT_FDCWD, path,
                 result, 0)
CNRG_SYSTEM_CALL(inspect, -1, int, stat64, (const char* path, struct stat64* result), SYS_newfstatat, AT_FDCWD,
                 path, result, 0)
CNRG_SYSTEM_CALL(inspect, -1, int, lstat, (const char* path, struct stat* result), SYS_newfstatat, AT_FDCWD, path,
                 result, AT_SYMLINK_NOFOLLOW)
CNRG_SYSTEM_CALL(inspect, file, int, fstat, (int file, struct stat* result), SYS_newfstatat, file, "", result,
                 AT_EMPTY_PATH)
CNRG_SYSTEM_CALL(inspect, file, int, fstat64, (int file, struct stat64* result), SYS_newfstatat, file, "", result,
                 AT_EMPTY_PATH)
CNRG_SYSTEM_CALL(inspect, -1, int, access, (const char* path, int mode), SYS_faccessat, AT_FDCWD, path, mode)
CNRG_SYSTEM_CALL(inspect, -1, ssize_t, readlink, (const char* path, char* result, size_t size), SYS_readlinkat,
                 AT_FDCWD, path, result, size)
CNRG_SYSTEM_CALL(inspect, file, off_t, lseek, (int file, off_t at, int whence), SYS_lseek, file, at, whence)
off64_t lseek64(int file, off64_t at, int whence) noexcept { return lseek(file, at, whence); }
CNRG_SYSTEM_CALL(inspect, file, int, flock, (int file, int operation), SYS_flock, file, operation)
CNRG_SYSTEM_CALL(inspect, file, int, fchmod, (int file, mode_t mode), SYS_fchmod, file, mode)
CNRG_SYSTEM_CALL(inspect, from, int, dup2, (int from, int to), SYS_dup2, from, to)
CNRG_CALL(inspect, -1, int, poll, (pollfd * files, nfds_t n, int milliseconds), -1, files, n, milliseconds)

}  // extern "C"
