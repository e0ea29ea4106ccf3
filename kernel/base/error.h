// The errors of the project, one class for each way to mend them: a bug of ours, bad input, a file, a stop.
#pragma once

#include <stdexcept>
#include <string>

namespace cnrg {

/// A broken invariant: a bug of ours. The program ends with exit status 1 and says what to send.
class InvariantError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Input that cannot be evaluated; the message says what is wrong and what to do (exit status 2).
/// The kernel knows no files: who reads one adds `file:line:column`.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read or written (exit status 3).
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Work that was stopped because that was asked for (kernel/base/progress.h).
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

/// Throws InvariantError when `condition` is false.
inline void require(bool condition, const char* message) {
  if (!condition) [[unlikely]]
    throw InvariantError(message);
}
inline void require(bool condition, const std::string& message) {
  if (!condition) [[unlikely]]
    throw InvariantError(message);
}

}  // namespace cnrg
