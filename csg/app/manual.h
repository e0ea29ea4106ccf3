// `cnrg manual` and `cnrg completion`: what is installed beside the program for `man` and for the shell.
#pragma once

#include "csg/app/program_text.h"

namespace cnrg::app {

/// Prints the manual page, in the language of `man`.
int run_manual(const ProgramText& text);

/// Prints a script for bash, zsh or fish.
int run_completion(const std::string& shell);

/// `cnrg __complete`, which no help lists and those scripts run: what can stand where the last of `words` begins.
int run_complete(const ProgramText& text, const std::vector<std::string>& words);

}  // namespace cnrg::app
