#include "bench/peers/program.h"

#include <fcntl.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <stdexcept>

#include "bench/peers/system.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

/// Waits until nobody holds the other end of the pipe. A program that dies together with this process may still
/// write for a moment, so one attempt may not be enough.
[[noreturn]] void remove_at_end(int pipe, const std::string& path) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  setsid();  // who ends this process may end all of its session
  dup2(pipe, 0);
  close_range(1, ~0u, 0);  // above all the pipes of others, who wait for their end
  char byte;
  while (read(0, &byte, 1) < 0 && errno == EINTR) {
  }
  for (int attempt = 0; attempt < 50; ++attempt) {
    std::error_code error;
    fs::remove_all(path, error);
    if (!fs::exists(path, error)) break;
    usleep(20000);
  }
  _exit(0);
}

void open_as(int descriptor, const char* path, int flags) {
  const int opened = open(path, flags, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
  if (opened != descriptor) close(opened);
}

[[noreturn]] void become(char* const* arguments, const char* output, const char* errors, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(126);  // it ended before that
  open_as(0, "/dev/null", O_RDONLY);
  open_as(1, output, O_WRONLY | O_CREAT | O_TRUNC);
  open_as(2, errors, O_WRONLY | O_CREAT | O_TRUNC);
  close_range(3, ~0u, 0);
  // OpenSCAD writes its cells in the order of their addresses: the same every time where these are.
  personality(ADDR_NO_RANDOMIZE);
  execvp(arguments[0], arguments);
  dprintf(2, "%s: %s\n", arguments[0], std::strerror(errno));
  _exit(127);
}

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  constexpr std::size_t kMostLetters = 1000;
  for (std::string line; std::getline(in, line);) lines.push_back(line.substr(0, kMostLetters));
  return lines;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  path_ = (fs::temp_directory_path() / "cnrg-XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder: " + path_);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    fs::remove(path_);
    throw std::runtime_error("no pipe");
  }
  remover_ = fork();
  if (remover_ == 0) {
    close(ends[1]);
    remove_at_end(ends[0], path_);
  }
  close(ends[0]);
  alive_ = ends[1];
  if (remover_ < 0) {
    close(alive_);
    fs::remove(path_);
    throw std::runtime_error("no process");
  }
}

TemporaryFolder::~TemporaryFolder() {
  close(alive_);
  while (waitpid(remover_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::string ProgramRun::reason() const {
  if (signal != 0) throw Crash("ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")");
  const auto last = std::find_if(errors.rbegin(), errors.rend(), [](const std::string& s) { return !s.empty(); });
  return last != errors.rend() ? *last : "ended with status " + std::to_string(status);
}

NamedProgram named_program(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.rfind(':');
  if (equals == std::string::npos || equals == 0)
    throw std::runtime_error("'" + text + "' is no NAME=PROGRAM or NAME=PROGRAM:ROUNDING");
  NamedProgram result;
  result.name = text.substr(0, equals);
  std::string program = text.substr(equals + 1);
  if (colon != std::string::npos && colon > equals) {
    std::size_t end = 0;
    try {
      result.rounding = std::stod(text.substr(colon + 1), &end);
    } catch (const std::exception&) {
    }
    if (end == 0 || end != text.size() - colon - 1 || !(result.rounding >= 0 && result.rounding < 1))
      throw std::runtime_error("'" + text.substr(colon + 1) + "' is no rounding; it is such as 1e-12");
    program = text.substr(equals + 1, colon - equals - 1);
  }
  result.path = program_path(result.name, program);
  return result;
}

std::string program_path(const std::string& name, const std::string& program) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.find_first_not_of(kLetters) != std::string::npos || name.starts_with('-') || name.size() > 60)
    throw std::runtime_error("'" + name +
                             "' is no name of a system; it has up to 60 letters, digits, - and _, and "
                             "begins with no -");
  std::error_code error;
  const std::string path = fs::canonical(program, error).string();
  if (error) throw std::runtime_error(program + ": there is no such program");
  if (access(path.c_str(), X_OK) != 0)
    throw std::runtime_error(program + ": is no program that may be run (chmod +x)");
  return path;
}

bool on_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

ProgramRun run_program(const std::vector<std::string>& arguments, const TemporaryFolder& folder,
                       const char* output) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const std::string errors = folder.file("standard-error");
  const pid_t parent = getpid(), pid = fork();
  if (pid < 0) throw std::runtime_error("no process");
  if (pid == 0) become(words.data(), output, errors.c_str(), parent);
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  ProgramRun run;
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  else run.status = WEXITSTATUS(status);
  run.errors = lines_of(errors);
  for (std::string& line : run.errors)  // the folder's name is chance
    for (std::size_t at; (at = line.find(folder.path() + "/")) != std::string::npos;)
      line.erase(at, folder.path().size() + 1);
  run.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  const auto no_memory = [](const std::string& line) { return line.find("std::bad_alloc") != std::string::npos; };
  if (!run.succeeded() && std::any_of(run.errors.begin(), run.errors.end(), no_memory)) throw std::bad_alloc();
  return run;
}

}  // namespace cnrg::bench
