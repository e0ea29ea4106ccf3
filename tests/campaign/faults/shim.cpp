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
FILE* fopen(const char* path, const char* mode) {
  CNRG_BEHIND(fopen);
  return fails(open_file, "fopen") ? nullptr : next(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  CNRG_BEHIND(fopen64);
  return fails(open_file, "fopen64") ? nullptr : next(path, mode);
}
DIR* opendir(const char* path) {
  CNRG_BEHIND(opendir);
  return fails(open_file, "opendir") ? nullptr : next(path);
}
DIR* fdopendir(int file) {
  CNRG_BEHIND(fdopendir);
  return fails(open_file, "fdopendir", file) ? nullptr : next(file);
}
int memfd_create(const char* name, unsigned flags) noexcept {
  return fails(open_file, "memfd_create") ? -1 : int(syscall(SYS_memfd_create, name, flags));
}

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
size_t fread(void* data, size_t size, size_t n, FILE* file) {
  CNRG_BEHIND(fread);
  return fails(read_data, "fread", fileno(file)) ? 0 : next(data, size, n, file);
}
dirent* readdir(DIR* folder) {
  CNRG_BEHIND(readdir);
  return fails(read_data, "readdir") ? nullptr : next(folder);
}
dirent64* readdir64(DIR* folder) {
  CNRG_BEHIND(readdir64);
  return fails(read_data, "readdir64") ? nullptr : next(folder);
}

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
size_t fwrite(const void* data, size_t size, size_t n, FILE* file) {
  CNRG_BEHIND(fwrite);
  return fails(write_data, "fwrite", fileno(file)) ? 0 : next(data, size, n, file);
}
int fputs(const char* text, FILE* file) {
  CNRG_BEHIND(fputs);
  return fails(write_data, "fputs", fileno(file)) ? EOF : next(text, file);
}
int fflush(FILE* file) {
  CNRG_BEHIND(fflush);
  return fails(write_data, "fflush", file != nullptr ? fileno(file) : -1) ? EOF : next(file);
}

int fsync(int file) {
  CNRG_BEHIND(fsync);
  return fails(flush, "fsync", file) ? -1 : next(file);
}
int fdatasync(int file) {
  CNRG_BEHIND(fdatasync);
  return fails(flush, "fdatasync", file) ? -1 : next(file);
}
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

int rename(const char* from, const char* to) noexcept {
  CNRG_BEHIND(rename);
  return fails(rename_file, "rename") ? -1 : next(from, to);
}
int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  CNRG_BEHIND(renameat);
  return fails(rename_file, "renameat") ? -1 : next(from_folder, from, to_folder, to);
}
int link(const char* from, const char* to) noexcept {
  CNRG_BEHIND(link);
  return fails(rename_file, "link") ? -1 : next(from, to);
}
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  CNRG_BEHIND(linkat);
  return fails(rename_file, "linkat") ? -1 : next(from_folder, from, to_folder, to, flags);
}
int unlink(const char* path) noexcept {
  CNRG_BEHIND(unlink);
  return fails(remove_file, "unlink") ? -1 : next(path);
}
int unlinkat(int folder, const char* path, int flags) noexcept {
  CNRG_BEHIND(unlinkat);
  return fails(remove_file, "unlinkat") ? -1 : next(folder, path, flags);
}
int remove(const char* path) noexcept {
  CNRG_BEHIND(remove);
  return fails(remove_file, "remove") ? -1 : next(path);
}
int mkdir(const char* path, mode_t mode) noexcept {
  CNRG_BEHIND(mkdir);
  return fails(rename_file, "mkdir") ? -1 : next(path, mode);
}
int ftruncate(int file, off_t size) noexcept {
  return fails(truncate_file, "ftruncate", file) ? -1 : int(syscall(SYS_ftruncate, file, size));
}
int ftruncate64(int file, off_t size) noexcept { return ftruncate(file, size); }

// --- processes and threads

