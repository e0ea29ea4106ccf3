// The files that the program reads, standard input among them.
//
// Of what has a name only regular files are read: a pipe may never end, a device may never end or do something
// when it is opened, and a directory is none. An untrusted tree may be kept in a folder: what a name leads to is
// looked at after links and
// `..` are resolved, and what was looked at is what is read, whatever happens to the name in between.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace cnrg {

/// The whole content of a regular file. `inside`: a folder, as `folder_of_inputs` gives it, in which the file must
/// lie; empty: anywhere. Throws FileError if there is no such file, if it cannot be read or is no regular file,
/// or has more bytes than the machine has memory, InputError if it is not in the folder, be it elsewhere or
/// nowhere, or has more than `most` bytes; messages have no position.
std::string read_file(const std::string& path, const std::string& inside = {},
                      std::size_t most = std::numeric_limits<std::size_t>::max());

/// How standard input is called in messages, and what stands for it on a command line.
inline constexpr const char* kStandardInput = "<stdin>";
inline constexpr const char* kStandardInputWord = "-";

/// All that comes on standard input. Throws FileError if it cannot be read, InputError if it has more than `most`
/// bytes, and then reads no more of it.
std::string read_standard_input(std::size_t most);

/// A folder without links in its path. FileError if there is none.
std::string folder_of_inputs(const std::string& path);

/// A text without the byte order mark that some editors write before UTF-8.
std::string_view without_mark(std::string_view text);

/// Bytes of memory that the machine has; 0 if the system does not tell.
std::size_t memory_of_machine();
/// Bytes of it that programs could have now; 0 if the system does not tell.
std::size_t memory_available();

}  // namespace cnrg
