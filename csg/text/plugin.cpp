// The system's own search (dlopen of a name without a folder) looks along the RUNPATH of who calls it, which is
// the program or module that holds this file.
#include "csg/text/plugin.h"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#include <map>
#include <mutex>
#include <utility>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// A module, or why there is none.
struct Opened {
  void* module = nullptr;
  std::string reason;
};

Opened open(const Plugin& plugin) {
#if __has_include(<dlfcn.h>)
  const std::string file = std::string("cnrg_") + plugin.name + ".so";
  // Its own symbols come first: another HDF5 in the process of a Python program is not to answer for ours.
  if (void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return {module, {}};
  const char* const error = dlerror();
  return {nullptr, error != nullptr ? error : "no reason given"};
#else
  (void)plugin;
  return {nullptr, "this system opens no modules"};
#endif
}

const Opened& opened(const Plugin& plugin) {
  static std::mutex mutex;
  static std::map<std::string, Opened> all;
  const std::lock_guard lock(mutex);
  const auto [entry, fresh] = all.try_emplace(plugin.name);
  if (fresh) entry->second = open(plugin);
  return entry->second;
}

}  // namespace

std::string plugin_fault(const Plugin& plugin) {
  const std::string& reason = opened(plugin).reason;
  if (reason.empty()) return {};
  return std::string("this cnrg has no ") + plugin.library + " (" + reason + "): install " + plugin.package +
         " and build cnrg again";
}

void require_plugin(const Plugin& plugin, const std::string& subject, const std::string& instead) {
  if (const std::string fault = plugin_fault(plugin); !fault.empty())
    throw InputError(subject + ": " + fault + ", or " + instead);
}

void* plugin_symbol(const Plugin& plugin, const char* name) {
  if (const std::string fault = plugin_fault(plugin); !fault.empty()) throw InputError(fault);
#if __has_include(<dlfcn.h>)
  void* const symbol = dlsym(opened(plugin).module, name);
  require(symbol != nullptr, "a plug-in of another build");
  return symbol;
#else
  (void)name;
  return nullptr;
#endif
}

std::string plugin_version(const Plugin& plugin) {
  using Version = const char*();
  const std::string name = std::string("cnrg_") + plugin.name + "_version";
  return reinterpret_cast<Version*>(plugin_symbol(plugin, name.c_str()))();
}

}  // namespace cnrg
