// The machine that a sweep runs on, as far as the system tells.
#pragma once

#include "bench/sweep/description.h"

namespace cnrg::bench {

/// Processor, cores, memory, operating system, compiler and date; the rest is for the caller. What cannot be
/// found out is empty or 0.
MachineInfo this_machine();

}  // namespace cnrg::bench
