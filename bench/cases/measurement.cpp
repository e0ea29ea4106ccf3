#include "bench/cases/measurement.h"

#include <malloc.h>

#include <chrono>
#include <fstream>
#include <sstream>

namespace cnrg::bench {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// A line of /proc/self/status such as `VmRSS:   1234 kB`; 0 if there is none.
std::size_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with(key + ":")) continue;
    std::istringstream words(line.substr(key.size() + 1));
    std::size_t kilobytes = 0;
    words >> kilobytes;
    return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace

double Measures::seconds() const {
  double all = 0;
  for (const auto& [stage, time] : stages) all += time;
  return all;
}

Measurement::Measurement() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts from what is resident now
  measures_.base_bytes = status_bytes("VmRSS");
  last_ = now();
}

void Measurement::lap(const std::string& stage) {
  const double time = now();
  measures_.stages.emplace_back(stage, time - last_);
  last_ = time;
}

Measures Measurement::stop() {
  measures_.peak_bytes = status_bytes("VmHWM");
  return measures_;
}

}  // namespace cnrg::bench
