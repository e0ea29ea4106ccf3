// A file that appears whole or not at all.
#pragma once

#include <sys/stat.h>

#include <stop_token>
#include <string>
#include <string_view>

namespace cnrg {

// A file that is being written and has not appeared yet.
//
// A temporary file beside the target is left behind when the program is killed. A draft without a name (O_TMPFILE)
// cannot be: the system forgets it with its process. It gets a name when it is whole and on the disk; over an old
// file not even that is one step, since a link cannot replace a name: it is linked beside the target and renamed
// at once. File systems without such drafts get a named one from the start: there, and between link and rename, a
// kill that no program hears of leaves `TARGET.PID.NUMBER.tmp`.

class Draft {
 public:
  enum class Kind { unnamed_if_possible, named };
  /// For the regular file `target`, which may exist. Throws FileError with the system's reason, as all else here.
  explicit Draft(const std::string& target, Kind kind = Kind::unnamed_if_possible);
  /// Without `appear` nothing has happened.
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  void write(std::string_view content);
  /// Flushes to the disk and replaces the target, whose permissions (those of `old`, if there is one) stay.
  void appear(const struct stat* old);

 private:
  [[noreturn]] void fail(const char* what, int reason) const;
  bool open_unnamed();
  void open_named();
  /// Another name beside the target: `TARGET.PID.NUMBER.tmp`.
  std::string new_name() const;
  bool link_to(const std::string& name) const;

  std::string target_;
  std::string name_;  ///< beside the target; empty while the draft has none
  int descriptor_ = -1;
};

/// Writes `content` as a draft that appears at `path` when it is whole and on the disk; a symbolic link
/// is followed, the permissions of an old file are kept. Throws FileError with the path and the system's reason;
/// then the old file is untouched and nothing is left behind, and so it is where a stop is asked for (Stopped).
void replace_file(const std::string& path, std::string_view content, const std::stop_token& stop = {});

/// Throws FileError for a path where only a directory can be.
void require_no_directory(const std::string& path);

/// The extension with its dot in lower case (`.vtu`), or an empty string.
std::string extension_of(const std::string& path);

}  // namespace cnrg
