// How a program runs and ends: each kind of exception becomes one message and its exit status.
#pragma once

#include <functional>
#include <string>

namespace cnrg::app {

/// Runs `program`, which returns an exit status and throws what the libraries throw, with standard output escaped
/// and with the ends guarded that no `catch` sees (memory.h). `name` begins messages that are of no file.
int run_program(const std::string& name, const std::function<int()>& program);

}  // namespace cnrg::app
