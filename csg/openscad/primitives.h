// Modules without children: solids, areas, imported meshes.
#pragma once

#include <string>
#include <string_view>

#include "csg/openscad/interpreter.h"

namespace cnrg::openscad {

/// What a statement is evaluated in.
struct Context {
  const std::string& path;    ///< of the file
  const std::string& inside;  ///< the folder that imported files must lie in; empty: anywhere
  Report& report;
  Fineness fineness{};  ///< of the statement
};

using Maker = Value (*)(const Statement&, const Context&);

/// The function of a module; nullptr if it is none of these.
Maker primitive(std::string_view name);

/// What somebody can do about a module that is not read.
std::string remedy();

}  // namespace cnrg::openscad
