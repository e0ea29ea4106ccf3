// Libraries that most runs never need stand in plug-ins: OpenCASCADE, HDF5, cairo with FreeType, TetGen. Linked
// into the program, they and what they need (75 shared objects) would cost every start 40 ms; and whoever builds
// without one has the same program, which says what it lacks.
//
// A plug-in is a module `cnrg_NAME.so` that exports functions with C linkage. It is opened when somebody asks for
// a function of it, and never closed. It is searched for where the program, or the Python module, says (RUNPATH).
// Functions throw as any other does. Structures of C++ cross the border, so only plug-ins that were built with the
// program are used: each exports a stamp of all headers and of the compiler.
//
//   const auto write = CNRG_PLUGIN_FUNCTION(kPaperPlugin, cnrg_paper_png);   // declared in a header of the room
#pragma once

#include <string>

namespace cnrg {

struct Plugin {
  const char* name;     ///< of the module: `cad` is `cnrg_cad.so`
  const char* library;  ///< what is in it
  const char* option;   ///< of CMake, which is OFF in a build without it
  const char* package;  ///< that Debian has it in, for who builds
};
inline constexpr Plugin kCadPlugin{"cad", "OpenCASCADE", "CNRG_OPENCASCADE", "libocct-data-exchange-dev"};
inline constexpr Plugin kHdf5Plugin{"hdf5", "HDF5", "CNRG_HDF5", "libhdf5-dev"};
inline constexpr Plugin kPaperPlugin{"paper", "cairo with FreeType and the font DejaVu Sans", "CNRG_CAIRO",
                                     "libcairo2-dev libfreetype-dev fonts-dejavu-core"};
inline constexpr Plugin kTetgenPlugin{"tetgen", "TetGen", "CNRG_TETGEN", "libtet1.5-dev"};
inline constexpr const Plugin* kPlugins[] = {&kCadPlugin, &kHdf5Plugin, &kPaperPlugin, &kTetgenPlugin};

/// Why the plug-in cannot be used, and how to get it; empty if it can.
std::string plugin_fault(const Plugin& plugin);

/// Throws InputError where the plug-in cannot be used: `subject: fault, or instead`.
void require_plugin(const Plugin& plugin, const std::string& subject, const std::string& instead);

/// Throws InputError with `plugin_fault`.
void* plugin_symbol(const Plugin& plugin, const char* name);

/// Every plug-in has `const char* cnrg_NAME_version()`. Throws InputError as above.
std::string plugin_version(const Plugin& plugin);

#define CNRG_PLUGIN_FUNCTION(plugin, function) \
  reinterpret_cast<decltype(&(function))>(::cnrg::plugin_symbol(plugin, #function))

}  // namespace cnrg

/// In front of the definition of a plug-in's function.
#define CNRG_PLUGIN_EXPORT extern "C" __attribute__((visibility("default")))
