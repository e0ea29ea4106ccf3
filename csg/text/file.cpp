// The target is what a symbolic link leads to; all else is a draft's (draft.h).
#include "csg/text/file.h"

#include <sys/stat.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "csg/text/draft.h"
#include "kernel/base/error.h"

namespace cnrg {

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
