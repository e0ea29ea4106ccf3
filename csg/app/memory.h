// The end of the program where no `catch` is: GMP calls abort() when memory runs out, and an exception that leaves
// a thread or a destructor calls std::terminate. Here the program ends with a message and an exit status all the
// same.
#pragma once

namespace cnrg::app {

/// Says that memory ran out, for which it needs none; the exit status.
int memory_ran_out() noexcept;

/// Gives GMP allocators that end the program by `memory_ran_out`, and std::terminate a line that says why; and
/// lets malloc keep what is freed. Call it first of all.
/// `name` of the program begins messages; it lives as long as the program.
void guard_ends(const char* name);

}  // namespace cnrg::app
