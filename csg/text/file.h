// A file that appears whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace cnrg {

/// Writes `content` beside `path`, flushes it to the disk and renames it to `path`; a symbolic link is
/// followed, the permissions of an old file are kept. Throws FileError with the path and the system's reason;
/// then the old file is untouched and nothing is left behind.
void replace_file(const std::string& path, std::string_view content);

/// The extension with its dot in lower case (`.vtu`), or an empty string.
std::string extension_of(const std::string& path);

}  // namespace cnrg
