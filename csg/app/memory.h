// GMP calls abort() when memory runs out; here the program ends with a message and an exit status of its own.
#pragma once

namespace cnrg::app {

/// What people read when memory ran out.
inline constexpr const char* kMemoryRanOut =
    "memory ran out; use fewer segments or a smaller tree, or --threads 1";

/// Gives GMP allocators that end the program with a message and exit status 3. Call it first of all.
void guard_gmp_memory();

}  // namespace cnrg::app
