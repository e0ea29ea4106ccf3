#pragma once

#include <span>
#include <string>

#include "csg/text/plugin.h"

namespace cnrg::app {

/// The text of `--version`: a line for each library that is in, and for each plug-in that the program could use;
/// of one that it lacks or cannot open, the reason.
std::string version_text(const std::string& program, std::span<const Plugin* const> plugins);

}  // namespace cnrg::app