pid_t fork() noexcept {
  CNRG_BEHIND(fork);
  return fails(start_process, "fork") ? -1 : next();
}
pid_t vfork() noexcept { return fork(); }  // a function cannot return twice into a frame that is gone
int posix_spawn(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const* arguments, char* const* environment) {
  CNRG_BEHIND(posix_spawn);
  return fails(start_process, "posix_spawn") ? answer
                                             : next(process, path, actions, attributes, arguments, environment);
}
int posix_spawnp(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const* arguments, char* const* environment) {
  CNRG_BEHIND(posix_spawnp);
  return fails(start_process, "posix_spawnp") ? answer
                                              : next(process, path, actions, attributes, arguments, environment);
}
int execve(const char* path, char* const* arguments, char* const* environment) noexcept {
  CNRG_BEHIND(execve);
  return fails(start_process, "execve") ? -1 : next(path, arguments, environment);
}
int execvp(const char* path, char* const* arguments) noexcept {
  CNRG_BEHIND(execvp);
  return fails(start_process, "execvp") ? -1 : next(path, arguments);
}
FILE* popen(const char* command, const char* mode) {
  CNRG_BEHIND(popen);
  return fails(start_process, "popen") ? nullptr : next(command, mode);
}
int pipe(int* ends) noexcept {
  CNRG_BEHIND(pipe);
  return fails(open_pipe, "pipe") ? -1 : next(ends);
}
int pipe2(int* ends, int flags) noexcept {
  CNRG_BEHIND(pipe2);
  return fails(open_pipe, "pipe2") ? -1 : next(ends, flags);
}
/// Nobody is there to wait for where the system forgets children that ended (SIGCHLD is ignored): when they ended.
pid_t waitpid(pid_t process, int* status, int options) {
  CNRG_BEHIND(waitpid);
  if (!fails(wait_process, "waitpid")) return next(process, status, options);
  if (answer == ECHILD) next(process, status, options);
  errno = answer;
  return -1;
}
pid_t wait4(pid_t process, int* status, int options, rusage* usage) {
  CNRG_BEHIND(wait4);
  return fails(wait_process, "wait4") ? -1 : next(process, status, options, usage);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                   void* argument) noexcept {
  CNRG_BEHIND(pthread_create);
  return fails(start_thread, "pthread_create") ? answer : next(thread, attributes, work, argument);
}

// --- questions about files, and small changes

int stat(const char* path, struct stat* result) noexcept {
  return fails(inspect, "stat") ? -1 : int(syscall(SYS_newfstatat, AT_FDCWD, path, result, 0));
}
int stat64(const char* path, struct stat64* result) noexcept {
  return fails(inspect, "stat64") ? -1 : int(syscall(SYS_newfstatat, AT_FDCWD, path, result, 0));
}
int lstat(const char* path, struct stat* result) noexcept {
  return fails(inspect, "lstat") ? -1 : int(syscall(SYS_newfstatat, AT_FDCWD, path, result, AT_SYMLINK_NOFOLLOW));
}
int fstat(int file, struct stat* result) noexcept {
  return fails(inspect, "fstat", file) ? -1 : int(syscall(SYS_newfstatat, file, "", result, AT_EMPTY_PATH));
}
int fstat64(int file, struct stat64* result) noexcept {
  return fails(inspect, "fstat64", file) ? -1 : int(syscall(SYS_newfstatat, file, "", result, AT_EMPTY_PATH));
}
int access(const char* path, int mode) noexcept {
  return fails(inspect, "access") ? -1 : int(syscall(SYS_faccessat, AT_FDCWD, path, mode));
}
ssize_t readlink(const char* path, char* result, size_t size) noexcept {
  return fails(inspect, "readlink") ? -1 : ssize_t(syscall(SYS_readlinkat, AT_FDCWD, path, result, size));
}
off_t lseek(int file, off_t at, int whence) noexcept {
  return fails(inspect, "lseek", file) ? -1 : off_t(syscall(SYS_lseek, file, at, whence));
}
off64_t lseek64(int file, off64_t at, int whence) noexcept { return lseek(file, at, whence); }
int flock(int file, int operation) noexcept {
  return fails(inspect, "flock", file) ? -1 : int(syscall(SYS_flock, file, operation));
}
int fchmod(int file, mode_t mode) noexcept {
  return fails(inspect, "fchmod", file) ? -1 : int(syscall(SYS_fchmod, file, mode));
}
int dup2(int from, int to) noexcept {
  return fails(inspect, "dup2", from) ? -1 : int(syscall(SYS_dup2, from, to));
}
int poll(pollfd* files, nfds_t n, int milliseconds) {
  CNRG_BEHIND(poll);
  return fails(inspect, "poll") ? -1 : next(files, n, milliseconds);
}

}  // extern "C"
