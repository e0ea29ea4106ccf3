// The content goes to a new file in the same directory, which is flushed and then renamed. Within a directory a
// rename is atomic; without the flush a crash might leave the new name with no content.
#include "csg/text/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what, int reason) {
  throw FileError(path + ": " + what + ": " + std::strerror(reason));
}

/// A file open for writing; closed and removed again unless it was kept.
class Draft {
 public:
  explicit Draft(const std::string& path) : path_(path) {
    static std::atomic<unsigned> counter{0};
    do {
      name_ = path + "." + std::to_string(getpid()) + "." + std::to_string(counter++) + ".tmp";
      descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) fail(path_, "cannot be written", errno);
  }
  ~Draft() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!kept_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t n = ::write(descriptor_, content.data(), content.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(path_, "cannot be written", errno);
      content.remove_prefix(std::size_t(n));
    }
  }
  void keep(const struct stat* old) {
    if (old != nullptr) (void)fchmod(descriptor_, old->st_mode & 07777);
    if (fsync(descriptor_) != 0) fail(path_, "cannot be flushed to the disk", errno);
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(path_, "cannot be written", errno);
    if (rename(name_.c_str(), path_.c_str()) != 0) fail(path_, "cannot be replaced", errno);
    kept_ = true;
  }

 private:
  std::string path_, name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void replace_file(const std::string& path, std::string_view content) {
  std::string target = path;
  std::error_code ignored;
  if (std::filesystem::is_symlink(path, ignored)) {
    const auto followed = std::filesystem::weakly_canonical(path, ignored);
    if (!followed.empty()) target = followed.string();
  }
  struct stat old;
  const bool exists = stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(path, "cannot be written", EISDIR);
  if (exists && !S_ISREG(old.st_mode)) throw FileError(path + ": cannot be replaced: it is no regular file");
  Draft draft(target);
  draft.write(content);
  draft.keep(exists ? &old : nullptr);
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace cnrg
