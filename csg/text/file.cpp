// The target is what a symbolic link leads to; all else is a draft's (draft.h).
#include "csg/text/file.h"

#include <sys/stat.h>

#include <cctype>
#include <filesystem>

#include "csg/text/draft.h"
#include "kernel/base/error.h"

namespace cnrg {

void require_no_directory(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored) && !path.ends_with('/')) return;
  throw FileError(path + ": cannot be written: it is a directory; give the name of a file in it");
}

void replace_file(const std::string& path, std::string_view content) {
  std::string target = path;
  std::error_code ignored;
  if (std::filesystem::is_symlink(path, ignored)) {
    const auto followed = std::filesystem::weakly_canonical(path, ignored);
    if (!followed.empty()) target = followed.string();
  }
  struct stat old;
  const bool exists = stat(target.c_str(), &old) == 0;
  require_no_directory(path);
  if (exists && !S_ISREG(old.st_mode)) throw FileError(path + ": cannot be replaced: it is no regular file");
  Draft draft(target);
  draft.write(content);
  draft.appear(exists ? &old : nullptr);
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace cnrg
