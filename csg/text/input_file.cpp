// A file is opened twice: first as a place only (O_PATH), which does nothing to it and blocks nowhere; that place
// has a kind and, in /proc, a path without links; then by its place in /proc for reading.
#include "csg/text/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

#ifdef O_PATH
constexpr int kPlaceOnly = O_PATH;
#else  // a pipe or a device is opened, without waiting for its other end
constexpr int kPlaceOnly = O_RDONLY | O_NONBLOCK;
#endif

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : number_(open(path.c_str(), flags | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  bool open_now() const { return number_ >= 0; }
  std::string place() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

/// Both without links.
bool lies_inside(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const std::string text = file.string(), head = folder == "/" ? "/" : folder.string() + "/";
  return text.starts_with(head);
}

[[noreturn]] void refuse_outside(const std::string& path, const std::string& inside) {
  throw InputError("'" + path + "' is no file inside of the folder '" + inside +
                   "', and this tree may read no others; copy it there");
}

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw FileError("'" + path + "' cannot be read: " + why);
}

}  // namespace

std::string folder_of_inputs(const std::string& path) {
  std::error_code code;
  const std::filesystem::path folder = std::filesystem::canonical(path, code);
  if (code || !std::filesystem::is_directory(folder, code)) throw FileError("there is no folder '" + path + "'");
  return folder.string();
}

std::string read_file(const std::string& path, const std::string& inside, std::size_t most) {
  const auto none = [&] { return FileError("there is no file '" + shown(path) + "': check the path"); };
  if (path.find('\0') != std::string::npos) throw none();
  std::error_code code;
  const Descriptor place(path, kPlaceOnly);
  if (!place.open_now() && !inside.empty()) refuse_outside(path, inside);  // tells nothing of what is elsewhere
  if (!place.open_now() && (errno == ENOENT || errno == ENOTDIR)) throw none();
  if (!place.open_now()) fail(path, std::strerror(errno));
  if (!inside.empty()) {
    const std::filesystem::path found = std::filesystem::read_symlink(place.place(), code);
    if (code || !lies_inside(found, inside)) refuse_outside(path, inside);
  }
  struct stat status;
  if (fstat(place.number(), &status) != 0) fail(path, std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    fail(path, std::string("it is ") + kind_of(status.st_mode) + ", give a regular file");

  const bool proc = access("/proc/self/fd", X_OK) == 0;
  const Descriptor file(proc ? place.place() : path, O_RDONLY | O_NONBLOCK);
  if (!file.open_now()) fail(path, std::strerror(errno));
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > most) {
    throw InputError("this file has " + grouped(size) + " bytes, and at most " + grouped(most) + " are read");
  }
  const std::string bytes = "it has " + grouped(size) + " bytes, ";
  if (const std::size_t memory = memory_of_machine(); memory > 0 && size > memory)
    fail(path, bytes + "more than the memory of this machine; give a smaller file");
  std::string content;
  try {
    content.resize(size);
  } catch (const std::exception&) {  // no memory, or more than a string can hold
    fail(path, bytes + "more than there is memory for");
  }
  std::size_t filled = 0;
  for (;;) {
    if (filled == content.size())
      content.resize(content.size() + 4096);  // it may have grown, or /proc tells no size
    const ssize_t n = ::read(file.number(), content.data() + filled, content.size() - filled);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, std::strerror(errno));
    if (n == 0) break;
    filled += static_cast<std::size_t>(n);
  }
  content.resize(filled);
  return content;
}

std::string read_standard_input(std::size_t most) {
  constexpr std::size_t kBlock = 1 << 16;
  std::string content;
  for (;;) {
    const std::size_t size = content.size();
    content.resize(size + kBlock);
    const ssize_t n = ::read(STDIN_FILENO, content.data() + size, kBlock);
    const int reason = errno;
    content.resize(size + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n < 0 && reason == EINTR) continue;
    if (n < 0) throw FileError(std::string("standard input cannot be read: ") + std::strerror(reason));
    if (n == 0) return content;
    if (content.size() > most)
      throw InputError("standard input has more than " + grouped(most) + " bytes, and no more are read");
  }
}

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

std::size_t memory_of_machine() {
  const std::int64_t pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(size) : 0;
}

std::size_t memory_available() {
  std::ifstream told("/proc/meminfo");
  std::string word;
  std::size_t kilobytes = 0;
  while (told >> word) {
    if (word == "MemAvailable:" && told >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace cnrg
