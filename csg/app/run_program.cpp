#include "csg/app/run_program.h"

#include <csignal>
#include <exception>
#include <new>
#include <stdexcept>

#include "csg/app/exit_status.h"
#include "csg/app/memory.h"
#include "csg/app/output.h"
#include "csg/tree/position.h"
#include "kernel/base/error.h"

namespace cnrg::app {
namespace {

/// Messages about files have their place in front; others are told in the program's name.
int fail(const std::string& name, int status, const std::string& message) {
  const bool placed = message.find(": error: ") != std::string::npos;
  tell((placed ? "" : name + ": error: ") + message);
  return status;
}

int fail(const std::string& name, int status, const std::exception& error) {
  if (dynamic_cast<const Placed*>(&error) == nullptr) return fail(name, status, std::string(error.what()));
  tell_error(error);
  return status;
}

int guarded(const std::string& name, const std::function<int()>& program) {
  try {
    Output output;
    const int status = program();
    if (output.finish()) return status;
    if (output.unread()) return kNoAccess;
    return fail(name, kNoAccess, "the results could not be written to standard output; is there room?");
  } catch (const InputError& e) {
    return fail(name, kBadInput, e);
  } catch (const FileError& e) {
    return fail(name, kNoAccess, e);
  } catch (const std::bad_alloc&) {
    return memory_ran_out();
  } catch (const std::runtime_error& e) {  // a thread or a folder that the system does not give
    return fail(name, kNoAccess,
                std::string("the system refused: ") + e.what() + "; free memory or use --threads 1");
  } catch (const std::exception& e) {
    fail(name, kBug, std::string("broken invariant: ") + e.what());
    tell(
        "This is a bug of cnrg: please send this message, the tree file with the files that it names, and the "
        "output of `" +
        name + " --version`.");
    return kBug;
  }
}

}  // namespace

int run_program(const std::string& name, const std::function<int()>& program) {
  guard_ends(name.c_str());
  occupy_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond `ulimit -f` is an error of its write
  std::signal(SIGCHLD, SIG_DFL);  // who starts us may have ignored it, and then no child could be waited for
  try {
    std::ios::sync_with_stdio(false);
    return guarded(name, program);
  } catch (const std::bad_alloc&) {  // for a message, too
    return memory_ran_out();
  }
}

}  // namespace cnrg::app
