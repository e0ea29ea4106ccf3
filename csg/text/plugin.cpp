// The system's own search looks along the RUNPATH of who calls it, which is the program or module that holds this
// file.
#include "csg/text/plugin.h"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#include <cstring>
#include <map>
#include <mutex>

#include "csg/text/module_file.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// A module, or why there is none.
struct Opened {
  void* module = nullptr;
  std::string fault;
};

/// CNRG_PLUGINS are the names of those that were built with this file, each with spaces about it.
bool is_built(const Plugin& plugin) {
  return std::string(CNRG_PLUGINS).find(std::string(" ") + plugin.name + " ") != std::string::npos;
}

Opened open(const Plugin& plugin) {
  const std::string file = std::string("cnrg_") + plugin.name + ".so", library = plugin.library;
  if (!is_built(plugin)) {
    return {nullptr, "this cnrg was built without " + library + ": install " + plugin.package +
                         " and build cnrg again with " + plugin.option + "=ON"};
  }
#if __has_include(<dlfcn.h>)
  const std::string again = ": install or build cnrg again, with it", path = module_path(file);
  const auto closed = [&](const std::string& reason) {
    return Opened{nullptr, "the plug-in for " + library + " cannot be opened (" + reason + ")" + again};
  };
  const std::string damage = path.empty() ? path : module_damage(path);
  if (!damage.empty()) return closed(path + ": " + damage);
  const std::string& found = path.empty() ? file : path;
  // Its own symbols come first: another HDF5 in the process of a Python program is not to answer for ours.
  void* const module = dlopen(found.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    const char* const error = dlerror();
    return closed(error != nullptr ? error : "no reason given");
  }
  using Stamp = const char*();
  void* const stamp = dlsym(module, "cnrg_plugin_stamp");
  if (stamp == nullptr || std::strcmp(reinterpret_cast<Stamp*>(stamp)(), CNRG_PLUGIN_STAMP) != 0)
    return {nullptr, "the file " + found + " is no plug-in for " + library + " of this build of cnrg" + again};
  return {module, {}};
#else
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

std::string plugin_fault(const Plugin& plugin) { return opened(plugin).fault; }

void require_plugin(const Plugin& plugin, const std::string& subject, const std::string& instead) {
  if (const std::string fault = plugin_fault(plugin); !fault.empty())
    throw InputError(subject + ": " + fault + ", or " + instead);
}

void* plugin_symbol(const Plugin& plugin, const char* name) {
  if (const std::string fault = plugin_fault(plugin); !fault.empty()) throw InputError(fault);
#if __has_include(<dlfcn.h>)
  void* const symbol = dlsym(opened(plugin).module, name);
  require(symbol != nullptr, std::string("no function ") + name + " in a plug-in");
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
