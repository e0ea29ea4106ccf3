#pragma once

#include <string>

namespace cnrg::app {

/// The text of `--version`: a line for each library that is in, and for each that could be and is not, with the
/// reason.
std::string version_text(const std::string& program);

}  // namespace cnrg::app
