// A file that appears whole or not at all.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>

namespace cnrg {

/// Writes `content` as a draft (draft.h) that appears at `path` when it is whole and on the disk; a symbolic link
/// is followed, the permissions of an old file are kept. Throws FileError with the path and the system's reason;
/// then the old file is untouched and nothing is left behind, and so it is where a stop is asked for (Stopped).
void replace_file(const std::string& path, std::string_view content, const std::stop_token& stop = {});

/// Throws FileError for a path where only a directory can be.
void require_no_directory(const std::string& path);

/// The extension with its dot in lower case (`.vtu`), or an empty string.
std::string extension_of(const std::string& path);

}  // namespace cnrg
