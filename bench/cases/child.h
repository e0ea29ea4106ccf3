// One measurement in a process of its own: a crash, a limit or a leak stays there, and peak memory is its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace cnrg::bench {

struct Limits {
  double seconds = 0;     ///< wall time; 0: none
  std::size_t bytes = 0;  ///< of address space; 0: none
};

struct ChildResult {
  enum class End { done, crash, timeout, out_of_memory } end = End::done;
  int signal = 0;              ///< of a crash
  std::string text;            ///< what the work returned
  std::size_t peak_bytes = 0;  ///< resident
  double seconds = 0;          ///< wall time of the whole process
};

/// Runs `work` in a forked process and returns its text. The caller must not have started threads. The process
/// ends with its parent, however that ends; what it started and left behind ends with it.
ChildResult run_child(const std::function<std::string()>& work, const Limits& limits = {});

}  // namespace cnrg::bench
