// A comparison in a process of its own: a crash, a hang or a hunger for memory is an outcome, too.
//
// The process that calls must not have started threads: a copy of it would wait for threads that it does not have.
#pragma once

#include "tests/campaign/driver/family.h"

namespace cnrg::campaign {

/// What one process may use.
struct Limits {
  int seconds = 60;                          ///< of one trial
  std::size_t bytes = std::size_t{4} << 30;  ///< of address space
};

/// Ends with its parent, and takes no more memory than it may. For the child after a fork.
void enter_child(const Limits& limits);
/// How a process ended, by its wait status: `signal 11 (Segmentation fault)`, or the limit that it met.
std::string words_of_end(int wait_status, const Limits& limits);

/// `judge(compare)` in a child.
Outcome judge_isolated(const std::function<std::string()>& compare, const Limits& limits);

}  // namespace cnrg::campaign
