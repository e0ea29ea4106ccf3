#include "bench/sweep/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace cnrg::bench {
namespace {

/// What follows `key` in a line of a file, without separators and quotes around it.
std::string value_in(const char* path, const std::string& key) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size()), end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return "";
}

std::string operating_system() {
  std::string text = value_in("/etc/os-release", "PRETTY_NAME");
  if (utsname name{}; uname(&name) == 0)
    text += (text.empty() ? "" : ", ") + std::string(name.sysname) + " " + name.release;
  return text;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

MachineInfo this_machine() {
  MachineInfo machine;
  machine.cpu = value_in("/proc/cpuinfo", "model name");
  machine.cores = std::thread::hardware_concurrency();
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (pages > 0 && page > 0)
    machine.memory_bytes = static_cast<std::size_t>(pages) * static_cast<std::size_t>(page);
  machine.system = operating_system();
#if defined(__GNUC__) && !defined(__clang__)
  machine.compiler = "g++ " __VERSION__;
#else
  machine.compiler = __VERSION__;
#endif
  machine.compiler += " " CNRG_FLAGS "; CGAL's assertions are on for verdicts, ";
#ifdef NDEBUG
  machine.compiler += "off for times";
#else
  machine.compiler += "and for times";
#endif
  machine.date = today();
  return machine;
}

}  // namespace cnrg::bench
