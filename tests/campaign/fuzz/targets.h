// What the fuzzers call: one function per kind of input, on bytes of any kind.
//
// A fuzzer changes bytes and keeps what reaches new code; all that it can see of a fault is that the process ends
// badly. So a target catches the errors that people are meant to read (InputError and FileError,
// kernel/base/error.h) and lets everything else through: another exception, a broken invariant, memory that ran
// out, a report of a sanitizer. To read without an error is not enough: what was read is evaluated with all checks
// on, as long as it is small, for a reader that accepts nonsense shows only there.
//
// Work is bounded by the target and not by the fuzzer's clock: a sphere of a million facets is slow and no fault.
#pragma once

#include <span>
#include <string_view>

namespace cnrg::fuzz {

struct Target {
  const char* name;
  void (*run)(std::string_view bytes);
};

/// All targets of this build; `step` and `brep` only with OpenCASCADE.
std::span<const Target> targets();

/// Children of this process (CAD files are read in them) get a second of processor time from now on, and are no
/// fuzzers: what a sanitizer says of them is theirs alone.
void limit_children();

void run_tree(std::string_view bytes);
void run_off(std::string_view bytes);
void run_obj(std::string_view bytes);
void run_ply(std::string_view bytes);
void run_stl(std::string_view bytes);
void run_vtp(std::string_view bytes);
void run_vtk(std::string_view bytes);
void run_msh(std::string_view bytes);
void run_glb(std::string_view bytes);
void run_3mf(std::string_view bytes);
void run_gocad(std::string_view bytes);
void run_csg(std::string_view bytes);
void run_grid(std::string_view bytes);
void run_points(std::string_view bytes);
void run_json(std::string_view bytes);
void run_step(std::string_view bytes);
void run_brep(std::string_view bytes);
void run_soup(std::string_view bytes);

}  // namespace cnrg::fuzz
