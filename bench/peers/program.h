// Programs of others, run so that nothing stays behind: neither processes nor files, however this process ends.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cnrg::bench {

/// A folder for files between this process and programs. A small process of its own waits for the end of the
/// folder's life or of this process, also by SIGKILL, and removes it.
class TemporaryFolder {
 public:
  /// Throws std::runtime_error if there can be none.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
  int alive_ = -1;  // closed when this process ends
  int remover_ = 0;
};

struct ProgramRun {
  int status = 0;                   ///< of its exit; 127 if there is no such program
  int signal = 0;                   ///< that ended it, or 0
  std::vector<std::string> errors;  ///< lines of standard error
  std::size_t peak_bytes = 0;       ///< resident
  bool succeeded() const { return status == 0 && signal == 0; }
  /// The last line that is not empty, or the status. Throws Crash (system.h) with the signal, if one ended it.
  std::string reason() const;
};

/// What an option `--system` says.
struct NamedProgram {
  std::string name, path;  ///< the path is absolute
  double rounding = 1e-12;
};

/// NAME=PROGRAM or NAME=PROGRAM:ROUNDING. Throws std::runtime_error for anything else, for a name with letters
/// that names of files do not have, and if there is no such program.
NamedProgram named_program(const std::string& text);

/// The absolute path of the program of a system. Throws std::runtime_error as `named_program` does.
std::string program_path(const std::string& name, const std::string& program);

/// Whether PATH has a program of this name.
bool on_path(const std::string& program);

/// Runs `arguments[0]`, searched on PATH, without a shell; standard output goes to a file. It inherits the limits
/// of this process and is killed when this process ends. `folder` takes the text of standard error. Throws
/// std::bad_alloc if the program failed with that, std::runtime_error if no process can be started.
ProgramRun run_program(const std::vector<std::string>& arguments, const TemporaryFolder& folder,
                       const char* output = "/dev/null");

}  // namespace cnrg::bench
