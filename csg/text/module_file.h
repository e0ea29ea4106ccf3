// The file of a module, before it is opened: the system's loader maps what the headers of the file promise, and of
// a file that a full disk or a broken copy cut short it reads behind the end, which ends the process (SIGBUS).
#pragma once

#include <string>

namespace cnrg {

/// Where the system's loader finds `name` for the program or module that holds this function: along its RUNPATH.
/// Empty if it is nowhere, or the system does not tell.
std::string module_path(const std::string& name);

/// What is wrong with the file, as its header and its table of sections tell; empty if it is whole.
std::string module_damage(const std::string& path);

}  // namespace cnrg
