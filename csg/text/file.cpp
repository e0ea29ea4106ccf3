// The target is what a symbolic link leads to; all else is a draft's.
#include "csg/text/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

// Within a directory a rename is atomic; without the flush before it a crash of the system might leave the new
// name with no content.

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

Draft::Draft(const std::string& target, Kind kind) : target_(target) {
  if (kind == Kind::named || !open_unnamed()) open_named();
}

Draft::~Draft() {
  if (!name_.empty()) unlink(name_.c_str());
  if (descriptor_ >= 0) close(descriptor_);
}

void Draft::fail(const char* what, int reason) const {
  throw FileError(target_ + ": " + what + ": " + std::strerror(reason));
}

std::string Draft::new_name() const {
  static std::atomic<unsigned> counter{0};
  return target_ + "." + std::to_string(getpid()) + "." + std::to_string(counter++) + ".tmp";
}

bool Draft::open_unnamed() {
#ifdef O_TMPFILE
  descriptor_ = open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  // It will be linked by its name in /proc.
  if (descriptor_ >= 0 && access("/proc/self/fd", X_OK) == 0) return true;
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
#endif
  return false;
}

void Draft::open_named() {
  do {
    name_ = new_name();
    descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ >= 0) return;
  const int reason = errno;
  name_.clear();
  fail("cannot be written", reason);
}

bool Draft::link_to(const std::string& name) const {
  const std::string self = "/proc/self/fd/" + std::to_string(descriptor_);
  return linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

void Draft::write(std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(descriptor_, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("cannot be written", errno);
    content.remove_prefix(static_cast<std::size_t>(n));
  }
}

void Draft::appear(const struct stat* old) {
  if (old != nullptr && fchmod(descriptor_, old->st_mode & 07777) != 0)
    fail("cannot be given the permissions that it has", errno);
  if (fsync(descriptor_) != 0) fail("cannot be flushed to the disk", errno);
  if (name_.empty()) {
    if (old == nullptr && link_to(target_)) return;  // where nothing was the link is all
    std::string name = new_name();
    while (!link_to(name)) {
      if (errno != EEXIST) fail("cannot be replaced", errno);
      name = new_name();
    }
    name_ = std::move(name);
  }
  if (rename(name_.c_str(), target_.c_str()) != 0) fail("cannot be replaced", errno);
  name_.clear();
}

void require_no_directory(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored) && !path.ends_with('/')) return;
  throw FileError(path + ": cannot be written: it is a directory; give the name of a file in it");
}

void replace_file(const std::string& path, std::string_view content, const std::stop_token& stop) {
  require_no_directory(path);
  std::string target = path;
  struct stat old;
  const auto fail = [&](const std::string& reason) { throw FileError(path + ": cannot be written: " + reason); };
  const auto look_up = [&](auto* question, const std::string& name) {
    if (question(name.c_str(), &old) == 0) return true;
    if (errno != ENOENT && errno != ENOTDIR) fail(std::strerror(errno));  // an old file that is overlooked is lost
    return false;
  };
  if (look_up(lstat, path) && S_ISLNK(old.st_mode)) {
    std::error_code code;
    target = std::filesystem::weakly_canonical(path, code).string();
    if (code) fail(code.message());
  }
  const bool exists = look_up(stat, target);
  if (exists && !S_ISREG(old.st_mode)) throw FileError(path + ": cannot be replaced: it is no regular file");
  const auto check = [&] {
    if (stop.stop_requested()) throw Stopped();
  };
  constexpr std::size_t kBlock = 1 << 24;  // bytes that are on their way before anybody looks
  Draft draft(target);
  for (std::size_t at = 0; at < content.size(); at += kBlock) {
    check();
    draft.write(content.substr(at, kBlock));
  }
  check();
  draft.appear(exists ? &old : nullptr);
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace cnrg
