// `cnrg manual` and `cnrg completion`: what is installed beside the program for `man` and for the shell.
#pragma once

#include "csg/app/program_text.h"

namespace cnrg::app {

/// Prints the manual page, in the language of `man`.
int run_manual(const ProgramText& text);

/// Prints a script for bash, zsh or fish.
int run_completion(const ProgramText& text, const std::string& shell);

}  // namespace cnrg::app
