// Completions for other shells than bash, of the same table of options.
#pragma once

#include <string>

#include "csg/app/program_text.h"

namespace cnrg::app {

std::string zsh_completion(const ProgramText& text);
std::string fish_completion(const ProgramText& text);

}  // namespace cnrg::app
