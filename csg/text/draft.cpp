// Within a directory a rename is atomic; without the flush before it a crash of the system might leave the new
// name with no content.
//
// Who may remove a name like ours? Its pattern has to fit to the letter, it has to be a regular file of our user,
// its process must be gone, and its lock free: a process of another machine or container is known by its lock
// alone. A writer that finds its fresh file removed between its making and its lock makes another.
#include "csg/text/draft.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

bool lock(int descriptor) { return flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

/// Whether the name still is this open file; nothing if the system does not tell.
std::optional<bool> is_at(int descriptor, const std::string& name) {
  struct stat open_one, named_one;
  if (fstat(descriptor, &open_one) != 0) return std::nullopt;
  if (lstat(name.c_str(), &named_one) != 0) return errno == ENOENT ? std::optional(false) : std::nullopt;
  return open_one.st_dev == named_one.st_dev && open_one.st_ino == named_one.st_ino;
}

/// The digits at the front of `text`, which is advanced behind them; -1 if there are none.
std::int64_t take_number(std::string_view& text) {
  std::int64_t value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || text[0] == '-') return -1;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The process of a name `BASE.PID.NUMBER.tmp`; -1 for any other name.
std::int64_t process_of(std::string_view name, std::string_view base) {
  if (!name.starts_with(base)) return -1;
  name.remove_prefix(base.size());
  if (!name.starts_with('.')) return -1;
  name.remove_prefix(1);
  const std::int64_t process = take_number(name);
  if (process <= 0 || !name.starts_with('.')) return -1;
  name.remove_prefix(1);
  return take_number(name) >= 0 && name == ".tmp" ? process : -1;
}

bool lives(std::int64_t process) {
  return process != getpid() && (kill(pid_t(process), 0) == 0 || errno != ESRCH);
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

Draft::Draft(const std::string& target, Kind kind) : target_(target) {
  remove_abandoned();
  if (kind == Kind::named || !open_unnamed()) open_named();
}

Draft::~Draft() {
  if (!name_.empty() && is_at(descriptor_, name_).value_or(true)) unlink(name_.c_str());
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
  // It will be linked by its name in /proc, and locked by then.
  if (descriptor_ >= 0 && access("/proc/self/fd", X_OK) == 0 && lock(descriptor_)) return true;
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
#endif
  return false;
}

void Draft::open_named() {
  for (;;) {
    name_ = new_name();
    descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == EEXIST) continue;
    if (descriptor_ < 0) {
      const int reason = errno;
      name_.clear();
      fail("cannot be written", reason);
    }
    if (!lock(descriptor_) && errno != EWOULDBLOCK) return;  // a file system without locks: nobody else has one
    if (is_at(descriptor_, name_).value_or(true)) return;
    close(descriptor_);  // taken for abandoned before it was locked
  }
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

void Draft::remove_abandoned() const {
  const std::string base = std::filesystem::path(target_).filename().string();
  const std::string folder = folder_of(target_);
  // Not std::filesystem's iterator: where memory runs out in it, it ends the program.
  struct Close {
    void operator()(DIR* directory) const { closedir(directory); }
  };
  const std::unique_ptr<DIR, Close> entries(opendir(folder.c_str()));
  for (const dirent* entry; entries != nullptr && (entry = readdir(entries.get())) != nullptr;) {
    const std::int64_t process = process_of(entry->d_name, base);
    if (process < 0 || lives(process)) continue;
    const std::string name = folder + "/" + entry->d_name;
    const int descriptor = open(name.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    struct stat found;
    const bool ours = fstat(descriptor, &found) == 0 && S_ISREG(found.st_mode) && found.st_uid == geteuid();
    if (ours && lock(descriptor) && is_at(descriptor, name).value_or(false)) unlink(name.c_str());
    close(descriptor);
  }
}

}  // namespace cnrg
